#!/bin/sh
# SPDX-License-Identifier: MIT
# headers.sh CXX SOURCE: the public headers of the engine compile as C++17, so that programs of Box2D 2.3 compile with
# the default standard of their compiler. Inline variables need C++17. Exit codes: 0 they do, 1 they do not.
set -eu
cd "$2/engine"
{
    find include include-2.4 -name '*.h' | sort | sed 's/.*/#include "&"/'
    cat <<'EOF'
const char* Restore(b2World& world, const std::vector<uint8>& bytes)
{
    return b2RestoreSnapshot(world, bytes.data(), bytes.size());
}
EOF
} | "$1" -std=c++17 -pedantic-errors -Wall -Wextra -Werror -Iinclude -Iinclude-2.4 -I. -x c++ -fsyntax-only -
