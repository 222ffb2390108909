# SPDX-License-Identifier: MIT
"""The benchmark of the module works, and a process has room for many worlds. No time is checked: machines are shared."""

import os
import resource
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "benchmark"))
import python_speed  # noqa: E402


class Speed(unittest.TestCase):
    def test_benchmark_measures(self):
        found = python_speed.measure(1)
        self.assertGreater(min(found["step_python_us"], found["poses_5000_us"]), 0)

    def test_a_thousand_worlds_take_less_than_400_mb(self):
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        worlds = [python_speed.small_world() for _ in range(1000)]
        for world in worlds:
            world.Step(1 / 60, 8, 3)
        grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
        self.assertLess(grown, 400 * 1024)  # kB


if __name__ == "__main__":
    unittest.main()
