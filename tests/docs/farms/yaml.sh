#!/bin/sh
# SPDX-License-Identifier: MIT
#
# yaml.sh CHECKOUT PROGRAM: what the job of Kubernetes and the one of Open Job Description run makes the
# parts of the film of a single run. Exit code 77: Python has no YAML.
. "$(dirname "$0")/check.sh"
for python in python3 /usr/bin/python3 ''; do
    [ -n "$python" ] || skip 'no Python with YAML (python3-yaml) is installed'
    ! $python -c 'import yaml' 2>/dev/null || break
done
cat >container.py <<'PYTHON'
# Runs the pod of one index, without its image, in the folder of this checkout.
import os, subprocess, sys, yaml
job = yaml.safe_load(open("docs/farms/kubernetes.yaml"))["spec"]
assert job["completionMode"] == "Indexed", job
container = job["template"]["spec"]["containers"][0]
env = {one["name"]: one["value"] for one in container["env"]}
assert job["completions"] * int(env["PART"]) == int(env["FRAMES"]), env
refused = [rule["onExitCodes"] for rule in job["podFailurePolicy"]["rules"] if rule["action"] == "FailJob"]
assert refused[0]["values"] == [1, 2, 3] and refused[0]["containerName"] == container["name"], refused
missing = set(env) - set(os.environ)
assert not missing, missing  # every value of the pod has its counterpart here
sys.exit(subprocess.call(container["command"], env=dict(os.environ, JOB_COMPLETION_INDEX=sys.argv[1])))
PYTHON
cat >task.py <<'PYTHON'
# Runs a step of the template for each of its tasks; what it says is Open Job Description's.
import os, re, subprocess, sys, yaml
template = yaml.safe_load(open("docs/farms/openjd.yaml"))
assert template["specificationVersion"] == "jobtemplate-2023-09"
values = {"Param." + one["name"]: str(one["default"]) for one in template["parameterDefinitions"]}
values["Param.Film"], values["Param.Frames"], values["Param.Part"] = (os.environ[n] for n in ("FILM", "FRAMES", "PART"))
values["Param.LastPart"] = str((int(os.environ["FRAMES"]) - 1) // int(os.environ["PART"]))
values["Param.Scripts"], values["Param.Folder"] = "docs/farms", sys.argv[2]
def filled(text):
    return re.sub(r"{{\s*([A-Za-z.]+)\s*}}", lambda name: values[name[1]], text)
step = next(one for one in template["steps"] if one["name"] == sys.argv[1])
numbers = ["0"]
if "parameterSpace" in step:
    first, last = filled(step["parameterSpace"]["taskParameterDefinitions"][0]["range"]).split("-")
    numbers = range(int(first), int(last) + 1)
for number in numbers:
    values["Task.Param.Number"] = str(number)
    values["Task.File.Run"] = os.path.join(sys.argv[3], "run")
    with open(values["Task.File.Run"], "w") as file:
        file.write(filled(step["script"]["embeddedFiles"][0]["data"]))
    action = step["script"]["actions"]["onRun"]
    command = [action["command"]] + [filled(argument) for argument in action["args"]]
    output = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
    if "parameterSpace" in step:
        assert "openjd_progress: 100.0" in output, output
PYTHON

export FOLDER="$work/parts"
for index in 3 1 0 2; do
    (cd "$checkout" && $python "$work/container.py" $index) 2>log || { cat log >&2; fail "pod $index"; }
done
"$checkout/docs/farms/merge.sh" film.mkv
expect_whole film.mkv

for step in Parts Merge; do
    (cd "$checkout" && $python "$work/task.py" $step "$work/openjd" "$work") 2>log || { cat log >&2; fail "step $step"; }
done
expect_whole openjd/film.mkv
