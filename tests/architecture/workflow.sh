#!/bin/sh
# SPDX-License-Identifier: MIT
#
# workflow.sh CHECKOUT: .github/workflows/ci.yml builds with gcc and with clang what CMakePresets.json knows, and its
# steps are shell commands. Exit code 77: Python has no YAML.
set -eu
for python in python3 /usr/bin/python3 ''; do
    [ -n "$python" ] || { echo 'skipped: no Python with YAML (python3-yaml) is installed'; exit 77; }
    ! $python -c 'import yaml' 2>/dev/null || break
done
exec $python - "$1" <<'PYTHON'
import json, os, subprocess, sys, yaml
checkout = sys.argv[1]
workflow = yaml.safe_load(open(checkout + "/.github/workflows/ci.yml"))
job = workflow["jobs"]["tests"]
matrix = job["strategy"]["matrix"]
assert matrix["compiler"] == ["g++", "clang++"], matrix
assert sorted(matrix["preset"]) == ["asan", "debug", "release", "tsan"], matrix
presets = json.load(open(checkout + "/CMakePresets.json"))
for kind in "configurePresets", "buildPresets", "testPresets":
    known = {preset["name"] for preset in presets[kind]}
    assert set(matrix["preset"]) <= known, f"{kind} of CMakePresets.json lacks {set(matrix['preset']) - known}"
for preset in matrix["preset"]:
    ran = []
    for step in job["steps"]:
        # The only conditions: for the release, and for all but it.
        condition = step.get("if", "true").replace("matrix.preset", repr(preset))
        if "run" in step and (condition == "true" or eval(condition)):
            script = step["run"].replace("${{ matrix.preset }}", preset)
            assert "${{" not in script, script
            subprocess.run(["sh", "-n", "-c", script], check=True)
            ran.append(script)
    whole = "\n".join(ran)
    wanted = [".ci/run"] if preset == "release" else [f"{command} --preset {preset}" for command in
                                                    ("cmake", "cmake --build", "ctest")]
    for command in wanted:
        assert command in whole, f"the job of {preset} does not run `{command}`"
for script in "boxreel", ".ci/run":
    assert os.access(f"{checkout}/{script}", os.X_OK), f"{script} cannot be run"
PYTHON
