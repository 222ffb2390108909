# SPDX-License-Identifier: MIT
"""Small programs of our own that use the module as well-known ones do: a lander, a walker, a car seen from above,
and a test bed; and the examples of python/examples."""

import math
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import _boxreel
import Box2D
from Box2D.b2 import (circleShape, contactListener, edgeShape, fixtureDef, polygonShape, rayCastCallback,
                      revoluteJointDef)

EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "python", "examples")


class Touch(contactListener):
    def __init__(self, env):
        contactListener.__init__(self)
        self.env = env

    def BeginContact(self, contact):
        if self.env.hull == contact.fixtureA.body or self.env.hull == contact.fixtureB.body:
            self.env.game_over = True
        for leg in self.env.legs:
            if leg in [contact.fixtureA.body, contact.fixtureB.body]:
                leg.ground_contact = True

    def EndContact(self, contact):
        for leg in self.env.legs:
            if leg in [contact.fixtureA.body, contact.fixtureB.body]:
                leg.ground_contact = False


class Lidar(rayCastCallback):
    def ReportFixture(self, fixture, point, normal, fraction):
        if (fixture.filterData.categoryBits & 1) == 0:
            return -1
        self.p2 = point
        self.fraction = fraction
        return fraction


class Craft:
    """A hull on two legs above flat ground."""

    def __init__(self, motors=False):
        self.world = Box2D.b2World()
        self.game_over = False
        self.listener = Touch(self)
        self.world.contactListener = self.listener
        self.ground = self.world.CreateStaticBody(shapes=edgeShape(vertices=[(-20, 0), (20, 0)]))
        self.ground.CreateEdgeFixture(vertices=[(20, 0), (20, 5)], density=0, friction=0.1)
        self.hull = self.world.CreateDynamicBody(
            position=(0, 4), angle=0.0,
            fixtures=fixtureDef(shape=polygonShape(vertices=[(-0.5, 0), (0.5, 0), (0.4, 0.6), (-0.4, 0.6)]), density=5.0,
                                friction=0.1, categoryBits=0x0010, maskBits=0x001, restitution=0.0))
        self.hull.color1 = (128, 102, 230)
        self.hull.ApplyForceToCenter((np.float64(1.0), np.float32(0.5)), True)
        self.legs, self.joints = [], []
        for i in [-1, +1]:
            leg = self.world.CreateDynamicBody(
                position=(0.6 * i, 3.5), angle=i * 0.05,
                fixtures=fixtureDef(shape=polygonShape(box=(0.1, 0.5)), density=1.0, restitution=0.0, categoryBits=0x20,
                                    maskBits=0x001))
            leg.ground_contact = False
            rjd = revoluteJointDef(bodyA=self.hull, bodyB=leg, localAnchorA=(0.5 * i, 0), localAnchorB=(0, 0.4),
                                   enableMotor=True, enableLimit=True, maxMotorTorque=40, motorSpeed=+0.3 * i,
                                   lowerAngle=-0.4, upperAngle=0.4)
            if motors:
                rjd.lowerAngle, rjd.upperAngle = -0.8, 0.8
            self.joints.append(self.world.CreateJoint(rjd))
            leg.joint = self.joints[-1]
            self.legs.append(leg)
        self.drawlist = [self.hull] + self.legs

    def step(self):
        self.world.Step(1.0 / 50, 6 * 30, 2 * 30)


class Programs(unittest.TestCase):
    def test_lander_stands_on_its_legs(self):
        craft = Craft()
        for _ in range(200):
            tip = math.sin(craft.hull.angle), math.cos(craft.hull.angle)
            if craft.hull.linearVelocity.y < -1.5:
                place = craft.hull.position[0] - tip[0], craft.hull.position[1]
                craft.hull.ApplyLinearImpulse((tip[0] * 1.6, tip[1] * 1.6), place, True)
            craft.step()
        self.assertEqual([leg.ground_contact for leg in craft.legs], [True, True])
        self.assertFalse(craft.game_over)
        self.assertLess(abs(craft.hull.angle), 0.1)
        for body in craft.drawlist:
            for fixture in body.fixtures:
                self.assertIs(type(fixture.shape), polygonShape)
                path = [fixture.body.transform * vertex for vertex in fixture.shape.vertices]
                self.assertEqual(len(path), 4)

    def test_walker_sees_the_ground_and_moves_its_joints(self):
        craft = Craft(motors=True)
        lidar = [Lidar() for _ in range(10)]
        for frame in range(50):
            for joint in craft.joints:
                joint.motorSpeed = float(4 * np.sign(math.sin(frame / 5)))
                joint.maxMotorTorque = float(80 * np.clip(abs(1.0), 0, 1))
            craft.step()
            for i, ray in enumerate(lidar):
                ray.fraction = 1.0
                ray.p1 = craft.hull.position
                ray.p2 = ray.p1[0] + math.sin(0.15 * i) * 10, ray.p1[1] - math.cos(0.15 * i) * 10
                craft.world.RayCast(ray, ray.p1, ray.p2)
        self.assertTrue(all(ray.fraction < 1 for ray in lidar[:5]))
        self.assertAlmostEqual(lidar[0].p2.y, 0, 2)
        state = [craft.hull.angle, craft.hull.linearVelocity.x, craft.joints[0].angle, craft.joints[0].speed]
        self.assertTrue(all(isinstance(number, float) for number in state))

    def test_car_from_above_steers_over_tiles(self):
        world = Box2D.b2World((0, 0), contactListener=(listener := Tiles()))
        tile_def = fixtureDef(shape=polygonShape(vertices=[(0, 0), (1, 0), (1, -1), (0, -1)]))
        tiles = []
        for i in range(20):
            tile_def.shape.vertices = [(-6, 4 * i), (6, 4 * i), (6, 4 * i + 4), (-6, 4 * i + 4)]
            tile = world.CreateStaticBody(fixtures=tile_def)
            tile.userData = tile
            tile.road_visited = False
            tile.fixtures[0].sensor = True
            tiles.append(tile)
        hull = world.CreateDynamicBody(position=(0, 2), angle=0.0, fixtures=[
            fixtureDef(shape=polygonShape(vertices=[(-1, -2), (1, -2), (1, 2), (-1, 2)]), density=1.0)])
        wheels = []
        for x, y in [(-1, 1.5), (1, 1.5), (-1, -1.5), (1, -1.5)]:
            wheel = world.CreateDynamicBody(position=(x, 2 + y), angle=0.0, fixtures=fixtureDef(
                shape=polygonShape(box=(0.3, 0.5)), density=0.1, categoryBits=0x0020, maskBits=0x001, restitution=0.0))
            wheel.joint = world.CreateJoint(revoluteJointDef(
                bodyA=hull, bodyB=wheel, localAnchorA=(x, y), localAnchorB=(0, 0), enableMotor=True, enableLimit=True,
                maxMotorTorque=1000, motorSpeed=0, lowerAngle=-0.4, upperAngle=+0.4))
            wheel.tiles = set()
            wheel.userData = wheel
            wheels.append(wheel)
        for _ in range(150):
            for i, wheel in enumerate(wheels):
                steer = 0.1 if i < 2 else 0.0
                wheel.joint.motorSpeed = float(np.sign(steer - wheel.joint.angle) * min(50 * abs(steer - wheel.joint.angle), 3))
                forward, side = wheel.GetWorldVector((0, 1)), wheel.GetWorldVector((1, 0))
                v = wheel.linearVelocity
                slip = side[0] * v[0] + side[1] * v[1]
                wheel.ApplyForceToCenter((-slip * 5 * side[0] + 10 * forward[0], -slip * 5 * side[1] + 10 * forward[1]), True)
            world.Step(1.0 / 50, 6 * 30, 2 * 30)
        self.assertGreater(hull.position.y, 6)
        self.assertGreater(sum(tile.road_visited for tile in tiles), 2)
        self.assertGreater(listener.count, 2)
        for tile in tiles:
            world.DestroyBody(tile)
        self.assertTrue(all(not wheel.tiles for wheel in wheels))

    def test_test_bed_drags_a_body_with_the_mouse(self):
        from Box2D import (b2_dynamicBody, b2AABB, b2ContactListener, b2DestructionListener, b2GetPointStates,
                           b2QueryCallback, b2Vec2, b2World)

        class Query(b2QueryCallback):
            def __init__(self, p):
                super(Query, self).__init__()
                self.point, self.fixture = p, None

            def ReportFixture(self, fixture):
                if fixture.body.type == b2_dynamicBody and fixture.TestPoint(self.point):
                    self.fixture = fixture
                    return False
                return True

        class Bed(b2ContactListener):
            def __init__(self):
                super(Bed, self).__init__()
                self.points = []
                self.world = b2World(gravity=(0, -10), doSleep=True)
                self.world.destructionListener = b2DestructionListener()
                self.world.contactListener = self
                self.ground = self.world.CreateBody()
                self.ground.CreateEdgeFixture(vertices=[(-20, 0), (20, 0)])

            def PreSolve(self, contact, old_manifold):
                state1, state2 = b2GetPointStates(old_manifold, contact.manifold)
                for i, point in enumerate(state2):
                    if point == Box2D.b2_addState:
                        self.points.append((contact.fixtureA, contact.worldManifold.points[i]))

        bed = Bed()
        box = bed.world.CreateDynamicBody(position=(0, 0.6), shapes=polygonShape(box=(0.5, 0.5)),
                                          shapeFixture=fixtureDef(density=1))
        bed.world.Step(1 / 60, 8, 3)
        p = b2Vec2(0.25, 0.5)
        query = Query(p)
        bed.world.QueryAABB(query, b2AABB(lowerBound=p - (0.001, 0.001), upperBound=p + (0.001, 0.001)))
        self.assertIs(query.fixture.body, box)
        mouse = bed.world.CreateMouseJoint(bodyA=bed.ground, bodyB=box, target=p, maxForce=1000.0 * box.mass)
        box.awake = True
        for i in range(60):
            mouse.target = p + (0.05 * i, 0.05 * i)
            bed.world.Step(1 / 60, 8, 3)
        self.assertGreater(box.position.x, 1.5)
        bed.world.DestroyJoint(mouse)
        for _ in range(120):
            bed.world.Step(1 / 60, 8, 3)
        self.assertGreater(len(bed.points), 0)


class Tiles(contactListener):
    count = 0

    def BeginContact(self, contact):
        self.note(contact, True)

    def EndContact(self, contact):
        self.note(contact, False)

    def note(self, contact, begins):
        data = contact.fixtureA.body.userData, contact.fixtureB.body.userData
        tile = next((item for item in data if item and hasattr(item, "road_visited")), None)
        wheel = next((item for item in data if item and hasattr(item, "tiles")), None)
        if tile is None or wheel is None:
            return
        if begins:
            wheel.tiles.add(tile)
            tile.road_visited = True
            self.count += 1
        else:
            wheel.tiles.remove(tile)


class Examples(unittest.TestCase):
    def test_each_runs_and_films(self):
        for name in sorted(os.listdir(EXAMPLES)):
            if name.endswith(".py"):
                with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                    film = os.path.join(folder, "film.mp4")
                    subprocess.run([sys.executable, os.path.join(EXAMPLES, name), film], check=True, cwd=folder,
                                   env={**os.environ, "PYTHONPATH": os.path.dirname(_boxreel.__file__)})
                    self.assertGreater(os.path.getsize(film), 5000)


class Page(unittest.TestCase):
    def test_first_program_and_pictures_run(self):
        page = os.path.join(EXAMPLES, "..", "..", "docs", "python.md")
        with open(page, encoding="utf-8") as file:
            blocks = [part.partition("```")[0] for part in file.read().split("```python\n")[1:]]
        first = next(block for block in blocks if "hello.mp4" in block)
        pictures = next(block for block in blocks if "boxreel.shot" in block)
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, "-c", first + pictures], check=True, cwd=folder,
                           env={**os.environ, "PYTHONPATH": os.path.dirname(_boxreel.__file__)})
            self.assertEqual(set(os.listdir(folder)), {"hello.mp4", "figure.svg", "figure.pdf"})

    def test_names_of_inner_modules_can_be_imported(self):
        for text in ("import Box2D; assert Box2D.b2.world is Box2D.b2World; Box2D.b2.globals.b2_pi",
                     "from Box2D.Box2D import *; assert b2World().bodyCount == 0 and RAND_LIMIT == 32767",
                     "from Box2D.b2 import *; assert globals()['world']; random(0, 1)",
                     "import Box2D; Box2D.__author__, Box2D.__license__, Box2D.__date__"):
            subprocess.run([sys.executable, "-c", text], check=True,
                           env={**os.environ, "PYTHONPATH": os.path.dirname(_boxreel.__file__)})


if __name__ == "__main__":
    unittest.main()
