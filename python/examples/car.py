# SPDX-License-Identifier: MIT
"""A car seen from above drives around a track, steered at points of its middle line: car.py [FILM]"""

import math
import sys

import boxreel
from Box2D import b2FixtureDef, b2PolygonShape, b2Vec2, b2World

STEP = 1 / 50

world = b2World(gravity=(0, 0))
middle = []
for i in range(60):
    turn = 2 * math.pi * i / 60
    radius = 26 + 5 * math.sin(3 * turn)
    middle.append(b2Vec2(1.35 * radius * math.cos(turn), radius * math.sin(turn)))
for i, point in enumerate(middle):  # the tiles are sensors: seen, not felt
    ahead = middle[(i + 1) % len(middle)]
    across = (ahead - point).skew
    across.Normalize()
    tile = world.CreateStaticBody(fixtures=b2FixtureDef(isSensor=True, shape=b2PolygonShape(vertices=[
        point - 4 * across, point + 4 * across, ahead + 4 * across, ahead - 4 * across])))


class Car:
    def __init__(self, position, angle):
        self.hull = world.CreateDynamicBody(position=position, angle=angle, fixtures=b2FixtureDef(
            shape=b2PolygonShape(vertices=[(-0.9, -2), (0.9, -2), (0.9, 1.2), (0.5, 2.2), (-0.5, 2.2), (-0.9, 1.2)]),
            density=1, groupIndex=-1))
        self.wheels = []
        for x, y, steers in ((-1, 1.4, True), (1, 1.4, True), (-1, -1.4, False), (1, -1.4, False)):
            wheel = world.CreateDynamicBody(position=self.hull.GetWorldPoint((x, y)), angle=angle, fixtures=b2FixtureDef(
                shape=b2PolygonShape(box=(0.25, 0.5)), density=0.3, groupIndex=-1))
            wheel.steers = steers
            wheel.joint = world.CreateRevoluteJoint(bodyA=self.hull, bodyB=wheel, anchor=wheel.position, enableLimit=True,
                                                    lowerAngle=-0.5, upperAngle=0.5, enableMotor=True, maxMotorTorque=200)
            self.wheels.append(wheel)

    def drive(self, target, speed):
        """Steers at a point of the world [m] and keeps a speed [m/s]."""
        local = self.hull.GetLocalPoint(target)
        steer = max(-0.5, min(0.5, math.atan2(-local.x, local.y)))
        for wheel in self.wheels:
            angle = steer if wheel.steers else 0.0
            wheel.joint.motorSpeed = max(-4.0, min(4.0, 20 * (angle - wheel.joint.angle)))
            forward, side = wheel.GetWorldVector((0, 1)), wheel.GetWorldVector((1, 0))
            grip = -60 * wheel.linearVelocity.dot(side)
            push = 12 * (speed - wheel.linearVelocity.dot(forward))
            wheel.ApplyForceToCenter(max(-40.0, min(40.0, grip)) * side + max(-20.0, min(20.0, push)) * forward, True)


start = middle[1] - middle[0]
car = Car(middle[0], math.atan2(-start.x, start.y))
camera = boxreel.Camera(640, 360, center=(0, 0), pixelsPerMeter=5.0)
goal, path = 3, []
with boxreel.film(sys.argv[1] if len(sys.argv) > 1 else "car.mp4", size=(640, 360), fps=50) as film:
    for _ in range(900):
        while (middle[goal % len(middle)] - car.hull.position).length < 8:
            goal += 1
        car.drive(middle[goal % len(middle)], 13)
        world.Step(STEP, 8, 3)
        path.append(car.hull.position.tuple)
        film.add(world, camera=camera, trails=[path])

print(f"passed {goal} points of the track, film {film.path}")
