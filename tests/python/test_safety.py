# SPDX-License-Identifier: MIT
"""Wrong arguments, callbacks, lifetimes, copies: what must raise and never crash."""

import contextlib
import copy
import gc
import math
import os
import pickle
import random
import re
import subprocess
import sys
import tempfile
import threading
import unittest
import weakref

import Box2D
import boxreel
from Box2D import (b2CircleShape, b2ContactFilter, b2ContactListener, b2DestructionListener, b2EdgeShape, b2Error,
                   b2FixtureDef, b2PolygonShape, b2World)


def ground(world):
    return world.CreateStaticBody(shapes=b2EdgeShape(vertices=[(-50, 0), (50, 0)]))


def ball(world, position=(0, 0.4)):
    return world.CreateDynamicBody(position=position, fixtures=b2FixtureDef(shape=b2CircleShape(radius=0.5), density=1))


class Arguments(unittest.TestCase):
    def setUp(self):
        self.world = b2World()
        self.body = ball(self.world)

    def test_numbers_out_of_range_are_refused(self):
        joint = self.world.CreateRevoluteJoint(bodyA=ground(self.world), bodyB=self.body, anchor=(0, 0))
        for change in (lambda: setattr(self.body, "position", (math.nan, 0)),
                       lambda: setattr(self.body, "linearDamping", -1),
                       lambda: setattr(self.body, "angularVelocity", math.inf),
                       lambda: setattr(self.body, "type", 7),
                       lambda: setattr(self.body.fixtures[0], "friction", -1),
                       lambda: setattr(self.body.fixtures[0], "categoryBits", 0x10000),
                       lambda: setattr(joint, "limits", (1, -1)),
                       lambda: setattr(joint, "maxMotorTorque", -1),
                       lambda: setattr(self.world, "subStepCount", 0),
                       lambda: self.world.Step(-1, 8, 3),
                       lambda: self.world.Step(1 / 60, -8, 3),
                       lambda: self.world.CreateDynamicBody(linearVelocity=(math.nan, 0)),
                       lambda: self.body.CreateCircleFixture(radius=1, density=-1),
                       lambda: self.body.fixtures[0].GetAABB(1),
                       lambda: self.world.RayCast(lambda *_: 1, (0, 0), (math.nan, 0))):
            with self.assertRaises(b2Error):
                change()
        self.assertEqual(self.world.subStepCount, 1)

    def test_an_error_is_raised_by_the_call_that_made_it(self):
        empty, box, place = b2PolygonShape(), b2PolygonShape(box=(1, 1)), Box2D.b2Transform()
        for use in (lambda: empty.getMass(1), lambda: empty.getAABB(place), lambda: empty.TestPoint(place, (0, 0)),
                    lambda: empty.RayCast((0, 0), (1, 0), 1, place), lambda: Box2D.b2Distance(shapeA=empty, shapeB=box),
                    lambda: Box2D.b2TestOverlap(empty, 0, box, 0, place, place)):
            with self.assertRaises(b2Error):
                use()
            self.world.gravity = 0, -10  # raised the error of the call before

    def test_errors_are_caught_as_three_builtin_kinds(self):
        for kind in (ValueError, AssertionError, RuntimeError):
            with self.assertRaises(kind):
                self.body.linearDamping = -1

    def test_wrong_types_name_the_argument(self):
        for change, name in ((lambda: setattr(self.body, "angle", "x"), "angle"),
                             (lambda: self.body.ApplyForce(1, (0, 0), True), "force"),
                             (lambda: self.world.CreateDynamicBody(position=5), "b2Vec2"),
                             (lambda: self.world.CreateDynamicBody(positon=(0, 0)), "position"),
                             (lambda: self.world.CreateDynamicBody(fixtures=3), "b2FixtureDef"),
                             (lambda: self.world.Step(None, 8, 3), "timeStep"),
                             (lambda: self.world.CreateJoint(5), "joint")):
            with self.assertRaisesRegex(TypeError, name):
                change()

    def test_wrong_calls_name_the_expected_arguments(self):
        world, body = self.world, self.body
        for call, text in ((lambda: world.DestroyBody(None), r"^b2World.DestroyBody: expected \(body\), not \(None\)$"),
                           (lambda: world.Step(1 / 60), r"^b2World.Step: expected \(timeStep, .*\), not \('float'\)$"),
                           (lambda: body.ApplyForce((1, 2)), r"^b2Body.ApplyForce: expected \(force, point, wake\)"),
                           (lambda: Box2D.b2Dot(1), r"^b2Dot: expected \(a, b\), not \('int'\)$"),
                           (lambda: Box2D.b2Vec2(1, 2, 3), r"^b2Vec2: expected \(x, y\), not \('int', 'int', 'int'\)$"),
                           (lambda: body.GetWorldPoint(localpoint=(1, 2)), "did you mean 'localPoint'"),
                           (lambda: Box2D.b2GetPointStates(None, None), "^b2GetPointStates: expected two b2Manifold, not None$"),
                           (lambda: body.fixtures[0].RayCast(3), "^b2Fixture.RayCast: input: .*, not 'int'$"),
                           (lambda: body.fixtures[0].RayCast(p1=(0, 0)), "^b2Fixture.RayCast: .*p2 is missing$"),
                           (lambda: world.CreateJoint(type=3), "^type: expected a class of joint definitions, not 3$"),
                           (lambda: Box2D.b2Body(), "^b2Body: "),
                           (lambda: boxreel.film("a.mp4", fpss=3), "^film: .*, not \\('str', fpss='int'\\).*'fpss'"),
                           (lambda: Box2D.b2Abs("a"), "^a: expected a b2Vec2"),
                           (lambda: Box2D.b2Mul("a", "b"), "^a: expected a b2Transform"),
                           (lambda: setattr(Box2D.b2Draw(), "flags", {"drawShape": True}), "did you mean 'drawShapes'")):
            with self.assertRaisesRegex(TypeError, text):
                call()

    def test_the_class_of_an_object_stays(self):
        for item in (self.world, self.body, Box2D.b2Vec2(1, 2), b2CircleShape(radius=1)):
            for other in (b2World, Box2D.b2Body, Box2D.b2Vec2):
                with self.assertRaisesRegex(TypeError, "__class__ cannot be set"):
                    item.__class__ = other
            self.assertIs(item.__class__, type(item))

    def test_sentences_have_names_of_python(self):
        for change, text in ((lambda: setattr(self.body, "position", (math.nan, 0)), "^b2Body.transform needs"),
                             (lambda: setattr(self.body, "linearVelocity", (1e39, 0)), "^b2Body.linearVelocity needs"),
                             (lambda: Box2D.b2Vec2(Box2D.b2Rot(0)), "not 'b2Rot'$"),
                             (lambda: Box2D.b2CheckPolygon(b2World), "not the class b2World$")):
            with self.assertRaisesRegex((b2Error, TypeError), text):
                change()

    def test_exceptions_of_the_program_are_its_own(self):
        class Pair:
            def __len__(self):
                return 2

            def __getitem__(self, index):
                raise KeyError("mine")

        class Number:
            def __float__(self):
                raise KeyError("mine")

        for value in (Pair(), (Number(), 1)):
            with self.assertRaises(KeyError):
                b2World().gravity = value

    def test_wrong_calls_raise_no_message_of_python(self):
        """Calls of everything public with wrong arguments, which fail with our words, work, or do nothing."""
        foreign = re.compile("positional argument|unexpected keyword|incompatible function|object is not|has no setter"
                             "|unsupported operand|has no attribute '(?!nonsense)|indices must|not supported between|_boxreel")
        joint = self.world.CreateRevoluteJoint(bodyA=ground(self.world), bodyB=self.body, anchor=(0, 0))
        for _ in range(60):
            self.world.Step(1 / 60, 8, 3)
        objects = [self.world, self.body, self.body.fixtures[0], joint, *self.world.contacts, self.world.contactManager,
                   Box2D.b2Globals]
        for one in (getattr(Box2D, name) for name in Box2D.__all__):
            if isinstance(one, type) and not issubclass(one, (Exception, list, tuple)):
                with contextlib.suppress(TypeError, ValueError, b2Error):  # of those that the engine makes
                    objects.append(one())
        calls = [(name, getattr(module, name)) for module in (Box2D, boxreel) for name in module.__all__
                 if callable(getattr(module, name))]
        for item in objects:
            names = [name for name in dir(type(item)) if not name.startswith("_") or name in ("__getitem__", "__setitem__")]
            for name in names:
                full = f"{type(item).__name__}.{name}"
                if isinstance(getattr(type(item), name), property):
                    calls.append((full, lambda *values, item=item, name=name, **keywords: setattr(item, name, values)))
                elif callable(getattr(type(item), name)) and name not in (
                        "Step", "Dump", "DestroyBody", "DestroyFixture", "DestroyJoint"):
                    calls.append((full, lambda *values, item=item, name=name, **keywords:
                                  getattr(item, name)(*values, **keywords)))
        count = 0
        for name, call in calls:
            for values in ((), (1,), (None,), ("x",), (1, 2), (None, None, None), (object(),), (slice(None),), (1,) * 10):
                for keywords in ({}, {"nonsense": 1}):
                    with self.subTest(call=name, values=values, keywords=keywords):
                        try:
                            call(*values, **keywords)
                        except (TypeError, ValueError, AttributeError, LookupError, b2Error, OSError, NotImplementedError,
                                boxreel.Error) as error:
                            count += 1
                            self.assertNotRegex(str(error), foreign)
        self.assertGreater(count, 5000)

    def test_definitions_and_bodies_may_be_positional(self):
        world = self.world
        body = world.CreateStaticBody(Box2D.b2BodyDef(position=(3, 4)))
        self.assertEqual((body.type, tuple(body.position)), (Box2D.b2_staticBody, (3, 4)))
        definition = b2FixtureDef(b2CircleShape(radius=2), density=1)
        self.assertEqual(self.body.CreateFixture(definition).shape.radius, 2)
        joint = world.CreateWeldJoint(body, self.body, anchor=(1, 1))
        self.assertIs(joint.bodyB, self.body)
        self.assertIs(world.CreateWeldJoint(Box2D.b2WeldJointDef(body, self.body)).bodyA, body)
        for call in (lambda: b2FixtureDef(1, 2), lambda: b2FixtureDef(b2CircleShape(), shape=b2CircleShape()),
                     lambda: Box2D.b2WeldJointDef(1, 2), lambda: Box2D.b2BodyDef(1)):
            with self.assertRaises(TypeError):
                call()

    def test_unknown_keywords_name_the_nearest(self):
        for call, near in ((lambda: self.body.CreateCircleFixture(raduis=1), "radius"),
                           (lambda: b2CircleShape(raduis=1), "radius"),
                           (lambda: Box2D.b2Vec2(X=1), "x"),
                           (lambda: self.world.CreateDynamicBody(pos=(0, 0)), "position"),
                           (lambda: self.body.CreatePolygonFixture(box=(1, 1), frction=1), "friction"),
                           (lambda: b2World(gravty=(0, 0)), "gravity"),
                           (lambda: Box2D.b2RevoluteJointDef(enableMoter=True), "enableMotor")):
            with self.assertRaisesRegex(TypeError, f"did you mean '{near}'"):
                call()

    def test_callbacks_of_a_wrong_kind_are_refused(self):
        for name in ("contactListener", "contactFilter", "destructionListener", "renderer"):
            for value in (3, object()):
                with self.assertRaisesRegex(TypeError, f"{name}: expected a b2.* or None"):
                    setattr(self.world, name, value)
            self.assertIsNone(getattr(self.world, name))

    def test_joints_need_two_bodies_of_this_world(self):
        second = b2World()
        other = ball(second)
        for bodies in ({}, {"bodyA": self.body}, {"bodyA": self.body, "bodyB": self.body},
                       {"bodyA": self.body, "bodyB": other}):
            with self.assertRaises(ValueError):
                self.world.CreateWeldJoint(**bodies)
        with self.assertRaises(b2Error):
            self.world.DestroyBody(other)


class Destroying:
    """A number whose conversion destroys a body."""

    def __init__(self, world, body):
        self.world, self.body = world, body

    def __float__(self):
        if self.body in self.world.bodies:
            self.world.DestroyBody(self.body)
        return 1.0


class Conversions(unittest.TestCase):
    """Arguments whose conversion runs code."""

    def test_a_body_its_argument_destroys_is_refused(self):
        for use in (lambda body, bad: body.CreateCircleFixture(radius=1, density=bad),
                    lambda body, bad: body.CreateFixture(shape=b2CircleShape(radius=1), friction=bad),
                    lambda body, bad: body.ApplyForce((bad, 0), (0, 0)),
                    lambda body, bad: body.ApplyTorque(bad),
                    lambda body, bad: body.ApplyLinearImpulseToCenter((0, bad)),
                    lambda body, bad: body.GetWorldPoint((bad, 0)),
                    lambda body, bad: body.fixtures[0].TestPoint((bad, 0)),
                    lambda body, bad: setattr(body.fixtures[0], "friction", bad),
                    *(lambda body, bad, name=name: setattr(body, name, bad)
                      for name in ("angle", "mass", "inertia", "linearDamping", "gravityScale")),
                    *(lambda body, bad, name=name: setattr(body, name, (bad, 0))
                      for name in ("position", "linearVelocity", "localCenter"))):
            world = b2World()
            body = ball(world)
            with self.assertRaises(b2Error):
                use(body, Destroying(world, body))

    def test_a_joint_its_argument_destroys_is_refused(self):
        world = b2World()
        for use in (lambda joint, bad: setattr(joint, "maxMotorTorque", bad), lambda joint, bad: joint.SetLimits(0, bad),
                    lambda joint, bad: joint.GetReactionForce(bad)):
            body = ball(world)
            joint = world.CreateRevoluteJoint(bodyA=ground(world), bodyB=body, anchor=(0, 0))
            with self.assertRaises(b2Error):
                use(joint, Destroying(world, body))

    def test_a_joint_whose_definition_kills_a_body_fails(self):
        world = b2World()
        body = ball(world)
        definition = Box2D.b2RevoluteJointDef(bodyA=body, bodyB=ground(world))
        definition.motorSpeed = Destroying(world, body)
        with self.assertRaises(b2Error):
            world.CreateJoint(definition)
        self.assertEqual(world.jointCount, 0)

    def test_a_list_that_its_item_empties_is_refused(self):
        pair = []
        clears = type("Clears", (), {"__float__": lambda self: pair.clear() or 1.0})()
        pair[:] = [clears, 2]
        with self.assertRaises(TypeError):
            Box2D.b2Vec2(pair)

    def test_sequences_are_read_up_to_their_length(self):
        class Endless:
            def __init__(self, item, length):
                self.item, self.length = item, length

            def __len__(self):
                return self.length

            def __getitem__(self, index):
                return self.item

        self.assertEqual(Box2D.b2Vec2(Endless(3, 2)), (3, 3))
        with self.assertRaises(TypeError):
            Box2D.b2Vec2(Endless(3, 5))
        with self.assertRaises(ValueError):
            b2PolygonShape(vertices=Endless((0, 0), 4))


class Uninitialized(unittest.TestCase):
    def test_objects_refuse_every_use(self):
        for cls in (value for value in vars(Box2D).values() if isinstance(value, type)):
            try:
                made = cls.__new__(cls)
            except TypeError:
                continue
            for name in dir(cls):
                if name not in ("__class__", "__new__", "__init__"):
                    try:
                        value = getattr(made, name)
                        value() if callable(value) else None
                    except (TypeError, AttributeError, LookupError, ValueError):
                        pass
        for cls, name in ((Box2D.b2Body, "position"), (Box2D.b2Vec2, "x"), (b2World, "gravity")):
            with self.assertRaises(TypeError):
                getattr(cls.__new__(cls), name)

    def test_constructors_refuse_other_objects(self):
        world = b2World()
        body = ball(world)
        fixture = body.fixtures[0]
        for cls in (value for value in vars(Box2D).values() if isinstance(value, type)):
            for other in (body, fixture, fixture.shape, fixture.filterData, body.linearVelocity, world, None):
                for name in ("__init__", "__setstate__", "__copy__"):
                    for arguments in ((), (1, 2), ((1, 2),)):
                        try:
                            getattr(cls, name)(other, *arguments)
                        except (TypeError, AttributeError, ValueError):
                            pass


class Reentrance(unittest.TestCase):
    """Code of the program that runs where the engine or a list is half done."""

    def test_bodies_are_read_while_one_is_destroyed(self):
        class Goodbye(b2DestructionListener):
            def SayGoodbye(self, gone):
                self.seen = len(gone.body.world.bodies)

        class Contacts(b2ContactListener):
            def EndContact(self, contact):
                list(contact.fixtureA.body.world.bodies)

        goodbye, contacts = Goodbye(), Contacts()
        world = b2World(destructionListener=goodbye, contactListener=contacts)
        ground(world)
        balls = [ball(world, (i, 0.4)) for i in range(3)]
        world.Step(1 / 60, 8, 3)
        world.DestroyBody(balls[0])
        self.assertEqual(goodbye.seen, 4)
        self.assertEqual(len(world.bodies), 3)
        self.assertEqual(world.poses().shape, (3, 3))
        self.assertTrue(all(body.position.y < 5 for body in world.bodies))

    def test_collector_destroys_bodies_during_a_list(self):
        class Sprite:
            def __init__(self, world):
                self.me, self.world = self, world
                self.body = world.CreateDynamicBody()

            def __del__(self):
                self.world.DestroyBody(self.body)

        before = gc.get_threshold()
        gc.set_threshold(1)
        try:
            for read in (lambda world: world.bodies, lambda world: list(world), lambda world: copy.deepcopy(world)):
                for _ in range(20):
                    world = b2World()
                    for _ in range(20):
                        world.CreateDynamicBody()
                    for _ in range(5):
                        Sprite(world)
                    read(world)
        finally:
            gc.set_threshold(*before)

    def test_other_threads_are_refused_during_a_callback(self):
        inside, done, refused = threading.Event(), threading.Event(), []

        class Waits(b2ContactListener):
            def BeginContact(self, contact):
                inside.set()
                done.wait(10)

        world = b2World(contactListener=Waits())
        ground(world)
        body = ball(world)

        def other():
            inside.wait(10)
            for use in (lambda: world.QueryAABB(lambda fixture: True, Box2D.b2AABB(lowerBound=(-9, -9), upperBound=(9, 9))),
                        lambda: body.position, lambda: world.Step(1 / 60, 8, 3)):
                try:
                    use()
                except b2Error:
                    refused.append(use)
            done.set()

        thread = threading.Thread(target=other)
        thread.start()
        world.Step(1 / 60, 8, 3)
        thread.join()
        self.assertEqual(len(refused), 3)

    def test_program_ends_while_a_thread_steps(self):
        program = ("import threading, time, Box2D\n"
                   "world = Box2D.b2World()\n"
                   "for i in range(100): world.CreateDynamicBody(position=(i, 0)).CreateCircleFixture(radius=1, density=1)\n"
                   "def run():\n    while True: world.Step(1 / 60, 8, 3)\n"
                   "threading.Thread(target=run, daemon=True).start()\ntime.sleep(0.2)\n")
        for _ in range(3):
            self.assertEqual(subprocess.run([sys.executable, "-c", program], timeout=60).returncode, 0)

    def test_first_arrays_may_come_from_several_threads(self):
        program = """
import threading
from Box2D import b2World
import boxreel
worlds = [b2World() for _ in range(4)]
for call in (lambda world: world.poses(), lambda world: boxreel.render(world, (64, 36))):
    threads = [threading.Thread(target=call, args=(world,), daemon=True) for world in worlds]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(20)
    assert not any(thread.is_alive() for thread in threads)
"""
        subprocess.run([sys.executable, "-c", program], check=True, timeout=120)

    def test_forked_process_leaves_the_film_of_its_parent(self):
        program = ("import os, sys, Box2D, boxreel\n"
                   "world = Box2D.b2World(); world.CreateDynamicBody().CreateCircleFixture(radius=1, density=1)\n"
                   "film = boxreel.film(sys.argv[1], size=(16, 16)); film.add(world)\n"
                   "child = os.fork()\n"
                   "if child == 0:\n"
                   "    try: film.add(world)\n"
                   "    except Box2D.b2Error: pass\n"
                   "    del film\n"
                   "    os._exit(7)\n"
                   "status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])\n"
                   "film.close()\n"
                   "raise SystemExit(status)\n")
        with tempfile.TemporaryDirectory() as folder:
            result = subprocess.run([sys.executable, "-c", program, folder + "/film.mp4"], timeout=60, capture_output=True)
            self.assertEqual(result.returncode, 7, result.stderr)
            self.assertGreater(os.path.getsize(folder + "/film.mp4"), 500)

    def test_forked_process_refuses_to_film(self):
        program = ("import os, Box2D, boxreel\n"
                   "world = Box2D.b2World(); world.CreateDynamicBody().CreateCircleFixture(radius=1, density=1)\n"
                   "boxreel.render(world, (16, 16))\n"
                   "child = os.fork()\n"
                   "if child == 0:\n"
                   "    try: boxreel.film('never.mp4', size=(16, 16)).add(world)\n"
                   "    except Box2D.b2Error: os._exit(7)\n"
                   "    os._exit(1)\n"
                   "raise SystemExit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))\n")
        result = subprocess.run([sys.executable, "-c", program], timeout=60, capture_output=True)
        self.assertEqual(result.returncode, 7, result.stderr)


class Destroyed(unittest.TestCase):
    def test_objects_refuse_every_use(self):
        world = b2World()
        body = ball(world)
        fixture = body.fixtures[0]
        joint = world.CreateWeldJoint(bodyA=ground(world), bodyB=body, anchor=(0, 0))
        body.mark = 1
        world.DestroyBody(body)
        for use in (lambda: body.position, lambda: body.ApplyTorque(1, True), lambda: world.DestroyBody(body),
                    lambda: body.fixtures, lambda: body.CreateCircleFixture(radius=1), lambda: fixture.shape,
                    lambda: setattr(fixture, "friction", 1), lambda: joint.anchorA, lambda: world.DestroyJoint(joint),
                    lambda: body.userData, lambda: body.next, lambda: fixture.body, lambda: joint.bodyA):
            with self.assertRaises(b2Error):
                use()
        self.assertEqual(body.mark, 1)
        self.assertIn("destroyed", repr(body))

    def test_objects_of_a_dropped_world_refuse(self):
        world = b2World()
        body, contacts = ball(world), None
        ground(world)
        world.Step(1 / 60, 8, 3)
        contacts = world.contacts
        del world
        with self.assertRaises(b2Error):
            body.position
        with self.assertRaises(b2Error):
            contacts[0].touching

    def test_contacts_that_are_gone_refuse(self):
        world = b2World()
        ground(world)
        body = ball(world)
        world.Step(1 / 60, 8, 3)
        contact = world.contacts[0]
        self.assertTrue(contact.touching)
        world.Step(1 / 60, 8, 3)
        self.assertTrue(contact.touching)
        self.assertEqual(contact, body.contacts[0].contact)
        world.DestroyBody(body)
        with self.assertRaises(b2Error):
            contact.touching

    def test_a_world_without_references_is_freed_at_once(self):
        world = b2World()
        ball(world).CreateCircleFixture(radius=1)
        gone = weakref.ref(world)
        gc.disable()
        try:
            del world
            self.assertIsNone(gone())
        finally:
            gc.enable()

    def test_cycles_are_collected(self):
        class Environment(b2ContactListener):
            def __init__(self):
                super().__init__()
                self.world = b2World(contactListener=self)
                self.body = ball(self.world)
                self.body.userData = self
                self.body.fixtures[0].owner = self

        environment = Environment()
        gone = weakref.ref(environment), weakref.ref(environment.body), weakref.ref(environment.world)
        del environment
        gc.collect()
        self.assertEqual([each() for each in gone], [None, None, None])

    def test_objects_are_freed_in_any_order(self):
        dice = random.Random(1)
        for _ in range(20):
            world = b2World()
            things = [world, ground(world)] + [ball(world, (i, 0.4)) for i in range(6)]
            things += [world.CreateRevoluteJoint(bodyA=things[2], bodyB=body, anchor=(0, 0)) for body in things[3:6]]
            for _ in range(5):
                world.Step(1 / 60, 8, 3)
                gc.collect()
                things += world.contacts + [f for body in world.bodies for f in body.fixtures]
            world.DestroyBody(things[2])
            del world
            while things:
                things.pop(dice.randrange(len(things)))
                gc.collect(0)
                for thing in things:
                    repr(thing)


class Callbacks(unittest.TestCase):
    def setUp(self):
        self.world = b2World()
        self.ground = ground(self.world)
        self.body = ball(self.world)

    def step_with(self, **functions):
        self.world.contactListener = type("Listener", (b2ContactListener,), functions)()
        self.world.Step(1 / 60, 8, 3)

    def test_listener_receives_all_four_events(self):
        heard = []
        listener = type("Listener", (b2ContactListener,), {
            "BeginContact": lambda self, contact: heard.append("begin"),
            "EndContact": lambda self, contact: heard.append("end"),
            "PreSolve": lambda self, contact, old: heard.append(("pre", old.pointCount)),
            "PostSolve": lambda self, contact, impulse: heard.append(("post", impulse.normalImpulses[0] > 0))})
        self.world.contactListener = listener()
        self.world.Step(1 / 60, 8, 3)
        self.body.position = 0, 5
        self.world.Step(1 / 60, 8, 3)
        self.assertEqual(heard, ["begin", ("pre", 0), ("post", True), "end"])

    def test_presolve_can_disable_a_contact(self):
        self.step_with(PreSolve=lambda self, contact, old: setattr(contact, "enabled", False))
        self.assertLess(self.body.linearVelocity.y, 0)

    def test_exceptions_reach_the_caller(self):
        for name in ("BeginContact", "PreSolve", "PostSolve"):
            self.setUp()

            def fail(*arguments):
                raise KeyError(name)

            with self.assertRaisesRegex(KeyError, name):
                self.step_with(**{name: fail})
            self.world.contactListener = None
            self.world.Step(1 / 60, 8, 3)

    def test_only_the_first_exception_counts(self):
        ball(self.world, (3, 0.4))
        calls = []

        def fail(self, contact):
            calls.append(contact)
            raise ValueError("once")

        with self.assertRaises(ValueError):
            self.step_with(BeginContact=fail)
        self.assertEqual(len(calls), 1)

    def test_the_world_cannot_be_changed(self):
        world, body, fixture = self.world, self.body, self.body.fixtures[0]
        for change in (lambda: world.DestroyBody(body), lambda: world.CreateStaticBody(),
                       lambda: body.CreateCircleFixture(radius=1), lambda: body.DestroyFixture(fixture),
                       lambda: world.CreateWeldJoint(bodyA=world.bodies[0], bodyB=body, anchor=(0, 0)),
                       lambda: setattr(body, "position", (0, 9)), lambda: setattr(body, "active", False),
                       lambda: setattr(body, "type", 0), lambda: world.Step(1 / 60, 8, 3), lambda: world.ShiftOrigin((1, 0)),
                       lambda: copy.deepcopy(world)):
            self.world.contactListener = None
            self.body.position = 0, 0.4
            self.world.Step(0, 0, 0)
            with self.assertRaises(b2Error):
                self.step_with(PreSolve=lambda self, contact, old: change())
            self.assertEqual(self.world.bodyCount, 2)
        world.contactListener = None
        world.DestroyBody(body)

    def test_listener_may_be_removed_inside(self):
        self.step_with(BeginContact=lambda listener, contact: setattr(self.world, "contactListener", None))
        self.assertIsNone(self.world.contactListener)
        self.world.Step(1 / 60, 8, 3)

    def test_filter_prevents_contacts(self):
        class Filter(b2ContactFilter):
            def ShouldCollide(self, fixtureA, fixtureB):
                return b2ContactFilter.ShouldCollide(self, fixtureA, fixtureB) and self.allows

        self.world.contactFilter = Filter(allows=False)
        self.world.Step(1 / 60, 8, 3)
        self.assertEqual(self.world.contactCount, 0)

    def test_destruction_listener_gets_joint_and_fixture(self):
        gone = []

        class Listener(b2DestructionListener):
            def SayGoodbye(self, object):
                gone.append((type(object), object.userData))

        joint = self.world.CreateWeldJoint(bodyA=self.ground, bodyB=self.body, anchor=(0, 0), userData="j")
        self.body.fixtures[0].userData = "f"
        self.world.destructionListener = Listener()
        self.world.DestroyBody(self.body)
        self.assertEqual(gone, [(Box2D.b2WeldJoint, "j"), (Box2D.b2Fixture, "f")])
        with self.assertRaises(b2Error):
            joint.anchorA

    def test_destroying_in_say_goodbye_is_refused(self):
        class Listener(b2DestructionListener):
            def SayGoodbye(listener, object):
                self.world.DestroyBody(self.ground)

        self.world.destructionListener = Listener()
        with self.assertRaises(b2Error):
            self.world.DestroyBody(self.body)
        self.assertEqual(self.world.bodies, [self.ground])

    def test_queries_pass_exceptions(self):
        def fail(*arguments):
            raise KeyError("query")

        with self.assertRaises(KeyError):
            self.world.QueryAABB(fail, Box2D.b2AABB((-9, -9), (9, 9)))
        with self.assertRaises(KeyError):
            self.world.RayCast(fail, (0, 9), (0, -9))
        with self.assertRaises(TypeError):
            self.world.RayCast(lambda *_: None, (0, 9), (0, -9))


class Copies(unittest.TestCase):
    def setUp(self):
        self.world = b2World()
        ground(self.world)
        self.body = ball(self.world, (0, 3))
        self.body.friend = ball(self.world, (0.2, 6))
        self.body.userData = [self.body]
        self.joint = self.world.CreateDistanceJoint(bodyA=self.body, bodyB=self.body.friend, anchorA=(0, 3),
                                                    anchorB=(0.2, 6))
        self.joint.name = "rod"

    def run_world(self, world, steps=60):
        for _ in range(steps):
            world.Step(1 / 60, 8, 3)
        return world.poses().tobytes()

    def test_copies_and_pickles_continue_with_the_same_bits(self):
        self.run_world(self.world, 20)
        twins = [copy.deepcopy(self.world), copy.copy(self.world), pickle.loads(pickle.dumps(self.world))]
        expected = self.run_world(self.world)
        for twin in twins:
            body = twin.bodies[1]
            self.assertIs(body.friend, twin.bodies[2])
            self.assertIs(body.userData[0], body)
            self.assertEqual(twin.joints[0].name, "rod")
            self.assertEqual(self.run_world(twin), expected)
        self.assertIsNot(twins[0].bodies[1], self.body)

    def test_every_protocol_of_pickle_is_supported(self):
        values = Box2D.b2Vec2(1, 2), Box2D.b2Color(1, 0, 0), b2PolygonShape(box=(1, 2)), Box2D.b2Sweep(c=(1, 2), a=3)
        for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
            for value in values:
                twin = pickle.loads(pickle.dumps(value, protocol))
                self.assertEqual(repr(twin), repr(value))
            world = pickle.loads(pickle.dumps(self.world, protocol))
            self.assertIs(world.bodies[1].friend, world.bodies[2])
            self.assertEqual(self.world.bodies[1].__reduce__(), self.body.__reduce_ex__(protocol))
        self.assertEqual(len(self.world.__reduce__()), 3)

    def test_a_body_alone_is_copied_with_its_world(self):
        for copied in (copy.deepcopy(self.body), pickle.loads(pickle.dumps(self.body))):
            self.assertEqual(copied.position, self.body.position)
            copied.position = (7, 7)
            self.assertNotEqual(copied.position, self.body.position)
            self.assertIsNot(copied.world, self.body.world)

    def test_contacts_and_profiles_refuse_to_be_copied(self):
        self.body.position = 0, 0.4
        self.world.Step(1 / 60, 8, 3)
        for value in (self.world.contacts[0], self.world.profile):
            for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
                with self.assertRaisesRegex(TypeError, "cannot be copied or pickled"):
                    pickle.dumps(value, protocol)
            for use in (value.__reduce__, lambda: copy.copy(value), lambda: copy.deepcopy(value)):
                with self.assertRaises(TypeError):
                    use()

    def test_a_program_that_holds_a_world_is_copied(self):
        class Environment:
            pass

        environment = Environment()
        environment.body, environment.world = self.body, self.world
        twin = copy.deepcopy(environment)
        self.assertIs(twin.body, twin.world.bodies[1])
        world, body = pickle.loads(pickle.dumps((self.world, self.body)))
        self.assertIs(body, world.bodies[1])
        self.assertIs(body.userData[0], body)

    def test_restore_keeps_the_objects(self):
        snapshot = self.world._save()
        first = self.run_world(self.world)
        later = ball(self.world, (9, 9))
        self.body.position = 5, 5
        self.world._restore(snapshot)
        self.assertEqual((self.body.position, self.world.bodies[1]), ((0, 3), self.body))
        self.assertEqual(self.joint.name, "rod")
        with self.assertRaises(b2Error):
            later.position
        self.assertEqual(self.run_world(self.world), first)

    def test_restore_keeps_destroyed_objects_invalid(self):
        snapshot = self.world._save()
        self.world.DestroyBody(self.body)
        self.world._restore(snapshot)
        self.assertEqual(self.world.bodyCount, 3)
        with self.assertRaises(b2Error):
            self.body.position

    def test_a_snapshot_of_another_world_is_restored(self):
        other = b2World()
        other.CreateStaticBody().CreatePolygonFixture(box=(1, 1))
        other.CreateStaticBody()
        self.world._restore(other._save())
        self.assertEqual(self.world.bodyCount, 2)
        for thing in (self.body, self.joint, *self.world.bodies):
            repr(thing)
        self.run_world(self.world)

    def test_a_damaged_snapshot_changes_nothing(self):
        with self.assertRaises(b2Error):
            self.world._restore(self.world._save()[:-9])
        self.assertEqual(self.body.position, (0, 3))


class Threads(unittest.TestCase):
    def test_worlds_are_stepped_at_once_with_the_same_bits(self):
        def build():
            world = b2World()
            ground(world)
            for i in range(60):
                ball(world, (i % 8, 1 + i // 8))
            return world

        def run(world):
            for _ in range(50):
                world.Step(1 / 60, 8, 3)

        worlds = [build() for _ in range(6)]
        threads = [threading.Thread(target=run, args=(world,)) for world in worlds]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len({world.poses().tobytes() for world in worlds}), 1)

    def test_another_thread_is_refused_during_a_step(self):
        world = b2World()
        ground(world)
        bodies = [ball(world, (i % 40, 1 + i // 40)) for i in range(2000)]
        stop = threading.Event()
        problems = []

        def watch():
            while not stop.is_set():
                try:
                    bodies[0].position
                except b2Error:
                    pass
                except BaseException as error:  # any other is a failure
                    problems.append(error)

        thread = threading.Thread(target=watch)
        thread.start()
        for _ in range(30):
            world.Step(1 / 60, 8, 3)
        stop.set()
        thread.join()
        self.assertEqual(problems, [])


if __name__ == "__main__":
    unittest.main()
