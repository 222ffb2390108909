#!/bin/sh
# SPDX-License-Identifier: MIT
# same-bits.sh SOURCE WORK COMPILER LEVEL [CMAKE OPTION]…
# Builds the program with another compiler and optimisation level, and compares every scene with what was
# approved: states, draw lists and pixels must be the same, and so the states after 600 steps, with sub-steps too.
# Exits 77 (skipped) when the compiler is absent.
set -eu
source=$1 work=$2 compiler=$3 level=$4
shift 4

if ! command -v "$compiler" >/dev/null; then
    echo "skipped: $compiler is not installed"
    exit 77
fi
cmake -S "$source" -B "$work" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=None \
    -DCMAKE_CXX_FLAGS="$level" -DBOXREEL_WERROR=ON -DBOXREEL_BUILD_TESTS=ON "$@" >"$work.log" 2>&1 &&
    cmake --build "$work" --target boxreel boxreel_scene_states_tests boxreel_engine_dynamics_tests >>"$work.log" 2>&1 || {
    tail -n 40 "$work.log"
    exit 1
}
"$work/tests/testbed/boxreel_scene_states_tests" --gtest_brief=1
"$work/tests/engine/boxreel_engine_dynamics_tests" --gtest_brief=1 --gtest_filter='*BitsOfEveryCompiler'
exec "$work/boxreel" golden verify --references "$source/golden/references" --output "$work/golden-output"
