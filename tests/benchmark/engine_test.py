# SPDX-License-Identifier: MIT
"""The engine beside its peers: what a run must show before its time counts, medians, ratios, goals."""
from __future__ import annotations

import argparse
import json
import unittest

from support import ENGINE, SCENE, BuildCase, engine_line

from runner import common, engine

OPTIONS = argparse.Namespace(rounds=2, threads=[1], sub_steps=None, against=None)


def method(name: str = "boxreel 1", ours: bool = True, **figures: object) -> dict:
    """A sound run."""
    said = json.loads(engine_line(**figures))
    said.pop("engine")
    program = "boxreel_bench_box2d" if "Box2D" in name else "boxreel_bench"
    return {"method": name, "program": program, "ours": ours, **said}


def judged(ours: dict, *peers: dict, **scene: object) -> dict:
    """The result of a scene; without peers one of Box2D like ours."""
    result = {**SCENE, **scene, "methods": [ours, *(peers or [method("Box2D 2.4.1", False, cpu=8e-3, mean=8e-3)])]}
    engine.Engine().judge(result)
    return result


class Judge(unittest.TestCase):
    """Verdicts of runs."""

    def test_accepts_runs_that_end_like_the_peers(self) -> None:
        first, peer = judged(method())["methods"]
        self.assertEqual((first["verdict"], peer["verdict"]), ("sound", "sound"))
        self.assertAlmostEqual(peer["cpuTimes"], 4.0)

    def test_names_differences_from_the_peers(self) -> None:
        for figures, verdict in (({"bodies": 51}, "other bodies"), ({"found": 8}, "other found"), ({"foundSum": 3.6}, "other found"),
                                 ({"contacts": 130}, "other contacts"), ({"meanHeight": 10.4}, "other heights"),
                                 ({"overlap": 0.0126}, "deep overlaps"), ({"finite": False}, "not finite"),
                                 ({"escaped": 3}, "escaped"), ({"awake": 2}, "awake"), ({"bits": "vary"}, "other bits")):
            first, peer = judged(method(**figures))["methods"]
            self.assertEqual(first["verdict"], verdict, figures)
            self.assertNotIn("cpuTimes", peer, figures)

    def test_accepts_small_deviations(self) -> None:
        for figures in ({"contacts": 114}, {"meanHeight": 10.29}, {"overlap": 0.0124}, {"meanSpeed": 9.0}, {"foundSum": 3.5003}):
            self.assertEqual(judged(method(**figures))["methods"][0]["verdict"], "sound", figures)

    def test_compares_speeds_where_nothing_rests(self) -> None:
        for figures, verdict in (({"meanHeight": 99.0}, "sound"), ({"overlap": 0.5}, "sound"), ({"contacts": 110}, "sound"),
                                 ({"contacts": 140}, "other contacts"), ({"meanSpeed": 1.2}, "other speeds")):
            self.assertEqual(judged(method(**figures), comparesSpeeds=True)["methods"][0]["verdict"], verdict, figures)

    def test_compares_nothing_with_an_invalid_run(self) -> None:
        burst = method("Chipmunk 7", False, escaped=5, contacts=None)
        result = judged(method(), method("Box2D 2.4.1", False), burst)
        self.assertEqual(burst["verdict"], "escaped")
        self.assertNotIn("cpuTimes", result["methods"][2])
        self.assertIn("cpuTimes", result["methods"][1])

    def test_requires_equal_bits_at_every_thread_count(self) -> None:
        ours, other = method(), method(threads=2, bits="cd", mean=1e-3)
        result = judged(ours, other, method("Box2D 2.4.1", False))
        self.assertEqual([one["verdict"] for one in result["methods"]], ["sound", "other bits", "sound"])
        self.assertAlmostEqual(other["speedUp"], 2.0)


class Words(unittest.TestCase):
    """For every verdict, with the numbers and names of the run."""

    def test_exist_for_each_verdict_and_hold_its_figures(self) -> None:
        kinds = [wrong for figures in ("resting", "moving") for *_, wrong in common.GOALS["likeness"][figures].values()]
        self.assertLessEqual({*kinds, "deep overlaps", "other bits"}, common.TEXTS["verdicts"].keys())
        for figures, name in (({"escaped": 3}, "3"), ({"awake": 2}, "2"), ({"found": 8}, "hits")):
            result = judged(method(**figures))
            self.assertIn(name, common.verdict_text(result["methods"][0], result).split())


class Goals(unittest.TestCase):
    """How goals stand."""

    def reached(self, ours: dict, *peers: dict) -> dict[str, tuple]:
        """Of the goals of a case, what is reached and whether that meets them."""
        reached = judged(ours, *peers, case="large-pyramid")["reached"]
        return {figure: (reached[figure], common.is_met(goal, reached[figure]))
                for figure, goal in common.GOALS["engine"]["large-pyramid"].items() if figure in reached}

    def test_compare_ours_with_box2d_threads_and_memory(self) -> None:
        two = method(threads=2, mean=1.2e-3)
        reached = self.reached(method(memory=15 * 1024 + 1), two, method("Box2D 2.4.1", False, cpu=13.9e-3))
        self.assertEqual({figure: met for figure, (_, met) in reached.items()},
                         {"times faster than Box2D 2.4": False, "speed-up of 2 threads": True, "memory [MB]": False})
        self.assertAlmostEqual(reached["times faster than Box2D 2.4"][0], 6.95)
        self.assertAlmostEqual(reached["speed-up of 2 threads"][0], 2.0 / 1.2)

    def test_are_missed_by_runs_that_differ_from_peers(self) -> None:
        reached = self.reached(method(meanHeight=20.0), method("Box2D 2.4.1", False, cpu=1.0))
        self.assertEqual(reached["times faster than Box2D 2.4"], (None, False))

    def test_are_left_out_where_nothing_is_compared(self) -> None:
        result = judged(method(), method("Chipmunk 7", False), case="pyramids")
        self.assertEqual(common.goal_table("engine", [result]), "")

    def test_compare_finite_numbers_only(self) -> None:
        self.assertTrue(common.is_met(["<=", 5], 5.0))
        self.assertFalse(common.is_met([">=", 7], 6.999))
        for value in (None, float("nan"), float("inf"), True):
            self.assertFalse(common.is_met(["<=", 5], value), value)


class Measure(BuildCase):
    """Running programs."""

    def test_runs_programs_in_turn_and_takes_medians(self) -> None:
        times = 'n=$(cat "$0.n" 2>/dev/null || echo 0); echo $((n + 1)) >"$0.n"; log "$(basename "$0")"\n'
        for name, cpus in (("boxreel_bench", (2e-3, 9e-3, 3e-3)), ("boxreel_bench_box2d", (8e-3, 7e-3, 1e-3))):
            lines = " ".join(f"'{engine_line(cpu=cpu, engine=name)}'" for cpu in cpus)
            self.program(name, f"{times}set -- {lines}\nshift $n\necho \"$1\"")
        options = argparse.Namespace(**{**vars(OPTIONS), "rounds": 3})
        result = engine.Engine().measure(self.folder / "build", SCENE, options, self.folder)
        self.assertEqual(self.calls(), ["boxreel_bench", "boxreel_bench_box2d"] * 3)
        self.assertEqual([one["cpu"] for one in result["methods"]], [3e-3, 7e-3])
        self.assertEqual([one["ours"] for one in result["methods"]], [True, False])

    def test_keeps_the_others_when_a_peer_fails(self) -> None:
        self.program("boxreel_bench", ENGINE)
        self.program("boxreel_bench_box2d", "exit 5")
        result = engine.Engine().measure(self.folder / "build", SCENE, OPTIONS, self.folder)
        engine.Engine().judge(result)
        self.assertEqual([one["verdict"] for one in result["methods"]], ["sound", "failed"])

    def test_reports_bits_that_vary_between_rounds(self) -> None:
        self.program("boxreel_bench", f"echo '{engine_line()}' | sed \"s/ab/$$/\"")
        result = engine.Engine().measure(self.folder / "build", SCENE, OPTIONS, self.folder)
        self.assertEqual(result["methods"][0]["bits"], "vary")


class Charts(unittest.TestCase):
    """The numbers that charts get."""

    def test_have_ratios_only_of_what_is_compared(self) -> None:
        peers = [method("Box2D 2.4.1", False, cpu=8e-3), method("Chipmunk 7", False, escaped=4)]
        for ours, expected in ((method(), [4.0, None]), (method(meanHeight=10.4), [None, None])):
            chart = engine.Engine().drawn([judged(ours, *peers)])[""]
            self.assertEqual([ratio for ratio, _ in chart.groups[0][3]], expected)

    def test_need_a_peer(self) -> None:
        result = {**SCENE, "methods": [method()]}
        engine.Engine().judge(result)
        with self.assertRaises(common.Problem) as caught:
            engine.Engine().drawn([result])
        self.assertEqual(caught.exception.code, 3)


if __name__ == "__main__":
    unittest.main()
