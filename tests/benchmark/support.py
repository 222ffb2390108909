# SPDX-License-Identifier: MIT
"""What the tests of the runner share: build folders with programs made of shell, and the command itself."""
from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE))


class BuildCase(unittest.TestCase):
    """A test with a folder of its own, and build folders in it."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def program(self, name: str, body: str, build: str = "build") -> Path:
        """A benchmark program; `log WORDS` notes its call in the file `calls`."""
        path = self.folder / build / "tests" / "benchmark" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f'#!/bin/sh\nlog() {{ echo "$@" >>"{self.folder}/calls"; }}\n{body}\n', encoding="utf-8")
        path.chmod(0o755)
        return path

    def calls(self) -> list[str]:
        """What the programs noted."""
        return (self.folder / "calls").read_text(encoding="utf-8").splitlines()

    def bench(self, *words: str, build: str = "build", **variables: str) -> subprocess.CompletedProcess[str]:
        """The command with the build folder, in the test's folder."""
        environment = {**os.environ, "BOXREEL_BUILD_DIR": str(self.folder / build), **variables}
        return subprocess.run([sys.executable, HERE / "bench.py", *words], cwd=self.folder, env=environment, text=True,
                              capture_output=True, check=False, timeout=1000)

    def assert_refused(self, code: int, culprit: str, *words: str, **variables: str) -> None:
        """The command ends with this code and one sentence that names the culprit."""
        done = self.bench(*words, **variables)
        self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
        self.assertIn(culprit, done.stderr.splitlines()[-1])
        self.assertNotIn("Traceback", done.stderr)


def engine_line(**figures: object) -> str:
    """What an engine's program prints of a sound run, as JSON."""
    return json.dumps({"engine": "boxreel 1", "threads": 1, "mean": 2e-3, "median": 2e-3, "p99": 3e-3, "cpu": 2e-3, "contacts": 100,
                       "memory": 1024, "finite": True, "escaped": 0, "awake": 0, "overlap": 0.01, "meanHeight": 10.0,
                       "meanSpeed": 1.0, "bodies": 50, "found": 7, "foundSum": 3.5, "bits": "ab", **figures})


SCENE = {"case": "rain", "what": "rain", "curve": "", "count": 0, "onlyNamed": False, "found": "hits", "comparesSpeeds": False}
ENGINE = f"""case $1 in
list) echo '{json.dumps(SCENE)}'; echo '{json.dumps({**SCENE, "case": "snow", "onlyNamed": True})}' ;;
run) log NAME "$@"; echo 'a library talks'; echo '{engine_line()}' ;;
esac"""
