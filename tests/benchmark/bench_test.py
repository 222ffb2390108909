# SPDX-License-Identifier: MIT
"""The command: options, errors, files, show, --against, signals, and charts."""
from __future__ import annotations

import contextlib
import importlib.util
import io
import json
import os
import signal
import subprocess
import sys
import time
import unittest
from unittest import mock

from support import ENGINE, HERE, BuildCase, engine_line

import bench
from runner import common

PEER = ENGINE.replace("boxreel 1", "Box2D 2.4.1").replace('"cpu": 0.002', '"cpu": 0.008')
HAS_MATPLOTLIB = importlib.util.find_spec("matplotlib") is not None


class Command(BuildCase):
    """The command with programs of shell."""

    def setUp(self) -> None:
        super().setUp()
        self.program("boxreel_bench", ENGINE)
        self.program("boxreel_bench_box2d", PEER)

    def test_refuses_unknown_arguments(self) -> None:
        for culprit, words in (("'large'", ["large"]), ("--curves", ["engine", "--curves"]), ("'rian'", ["engine", "rian"]),
                               ("'rain'", ["engine", "rain", "rain"]), ("--rounds", ["engine", "--rounds", "0"]), ("'pink'", ["engine", "--theme", "pink"]),
                               ("1,1", ["engine", "--threads", "1,1"]), ("640x361", ["record", "--size", "640x361"]),
                               ("chart.pdf", ["engine", "--chart", "chart.pdf"]), ("--rounds", ["show", "a", "--rounds", "2"]),
                               ("--against", ["show", "a", "--against", "b"]), ("FILE", ["show"]), ("NAME", []),
                               ("--rounds", ["engine", "--rounds"]), ("--list", ["engine", "--list=3"]), ("NAME", ["--nope"])):
            with self.subTest(words=words):
                self.assert_refused(1, culprit, *words)
                self.assertIn(";", self.bench(*words).stderr, "no remedy")
                self.assertNotRegex(self.bench(*words).stderr, "argument [A-Z-]|choose from|unrecognized", "argparse's words")

    def test_suggests_the_nearest_case(self) -> None:
        self.assertIn("'rain'", self.bench("engine", "rian").stderr)

    def test_names_a_missing_program(self) -> None:
        self.assert_refused(3, "boxreel_render_bench", "render")

    def test_lists_cases_and_those_that_are_only_named(self) -> None:
        done = self.bench("engine", "--list")
        self.assertEqual([line.split()[0] for line in done.stdout.splitlines()], ["rain", "snow"])

    def test_passes_sub_steps_on_and_then_has_no_goals(self) -> None:
        done = self.bench("engine", "--sub-steps", "4", "--rounds", "1", "--json", "a.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.calls()[0].split()[-4:], ["run", "rain", "1", "4"])
        [result] = json.loads((self.folder / "a.json").read_text(encoding="utf-8"))["results"]  # snow is only named
        self.assertEqual((result["subSteps"], result["reached"]), (4, {}))

    def test_measures_pictures_with_films_in_one_run(self) -> None:
        class Fake(common.Benchmark):
            """Measures nothing."""
            def __init__(self, name: str) -> None:
                self.name = name

            def cases(self, build: object) -> list[dict]:
                return [{"case": self.name, "what": ""}, {"case": "slow", "what": "", "onlyNamed": True}]

            def measure(self, build: object, case: dict, options: object, work: object) -> dict:
                return case

            def judge(self, result: dict) -> None:
                pass

            def text(self, results: list[dict]) -> str:
                return f"{self.name}: {[one['case'] for one in results]}\n"

        fakes = {name: Fake(name) for name in ("record", "render", "golden")}
        with mock.patch.dict(bench.BENCHMARKS, fakes), contextlib.redirect_stdout(io.StringIO()) as output:
            self.assertEqual(bench.main(["record", "--pictures"]), 0)
            self.assertEqual(bench.main(["record", "--pictures", "--json", "-"]), 1)
        self.assertEqual(output.getvalue().split("\n\n"), ["record: ['record']", "render: ['render']", "golden: ['golden']\n"])

    def test_reads_what_it_wrote(self) -> None:
        self.assertEqual(self.bench("engine", "snow", "--json", "a.json").returncode, 0)
        shown = self.bench("show", "a.json", "--json", "-")
        self.assertEqual(shown.stdout, (self.folder / "a.json").read_text(encoding="utf-8"))
        self.assertEqual(self.bench("show", "a.json", "--list").stdout.split()[0], "snow")
        self.assertEqual(self.bench("show", "a.json", "snow").stdout, self.bench("show", "a.json").stdout)
        self.assert_refused(1, "'rain'", "show", "a.json", "rain")

    def test_refuses_files_that_it_did_not_write(self) -> None:
        self.bench("engine", "--json", "good.json")
        good = (self.folder / "good.json").read_text(encoding="utf-8")
        for name, text in (("empty", ""), ("words", "words"), ("list", "[1]"), ("other", good.replace('"engine"', '"render"', 1)), ("unknown", good.replace('"engine"', '"snow"', 1)),
                           ("ratios", good.replace('"engine"', '"against"', 1)),
                           ("nan", good.replace("0.002", "NaN", 1)), ("text", good.replace("0.002", '"x"')), ("deep", "[" * 99999),
                           ("none", '{"benchmark": "engine", "results": []}'), ("zero", good.replace("0.002", "0")),
                           ("methods", '{"benchmark": "engine", "results": [{"case": "a", "what": "b", "methods": []}]}')):
            with self.subTest(name=name):
                (self.folder / f"{name}.json").write_text(text, encoding="utf-8")
                self.assert_refused(1, f"'{name}.json'", "show", f"{name}.json")
        self.assert_refused(1, "'absent.json'", "show", "absent.json")

    def test_leaves_no_control_character_for_the_terminal(self) -> None:
        self.bench("engine", "--json", "a.json")
        path = self.folder / "a.json"
        path.write_text(path.read_text(encoding="utf-8").replace("Box2D", "\\u001b[31m\\u009bBox"), encoding="utf-8")
        shown = self.bench("show", "a.json").stdout
        self.assertFalse([sign for sign in shown if sign != "\n" and not sign.isprintable()])

    def test_keeps_existing_files_unless_it_is_forced(self) -> None:
        (self.folder / "a.json").write_text("mine", encoding="utf-8")
        self.assert_refused(1, "'a.json'", "engine", "--json", "a.json")
        self.assertEqual((self.folder / "a.json").read_text(encoding="utf-8"), "mine")
        self.assertFalse((self.folder / "calls").exists(), "refused before anything ran")
        self.assertEqual(self.bench("engine", "--json", "a.json", "--force").returncode, 0)

    def test_refuses_existing_charts_before_it_runs(self) -> None:
        self.program("boxreel_bench", 'log "$1"; echo \'{"case":"A-projectile","what":"","unit":"m","maxSubSteps":1}\'')
        (self.folder / "a-A-projectile-dark.svg").write_text("mine", encoding="utf-8")
        self.assert_refused(1, "a-A-projectile-dark.svg", "accuracy", "--chart", "a.svg", "--theme", "both")
        self.assertEqual(self.calls(), ["accuracy-list"])

    def test_refuses_a_missing_folder_before_it_runs(self) -> None:
        self.assert_refused(1, "'nowhere'", "engine", "--json", "nowhere/a.json")
        self.assertFalse((self.folder / "calls").exists())

    def test_writes_files_whole_or_not_at_all(self) -> None:
        path = self.folder / "a.json"
        path.write_text("before", encoding="utf-8")
        with mock.patch("pathlib.Path.replace", side_effect=OSError(28, "No space left")):
            with self.assertRaises(common.Problem):
                common.write_whole(path, b"after")
        self.assertEqual(path.read_text(encoding="utf-8"), "before")
        self.assertEqual([name for name in os.listdir(self.folder) if name.startswith(".")], [])

    def test_shows_finished_cases_when_stopped(self) -> None:
        self.program("boxreel_bench", ENGINE.replace("run)", "run) [ $2 = snow ] && { log slow; exec sleep 60; };"))
        (self.folder / "tmp").mkdir()
        environment = {**os.environ, "BOXREEL_BUILD_DIR": str(self.folder / "build"), "TMPDIR": str(self.folder / "tmp")}
        words = [sys.executable, str(HERE / "bench.py"), "engine", "rain", "snow", "--rounds", "1"]
        with subprocess.Popen(words, env=environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
            while not any("slow" in call for call in (self.calls() if (self.folder / "calls").exists() else [])):
                time.sleep(0.02)
            running.send_signal(signal.SIGTERM)
            shown, _ = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 0)
        self.assertIn("rain", shown)
        self.assertEqual(os.listdir(self.folder / "tmp"), [])


class Against(BuildCase):
    """Another build beside this one."""

    def setUp(self) -> None:
        super().setUp()
        self.program("boxreel_bench", ENGINE.replace("NAME", "this"))
        self.program("boxreel_bench_box2d", PEER)
        slower = ENGINE.replace("NAME", "other").replace('"cpu": 0.002', '"cpu": 0.003')
        self.program("boxreel_bench", slower, build="other")

    def test_alternates_builds_and_their_order(self) -> None:
        self.assertEqual(self.bench("engine", "--against", "other", "--rounds", "3").returncode, 0)
        self.assertEqual([call.split()[0] for call in self.calls()], ["this", "other", "other", "this", "this", "other"])

    def test_writes_the_ratio_and_its_spread(self) -> None:
        done = self.bench("engine", "--against", "other", "--rounds", "3", "--json", "a.json")
        figures = {one["figure"]: one for one in json.loads((self.folder / "a.json").read_text(encoding="utf-8"))["results"]}
        for key in ("ratio", "lowest", "highest"):
            self.assertAlmostEqual(figures["CPU"][key], 1.5)
        self.assertEqual(figures["CPU"]["seconds"], [[0.002, 0.003]] * 3)
        self.assertAlmostEqual(figures["mean"]["ratio"], 1.0)
        self.assertEqual(self.bench("show", "a.json").stdout, done.stdout)

    @unittest.skipUnless(HAS_MATPLOTLIB, "matplotlib is not installed (Debian: python3-matplotlib)")
    def test_draws_the_ratios_at_once_or_from_a_file(self) -> None:
        words = ("engine", "--against", "other", "--rounds", "1", "--json", "a.json", "--chart", "a.svg", "--theme", "dark")
        self.assertEqual(self.bench(*words).returncode, 0)
        self.assertEqual(self.bench("show", "a.json", "--chart", "b.svg", "--theme", "dark").returncode, 0)
        drawn = [(self.folder / name).read_bytes() for name in ("a.svg", "b.svg")]
        self.assertIn(b"<svg", drawn[0])
        self.assertEqual(drawn[0], drawn[1])

    def test_marks_different_results(self) -> None:
        self.program("boxreel_bench", ENGINE.replace('"bits": "ab"', '"bits": "cd"'), build="other")
        done = self.bench("engine", "--against", "other", "--json", "-")
        self.assertEqual({one["sameResults"] for one in json.loads(done.stdout)["results"]}, {False})

    def test_refuses_a_folder_that_is_no_build(self) -> None:
        self.assert_refused(3, "nowhere", "engine", "--against", "nowhere")


class Numbers(unittest.TestCase):
    """Numbers of several rounds."""

    def test_are_medians_of_each_member(self) -> None:
        rounds = [{"a": {"b": 1.0}, "c": "x"}, {"a": {"b": 9.0}, "c": "y"}, {"a": {"b": None}, "c": "z"}]
        self.assertEqual(common.median_of(rounds), {"a": {"b": 5.0}, "c": "x"})


class Programs(BuildCase):
    """What is read from programs."""

    def test_are_read_after_other_output(self) -> None:
        self.assertEqual(common.objects('talk\n{"a": 1}\n{"a": 2}\n'), [{"a": 1}, {"a": 2}])

    def test_are_refused_without_figures(self) -> None:
        for said in ("", "talk", "{broken"):
            with self.assertRaises(common.Problem):
                common.objects(said)

    def test_are_reported_with_their_last_line(self) -> None:
        path = self.program("boxreel_bench", "echo first >&2; echo 'no scene is called x' >&2; exit 1")
        with self.assertRaises(common.Problem) as caught:
            common.run([path])
        self.assertEqual(caught.exception.code, 1)
        self.assertIn("no scene is called x", str(caught.exception))

    def test_may_end_with_an_expected_code(self) -> None:
        self.assertEqual(common.run([self.program("boxreel_bench", "exit 22")], 22).code, 22)


@unittest.skipUnless(HAS_MATPLOTLIB, "matplotlib is not installed (Debian: python3-matplotlib)")
class Charts(BuildCase):
    """Charts as files."""

    def test_are_drawn_in_both_themes_and_formats(self) -> None:
        self.program("boxreel_bench", ENGINE)
        self.program("boxreel_bench_box2d", PEER)
        done = self.bench("engine", "--chart", "a.png", "--chart", "a.svg", "--theme", "both", "--rounds", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name, start in (("a-light.png", b"\x89PNG"), ("a-dark.png", b"\x89PNG"), ("a-light.svg", b"<?xml"), ("a-dark.svg", b"<?xml")):
            self.assertEqual((self.folder / name).read_bytes()[:len(start)], start)
        self.assertNotEqual((self.folder / "a-dark.svg").read_bytes(), (self.folder / "a-light.svg").read_bytes())


if __name__ == "__main__":
    unittest.main()
