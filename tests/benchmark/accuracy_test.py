# SPDX-License-Identifier: MIT
"""Error against time: sweeps, verdicts, the summary, and what charts show."""
from __future__ import annotations

import argparse
import json
import unittest

from support import BuildCase

from runner import accuracy, charts, common

OPTIONS = argparse.Namespace(rounds=3, against=None)
ACCURACY = accuracy.Accuracy()
ANSWER = """case $1 in
accuracy-list) echo '{"case":"A-projectile","what":"thrown","unit":"m","maxSubSteps":MOST}' ;;
accuracy)
    [ $# -eq 6 ] && log "$(basename "$0")" "$@"
    [ $# -eq 7 ] && { echo '{"cpu":AGAIN}'; exit; }
    echo '{"engine":"'$(basename "$0")'","velocityIterations":'$3',"positionIterations":'$4',"hz":'$5',"subSteps":'$6',"error":0.5,
"steps":100,"cpu":FIRST,"held":true,"ending":"","remarks":{}}' | tr -d '\\n'
    echo ;;
esac"""


def one(engine: str = "boxreel", steps: int = 1, error: float | None = 1e-5, **more: object) -> dict:
    """A run with the usual settings."""
    program = "boxreel_bench_box2d" if "Box2D" in engine else "boxreel_bench"
    return {"program": program, "engine": engine, "velocityIterations": 8, "positionIterations": 3, "hz": 60, "subSteps": steps, "error": error,
            "cpu": 1e-6, "held": True, "ending": "", "remarks": {}, **more}


def judged(*runs: dict, case: str = "A-projectile") -> dict:
    """A result."""
    result = {"case": case, "what": "thrown", "unit": "m", "runs": list(runs)}
    ACCURACY.judge(result)
    return result


class Sweep(BuildCase):
    """Running programs."""

    def measured(self, first: str, again: str) -> list[dict]:
        """The runs of two engines, of which one has sub-steps."""
        for name, most in (("boxreel_bench", "4"), ("boxreel_bench_box2d", "1")):
            self.program(name, ANSWER.replace("MOST", most).replace("FIRST", first).replace("AGAIN", again))
        case = ACCURACY.cases(self.folder / "build")[0]
        return ACCURACY.measure(self.folder / "build", case, OPTIONS, self.folder)["runs"]

    def test_varies_iterations_rates_and_sub_steps(self) -> None:
        runs = self.measured("1e-5", "1e-5")
        self.assertEqual(len(runs), 4 * 4 * (3 + 1))
        self.assertEqual({run["subSteps"] for run in runs if run["engine"] == "boxreel_bench"}, {1, 2, 4})
        self.assertEqual(len({(run["velocityIterations"], run["hz"]) for run in runs}), 16)

    def test_takes_engines_in_turn(self) -> None:
        self.measured("1e-5", "1e-5")
        self.assertEqual([call.split()[0] for call in self.calls()[:4]], ["boxreel_bench", "boxreel_bench_box2d"] * 2)

    def test_keeps_the_minimum_time_of_the_rounds(self) -> None:
        self.assertEqual({run["cpu"] for run in self.measured("1e-5", "7e-6")}, {7e-6})

    def test_measures_long_runs_once(self) -> None:
        self.assertEqual({run["cpu"] for run in self.measured("1e-2", "1e-9")}, {1e-2})

    def test_keeps_the_others_when_an_engine_fails(self) -> None:
        self.program("boxreel_bench", ANSWER.replace("MOST", "1").replace("FIRST", "1").replace("AGAIN", "1"))
        self.program("boxreel_bench_box2d", ANSWER.replace("accuracy)", "accuracy) exit 5").replace("MOST", "1"))
        result = ACCURACY.measure(self.folder / "build", {"case": "A-projectile", "what": "", "unit": "m"}, OPTIONS, self.folder)
        ACCURACY.judge(result)
        self.assertEqual([run["verdict"] for run in result["runs"]].count("failed"), 16)


class Verdicts(unittest.TestCase):
    """Of single runs, and the summary."""

    def test_judge_error_ending_and_remarks(self) -> None:
        for run, case, verdict in ((one(error=1e-4), "A-projectile", "met"), (one(error=2e-4), "A-projectile", "missed"),
                                   (one(error=None), "A-projectile", "not finite"), (one(held=False), "A-projectile", "not finite"),
                                   (one(ending="falls"), "A-projectile", "falls"),
                                   (one(remarks={"gap_mm": 0.05}), "B-pendulum", "met"),
                                   (one(remarks={"gap_mm": 0.3}), "B-pendulum", "missed"),
                                   (one(error=0.0, remarks={}), "X-walls-100", "missed"),
                                   (one(error=9.0), "not-a-case", "met")):
            self.assertEqual(judged(run, case=case)["runs"][0]["verdict"], verdict, run)

    def test_name_the_goals_that_are_missed(self) -> None:
        for run, case, missed in ((one(error=2e-4), "A-projectile", [("error", 2e-4, ["<=", 1e-4])]),
                                  (one(remarks={"gap_mm": 0.3}), "B-pendulum", [("gap_mm", 0.3, ["<=", 0.1])]),
                                  (one(error=0.0), "X-walls-100", [("energy_kept_percent", None, [">=", 98])])):
            self.assertEqual(common.missed_goals(run, judged(run, case=case)), missed)

    def test_compare_settings_by_the_time_of_a_frame(self) -> None:
        self.assertAlmostEqual(judged(one(hz=480))["runs"][0]["cpuOfFrame"], 8e-6)

    def test_are_summed_up_beside_box2d(self) -> None:
        runs = [one(steps=1), one(steps=2), one(steps=4, cpu=3e-6), one("Box2D 2.4.1", error=0.5, cpu=2e-6)]
        two, four = ([line for line in accuracy.summary([judged(*runs)], steps).splitlines()][1] for steps in (2, 4))
        self.assertTrue(two.endswith("2.00×  goal met"), two)
        self.assertTrue(four.endswith("0.67×  goal met, slower"), four)

    def test_report_missed_goals_in_the_summary(self) -> None:
        line = accuracy.summary([judged(one(error=1.0), one(steps=2, error=1.0))], 2).splitlines()[1]
        self.assertTrue(line.endswith("goal not met"), line)


class Charts(unittest.TestCase):
    """What charts show."""

    def drawn(self, *runs: dict) -> charts.Lines:
        """The chart of a case."""
        return ACCURACY.drawn([judged(*runs)])["A-projectile"]

    def test_have_a_curve_for_each_setting_that_varies(self) -> None:
        runs = [one(steps=steps) for steps in (1, 2, 4)] + [one(steps=4, hz=120), one(steps=2, hz=240)]
        curves = self.drawn(*runs, one("Box2D 2.4.1"), one("Box2D 2.4.1", hz=120)).curves
        self.assertEqual([(curve.name, curve.stroke, len(curve.points)) for curve in curves],
                         [("boxreel", "-", 3), ("boxreel", "--", 2), ("boxreel", "", 1), ("Box2D 2.4.1", "--", 2)])
        self.assertEqual([point.label for point in curves[0].points], ["1", "2", "4 sub-steps"])
        self.assertEqual([point.mark for point in curves[0].points], [".", ".", "o"])

    def test_always_name_the_usual_settings_and_the_end(self) -> None:
        curve = self.drawn(*(one(steps=steps) for steps in (1, 2, 4, 8))).curves[0]
        self.assertEqual([point.label for point in curve.points], ["1", "2", "4", "8 sub-steps"])
        self.assertEqual([point.optional for point in curve.points], [True, True, False, False])

    def test_mark_failed_runs_with_a_cross(self) -> None:
        curve = self.drawn(one(steps=1, ending="falls"), one(steps=2, error=None, held=False), one(steps=4)).curves[0]
        self.assertEqual([(point.mark, point.y) for point in curve.points], [("x", 1e-4 / 10), ("x", None), ("o", 1e-5)])

    def test_draw_errors_of_zero_at_the_minimum(self) -> None:
        chart = self.drawn(one(error=0.0), one(steps=4, error=0.0))
        self.assertEqual({point.y for point in chart.curves[0].points}, {chart.floor[0]})
        self.assertEqual(chart.floor, (1e-8, "≤ 1e-08"))

    def test_are_omitted_when_all_runs_failed(self) -> None:
        self.assertEqual(ACCURACY.drawn([judged(one(ending="falls"))]), {})


if __name__ == "__main__":
    unittest.main()
