#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Measures what Python adds to the engine, as JSON: ./boxreel python tests/benchmark/python_speed.py [ROUNDS]

The engine's own time is measured in C++ through the same world, without Python between the steps
(_boxreel._time_steps). All times are minima over the rounds [us].
"""

import json
import sys
import time

import _boxreel
from Box2D import b2EdgeShape, b2FixtureDef, b2PolygonShape, b2World


def small_world():
    world = b2World()
    world.CreateStaticBody(shapes=b2EdgeShape(vertices=[(-20, 0), (20, 0)]))
    for i in range(3):
        body = world.CreateDynamicBody(position=(2 * i, 0.5), shapes=b2PolygonShape(box=(0.5, 0.5)),
                                       shapeFixture=b2FixtureDef(density=1))
        body.sleepingAllowed = False
    return world


def best(rounds, function, count):
    """Returns the minimum over the rounds of the time of one call [us]."""
    result = float("inf")
    for _ in range(rounds):
        start = time.perf_counter()
        for _ in range(count):
            function()
        result = min(result, (time.perf_counter() - start) / count)
    return 1e6 * result


def measure(rounds=20):
    """Returns the figures by name."""
    world = small_world()
    for _ in range(100):
        world.Step(1 / 60, 8, 3)
    cpp = python = float("inf")
    for _ in range(rounds):  # in turns, so that both see the same machine
        cpp = min(cpp, 1e6 * _boxreel._time_steps(world, 5000))
        python = min(python, best(1, lambda: world.Step(1 / 60, 8, 3), 5000))
    crowd = b2World()
    shape = b2PolygonShape(box=(0.4, 0.4))
    for i in range(5000):
        crowd.CreateDynamicBody(position=(i % 100, i // 100), fixtures=b2FixtureDef(shape=shape, density=1))
    body = world.bodies[1]
    return {"step_cpp_us": cpp, "step_python_us": python, "step_overhead_us": python - cpp,
            "poses_5000_us": best(rounds, crowd.poses, 200),
            "position_us": best(rounds, lambda: body.position, 5000)}


if __name__ == "__main__":
    print(json.dumps(measure(int(sys.argv[1]) if len(sys.argv) > 1 else 20), indent=2))
