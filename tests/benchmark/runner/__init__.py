# SPDX-License-Identifier: MIT
"""The benchmarks of boxreel: a module each, and what they share. Called by bench.py and docs/speed/speed.py."""
