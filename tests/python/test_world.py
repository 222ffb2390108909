# SPDX-License-Identifier: MIT
"""Worlds, bodies, fixtures and joints, by the names that programs of the 2.3 generation use."""

import copy
import math
import pickle
import unittest

import Box2D
from Box2D import (b2AABB, b2BodyDef, b2CircleShape, b2ContactListener, b2EdgeShape, b2FixtureDef, b2MassData, b2PolygonShape,
                   b2QueryCallback, b2RayCastCallback, b2Vec2, b2World)
from Box2D import b2


def ball(world, position, **keywords):
    return world.CreateDynamicBody(
        position=position, fixtures=b2FixtureDef(shape=b2CircleShape(radius=0.5), density=1, **keywords))


class Velocity(unittest.TestCase):
    def setUp(self):
        self.world = b2World(gravity=(0, 0))
        self.body = self.world.CreateDynamicBody()

    def test_classes_instead_of_objects_are_refused(self):
        world = b2World()
        with self.assertRaisesRegex(TypeError, "the class b2CircleShape"):
            world.CreateDynamicBody(shapes=b2CircleShape)
        with self.assertRaisesRegex(TypeError, "contactListener: .*the class b2ContactListener"):
            world.contactListener = b2ContactListener

    def test_reaches_the_body_when_changed(self):
        velocity = self.body.linearVelocity
        velocity.x = 4
        self.assertEqual(self.body.linearVelocity, (4, 0))
        velocity[1] = 3
        self.assertEqual(self.body.linearVelocity, (4, 3))
        self.body.linearVelocity *= 2
        self.assertEqual(self.body.linearVelocity, (8, 6))
        velocity.length = 1
        self.assertAlmostEqual(self.body.linearVelocity.x, 0.8, 6)
        velocity.tuple = (2, 1)
        velocity += (1, 0)
        self.assertEqual(self.body.linearVelocity, (3, 1))
        velocity.SetZero()
        self.assertEqual(self.body.linearVelocity, (0, 0))

    def test_setting_a_component_keeps_the_other(self):
        velocity = self.body.linearVelocity
        self.body.linearVelocity = 0, 7
        velocity.x = 1
        self.assertEqual(self.body.linearVelocity, (1, 7))

    def test_copies_and_sums_are_plain_vectors(self):
        velocity = self.body.linearVelocity
        for plain in (copy.copy(velocity), velocity.copy(), copy.deepcopy(velocity), +velocity, velocity + (0, 0),
                      pickle.loads(pickle.dumps(velocity))):
            self.assertIs(type(plain), b2Vec2)
            plain.x = 5
        self.assertEqual(self.body.linearVelocity, (0, 0))

    def test_outlives_the_body(self):
        velocity = self.body.linearVelocity
        self.world.DestroyBody(self.body)
        velocity.x = 3
        self.assertEqual(velocity, (3, 0))


class Worlds(unittest.TestCase):
    def test_default_world_is_empty_with_gravity(self):
        world = b2World()
        self.assertEqual((world.gravity, world.allowSleeping, world.bodyCount, world.bodies), ((0, -10), True, 0, []))

    def test_keywords_set_properties(self):
        listener = Box2D.b2ContactListener()
        world = b2World(gravity=(1, 2), doSleep=False, contactListener=listener, subStepCount=4)
        self.assertEqual((world.gravity, world.allowSleeping, world.subStepCount), ((1, 2), False, 4))
        self.assertIs(world.contactListener, listener)
        with self.assertRaises(TypeError):
            b2World(gravty=(0, 0))

    def test_step_takes_positions_and_keywords(self):
        world = b2World()
        body = ball(world, (0, 10))
        world.Step(1 / 60, 8, 3)
        world.Step(timeStep=1 / 60, velocityIterations=8, positionIterations=3)
        world.ClearForces()
        self.assertAlmostEqual(body.linearVelocity.y, -10 / 30, 5)

    def test_lists_are_in_the_order_of_creation(self):
        world = b2World()
        bodies = [ball(world, (i, 0)) for i in range(5)]
        self.assertEqual(world.bodies, bodies)
        self.assertEqual(list(world), bodies)
        self.assertIn(bodies[0], world)
        for i, body in enumerate(bodies):
            self.assertIs(world.bodies[i], body)

    def test_poses_are_an_array(self):
        world = b2World()
        for i in range(3):
            world.CreateDynamicBody(position=(i, 2 * i), angle=0.5 * i)
        poses = world.poses()
        self.assertEqual(poses.tolist(), [[0, 0, 0], [1, 2, 0.5], [2, 4, 1]])
        world.bodies[0].position = (7, 7)
        self.assertIs(world.poses(poses), poses)
        self.assertEqual(poses[0, 0], 7)
        world.DestroyBody(world.bodies[0])
        self.assertEqual(world.poses().shape, (2, 3))
        with self.assertRaises(ValueError):
            world.poses(poses)

    def test_queries_find_bodies(self):
        world = b2World()
        near, far = ball(world, (0, 0)), ball(world, (5, 0))

        class Query(b2QueryCallback):
            def __init__(self):
                super().__init__()
                self.bodies = []

            def ReportFixture(self, fixture):
                self.bodies.append(fixture.body)
                return True

        query = Query()
        world.QueryAABB(query, b2AABB(lowerBound=(-1, -1), upperBound=(1, 1)))
        self.assertEqual(query.bodies, [near])

        class Closest(b2RayCastCallback):
            def ReportFixture(self, fixture, point, normal, fraction):
                self.hit = fixture.body, point, normal, fraction
                return fraction

        ray = Closest()
        world.RayCast(ray, (10, 0), (-10, 0))
        body, point, normal, fraction = ray.hit
        self.assertIs(body, far)
        self.assertEqual(point, (5.5, 0))
        self.assertEqual(normal, (1, 0))
        self.assertAlmostEqual(fraction, 0.225, 5)

    def test_short_names_are_the_same_classes(self):
        from Box2D.b2 import circleShape, contactListener, dynamicBody, edgeShape, fixtureDef, pi, vec2, world

        self.assertIs(world, b2World)
        self.assertIs(circleShape, b2CircleShape)
        self.assertIs(edgeShape, b2EdgeShape)
        self.assertIs(fixtureDef, b2FixtureDef)
        self.assertIs(contactListener, Box2D.b2ContactListener)
        self.assertEqual((vec2(1, 2), dynamicBody), ((1, 2), 2))
        self.assertAlmostEqual(pi, math.pi, 6)
        self.assertIs(b2.AABB, b2AABB)

    def test_all_joints_have_both_spellings(self):
        for kind in "Revolute Prismatic Distance Pulley Mouse Gear Wheel Weld Friction Rope Motor".split():
            for name in (f"b2{kind}Joint", f"b2{kind}JointDef"):
                self.assertTrue(hasattr(Box2D, name), name)
                self.assertTrue(hasattr(b2, name[2].lower() + name[3:]), name)
            self.assertTrue(hasattr(b2World, f"Create{kind}Joint"))

    def test_callbacks_may_be_functions(self):
        world, found = b2World(), []
        ball(world, (0, 0))
        world.RayCast(lambda fixture, point, normal, fraction: found.append(point.x) or 1, (-3, 0), (3, 0))
        world.QueryAABB(lambda fixture: found.append(fixture) or True, b2AABB((-1, -1), (1, 1)))
        self.assertEqual((len(found), found[1]), (2, world.bodies[0].fixtures[0]))
        self.assertAlmostEqual(found[0], -0.5, 2)

    def test_draws_by_debug_draw_as_well(self):
        class Draw(Box2D.b2Draw):
            def DrawSolidCircle(self, center, radius, axis, color):
                drawn.append(radius)

        drawn, world = [], b2World()
        ball(world, (0, 0))
        world.renderer = Draw()
        world.DebugDraw()
        self.assertEqual(drawn, [0.5])

    def test_draws_through_the_renderer(self):
        calls = []

        class Draw(Box2D.b2DrawExtended):
            def DrawSolidPolygon(self, vertices, color):
                calls.append(vertices)

            def DrawSolidCircle(self, center, radius, axis, color):
                calls.append((center, radius, color.bytes))

            def DrawSegment(self, p1, p2, color):
                calls.append((p1, p2))

        world = b2World()
        ball(world, (1, 2))
        world.CreateStaticBody(shapes=b2PolygonShape(box=(1, 1)))
        world.renderer = Draw(zoom=10, offset=(-20, -30), screenSize=(200, 100), flipY=True)
        world.renderer.flags = dict(drawShapes=True, drawJoints=False, convertVertices=True)
        world.DrawDebugData()
        self.assertIn([(10, 80), (30, 80), (30, 60), (10, 60)], calls)
        self.assertEqual([call[:2] for call in calls if isinstance(call, tuple)], [((30, 50), 0.5)])
        self.assertEqual(world.renderer.to_screen((1, 2)), (30, 50))


class Bodies(unittest.TestCase):
    def setUp(self):
        self.world = b2World()

    def test_properties_can_be_written(self):
        body = ball(self.world, (0, 0))
        for name, value in (("position", (1, 2)), ("linearVelocity", (3, 4)), ("angularVelocity", 2.0), ("angle", 0.5),
                            ("linearDamping", 0.25), ("angularDamping", 0.5), ("gravityScale", 2.0), ("bullet", True),
                            ("sleepingAllowed", False), ("fixedRotation", True), ("active", False), ("mass", 3.0),
                            ("type", Box2D.b2_kinematicBody), ("userData", {"any": "object"})):
            setattr(body, name, value)
            self.assertEqual(getattr(body, name), value, name)
        body.transform = (4, 5), 1.0
        self.assertEqual(body.position, (4, 5))
        self.assertAlmostEqual(body.transform.angle, 1, 6)

    def test_attributes_of_the_program_are_kept(self):
        body = ball(self.world, (0, 3))
        body.color1, body.ground_contact = (1, 2, 3), False
        body.fixtures[0].tag = "f"
        number = id(body)
        del body
        self.world.Step(1 / 60, 8, 3)
        body = self.world.bodies[0]
        self.assertEqual((id(body), body.color1, body.ground_contact, body.fixtures[0].tag),
                         (number, (1, 2, 3), False, "f"))
        self.assertIn(body, {body})

    def test_mass_data_is_set_and_reset(self):
        body = self.world.CreateDynamicBody(fixtures=b2FixtureDef(shape=b2PolygonShape(box=(1, 1)), density=2))
        self.assertEqual((body.mass, body.localCenter, body.worldCenter), (8, (0, 0), (0, 0)))
        body.massData = b2MassData(mass=1, center=(0.5, 0), I=2)
        self.assertEqual((body.mass, body.inertia, body.localCenter), (1, 2, (0.5, 0)))
        body.ResetMassData()
        self.assertEqual(body.mass, 8)

    def test_forces_and_impulses_change_velocities(self):
        body = ball(self.world, (0, 0))
        body.ApplyLinearImpulse(impulse=(body.mass, 0), point=body.worldCenter, wake=True)
        self.assertAlmostEqual(body.linearVelocity.x, 1, 5)
        body.ApplyAngularImpulse(1, True)
        self.assertGreater(body.angularVelocity, 0)
        self.world.gravity = 0, 0
        body.linearVelocity = 0, 0
        body.ApplyForce((60 * body.mass, 0), body.worldCenter, True)
        body.ApplyForceToCenter((0, 60 * body.mass), wake=True)
        body.ApplyTorque(1, True)
        self.world.Step(1 / 60, 8, 3)
        self.assertAlmostEqual(body.linearVelocity.x, 1, 4)
        self.assertAlmostEqual(body.linearVelocity.y, 1, 4)

    def test_points_and_vectors_are_converted(self):
        body = self.world.CreateDynamicBody(position=(1, 0), angle=math.pi / 2)
        self.assertAlmostEqual(body.GetWorldPoint((1, 0)).y, 1, 6)
        self.assertAlmostEqual(body.GetLocalPoint((1, 1)).x, 1, 6)
        self.assertAlmostEqual(body.GetWorldVector((1, 0)).y, 1, 6)
        self.assertAlmostEqual(body.GetLocalVector((0, 1)).x, 1, 6)
        body.angularVelocity = 1
        self.assertAlmostEqual(body.GetLinearVelocityFromWorldPoint((1, 1)).x, -1, 5)

    def test_fixtures_are_made_in_every_way(self):
        body = self.world.CreateStaticBody()
        square = b2PolygonShape(box=(1, 1))
        made = [body.CreateFixture(b2FixtureDef(shape=square, density=1)),
                body.CreateFixture(shape=square, density=1, friction=0.3),
                body.CreateFixture(square, 2),
                body.CreatePolygonFixture(box=(1, 2), density=1, friction=0.25),
                body.CreatePolygonFixture(vertices=[(0, 0), (1, 0), (0, 1)]),
                body.CreateCircleFixture(radius=1, pos=(1, 1), density=1),
                body.CreateEdgeFixture(vertices=[(0, 0), (1, 0)], density=0, friction=0.5),
                body.CreateLoopFixture(vertices=[(0, 0), (1, 0), (0, 1)]),
                body.CreateChainFixture(vertices=[(0, 0), (1, 0), (0, 1)]),
                body.CreateFixturesFromShapes(square)]
        made += body.CreateEdgeChain([(0, 0), (1, 0), (2, 1)])
        made += body.CreateFixturesFromShapes([square, b2CircleShape(radius=1)], b2FixtureDef(friction=0.75))
        self.assertEqual(body.fixtures, made)
        self.assertEqual([f.friction for f in (made[1], made[3], made[6], made[-1])], [0.30000001192092896, 0.25, 0.5, 0.75])
        self.assertEqual((made[7].shape.childCount, made[8].shape.childCount), (3, 2))
        self.assertEqual(list(body), made)
        body.DestroyFixture(made[0])
        self.assertNotIn(made[0], body.fixtures)

    def test_fixture_properties_are_read_and_set(self):
        body = ball(self.world, (0, 0), categoryBits=0x10, maskBits=0xFFFF, groupIndex=-3, restitution=0.5,
                    isSensor=True, userData="u")
        fixture = body.fixtures[0]
        self.assertEqual((fixture.filterData.categoryBits, fixture.filterData.maskBits, fixture.filterData.groupIndex,
                          fixture.restitution, fixture.sensor, fixture.userData), (0x10, 0xFFFF, -3, 0.5, True, "u"))
        fixture.sensor = False
        fixture.categoryBits = 4
        self.assertEqual((fixture.sensor, fixture.filterData.categoryBits), (False, 4))
        self.assertIs(type(fixture.shape), b2CircleShape)
        self.assertTrue(fixture.TestPoint((0.2, 0)))
        self.assertIs(fixture.body, body)

    def test_definitions_can_be_reused(self):
        definition = b2FixtureDef(shape=b2PolygonShape(vertices=[(0, 0), (1, 0), (1, -1), (0, -1)]), friction=0.5)
        first = self.world.CreateStaticBody(fixtures=definition)
        definition.shape.vertices = [(0, 0), (2, 0), (2, -2)]
        second = self.world.CreateStaticBody(fixtures=definition)
        self.assertEqual((first.fixtures[0].shape.vertexCount, second.fixtures[0].shape.vertexCount), (4, 3))
        body = self.world.CreateBody(b2BodyDef(type=Box2D.b2_dynamicBody, position=(1, 2), linearDamping=0.5))
        self.assertEqual((body.type, body.position, body.linearDamping), (2, (1, 2), 0.5))

    def test_a_body_with_invalid_fixture_is_not_created(self):
        with self.assertRaises(Box2D.b2Error):
            self.world.CreateDynamicBody(fixtures=b2FixtureDef(shape=b2PolygonShape(), density=1))
        self.assertEqual(self.world.bodyCount, 0)

    def test_a_filter_can_be_written(self):
        fixture = ball(self.world, (0, 0)).fixtures[0]
        kept = fixture.filterData
        fixture.filterData.maskBits = 0
        kept.groupIndex = -2
        self.assertEqual((fixture.maskBits, kept.maskBits, fixture.groupIndex), (0, 0, -2))
        other = ball(self.world, (9, 0)).fixtures[0]
        other.filterData = kept
        self.assertEqual((other.maskBits, other.groupIndex), (0, -2))
        other.filterData = Box2D.b2Filter(categoryBits=8)
        self.assertEqual((other.categoryBits, fixture.categoryBits), (8, 1))
        for twin in (kept.copy(), copy.copy(kept), copy.deepcopy(kept), pickle.loads(pickle.dumps(kept))):
            self.assertEqual((type(twin), twin.maskBits), (Box2D.b2Filter, 0))
        with self.assertRaises(ValueError):
            kept.maskBits = -1
        self.world.DestroyBody(fixture.body)
        with self.assertRaises(Box2D.b2Error):
            kept.maskBits

    def test_generators_and_broad_phase_give_objects(self):
        a, b = ball(self.world, (0, 0)), ball(self.world, (0.5, 0))
        joint = self.world.CreateWeldJoint(bodyA=a, bodyB=b, anchor=(0, 0), collideConnected=True)
        self.world.Step(1 / 60, 8, 3)
        self.assertEqual((list(self.world.bodies_gen), next(self.world.joints_gen)), ([a, b], joint))
        self.assertEqual(next(self.world.contacts_gen), next(a.contacts_gen).contact)
        self.assertEqual((next(a.joints_gen).other, next(a.fixtures_gen)), (b, a.fixtures[0]))
        phase = self.world.contactManager.broadPhase
        self.assertEqual((phase.proxyCount, phase.GetTreeHeight()), (2, self.world.treeHeight))

    def test_names_of_the_cpp_interface_work(self):
        body = ball(self.world, (1, 2))
        self.assertEqual((body.GetPosition(), body.GetMass(), body.IsAwake()), ((1, 2), body.mass, True))
        body.SetLinearVelocity((1, 0))
        self.assertEqual(body.linearVelocity, (1, 0))


class Joints(unittest.TestCase):
    def setUp(self):
        self.world = b2World(gravity=(0, 0))
        self.a = ball(self.world, (0, 0))
        self.b = ball(self.world, (2, 0))
        self.b.angle = 0.5

    def bodies(self):
        return {"bodyA": self.a, "bodyB": self.b}

    def test_revolute_joint_has_limits_and_motor(self):
        joint = self.world.CreateRevoluteJoint(anchor=(1, 0), lowerAngle=-0.5, upperAngle=0.75, enableLimit=True,
                                               maxMotorTorque=10, motorSpeed=1, enableMotor=True, **self.bodies())
        self.assertIs(type(joint), Box2D.b2RevoluteJoint)
        self.assertEqual((joint.angle, joint.limits, joint.motorSpeed, joint.motorEnabled, joint.limitEnabled),
                         (0, (-0.5, 0.75), 1, True, True))
        joint.motorSpeed, joint.limits, joint.maxMotorTorque = 2, (-1, 1), 5
        joint.lowerLimit = -0.25
        self.assertEqual((joint.motorSpeed, joint.limits, joint.maxMotorTorque), (2, (-0.25, 1), 5))
        for _ in range(10):
            self.world.Step(1 / 60, 8, 3)
        self.assertGreater(joint.angle, 0)
        self.assertEqual((joint.bodyA, joint.bodyB), (self.a, self.b))
        self.assertEqual([edge.joint for edge in self.a.joints], [joint])
        self.assertIs(self.a.joints[0].other, self.b)

    def test_definition_measures_the_reference_angle(self):
        definition = Box2D.b2RevoluteJointDef(localAnchorA=(1, 0), localAnchorB=(-1, 0), **self.bodies())
        self.assertEqual(definition.referenceAngle, 0.5)
        self.assertEqual(self.world.CreateJoint(definition).angle, 0)
        given = Box2D.b2RevoluteJointDef(referenceAngle=0.25, **self.bodies())
        self.assertEqual(self.world.CreateJoint(given).angle, 0.25)

    def test_slider_and_wheel_have_their_properties(self):
        slider = self.world.CreatePrismaticJoint(anchor=(2, 0), axis=(1, 0), lowerTranslation=-1, upperTranslation=1,
                                                 enableLimit=True, **self.bodies())
        self.assertEqual((slider.limits, slider.axis), ((-1, 1), (1, 0)))
        wheel = self.world.CreateWheelJoint(anchor=(2, 0), axis=(0, 1), frequencyHz=4, dampingRatio=0.5, **self.bodies())
        self.assertEqual((wheel.springFrequencyHz, wheel.springDampingRatio), (4, 0.5))
        wheel.motorEnabled = True

    def test_distance_rope_and_pulley_measure_their_lengths(self):
        distance = self.world.CreateDistanceJoint(anchorA=(0, 0), anchorB=(2, 0), frequencyHz=3, **self.bodies())
        self.assertEqual((distance.length, distance.frequency), (2, 3))
        distance.length = 4
        self.assertEqual(distance.length, 4)
        rope = self.world.CreateRopeJoint(localAnchorA=(0, 0), localAnchorB=(0, 0), maxLength=3, **self.bodies())
        self.assertEqual(rope.maxLength, 3)
        pulley = self.world.CreatePulleyJoint(anchorA=(0, 0), anchorB=(2, 0), groundAnchorA=(0, 5),
                                              groundAnchorB=(2, 5), ratio=1.5, **self.bodies())
        self.assertEqual((pulley.ratio, pulley.lengthA), (1.5, 5))

    def test_other_joints_have_their_properties(self):
        mouse = self.world.CreateMouseJoint(target=(2, 0), maxForce=100, **self.bodies())
        mouse.target = (3, 0)
        self.assertEqual((mouse.target, mouse.maxForce), ((3, 0), 100))
        weld = self.world.CreateWeldJoint(anchor=(1, 0), **self.bodies())
        self.assertEqual(weld.referenceAngle, 0.5)
        friction = self.world.CreateFrictionJoint(maxForce=2, maxTorque=3, **self.bodies())
        self.assertEqual((friction.maxForce, friction.maxTorque), (2, 3))
        motor = self.world.CreateMotorJoint(maxForce=2, **self.bodies())
        self.assertEqual((motor.linearOffset, motor.angularOffset), ((2, 0), 0.5))

    def test_gear_takes_the_bodies_of_its_joints(self):
        ground = self.world.CreateStaticBody()
        first = self.world.CreateRevoluteJoint(bodyA=ground, bodyB=self.a, anchor=(0, 0))
        second = self.world.CreateRevoluteJoint(bodyA=ground, bodyB=self.b, anchor=(2, 0))
        gear = self.world.CreateGearJoint(joint1=first, joint2=second, ratio=2)
        self.assertEqual((gear.ratio, gear.joint1, gear.joint2), (2, first, second))
        with self.assertRaisesRegex(TypeError, r"\bjoint1\b"):
            Box2D.b2GearJointDef(joint1=1, joint2=second)

    def test_joint_is_destroyed(self):
        joint = self.world.CreateWeldJoint(anchor=(1, 0), **self.bodies())
        self.world.DestroyJoint(joint)
        self.assertEqual((self.world.jointCount, self.world.joints), (0, []))

    def test_definitions_are_initialized_from_the_world(self):
        hinge = Box2D.b2RevoluteJointDef()
        hinge.Initialize(self.a, self.b, (1, 0))
        self.assertEqual((hinge.bodyA, hinge.bodyB, hinge.localAnchorA), (self.a, self.b, (1, 0)))
        self.assertEqual((hinge.anchorB, hinge.referenceAngle), (self.b.GetWorldPoint(hinge.localAnchorB), 0.5))
        self.assertEqual(self.world.CreateJoint(hinge).angle, 0)
        for kind in (Box2D.b2WeldJointDef, Box2D.b2FrictionJointDef):
            joint = kind()
            joint.Initialize(bodyA=self.a, bodyB=self.b, anchor=(1, 0))
            self.assertIsNotNone(self.world.CreateJoint(joint))
        for kind in (Box2D.b2PrismaticJointDef, Box2D.b2WheelJointDef):
            joint = kind()
            joint.Initialize(bodyA=self.b, bodyB=self.a, anchor=(1, 0), axis=(0, 1))
            self.assertEqual((joint.localAxisA, joint.localAnchorB), (self.b.GetLocalVector((0, 1)), (1, 0)))
            self.assertIsNotNone(self.world.CreateJoint(joint))

    def test_definitions_get_lengths_and_offsets(self):
        rod, pulley, motor = Box2D.b2DistanceJointDef(), Box2D.b2PulleyJointDef(), Box2D.b2MotorJointDef()
        rod.Initialize(self.a, self.b, anchorA=(0, 0), anchorB=(2, 0))
        self.assertEqual(rod.length, 2)
        pulley.Initialize(self.a, self.b, (0, 5), (2, 6), (0, 0), (2, 0), 1.5)
        self.assertEqual((pulley.lengthA, pulley.lengthB, pulley.ratio, pulley.groundAnchorB), (5, 6, 1.5, (2, 6)))
        motor.Initialize(self.a, self.b)
        self.assertEqual((motor.linearOffset, motor.angularOffset), ((2, 0), 0.5))
        for joint in (rod, pulley, motor):
            self.assertIsNotNone(self.world.CreateJoint(joint))
        with self.assertRaisesRegex(TypeError, r"\bbodyB\b"):
            motor.Initialize(self.a, None)

    def test_definitions_become_keywords(self):
        first = Box2D.b2RevoluteJointDef(anchor=(1, 0), enableMotor=True, **self.bodies())
        keywords = first.to_kwargs()
        self.assertEqual((keywords["enableMotor"], keywords["bodyA"]), (True, self.a))
        keywords["localAnchorA"].x = 7
        self.assertEqual(first.localAnchorA.x, 1)
        second = Box2D.b2RevoluteJointDef(**first.to_kwargs())
        self.assertEqual(second.to_kwargs(), first.to_kwargs())
        self.assertEqual(b2BodyDef(angle=2).to_kwargs()["angle"], 2)
        self.assertEqual(b2FixtureDef(**b2FixtureDef(maskBits=3).to_kwargs()).maskBits, 3)

    def test_joint_is_created_by_class(self):
        joint = self.world.CreateJoint(type=Box2D.b2WeldJoint, anchor=(0, 0), **self.bodies())
        self.assertIs(type(joint), Box2D.b2WeldJoint)


if __name__ == "__main__":
    unittest.main()
