# SPDX-License-Identifier: MIT
"""A machine on two pairs of legs walks by a rhythm of its motors: walker.py [FILM]"""

import math
import sys

import boxreel
from Box2D import b2EdgeShape, b2FixtureDef, b2PolygonShape, b2World

STEP = 1 / 60
HIP, KNEE = 0.4, 0.35  # how far the motors swing [rad]

world = b2World(gravity=(0, -10))
ground = [(x, 0.05 * math.sin(0.9 * x) if x > 4 else 0.0) for x in range(-10, 60)]
world.CreateStaticBody(shapes=[b2EdgeShape(vertices=pair) for pair in zip(ground, ground[1:])],
                       shapeFixture=b2FixtureDef(friction=1.0))


def part(position, size, density):
    return world.CreateDynamicBody(position=position, fixtures=b2FixtureDef(
        shape=b2PolygonShape(box=size), density=density, friction=1.0, groupIndex=-1))


def hinge(a, b, anchor, low, high):
    return world.CreateRevoluteJoint(bodyA=a, bodyB=b, anchor=anchor, enableLimit=True, lowerAngle=low, upperAngle=high,
                                     enableMotor=True, maxMotorTorque=220)


hull = part((0, 2.45), (2.0, 0.3), 1.0)
legs = []
for x in (-1.6, 1.6):
    for phase in (0.0, math.pi):
        thigh = part((x, 1.7), (0.16, 0.5), 1.0)
        shin = part((x, 0.75), (0.13, 0.55), 1.0)
        legs.append((hinge(hull, thigh, (x, 2.2), -0.9, 0.9), hinge(thigh, shin, (x, 1.25), -1.1, 0.1),
                     phase + (math.pi if x < 0 else 0)))


def follow(joint, target):
    """Drives a motor to an angle [rad]."""
    joint.motorSpeed = max(-8.0, min(8.0, 12 * (target - joint.angle)))


with boxreel.film(sys.argv[1] if len(sys.argv) > 1 else "walker.mp4", size=(640, 360), fps=60) as film:
    for frame in range(600):
        time = frame * STEP
        start = min(1.0, time / 1.5)  # the swing grows, so that it does not fall
        for hip, knee, phase in legs:
            angle = 6 * time + phase
            follow(hip, HIP * math.sin(angle) * start)
            # The knee bends while the leg swings forward.
            follow(knee, -0.1 - KNEE * max(0.0, math.cos(angle)) * 2 * start)
        world.Step(STEP, 8, 3)
        film.add(world, camera=boxreel.Camera(640, 360, center=(hull.position.x, 2.0), pixelsPerMeter=50))

print(f"walked to {hull.position.x:.1f} m, film {film.path}")
