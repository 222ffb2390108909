# SPDX-License-Identifier: MIT
"""Golden tests of worlds, for pytest and for any other runner.

    import boxreel_golden

    def test_tower():
        world = build_tower()
        for _ in range(120):
            world.Step(1 / 60, 8, 3)
        boxreel_golden.check(world, "tower")

A world is compared at three depths: its state bit by bit, what it draws, and its pixels. The first run has no
reference: `pytest --boxreel-accept` stores what is missing or has changed. A failure leaves its pictures in the
folder golden-output; `boxreel golden report` makes a page of HTML of them.

pytest loads this module with `-p boxreel_golden`, or by the entry point of an installed package. Other runners use
the variables BOXREEL_GOLDEN_REFERENCES, BOXREEL_GOLDEN_OUTPUT and BOXREEL_GOLDEN_ACCEPT.
"""

import os

import _boxreel

_accepted = set()
_options = {}


def check(world, name, *, camera=None, size=(480, 270), preset="same-machine", references=None, output=None,
          accept=None):
    """Compares a world with its reference; raises AssertionError if they differ.

    references, output: folders; by default those of the environment, else `references` and `golden-output`.
    accept: none, missing, changed, all or this-renderer.
    """
    global _accepted
    width, height = size if camera is None else (camera.width, camera.height)
    folder = references or _options.get("references") or os.environ.get("BOXREEL_GOLDEN_REFERENCES", "references")
    results = output or os.environ.get("BOXREEL_GOLDEN_OUTPUT", "golden-output")
    mode = accept or _options.get("accept") or os.environ.get("BOXREEL_GOLDEN_ACCEPT", "none")
    texts = {"name": name, "preset": preset, "references": os.fspath(folder), "output": os.fspath(results), "accept": mode}
    name, preset, folder, results, mode = (_boxreel._text(text, argument) for argument, text in texts.items())
    passed, message, text, _accepted = _boxreel._check_golden(
        world, name, camera, width, height, preset, folder, results, mode, _accepted)
    if text:
        print(text)
    if not passed:
        raise AssertionError(message)


def pytest_addoption(parser):
    """Adds the options of pytest."""
    group = parser.getgroup("boxreel")
    group.addoption("--boxreel-accept", nargs="?", const="all", default=None,
                    choices=["missing", "changed", "all", "this-renderer"],
                    help="store worlds as references instead of comparing them (default: all)")
    group.addoption("--boxreel-references", default=None, help="folder of the references (default: references)")


def pytest_configure(config):
    """Reads the options of pytest."""
    _options["accept"] = config.getoption("--boxreel-accept", None)
    _options["references"] = config.getoption("--boxreel-references", None)
