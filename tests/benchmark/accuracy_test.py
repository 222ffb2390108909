# SPDX-License-Identifier: MIT
"""Error against time: sweeps, and verdicts."""
from __future__ import annotations

import argparse
import unittest

from support import BuildCase

from runner import accuracy, common

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
    """Of single runs."""

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


if __name__ == "__main__":
    unittest.main()
