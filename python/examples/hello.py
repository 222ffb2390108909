# SPDX-License-Identifier: MIT
"""A ball and a box fall on the ground; five seconds as a film: hello.py [FILM]"""

import sys

import boxreel
from Box2D import b2EdgeShape, b2World

world = b2World(gravity=(0, -10))
world.CreateStaticBody(shapes=b2EdgeShape(vertices=[(-12, 0), (12, 0)]))
ball = world.CreateDynamicBody(position=(-1, 8))
ball.CreateCircleFixture(radius=0.8, density=1, restitution=0.7)
box = world.CreateDynamicBody(position=(1.5, 6), angle=0.6)
box.CreatePolygonFixture(box=(1, 0.6), density=1, friction=0.5)

with boxreel.film(sys.argv[1] if len(sys.argv) > 1 else "hello.mp4", size=(640, 360), fps=60) as film:
    for _ in range(300):
        world.Step(1 / 60, 8, 3)
        film.add(world)

print(f"ball at {ball.position}, box at {box.position}, film {film.path}")
