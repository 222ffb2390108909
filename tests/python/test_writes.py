# SPDX-License-Identifier: MIT
"""What is written to a part of a value reaches its object: `fixture.shape.radius = 2`, `world.gravity.y = -5`."""

import copy
import gc
import math
import pickle
import unittest

import Box2D
from Box2D import (b2AABB, b2BodyDef, b2ChainShape, b2CircleShape, b2ContactListener, b2EdgeShape, b2Error, b2FixtureDef,
                   b2PolygonShape, b2Transform, b2Vec2, b2World)


def step(world, count=1):
    for _ in range(count):
        world.Step(1 / 60, 8, 3)


class Listener(b2ContactListener):
    def __init__(self):
        super().__init__()
        self.begun, self.ended, self.inside = 0, 0, None

    def BeginContact(self, contact):
        self.begun += 1

    def EndContact(self, contact):
        self.ended += 1
        if self.inside:
            self.inside(contact)


class Vectors(unittest.TestCase):
    def test_change_their_world_and_joints(self):
        world = b2World(gravity=(0, -10))
        world.gravity.y = -5
        self.assertEqual(world.gravity, (0, -5))
        gravity = world.gravity
        gravity *= 2
        self.assertEqual(world.gravity, (0, -10))
        ground, ball = world.CreateStaticBody(), world.CreateDynamicBody(position=(3, 0))
        ball.CreateCircleFixture(radius=1, density=1)
        mouse = world.CreateMouseJoint(bodyA=ground, bodyB=ball, target=(3, 0), maxForce=100)
        mouse.target.x = 4
        self.assertEqual(mouse.target, (4, 0))
        motor = world.CreateMotorJoint(bodyA=ground, bodyB=ball)
        motor.linearOffset[1] = 2
        self.assertEqual(motor.linearOffset, (3, 2))
        ball.localCenter.x = 0.5
        self.assertEqual(ball.localCenter, (0.5, 0))

    def test_are_plain_when_their_owner_is_destroyed(self):
        world = b2World()
        ground, ball = world.CreateStaticBody(), world.CreateDynamicBody()
        joint = world.CreateMouseJoint(bodyA=ground, bodyB=ball, target=(0, 0), maxForce=1)
        target, gravity = joint.target, world.gravity
        world.DestroyJoint(joint)
        target.x = 1
        del world, ground, ball, joint
        gravity.y = 3
        self.assertEqual((target, gravity), ((1, 0), (0, 3)))

    def test_copies_do_not_reach_the_owner(self):
        world = b2World(gravity=(0, -10))
        for twin in (copy.copy(world.gravity), world.gravity.copy(), pickle.loads(pickle.dumps(world.gravity)),
                     b2Vec2(world.gravity), +world.gravity):
            self.assertIs(type(twin), b2Vec2)
            twin.y = 1
        self.assertEqual(world.gravity, (0, -10))

    def test_change_their_definitions_and_values(self):
        definition = b2BodyDef()
        definition.position.x = 1
        definition.linearVelocity.y = 2
        self.assertEqual((definition.position, definition.linearVelocity), ((1, 0), (0, 2)))
        self.assertEqual(b2BodyDef().position, (0, 0))
        fixture = b2FixtureDef()
        fixture.filter.maskBits = 2
        self.assertEqual((fixture.filter.maskBits, b2FixtureDef().filter.maskBits), (2, 0xffff))
        transform = b2Transform()
        transform.position.x = 3
        self.assertEqual(transform * (0, 0), (3, 0))
        box = b2AABB(lowerBound=(0, 0), upperBound=(1, 1))
        box.upperBound.y = 5
        self.assertEqual(box.center, (0.5, 2.5))

    def test_computing_with_a_position_moves_no_body(self):
        world = b2World()
        body = world.CreateDynamicBody(position=(1, 2))
        place = body.position
        place *= 20
        self.assertEqual(body.position, (1, 2))


class FreeShapes(unittest.TestCase):
    def test_vectors_reach_the_shape(self):
        circle = b2CircleShape(radius=1)
        circle.pos.x = 5
        circle.pos += (1, 1)
        self.assertEqual(circle.pos, (6, 1))
        edge = b2EdgeShape(vertices=[(0, 0), (2, 0)])
        edge.vertex1.x = 1
        self.assertEqual(edge.vertices, [(1, 0), (2, 0)])
        chain = b2ChainShape(vertices_chain=[(0, 0), (1, 0), (2, 0)])
        chain.prevVertex = -1, 0
        chain.prevVertex.y = 3
        self.assertEqual(chain.prevVertex, (-1, 3))

    def test_a_vector_keeps_its_shape_alive(self):
        center = b2CircleShape(radius=1).pos
        gc.collect()
        center.x = 2
        self.assertEqual(center, (2, 0))

    def test_refused_vertices_leave_the_shape_as_it_was(self):
        chain = b2ChainShape(vertices_chain=[(0, 0), (1, 0)])
        with self.assertRaises(b2Error):
            chain.vertices_chain = [(0, 0), (0, 0)]
        self.assertEqual(chain.vertices, [(0, 0), (1, 0)])


class FixtureShapes(unittest.TestCase):
    def setUp(self):
        self.world = b2World(gravity=(0, -10))
        self.ground = self.world.CreateStaticBody(shapes=b2EdgeShape(vertices=[(-20, 0), (20, 0)]))
        self.ball = self.world.CreateDynamicBody(position=(0, 1))
        self.fixture = self.ball.CreateCircleFixture(radius=1, density=1)

    def test_a_radius_reaches_the_fixture(self):
        shape = self.fixture.shape
        self.fixture.shape.radius = 2
        self.assertEqual((shape.radius, self.fixture.shape.radius), (2, 2))
        self.assertAlmostEqual(self.ball.mass, math.pi, 5)
        self.ball.ResetMassData()
        self.assertAlmostEqual(self.ball.mass, 4 * math.pi, 4)
        step(self.world, 120)
        self.assertAlmostEqual(self.ball.position.y, 2, 1)

    def test_a_position_reaches_the_fixture(self):
        self.fixture.shape.pos.x = 3
        self.assertTrue(self.fixture.TestPoint((3.9, 1)))
        self.assertFalse(self.fixture.TestPoint((-0.5, 1)))
        self.fixture.shape.pos = 0, -1
        self.assertEqual(self.fixture.shape.pos, (0, -1))

    def test_changed_vertices_move_the_ground(self):
        step(self.world, 60)
        self.ground.fixtures[0].shape.vertices = [(-20, -3), (20, -3)]
        self.ball.awake = True
        step(self.world, 120)
        self.assertAlmostEqual(self.ball.position.y, -2, 1)
        self.ground.fixtures[0].shape.vertex1.y = -6
        self.assertEqual(self.ground.fixtures[0].shape.vertices, [(-20, -6), (20, -3)])

    def test_a_box_takes_other_vertices(self):
        box = self.world.CreateDynamicBody(position=(8, 4)).CreatePolygonFixture(box=(1, 1), density=1)
        box.shape.box = (2, 1)
        self.assertEqual(max(x for x, _ in box.shape.vertices), 2)
        box.shape.vertices = [(-1, 0), (1, 0), (0, 1)]
        self.assertEqual(box.shape.vertexCount, 3)
        box.shape.SetAsBox(1, 3)
        self.assertTrue(box.TestPoint((8, 6.5)))

    def test_queries_find_the_new_place_at_once(self):
        self.fixture.shape.pos = 50, 0
        found = []
        self.world.QueryAABB(lambda fixture: found.append(fixture) or True, b2AABB(lowerBound=(49, 0), upperBound=(52, 1)))
        self.assertEqual(found, [self.fixture])

    def test_grown_shapes_touch_without_motion(self):
        world = b2World(gravity=(0, 0))
        listener = world.contactListener = Listener()
        balls = [world.CreateDynamicBody(position=(x, 0), allowSleep=False) for x in (0, 3)]
        fixtures = [ball.CreateCircleFixture(radius=1.4, density=1) for ball in balls]
        step(world, 3)
        self.assertEqual(listener.begun, 0)
        fixtures[0].shape.radius = 1.7
        step(world)
        self.assertEqual(listener.begun, 1)
        fixtures[0].shape.radius = 0.5
        step(world)
        self.assertEqual(listener.ended, 1)

    def test_a_chain_takes_another_number_of_edges(self):
        listener = self.world.contactListener = Listener()
        chain = self.world.CreateStaticBody(position=(0, -5)).CreateChainFixture(vertices=[(-9, 0), (0, -1), (9, 0)])
        self.ground.fixtures[0].shape.vertices = [(-20, -9), (20, -9)]
        step(self.world, 120)
        ended, proxies = listener.ended, self.world.proxyCount
        chain.shape.vertices_chain = [(-9, -2), (-3, -2), (3, -2), (9, -2)]
        self.assertEqual((chain.shape.childCount, self.world.proxyCount), (3, proxies + 1))
        self.assertGreater(listener.ended, ended)
        self.ball.awake = True
        step(self.world, 120)
        self.assertAlmostEqual(self.ball.position.y, -6, 1)

    def test_what_the_engine_refuses_changes_nothing(self):
        shape = self.fixture.shape
        box = self.ball.CreatePolygonFixture(box=(1, 1)).shape
        for change in (lambda: setattr(shape, "radius", -1), lambda: setattr(shape, "radius", math.nan),
                       lambda: setattr(shape, "pos", (math.inf, 0)), lambda: setattr(shape.pos, "x", 1e30),
                       lambda: setattr(box, "vertices", []), lambda: setattr(box, "vertices", [(0, 0), (1, 1)])):
            with self.assertRaises(b2Error):
                change()
        self.assertEqual((shape.radius, shape.pos, len(box.vertices)), (1, (0, 0), 4))
        step(self.world)

    def test_a_locked_world_is_not_changed(self):
        errors = []

        class Grower(b2ContactListener):
            def BeginContact(self, contact):
                for fixture in (contact.fixtureA, contact.fixtureB):
                    try:
                        fixture.shape.radius = 3
                    except b2Error as error:
                        errors.append(error)

        self.world.contactListener = Grower()
        step(self.world, 30)
        self.assertEqual((len(errors), self.fixture.shape.radius), (2, 1))

    def test_listeners_cannot_change_a_chain(self):
        listener = self.world.contactListener = Listener()
        self.ground.fixtures[0].shape.vertices = [(-20, -9), (20, -9)]
        chain = self.world.CreateStaticBody().CreateChainFixture(vertices=[(-9, 0), (0, 0), (9, 0)])
        step(self.world, 60)
        listener.inside = lambda contact: self.world.DestroyBody(self.ball)
        with self.assertRaises(b2Error):
            chain.shape.vertices_chain = [(-9, 0), (-1, 0), (1, 0), (9, 0)]
        listener.inside = None
        self.assertEqual((chain.shape.childCount, self.world.bodyCount), (3, 3))
        step(self.world, 60)

    def test_the_shape_outlives_its_fixture(self):
        shape, again = self.fixture.shape, self.fixture.shape
        self.fixture.note = shape
        again.radius = 2
        self.ball.DestroyFixture(self.fixture)
        self.assertGreater(shape.radius, 0)
        with self.assertRaises(b2Error):
            shape.radius = 3
        edge = self.ground.fixtures[0].shape
        del self.world, self.ground, self.ball, self.fixture
        gc.collect()
        self.assertEqual(edge.vertices, [(-20, 0), (20, 0)])
        with self.assertRaises(b2Error):
            edge.vertex1.x = 3

    def test_copies_do_not_reach_the_fixture(self):
        shape = self.fixture.shape
        for twin in (copy.copy(shape), copy.deepcopy(shape), shape.copy(), pickle.loads(pickle.dumps(shape))):
            self.assertEqual(twin, shape)
            twin.radius = 7
        self.assertEqual(shape.radius, 1)
        other = self.world.CreateDynamicBody(position=(9, 9)).CreateFixture(shape=shape, density=1)
        other.shape.radius = 4
        self.assertEqual(shape.radius, 1)

    def test_copies_and_snapshots_have_the_change(self):
        self.fixture.shape.radius = 2
        twin = copy.deepcopy(self.world)
        self.assertEqual(twin.bodies[1].fixtures[0].shape.radius, 2)
        shape = self.fixture.shape
        before = self.world._save()
        shape.radius = 3
        self.world._restore(before)
        self.assertEqual(shape.radius, 2)
        shape.radius = 4
        self.assertEqual(self.fixture.shape.radius, 4)

    def test_an_inactive_body_takes_a_shape(self):
        self.ball.active = False
        self.fixture.shape.radius = 2
        chain = self.ground.CreateChainFixture(vertices=[(30, 0), (40, 0)])
        self.ground.active = False
        chain.shape.vertices_chain = [(30, 0), (40, 0), (50, 0)]
        self.ground.active = self.ball.active = True
        step(self.world, 120)
        self.assertAlmostEqual(self.ball.position.y, 2, 1)

    def test_thousands_of_changes_leave_a_sound_world(self):
        world = b2World(gravity=(0, -10))
        chain = world.CreateStaticBody().CreateChainFixture(vertices=[(-20, 5), (-20, 0), (20, 0), (20, 5)])
        bodies = [world.CreateDynamicBody(position=(i % 8 * 2 - 8, 2 + i // 8 * 2)) for i in range(32)]
        for i, body in enumerate(bodies):
            body.CreateCircleFixture(radius=0.5, density=1) if i % 2 else body.CreatePolygonFixture(box=(0.5, 0.4), density=1)
        for turn in range(200):
            for i, body in enumerate(bodies):
                size = 0.3 + 0.05 * ((turn * 7 + i * 3) % 11)
                if i % 2:
                    body.fixtures[0].shape.radius = size
                else:
                    body.fixtures[0].shape.box = (size, 0.4)
                body.ResetMassData()
            middle = [(x, 0) for x in range(-15, 16, 5 + turn % 3)]
            chain.shape.vertices_chain = [(-20, 9), (-20, 0), *middle, (20, 0), (20, 9)]
            world.Step(1 / 60, 8, 3)
        self.assertTrue(all(body.position.valid for body in bodies))
        self.assertEqual(world.proxyCount, 32 + chain.shape.childCount)


class Names(unittest.TestCase):
    def test_every_writable_vector_reaches_its_object(self):
        """All properties with a setter, but for the two of a pose, which programs compute with in place."""
        world = b2World()
        ball, box = world.CreateDynamicBody(), world.CreateDynamicBody(position=(3, 0))
        ball.CreateCircleFixture(radius=1, density=1)
        items = [world, ball, world.CreateMotorJoint(bodyA=ball, bodyB=box),
                 world.CreateMouseJoint(bodyA=ball, bodyB=box, target=(3, 0), maxForce=9), ball.fixtures[0].shape,
                 b2CircleShape(), b2EdgeShape(vertices=[(0, 0), (1, 1)]), b2PolygonShape(box=(1, 1)),
                 b2ChainShape(vertices_chain=[(0, 0), (1, 1), (2, 0)])]
        for name in ("AABB", "BodyDef", "ClipVertex", "DistanceJointDef", "DistanceOutput", "FrictionJointDef", "MassData",
                     "Mat22", "MotorJointDef", "MouseJointDef", "PrismaticJointDef", "PulleyJointDef", "RayCastInput",
                     "RayCastOutput", "RevoluteJointDef", "RopeJointDef", "Sweep", "Transform", "WeldJointDef", "WheelJointDef"):
            items.append(getattr(Box2D, "b2" + name)())
        for item in items:
            names = [name for name, part in ((name, getattr(type(item), name)) for name in dir(type(item)))
                     if isinstance(part, property) and part.fset is not None]
            for name in names + [name for name in getattr(item, "_fields", ()) if name != "_given"]:
                try:
                    value = getattr(item, name)
                except ValueError:  # the anchors of a definition without bodies
                    continue
                if isinstance(value, b2Vec2) and (type(item).__name__, name) != ("b2Body", "position"):
                    value.x = before = value.x + 0.25
                    self.assertEqual(getattr(item, name).x, before, f"{type(item).__name__}.{name}")


if __name__ == "__main__":
    unittest.main()
