#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""workflow.py CHECKOUT SITE_FOLDER

Sees that the workflow that publishes the site builds the target `site`, and uploads the folder that this target
writes.
"""
import pathlib
import sys

import yaml

checkout, folder = map(pathlib.Path, sys.argv[1:])
jobs = yaml.safe_load((checkout / ".github/workflows/site.yml").read_text(encoding="utf-8"))["jobs"]
steps = jobs["build"]["steps"]
commands = [step["run"] for step in steps if "run" in step]
assert any(command.split() == ["cmake", "--build", "build/release", "--target", "site"] for command in commands), commands
uploads = [step["with"]["path"] for step in steps if "upload-pages-artifact" in step.get("uses", "")]
assert uploads == [f"build/release/{folder.name}"], uploads
assert jobs["publish"]["needs"] == "build"
assert any("deploy-pages" in step["uses"] for step in jobs["publish"]["steps"])
