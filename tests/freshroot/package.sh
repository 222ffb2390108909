#!/bin/sh
# SPDX-License-Identifier: MIT
#
# package.sh BUILD WORK_DIR
#
# Packs the build as Debian packages and installs them where nothing else is: a minimal Debian 12 in a
# folder. The program works there with what its package depends on, its manual page and completions are
# found, the other packages' library and Python module are used, and removing them leaves nothing.
#
# Exit codes: 0 all is well, 77 this machine cannot try it, anything else a failure. After a failure
# the folder stays for a look.
# shellcheck disable=SC2016 # $… is the inner shell's
set -eu
build=$1
work=$2
suite=bookworm # what this build links is this machine's
tools='cpack dpkg-shlibdeps gzip'
# shellcheck source=tests/freshroot/root.sh
. "$(dirname "$0")/root.sh"

(cd "$build" && cpack -G DEB -B "$work/packages") >"$work/cpack.log" 2>&1 || { tail "$work/cpack.log"; fail 'cpack'; }
if command -v lintian >/dev/null; then
    lintian --fail-on error \
        "$work"/packages/*boxreel*.deb >"$work/lintian.log" 2>&1 || { cat "$work/lintian.log"; fail 'lintian'; }
fi
cp "$work"/packages/*boxreel*.deb "$root/tmp/"
apt='apt-get install -y -q --no-install-recommends'

inside "apt-get update -q && $apt /tmp/boxreel_*.deb" >"$work/apt.log" 2>&1 || { tail "$work/apt.log"; fail 'the package cannot be installed'; }
inside 'cd /tmp && boxreel list --names | grep -qx Pyramid' || fail 'list'
inside 'cd /tmp && for film in mp4 webm mkv gif webp apng; do boxreel record pyramid -o p.$film --seconds 1 --size 160x90 || exit 1; done' \
    >"$work/films.log" 2>&1 || { tail "$work/films.log"; fail 'a film of some kind is not made'; }
inside 'cd /tmp && boxreel shot car --at 1s -o car.pdf && boxreel shot car --at 1s -o car.png --ui && test -s car.pdf && test -s car.png' ||
    fail 'pictures'
# The doctor ends well when one library can draw; here all that it asks for must be.
{ inside 'boxreel doctor' >"$work/doctor.log" 2>&1 && ! grep '^FAIL' "$work/doctor.log"; } ||
    { cat "$work/doctor.log"; fail 'the doctor finds something wrong'; }
inside 'cd /tmp && for backend in osmesa egl; do boxreel shot car --at 1s -o $backend.png --backend $backend || exit 1; done && cmp osmesa.png egl.png' \
    >"$work/backends.log" 2>&1 || { tail "$work/backends.log"; fail 'one of the two libraries that draw'; }
inside 'zcat /usr/share/man/man1/boxreel.1.gz | grep -q "^.TH BOXREEL"' || fail 'the manual page'
# minbase leaves out bash-completion, which would load the file by its name.
inside 'bash -c "source /usr/share/bash-completion/completions/boxreel && complete -p boxreel"' >/dev/null || fail 'completion for bash'
inside 'test -s /usr/share/zsh/vendor-completions/_boxreel' || fail 'completion for zsh'

inside "$apt g++ pkg-config libpng-dev libimgui-dev libstb-dev zlib1g-dev /tmp/libboxreel-dev_*.deb" >"$work/apt.log" 2>&1 ||
    { tail "$work/apt.log"; fail 'the package for programs cannot be installed'; }
cat >"$root/tmp/film.cpp" <<'END'
#include <Box2D/Box2D.h>
#include <debugdraw/DrawCollector.h>
#include <recorder/Recording.h>
int main()
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef body;
    body.type = b2_dynamicBody;
    b2CircleShape ball;
    ball.m_radius = 1.0f;
    world.CreateBody(&body)->CreateFixture(&ball, 1.0f);
    auto film = boxreel::Recording::Open("ball.mp4", {.width = 64, .height = 64});
    world.Step(1.0f / 60.0f, 8, 3);
    return film && film->Add(boxreel::DrawListOf(world), {64, 64, 0.0, 0.0, 10.0}) && film->Close() ? 0 : 1;
}
END
inside 'cd /tmp && c++ -std=c++20 film.cpp -o film $(pkg-config --static --cflags --libs boxreel-recorder boxreel-debugdraw) && ./film && test -s ball.mp4' ||
    fail 'a program that links the libraries'

inside "$apt /tmp/python3-boxreel_*.deb" >"$work/apt.log" 2>&1 || { tail "$work/apt.log"; fail 'the package for Python cannot be installed'; }
cat >"$root/tmp/ball.py" <<'END'
import boxreel
from Box2D import b2World
world = b2World(gravity=(0, -10))
world.CreateDynamicBody(position=(0, 4)).CreateCircleFixture(radius=0.5, density=1)
with boxreel.film("ball.mp4", size=(64, 64)) as film:
    for _ in range(10):
        world.Step(1 / 60, 8, 3)
        film.add(world)
END
inside 'cd /tmp && rm ball.mp4 && python3 ball.py && test -s ball.mp4' || fail 'a program in Python'

inside 'apt-get remove -y -q boxreel libboxreel-dev python3-boxreel' >"$work/apt.log" 2>&1 || fail 'the packages cannot be removed'
left=$(find "$root/usr" -name '*boxreel*')
[ -z "$left" ] || fail "removing them leaves $left"
rm -rf "$root"
echo 'installed, used and removed'
