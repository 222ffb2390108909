# SPDX-License-Identifier: MIT
"""Drawing, recording and comparing: what is measured, what goals are for, and what is found."""
from __future__ import annotations

import argparse
import json
import unittest

from support import BuildCase

from runner import toolkit
from runner.common import GOALS, Problem, is_met

OPTIONS = argparse.Namespace(rounds=2, against=None, frames=0, size=[0, 0], peers=None)


def painted(name: str = "boxreel 1", ours: bool = True, threads: str = "0", rms: float = 0.8, **cpus: float) -> dict:
    """A renderer's figures."""
    times = {"full": 4e-3, "together": 4e-4, "apart": 4e-4, "none": 1e-5, "empty": 2e-3, "floor": 2e-3, **cpus}
    return {"method": name, "ours": ours, "threads": threads, "rms": rms, "most": 9.0, "edgePixels": 5, "wrong": "", "by": "Mesa",
            "works": {work: {"cpu": cpu, "wall": cpu} for work, cpu in times.items()}}


def picture(*methods: dict, case: str = "1500-720p", shapes: int = 1500) -> dict:
    """The result of a picture."""
    result = {"case": case, "what": "", "shapes": shapes, "width": 1280, "height": 720, "methods": list(methods)}
    toolkit.Drawing().judge(result)
    return result


class Drawing(BuildCase):
    """Frames and their errors."""

    def test_compares_one_thread_with_each_goal(self) -> None:
        reached = picture(painted(full=6e-3, empty=3e-3, rms=1.2), painted(threads="own", full=1e-3))["reached"]
        missed = {figure for figure, goal in GOALS["render"]["1500-720p"].items() if not is_met(goal, reached[figure])}
        self.assertEqual(missed, {"full redraw [ms]", "empty over clear and read", "RMSE at edges"})
        self.assertAlmostEqual(reached["full redraw [ms]"], 6.0)

    def test_misses_goals_with_wrong_frames(self) -> None:
        result = picture({**painted(), "wrong": "apart"})
        self.assertIsNone(result["reached"]["full redraw [ms]"])

    def test_measures_errors_once_and_times_in_turn(self) -> None:
        error = {"method": "boxreel 1", "rms": 0.8, "most": 9.0, "edgePixels": 5}
        time = {"method": "boxreel 1", "by": "Mesa", "works": {"full": {"cpu": 4e-3, "wall": 4e-3}}, "wrong": ""}
        self.program("boxreel_render_bench", f"log \"$@\"; [ $1 = error ] && echo '{json.dumps(error)}' || echo '{json.dumps(time)}'")
        case = {"case": "50-720p", "what": "", "shapes": 50, "width": 1280, "height": 720}
        result = toolkit.Drawing().measure(self.folder / "build", case, OPTIONS, self.folder)
        self.assertEqual(self.calls(), ["error 50-720p"] * 2 + ["time 50-720p 0", "time 50-720p own"] * 2)
        self.assertEqual([one["threads"] for one in result["methods"]], ["0", "own"])


def film(role: str, frames: int = 600, **figures: object) -> dict:
    """A sound film."""
    return {"role": role, "method": role, "ours": role not in toolkit.FILM_PEERS, "frames": frames, "wall": 3.0, "cpu": 5.0,
            "memory": 200e6, "bytes": 1e6, "seen": "sound", **figures}


def filmed(*films: dict, case: str = "pyramid", **more: object) -> dict:
    """The result of a case."""
    result = {"case": case, "what": "", "width": 1280, "height": 720, "from": 0.0, "frames": 600, "resized": False, "cached": 1.0,
              "methods": list(films), "stages": [{"stage": "drawing", "thread": "main", "cpu": 1e-3, "wall": 2e-3}], **more}
    toolkit.Recording().judge(result)
    return result


class Recording(BuildCase):
    """Films."""

    def test_compares_ours_with_the_peers(self) -> None:
        reached = filmed(film("boxreel"), film("encodeOnly", wall=4.0, memory=150e6), film("immediate", wall=12.0))["reached"]
        self.assertEqual([reached[f"wall time over {name}"] for name in ("encoding only", "immediate mode")], [0.75, 0.25])
        self.assertAlmostEqual(reached["memory over the encoder's [MB]"], 50.0)
        self.assertAlmostEqual(reached["bytes over encoding only"], 1.0)

    def test_misses_goals_with_broken_films(self) -> None:
        for broken in (0, 1):
            films = [film("boxreel"), film("encodeOnly", wall=4.0)]
            films[broken]["seen"] = "599 frames"
            result = filmed(*films)
            self.assertEqual(films[broken]["verdict"], "unlike")
            self.assertIsNone(result["reached"]["wall time over encoding only"])

    def test_compares_resting_frames_with_moving_ones(self) -> None:
        films = [film("boxreel", 601, wall=1.6), film("start", 1, wall=1.0), film("moving", 421, wall=5.2),
                 film("movingStart", 1, wall=1.0)]
        self.assertAlmostEqual(filmed(*films, case="asleep")["reached"]["times faster than moving"], 10.0)

    def test_has_no_goals_for_films_of_another_size(self) -> None:
        self.assertEqual(filmed(film("boxreel"), resized=True)["reached"], {})

    def test_keeps_our_film_when_a_peer_fails(self) -> None:
        result = filmed(film("boxreel"), {"role": "immediate", "method": "immediate", "ours": False, "frames": 600, "failure": "no GL"})
        self.assertEqual(result["methods"][1]["verdict"], "not made")

    def test_reports_a_full_disk_before_it_records(self) -> None:
        take = {"frames": 10**9, "width": 1280, "height": 720, "from": 0, "take": []}
        self.program("boxreel_record_bench", f"log \"$1\"; echo '{json.dumps(take)}'")
        with self.assertRaises(Problem) as caught:
            toolkit.Recording().measure(self.folder / "build", {"case": "pyramid", "what": ""}, OPTIONS, self.folder)
        self.assertEqual(caught.exception.code, 4)
        self.assertIn("TMPDIR", str(caught.exception))
        self.assertEqual(self.calls(), ["films"])


class Comparing(BuildCase):
    """Pictures with planted changes."""

    def build(self, decoded: str = "true") -> None:
        """Two pairs, of which the first differs; our programs find that."""
        self.program("boxreel_golden_bench", f"""case $1 in
list) echo '{{"change":"body","what":"moved","truth":"different"}}'; echo '{{"change":"equal","what":"same","truth":"equal"}}' ;;
plant) for c in body equal; do echo '{{"change":"'$c'","expected":"'$c'-a.png","actual":"'$c'-b.png"}}'; done ;;
time) echo '{{"method":"boxreel 1, '$2'","different":{decoded},"decodedSeconds":2e-4}}'
      echo '{{"method":"boxreel 1, '$2'","different":false,"decodedSeconds":1e-4}}' ;;
esac""")
        program = self.folder / "build" / "boxreel"
        program.write_text('#!/bin/sh\ncase $2 in *body*) exit 2 ;; esac\n', encoding="utf-8")
        program.chmod(0o755)

    def measured(self, **options: object) -> dict:
        """The result of a scene."""
        result = toolkit.Comparing().measure(self.folder / "build", toolkit.Comparing().cases(self.folder)[0],
                                               argparse.Namespace(**{**vars(OPTIONS), **options}), self.folder)
        toolkit.Comparing().judge(result)
        return result

    def test_counts_found_missed_and_false_alarms(self) -> None:
        self.build()
        result = self.measured()
        ours = result["methods"][0]
        self.assertEqual([one["different"] for one in ours["pictures"]], [True, False])
        ours["pictures"][0]["different"], ours["pictures"][1]["different"] = False, True
        row = next(line for line in toolkit.Comparing().text([result]).splitlines() if "same-machine" in line)
        self.assertEqual(row.split()[3:5], ["0/1!", "1/1!"])

    def test_takes_the_median_of_both_clocks(self) -> None:
        self.build()
        ours = self.measured()["methods"][0]
        self.assertEqual(ours["method"], "boxreel 1, same-machine")
        self.assertAlmostEqual(ours["decoded"], 1.5e-4)
        self.assertGreater(ours["process"], 0.0)

    def test_refuses_a_program_with_another_verdict(self) -> None:
        self.build(decoded="false")
        with self.assertRaises(Problem) as caught:
            self.measured()
        self.assertIn("'body'", str(caught.exception))

    def test_names_absent_peers_with_their_packages(self) -> None:
        self.build()
        result = self.measured()
        self.assertLessEqual({"odiff-bin", "pixelmatch"}, set(result["absent"]))
        self.assertIn("npm install pixelmatch", toolkit.Comparing().text([result]))

    def test_runs_peers_of_a_folder(self) -> None:
        self.build()
        modules = self.folder / "npm" / "node_modules"
        for path, text in (("odiff-bin/package.json", '{"version":"4.5.0"}'),
                           ("@odiff/linux/odiff", '#!/bin/sh\ncase $1 in *body*) exit 22 ;; esac\n')):
            (modules / path).parent.mkdir(parents=True)
            (modules / path).write_text(text, encoding="utf-8")
        (modules / "@odiff/linux/odiff").chmod(0o755)
        found = {one["method"]: [picture["different"] for picture in one["pictures"]]
                 for one in self.measured(peers=str(self.folder / "npm"))["methods"]}
        self.assertEqual((found["odiff 4.5.0"], found["odiff 4.5.0, 0.01"]), ([True, False], [True, False]))

    def test_refuses_a_folder_without_peers(self) -> None:
        self.build()
        with self.assertRaises(Problem) as caught:
            self.measured(peers=str(self.folder))
        self.assertIn(str(self.folder), str(caught.exception))


if __name__ == "__main__":
    unittest.main()
