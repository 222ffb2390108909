# SPDX-License-Identifier: MIT
"""The real programs through the command: what they print is what the runner reads. BOXREEL_BUILD_DIR names their build."""
from __future__ import annotations

import ctypes
import json
import os
import shutil
import unittest
from pathlib import Path

from support import BuildCase

from runner.common import GOALS, objects, run

BUILD = Path(os.environ["BOXREEL_BUILD_DIR"])
PROGRAMS = BUILD / "tests" / "benchmark"


def has_library(name: str) -> bool:
    """Whether programs find the shared library."""
    try:
        ctypes.CDLL(name)
    except OSError:
        return False
    return True


class Programs(BuildCase):
    """Each benchmark on something small."""

    def results(self, *words: str) -> list[dict]:
        """What the command writes, after it printed a table of it."""
        done = self.bench(*words, "--rounds", "1", "--json", "a.json", "--force", BOXREEL_BUILD_DIR=str(BUILD))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout)
        return json.loads((self.folder / "a.json").read_text(encoding="utf-8"))["results"]

    def test_run_a_scene_on_all_engines(self) -> None:
        one = self.results("engine", "one-box")[0]
        self.assertEqual({method["verdict"] for method in one["methods"]}, {"sound"})
        self.assertEqual(one["methods"][0]["contacts"], 1)

    def test_are_compared_with_another_build(self) -> None:
        (self.folder / "other").symlink_to(BUILD)
        for one in self.results("engine", "one-box", "--against", "other"):
            self.assertTrue(one["sameResults"])
            self.assertGreater(one["ratio"], 0.0)

    def test_sweep_a_case_of_accuracy(self) -> None:
        one = self.results("accuracy", "A-projectile")[0]
        errors = {run["subSteps"]: run["error"] for run in one["runs"] if run["engine"].startswith("boxreel") and
                  (run["velocityIterations"], run["hz"]) == (8, 60)}
        # Velocities first, then places: what a throw is then off by is g t h / 2, that is 1/6 m.
        self.assertAlmostEqual(errors[1], 1.0 / 6.0, places=3)
        self.assertLessEqual(errors[4], GOALS["accuracy"]["A-projectile"]["error"][1])

    def test_draw_a_picture(self) -> None:
        one = self.results("render", "50-720p")[0]
        ours = one["methods"][0]
        self.assertEqual((ours["wrong"], ours["ours"], ours["threads"]), ("", True, "0"))
        self.assertLess(ours["rms"], 1.2)
        self.assertLess(ours["works"]["none"]["cpu"], ours["works"]["full"]["cpu"])

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_make_a_film_in_every_way(self) -> None:
        one = self.results("record", "tumbler", "--frames", "12", "--size", "160x90")[0]
        verdicts = {method["role"]: method.get("failure", method["verdict"]) for method in one["methods"]}
        immediate = verdicts.pop("immediate")
        if has_library("libOSMesa.so.8"):
            self.assertEqual(immediate, "sound")
        else:  # Mesa 25.1 and later: it is said, and the others are compared all the same
            self.assertIn("off-screen library", immediate)
        self.assertEqual(verdicts, dict.fromkeys(("boxreel", "start", "encodeOnly"), "sound"))
        self.assertIn("drawing", {stage["stage"] for stage in one["stages"]})
        self.assertEqual(one["reached"], {})

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_make_pictures(self) -> None:
        one = self.results("record", "pictures", "--frames", "3", "--size", "64x36")[0]
        self.assertEqual([(method["role"], method["verdict"]) for method in one["methods"]],
                         [("boxreel", "sound"), ("start", "sound"), ("encodeOnly", "sound")])

    def test_film_without_peers_when_ffmpeg_is_missing(self) -> None:
        words = ["record", "pyramid", "--frames", "3", "--size", "64x36", "--rounds", "1", "--json", "-"]
        done = self.bench(*words, BOXREEL_BUILD_DIR=str(BUILD), PATH="/nowhere")
        self.assertIn("install ffmpeg", done.stderr)
        self.assertEqual([method["role"] for method in json.loads(done.stdout)["results"][0]["methods"]], ["boxreel", "start"])

    def test_plant_changes_that_are_found(self) -> None:
        one = self.results("golden", "bridge")[0]
        found = {picture["change"]: picture["different"] for picture in one["methods"][0]["pictures"]}
        truths = {change["change"]: change["truth"] for change in one["changes"]}
        self.assertEqual(found.keys(), truths.keys())
        self.assertTrue(all(found[change] for change, truth in truths.items() if truth == "different"), found)
        self.assertFalse(found["equal"] or found["stray"], found)

    def test_refuse_unknown_scenes(self) -> None:
        self.assert_refused(1, "nothing", "golden", "nothing", BOXREEL_BUILD_DIR=str(BUILD))

    def test_list_every_case_that_has_a_goal(self) -> None:
        for name, (program, *words) in {"engine": ("boxreel_bench", "list"), "accuracy": ("boxreel_bench", "accuracy-list"),
                                        "render": ("boxreel_render_bench", "list"),
                                        "record": ("boxreel_record_bench", "list")}.items():
            known = {one["case"] for one in objects(run([PROGRAMS / program, *words]).output)}
            self.assertLessEqual(GOALS[name].keys(), known)

    @unittest.skipIf(os.environ.get("BOXREEL_SANITIZE"), "the sanitizers' own memory counts in the process's growth")
    def test_need_at_most_15_mb_for_the_large_pyramid(self) -> None:
        ours = objects(run([PROGRAMS / "boxreel_bench", "run", "large-pyramid"]).output)[-1]
        self.assertGreater(ours["memory"], 1024, "5050 boxes take more than that: nobody measured")
        self.assertLessEqual(ours["memory"] / 1024.0, GOALS["engine"]["large-pyramid"]["memory [MB]"][1])


if __name__ == "__main__":
    unittest.main()
