#!/bin/sh
# SPDX-License-Identifier: MIT
#
# golden-ci.sh CHECKOUT BUILD [whole]: the workflow of docs/examples/golden-ci.md is GitHub's, and its steps do what
# the page says, one after the other, for the project of docs/golden.md: fail without references, pass with
# them, and fail after a change with the pictures where the last step looks for them. boxreel itself is installed from
# BUILD; with `whole` it is built again, as the workflow does. Exit code 77: Python has no YAML.
set -eu
checkout=$1
built=$2
pace=${3-quick}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM
unset BOXREEL_GOLDEN_ACCEPT BOXREEL_GOLDEN_REFERENCES BOXREEL_GOLDEN_OUTPUT

fail() {
    echo "FAILED: $*" >&2
    exit 1
}
for python in python3 /usr/bin/python3 ''; do
    [ -n "$python" ] || { echo 'skipped: no Python with YAML (python3-yaml) is installed'; exit 77; }
    ! $python -c 'import yaml' 2>/dev/null || break
done

# A file a step that runs something, called by the step's name; `environment`, and `pictures`, what is uploaded.
cat >"$work/steps.py" <<'PYTHON'
import sys, yaml
workflow = yaml.safe_load(open(sys.argv[1]))
assert workflow[True] == ["push", "pull_request"], workflow  # YAML 1.1 takes `on` for a truth value
assert set(workflow) == {"name", True, "jobs"} and set(workflow["jobs"]) == {"golden"}, workflow
job = workflow["jobs"]["golden"]
assert job["container"] == "debian:12" and set(job) == {"runs-on", "container", "env", "steps"}, job
with open("environment", "w") as file:
    file.writelines(f"export {name}='{value}'\n" for name, value in job["env"].items())
names = []
for step in job["steps"]:
    assert set(step) <= {"name", "run", "uses", "with", "if"} and ("run" in step) != ("uses" in step), step
    names.append(step.get("name", step.get("uses")))
    if "run" in step:
        with open(step["name"], "w") as file:
            file.write(step["run"])
checkout, upload = "actions/checkout@v4", "Keep the pictures of what differs"
assert names == ["Install what the builds need", checkout, checkout, "Install boxreel", "Build", "Test", upload], names
own, boxreel, last = job["steps"][1], job["steps"][2], job["steps"][-1]
assert "with" not in own and boxreel["with"]["path"] == "boxreel" and "repository" in boxreel["with"], boxreel
assert last["uses"] == "actions/upload-artifact@v4" and last["if"] == "failure()", last
with open("pictures", "w") as file:
    file.write(last["with"]["path"])
PYTHON
cd "$work"
$python steps.py "$checkout/docs/examples/golden-ci/.github/workflows/golden.yml"

# What the first step installs has all that ./boxreel needs to build, but for the program's own.
grep -q '^apt-get -q update$' 'Install what the builds need' || fail 'the package lists of a container are empty'
# Debian 12 has OSMesa.
wanted=$(sed -n "/^find_missing/,/goal.* = test/s/^ *need ['\"][^'\"]*['\"] //p" "$checkout/boxreel" |
    sed 's/\$drawing/libosmesa6-dev/')
[ "$(echo "$wanted" | wc -w)" -ge 18 ] || fail 'the boxreel script names its packages in another way than it did'
for package in $wanted; do
    case $package in
        nlohmann-json3-dev | libcli11-dev) ;;
        *) grep -qw -- "$package" 'Install what the builds need' || fail "the workflow does not install $package" ;;
    esac
done

mkdir project
cp -R "$checkout"/tests/consumer/project/. project/
PREFIX=
# shellcheck disable=SC1091 # written above
. ./environment
[ -n "$PREFIX" ] || fail 'the workflow names no PREFIX'
PREFIX=$work/prefix
cd project
# As GitHub does in a container.
run() {
    sh -e "../$1" >../log 2>&1
}
if [ "$pace" = whole ]; then
    mkdir boxreel
    tar -C "$checkout" --exclude=./build --exclude=./.git -cf - . | tar -C boxreel -xf - # as actions/checkout brings it
    run 'Install boxreel' || { tail -n 30 ../log >&2; fail 'boxreel cannot be installed'; }
else
    cmake --install "$built" --prefix "$PREFIX" >../log
fi
run Build || { tail -n 30 ../log >&2; fail 'the project cannot be built'; }
pictures=$(cat ../pictures)

! run Test || fail 'there are no references, and the tests pass'
[ -f "$pictures/seesaw/1s.actual.png" ] || fail "without references no picture is in $pictures"
BOXREEL_GOLDEN_ACCEPT=missing ctest --test-dir build >../log 2>&1 || { cat ../log >&2; fail 'the pictures are not accepted'; }
[ -f references/frames/seesaw/1s.png ] || fail 'nothing is in references'
rm -r "$pictures"
run Test || { cat ../log >&2; fail 'the tests fail with references'; }

sed -i 's/4.0f, 5.0f/4.0f, 5.1f/' Seesaw.cpp
run Build
! run Test || fail 'a box falls from elsewhere, and the tests pass'
for picture in expected actual difference side-by-side; do
    [ -f "$pictures/seesaw/1s.$picture.png" ] || fail "there is no picture seesaw/1s.$picture.png in $pictures"
done
