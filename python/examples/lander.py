# SPDX-License-Identifier: MIT
"""A craft lands on its two legs by a controller that knows position and velocity: lander.py [FILM]"""

import math
import sys

import boxreel
from Box2D import b2ContactListener, b2EdgeShape, b2FixtureDef, b2PolygonShape, b2World

STEP = 1 / 50


class Legs(b2ContactListener):
    """Counts the legs that stand on something."""

    def __init__(self):
        super().__init__()
        self.standing = set()

    def _leg(self, contact):
        for body in (contact.fixtureA.body, contact.fixtureB.body):
            if getattr(body, "is_leg", False):
                return body
        return None

    def BeginContact(self, contact):
        leg = self._leg(contact)
        if leg is not None:
            self.standing.add(leg)

    def EndContact(self, contact):
        self.standing.discard(self._leg(contact))


class Lander:
    def __init__(self):
        self.legs = Legs()
        self.world = b2World(gravity=(0, -3), contactListener=self.legs)
        heights = [3.0, 2.2, 2.6, 1.2, 0.6, 0.6, 0.6, 1.4, 1.0, 2.4, 3.4]
        points = [(4 * i - 20, height) for i, height in enumerate(heights)]
        self.world.CreateStaticBody(shapes=[b2EdgeShape(vertices=pair) for pair in zip(points, points[1:])],
                                    shapeFixture=b2FixtureDef(friction=0.8))
        self.hull = self.world.CreateDynamicBody(position=(-9, 15), angle=0.25, linearVelocity=(3, 0), fixtures=b2FixtureDef(
            shape=b2PolygonShape(vertices=[(-1, 0), (1, 0), (0.7, 1.2), (-0.7, 1.2)]), density=1, friction=0.5))
        for side in (-1, 1):
            leg = self.world.CreateDynamicBody(
                position=self.hull.GetWorldPoint((side * 1.2, -0.3)), angle=self.hull.angle + 0.35 * side,
                fixtures=b2FixtureDef(shape=b2PolygonShape(box=(0.12, 0.7)), density=0.6, friction=0.9, groupIndex=-1))
            leg.is_leg = True
            self.world.CreateRevoluteJoint(bodyA=self.hull, bodyB=leg, anchor=self.hull.GetWorldPoint((side * 0.9, 0.3)),
                                           enableLimit=True, lowerAngle=-0.15, upperAngle=0.15, enableMotor=True,
                                           maxMotorTorque=6, motorSpeed=-side * 0.5)
        self.mass = sum(body.mass for body in self.world if body.mass)

    def control(self):
        """Thrusts upwards along the hull and turns it, so that it comes down slowly above the flat part."""
        if len(self.legs.standing) == 2:
            return
        hull = self.hull
        position, velocity = hull.position, hull.linearVelocity
        lean = max(-0.35, min(0.35, 0.10 * position.x + 0.28 * velocity.x))
        hull.ApplyTorque(30 * (lean - hull.angle) - 18 * hull.angularVelocity, True)
        sinking = -0.5 - 0.22 * max(0.0, position.y - 2.2)
        thrust = self.mass * (3 + 2.5 * (sinking - velocity.y)) / max(0.5, math.cos(hull.angle))
        hull.ApplyForce(hull.GetWorldVector((0, max(0.0, thrust))), hull.worldCenter, True)

    def step(self):
        self.control()
        self.world.Step(STEP, 8, 3)


lander = Lander()
camera = boxreel.Camera(640, 360, center=(0, 8), pixelsPerMeter=20)
path = []
with boxreel.film(sys.argv[1] if len(sys.argv) > 1 else "lander.mp4", size=(640, 360), fps=50) as film:
    for _ in range(600):
        lander.step()
        path.append(lander.hull.worldCenter.tuple)
        film.add(lander.world, camera=camera, trails=[path])

print(f"{len(lander.legs.standing)} legs stand, hull at {lander.hull.position}, film {film.path}")
