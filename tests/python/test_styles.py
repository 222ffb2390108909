# SPDX-License-Identifier: MIT
"""Programs of our own in the styles that are common for the 2.3 module: a test bed with settings and a renderer, scenes
with listeners, and environments for learning."""

import math
import random
import unittest

import Box2D
from Box2D import *  # noqa: F401,F403  as such programs do
from Box2D.b2 import (chainShape, circleShape, contactListener, dynamicBody, edgeShape, filter as b2filter, fixtureDef,
                      polygonShape, revoluteJointDef, staticBody, world as newWorld)

# flake8: noqa: F405


class Settings:
    hz, velocityIterations, positionIterations = 60.0, 8, 3
    enableWarmStarting, enableContinuous, enableSubStepping = True, True, False
    drawShapes, drawJoints, drawAABBs, drawPairs, drawCOMs, drawContactPoints = True, True, True, True, True, True
    maxContactPoints = 100


class ScreenDraw(b2DrawExtended):
    """Notes what a window would draw."""
    axisScale = 10.0

    def __init__(self, test=None, **kwargs):
        b2DrawExtended.__init__(self, **kwargs)
        self.flipX, self.flipY, self.convertVertices = False, True, True
        self.test, self.calls, self.frames = test, [], 0

    def StartDraw(self):
        self.zoom, self.center = self.test.viewZoom, self.test.viewCenter
        self.offset, self.screenSize = self.test.viewOffset, self.test.screenSize
        self.frames += 1

    def EndDraw(self):
        pass

    def note(self, name, color, *points):
        assert all(isinstance(c, int) and 0 <= c <= 255 for c in color.bytes), color
        for x, y in points:
            assert x == int(x) and y == int(y)
        self.calls.append(name)

    def DrawPoint(self, p, size, color):
        self.note("point", color, p)

    def DrawAABB(self, aabb, color):
        points = [(aabb.lowerBound.x, aabb.lowerBound.y), (aabb.upperBound.x, aabb.lowerBound.y)]
        self.calls.append("aabb")
        assert points[0][0] <= points[1][0]

    def DrawSegment(self, p1, p2, color):
        self.note("segment", color, p1, p2)

    def DrawTransform(self, xf):
        p1 = xf.position
        self.note("transform", b2Color(1, 0, 0), self.to_screen(p1), self.to_screen(p1 + self.axisScale * xf.R.x_axis),
                  self.to_screen(p1 + self.axisScale * xf.R.y_axis))

    def DrawCircle(self, center, radius, color, drawwidth=1):
        self.note("circle", color, center)

    def DrawSolidCircle(self, center, radius, axis, color):
        radius *= self.zoom
        radius = max(int(radius), 1)
        fill = (color / 2).bytes + [127]
        assert len(fill) == 4
        self.note("solid circle", color, center)
        return center[0] - radius * axis[0], center[1] + radius * axis[1]

    def DrawPolygon(self, vertices, color):
        if vertices:
            self.note("polygon", color, *vertices)

    def DrawSolidPolygon(self, vertices, color):
        if len(vertices) == 2:
            self.note("segment", color, *vertices)
        else:
            (color / 2).bytes + [127]
            self.note("solid polygon", color, *vertices)


class PointQuery(b2QueryCallback):
    def __init__(self, p):
        super(PointQuery, self).__init__()
        self.point, self.fixture = p, None

    def ReportFixture(self, fixture):
        body = fixture.body
        if body.type == b2_dynamicBody and fixture.TestPoint(self.point):
            self.fixture = fixture
            return False
        return True


class Goodbyes(b2DestructionListener):
    def __init__(self, test, **kwargs):
        super(Goodbyes, self).__init__(**kwargs)
        self.test = test

    def SayGoodbye(self, object):
        if isinstance(object, b2Joint):
            if self.test.mouseJoint == object:
                self.test.mouseJoint = None
            else:
                self.test.JointDestroyed(object)
        elif isinstance(object, b2Fixture):
            self.test.FixtureDestroyed(object)


class Framework(b2ContactListener):
    name, description = "None", None

    def __init__(self):
        super(Framework, self).__init__()
        self.settings = Settings()
        self.points, self.gone = [], []
        self.mouseJoint, self.stepCount = None, 0
        self.world = b2World(gravity=(0, -10), doSleep=True)
        self.destructionListener = Goodbyes(test=self)
        self.world.destructionListener = self.destructionListener
        self.world.contactListener = self
        self.viewZoom, self.screenSize = 10.0, b2Vec2(640, 480)
        self.setCenter((0, 20.0))
        self.renderer = ScreenDraw(test=self)
        self.world.renderer = self.renderer

    def setCenter(self, value):
        self.viewCenter = b2Vec2(*value)
        self.viewCenter *= self.viewZoom
        self.viewOffset = self.viewCenter - self.screenSize / 2

    def Step(self, settings):
        self.stepCount += 1
        timeStep = 1.0 / settings.hz if settings.hz > 0.0 else 0.0
        renderer = self.renderer
        renderer.flags = dict(drawShapes=settings.drawShapes, drawJoints=settings.drawJoints, drawAABBs=settings.drawAABBs,
                              drawPairs=settings.drawPairs, drawCOMs=settings.drawCOMs,
                              convertVertices=isinstance(renderer, b2DrawExtended))
        self.world.warmStarting = settings.enableWarmStarting
        self.world.continuousPhysics = settings.enableContinuous
        self.world.subStepping = settings.enableSubStepping
        self.points = []
        self.world.Step(timeStep, settings.velocityIterations, settings.positionIterations)
        self.world.ClearForces()
        renderer.StartDraw()
        self.world.DrawDebugData()
        if self.mouseJoint:
            p1, p2 = renderer.to_screen(self.mouseJoint.anchorB), renderer.to_screen(self.mouseJoint.target)
            renderer.DrawPoint(p1, 5, b2Color(0, 1, 0))
            renderer.DrawSegment(p1, p2, b2Color(0.8, 0.8, 0.8))
        if settings.drawContactPoints:
            for point in self.points:
                if point["state"] == b2_addState:
                    renderer.DrawPoint(renderer.to_screen(point["position"]), 10, b2Color(0.3, 0.95, 0.3))
        renderer.EndDraw()

    def run(self, count):
        for _ in range(count):
            self.Step(self.settings)
        return self

    def MouseDown(self, p):
        if self.mouseJoint is not None:
            return
        aabb = b2AABB(lowerBound=p - (0.001, 0.001), upperBound=p + (0.001, 0.001))
        query = PointQuery(p)
        self.world.QueryAABB(query, aabb)
        if query.fixture:
            body = query.fixture.body
            self.mouseJoint = self.world.CreateMouseJoint(bodyA=self.groundbody, bodyB=body, target=p, maxForce=1000.0 * body.mass)
            body.awake = True

    def MouseMove(self, p):
        if self.mouseJoint:
            self.mouseJoint.target = p

    def MouseUp(self):
        if self.mouseJoint:
            self.world.DestroyJoint(self.mouseJoint)
            self.mouseJoint = None

    def PreSolve(self, contact, old_manifold):
        manifold = contact.manifold
        if manifold.pointCount == 0:
            return
        state1, state2 = b2GetPointStates(old_manifold, manifold)
        if not state2:
            return
        worldManifold = contact.worldManifold
        for i, point in enumerate(state2):
            if len(self.points) < self.settings.maxContactPoints:
                self.points.append(dict(fixtureA=contact.fixtureA, fixtureB=contact.fixtureB,
                                        position=worldManifold.points[i], normal=worldManifold.normal, state=state2[i]))

    def JointDestroyed(self, joint):
        self.gone.append(type(joint).__name__)

    def FixtureDestroyed(self, fixture):
        self.gone.append(type(fixture).__name__)


class Pile(Framework):
    def __init__(self):
        super(Pile, self).__init__()
        self.groundbody = self.world.CreateBody(shapes=b2LoopShape(vertices=[(-20, 0), (20, 0), (20, 40), (-20, 40)]))
        shapes = [b2PolygonShape(box=(0.5, 0.5)), b2CircleShape(radius=0.5),
                  b2PolygonShape(vertices=[(-0.5, 0), (0.5, 0), (0, 1.5)])]
        for i in range(12):
            self.world.CreateDynamicBody(position=(-6 + i, 2 + i), angle=i, userData=i,
                                         fixtures=b2FixtureDef(shape=shapes[i % 3], density=1, friction=0.3))


class Conveyor(Framework):
    def __init__(self):
        super(Conveyor, self).__init__()
        self.groundbody = self.world.CreateStaticBody(position=(0, 0), shapes=[b2EdgeShape(vertices=[(-20, 0), (20, 0)])])
        self.platform = self.world.CreateStaticBody(position=(-5, 5), allowSleep=False, fixtures=b2FixtureDef(
            shape=b2PolygonShape(box=(10, 0.5)), friction=0.8)).fixtures[0]
        self.boxes = [self.world.CreateDynamicBody(position=(-10.0 + 2 * i, 7), fixtures=b2FixtureDef(
            shape=b2PolygonShape(box=(0.5, 0.5)), density=20)) for i in range(5)]

    def PreSolve(self, contact, old_manifold):
        super(Conveyor, self).PreSolve(contact, old_manifold)
        fixtureA, fixtureB = contact.fixtureA, contact.fixtureB
        if fixtureA == self.platform:
            contact.tangentSpeed = 5.0
        elif fixtureB == self.platform:
            contact.tangentSpeed = -5.0


class OneWay(Framework):
    Unknown, Above, Below = 0, 1, -1

    def __init__(self):
        super(OneWay, self).__init__()
        self.groundbody = self.world.CreateBody(shapes=b2EdgeShape(vertices=[(-20, 0), (20, 0)]))
        body = self.world.CreateBody(position=(0, 10))
        self.platform = body.CreatePolygonFixture(box=(3, 0.5))
        self.bottom, self.top = 10.0 - 0.5, 10.0 + 0.5
        self.character = self.world.CreateDynamicBody(position=(0, 5)).CreateFixture(b2FixtureDef(
            shape=b2CircleShape(radius=0.5), density=20.0))
        self.character.body.linearVelocity = (0, 14)

    def PreSolve(self, contact, old_manifold):
        super(OneWay, self).PreSolve(contact, old_manifold)
        if contact.fixtureA != self.platform and contact.fixtureB != self.platform:
            return
        if self.character.body.position.y < self.top + 0.5 - 3.0 * b2_linearSlop:
            contact.enabled = False


class Breakable(Framework):
    def __init__(self):
        super(Breakable, self).__init__()
        self.groundbody = self.world.CreateStaticBody(shapes=b2EdgeShape(vertices=[(-40, 0), (40, 0)]))
        self.shape1 = b2PolygonShape(box=(0.5, 0.5, (-0.5, 0), 0))
        self.shape2 = b2PolygonShape(box=(0.5, 0.5, (0.5, 0), 0))
        self.body = self.world.CreateDynamicBody(position=(0, 40), angle=0.25 * b2_pi, shapes=[self.shape1, self.shape2],
                                                 shapeFixture=b2FixtureDef(density=1))
        self.piece1, self.piece2 = self.body.fixtures
        self._break, self.broke = False, False

    def PostSolve(self, contact, impulse):
        if self.broke:
            return
        count = contact.manifold.pointCount
        if max(impulse.normalImpulses[i] for i in range(count)) > 40:
            self._break = True

    def Break(self):
        body1, center = self.piece1.body, self.piece1.body.worldCenter
        body1.DestroyFixture(self.piece2)
        self.piece2 = None
        body2 = self.world.CreateDynamicBody(position=body1.position, angle=body1.angle, shapes=self.shape2,
                                             shapeFixture=b2FixtureDef(density=1))
        body1.linearVelocity = self.velocity + b2Cross(self.angularVelocity, body1.worldCenter - center)
        body2.linearVelocity = self.velocity + b2Cross(self.angularVelocity, body2.worldCenter - center)
        body2.angularVelocity = self.angularVelocity
        self.body2 = body2

    def Step(self, settings):
        super(Breakable, self).Step(settings)
        if self._break:
            self.Break()
            self.broke, self._break = True, False
        if not self.broke:
            self.velocity, self.angularVelocity = self.body.linearVelocity, self.body.angularVelocity


class Cannibals(Framework):
    """The heavier of two touching bodies is destroyed after the step."""

    def __init__(self):
        super(Cannibals, self).__init__()
        self.groundbody = self.world.CreateStaticBody(shapes=b2EdgeShape(vertices=[(-50, 0), (50, 0)]))
        random.seed(3)
        for i in range(10):
            self.world.CreateDynamicBody(position=(random.uniform(-3, 3), 2 + 2 * i), fixtures=b2FixtureDef(
                shape=b2CircleShape(radius=random.uniform(0.5, 1)), density=1))

    def Step(self, settings):
        super(Cannibals, self).Step(settings)
        nuke = []
        pairs = [(p["fixtureA"].body, p["fixtureB"].body) for p in self.points]
        for body1, body2 in pairs:
            mass1, mass2 = body1.mass, body2.mass
            if mass1 > 0.0 and mass2 > 0.0:
                nuke.append(body1 if mass1 > mass2 else body2)
        for b in set(nuke):
            self.world.DestroyBody(b)


class Jansen(Framework):
    def __init__(self):
        super(Jansen, self).__init__()
        self.offset, self.motorSpeed = b2Vec2(0, 8), 2.0
        pivot = b2Vec2(0, 0.8)
        self.groundbody = self.world.CreateStaticBody(shapes=[
            b2EdgeShape(vertices=[(-50, 0), (50, 0)]), b2EdgeShape(vertices=[(-50, 0), (-50, 10)])])
        self.chassis = self.world.CreateDynamicBody(position=pivot + self.offset, fixtures=b2FixtureDef(
            shape=b2PolygonShape(box=(2.5, 1)), density=1, filter=b2Filter(groupIndex=-1)))
        self.wheel = self.world.CreateDynamicBody(position=pivot + self.offset, fixtures=b2FixtureDef(
            shape=b2CircleShape(radius=1.6), density=1, filter=b2Filter(groupIndex=-1)))
        self.motor = self.world.CreateRevoluteJoint(bodyA=self.wheel, bodyB=self.chassis, anchor=pivot + self.offset,
                                                    collideConnected=False, motorSpeed=self.motorSpeed, maxMotorTorque=400,
                                                    enableMotor=True)
        wheelAnchor = pivot + (0, -0.8)
        for angle in (0, 120, -120):
            if angle:
                self.wheel.transform = (self.wheel.position, angle * b2_pi / 180.0)
            self.leg(-1, wheelAnchor)
            self.leg(1, wheelAnchor)

    def leg(self, s, wheelAnchor):
        p1, p2 = b2Vec2(5.4 * s, -6.1), b2Vec2(7.2 * s, -1.2)
        p3, p4 = b2Vec2(4.3 * s, -1.9), b2Vec2(3.1 * s, 0.8)
        p5, p6 = b2Vec2(6.0 * s, 1.5), b2Vec2(2.5 * s, 3.7)
        points = [((p1, p2, p3), (b2Vec2(0, 0), p5 - p4, p6 - p4)), ((p1, p3, p2), (b2Vec2(0, 0), p6 - p4, p5 - p4))][s < 0]
        lower, upper = (self.world.CreateDynamicBody(
            position=position, angularDamping=10, fixtures=b2FixtureDef(
                shape=b2PolygonShape(vertices=vertices), groupIndex=-1, density=1))
            for position, vertices in zip((self.offset, p4 + self.offset), points))
        for bodyA, bodyB, a, b in ((lower, upper, p2, p5), (lower, upper, p3, p4), (lower, self.wheel, p3, wheelAnchor),
                                   (upper, self.wheel, p6, wheelAnchor)):
            self.world.CreateDistanceJoint(dampingRatio=0.5, frequencyHz=10, bodyA=bodyA, bodyB=bodyB,
                                           anchorA=a + self.offset, anchorB=b + self.offset)
        self.world.CreateRevoluteJoint(bodyA=upper, bodyB=self.chassis, anchor=p4 + self.offset)


class TestBed(unittest.TestCase):
    def test_draws_piles_and_drags_bodies(self):
        bed = Pile().run(60)
        kinds = set(bed.renderer.calls)
        self.assertLessEqual({"solid circle", "solid polygon", "segment", "point", "transform", "polygon"}, kinds | {"polygon"})
        body = max(bed.world.bodies, key=lambda body: body.userData if body.userData is not None else -1)
        bed.MouseDown(b2Vec2(body.worldCenter))
        self.assertEqual(bed.mouseJoint.bodyB, body)
        for i in range(60):
            bed.MouseMove(b2Vec2(0.1 * i, 20))
            bed.Step(bed.settings)
        self.assertGreater(body.position.y, 10)
        bed.world.DestroyBody(body)
        self.assertIsNone(bed.mouseJoint)
        bed.MouseUp()
        self.assertIn("b2Fixture", bed.gone)
        for b in bed.world:
            if b.type is b2_dynamicBody or b.type == b2_dynamicBody:
                bed.world.DestroyBody(b)
        self.assertEqual((len(bed.world.bodies), bed.world.bodyCount), (1, 1))

    def test_conveyor_carries_boxes(self):
        bed = Conveyor().run(120)
        self.assertTrue(all(box.position.x > -10 + 2 * i + 1 for i, box in enumerate(bed.boxes)))

    def test_platform_lets_through_from_below(self):
        bed = OneWay().run(200)
        self.assertAlmostEqual(bed.character.body.position.y, 11, 1)

    def test_body_breaks_in_two(self):
        bed = Breakable().run(240)
        self.assertTrue(bed.broke)
        self.assertEqual((len(bed.body.fixtures), len(bed.body2.fixtures)), (1, 1))
        self.assertNotIn("b2Fixture", bed.gone)

    def test_bodies_are_destroyed_in_sets(self):
        bed = Cannibals().run(300)
        self.assertLess(bed.world.bodyCount, 11)

    def test_jansen_walker_walks(self):
        bed = Jansen().run(300)
        self.assertGreater(abs(bed.chassis.position.x), 3)
        bed.motor.motorSpeed *= -1
        self.assertEqual(bed.motor.motorSpeed, -2)
        self.assertEqual(bed.motor.bodyA, bed.wheel)
        bed.world.DestroyBody(bed.chassis)
        self.assertEqual(bed.gone.count("b2RevoluteJoint"), 7)


def settle(world, count=60):
    for _ in range(count):
        world.Step(timeStep=1.0 / 60, velocityIterations=10, positionIterations=10)
        world.ClearForces()


class Scenes(unittest.TestCase):
    def test_drawing_functions_are_put_on_shapes(self):
        world = newWorld(gravity=(0, -10), doSleep=True)
        world.CreateStaticBody(position=(0, 0), shapes=polygonShape(box=(50, 1)))
        body = world.CreateDynamicBody(position=(10, 15), angle=15)
        body.CreatePolygonFixture(box=(2, 1), density=1, friction=0.3)
        body.CreateCircleFixture(radius=0.5, density=1, friction=0.3)
        drawn = []

        def draw_polygon(polygon, body, fixture):
            vertices = [(body.transform * v) * 20 for v in polygon.vertices]
            drawn.append([(v[0], 480 - v[1]) for v in vertices])

        def draw_circle(circle, body, fixture):
            position = body.transform * circle.pos * 20
            drawn.append([int(x) for x in (position[0], 480 - position[1])] + [int(circle.radius * 20)])

        polygonShape.draw, circleShape.draw = draw_polygon, draw_circle
        try:
            settle(world, 30)
            colors = {staticBody: (255, 255, 255, 255), dynamicBody: (127, 127, 127, 255)}
            for body in world.bodies:
                self.assertIn(body.type, colors)
                for fixture in body.fixtures:
                    fixture.shape.draw(body, fixture)
        finally:
            del polygonShape.draw, circleShape.draw
        self.assertEqual([len(item) for item in drawn], [4, 4, 3])

    def test_all_joints_hold_and_describe_themselves(self):
        world = b2World(gravity=(0, -10), doSleep=False)
        ground = world.CreateStaticBody(shapes=b2EdgeShape(vertices=[(-40, 0), (40, 0)]), userData="ground")

        def body(x, y):
            return world.CreateDynamicBody(position=(x, y), userData={"x": x}, fixtures=fixtureDef(
                shape=polygonShape(box=(0.5, 0.5)), density=1.0, filter=b2filter(groupIndex=-1, categoryBits=2, maskBits=0xFFFF)))

        bodies = [body(4 * i - 20, 10) for i in range(12)]
        joints = [
            world.CreateRevoluteJoint(bodyA=ground, bodyB=bodies[0], anchor=(-20, 10), lowerAngle=-0.25 * b2_pi,
                                      upperAngle=0.5 * b2_pi, enableLimit=True, maxMotorTorque=10.0, motorSpeed=1.0, enableMotor=True),
            world.CreatePrismaticJoint(bodyA=ground, bodyB=bodies[1], anchor=(-16, 10), axis=(0, 1), lowerTranslation=-5.0,
                                       upperTranslation=2.5, enableLimit=True, motorSpeed=1, maxMotorForce=500, enableMotor=True),
            world.CreateDistanceJoint(bodyA=ground, bodyB=bodies[2], anchorA=(-12, 14), anchorB=(-12, 10), frequencyHz=4.0,
                                      dampingRatio=0.5, collideConnected=True),
            world.CreatePulleyJoint(bodyA=bodies[3], bodyB=bodies[4], anchorA=(-8, 10.5), anchorB=(-4, 10.5),
                                    groundAnchorA=(-8, 16), groundAnchorB=(-4, 16), ratio=1.5),
            world.CreateMouseJoint(bodyA=ground, bodyB=bodies[5], target=(0, 10), maxForce=1000 * bodies[5].mass),
            world.CreateWheelJoint(bodyA=bodies[6], bodyB=bodies[7], anchor=bodies[7].position, axis=(0.0, 1.0), motorSpeed=0.0,
                                   maxMotorTorque=20, enableMotor=True, frequencyHz=4, dampingRatio=0.7),
            world.CreateWeldJoint(bodyA=ground, bodyB=bodies[8], anchor=(12, 10)),
            world.CreateFrictionJoint(bodyA=ground, bodyB=bodies[9], localAnchorA=(0, 0), localAnchorB=(0, 0),
                                      collideConnected=True, maxForce=bodies[9].mass * 10, maxTorque=bodies[9].mass * 10),
            world.CreateRopeJoint(bodyA=ground, bodyB=bodies[10], maxLength=4.01, localAnchorA=(20, 14), localAnchorB=(0, 0)),
            world.CreateMotorJoint(bodyA=ground, bodyB=bodies[11], maxForce=1000, maxTorque=1000),
        ]
        joints.append(world.CreateGearJoint(joint1=joints[0], joint2=joints[1], ratio=0.5))
        settle(world, 120)
        self.assertEqual([joint.type for joint in joints], [1, 2, 3, 4, 5, 7, 8, 9, 10, 11, 6])
        self.assertEqual({type(joint).__name__ for joint in world.joints}, {type(joint).__name__ for joint in joints})
        self.assertEqual(joints[0].bodyA.userData, "ground")
        self.assertLessEqual(joints[0].lowerLimit - b2_angularSlop, joints[0].angle)
        self.assertLessEqual(joints[1].translation, joints[1].upperLimit + 0.02)
        joints[1].motorEnabled = not joints[1].motorEnabled
        joints[0].limits = (-1, 1)
        joints[0].SetLimits(-0.5, 0.5)
        self.assertEqual(joints[0].limits, (-0.5, 0.5))
        self.assertAlmostEqual(joints[3].ratio, 1.5)
        self.assertAlmostEqual(bodies[8].position.y, 10, 2)
        self.assertGreater(joints[6].GetReactionForce(60).length, 9)
        joints[9].linearOffset, joints[9].angularOffset = (24 + math.sin(1), 12), 0.3
        joints[9].linearOffset.x = 25
        settle(world, 120)
        self.assertAlmostEqual(bodies[11].position.x, 25, 1)
        for joint in joints:
            self.assertIn(type(joint).__name__, repr(joint))
            for edge in joint.bodyB.joints:
                self.assertIn(edge.joint, world.joints)
        for joint in [joints[-1]] + joints[:-1]:
            world.DestroyJoint(joint)
        self.assertEqual(world.jointCount, 0)

    def test_filters_are_changed_while_bodies_lie(self):
        world = b2World()
        ground = world.CreateStaticBody(shapes=polygonShape(box=(10, 1)))
        box = world.CreateDynamicBody(position=(0, 2), fixtures=fixtureDef(
            shape=polygonShape(vertices=[(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]), density=1,
            filter=b2Filter(groupIndex=0, categoryBits=0x0002, maskBits=0xFFFF), userData="box"))
        settle(world)
        self.assertEqual([contact.fixtureB.userData for contact in world.contacts if contact.touching], ["box"])
        box.fixtures[0].filterData.maskBits = 0x0004
        box.awake = True
        settle(world)
        self.assertLess(box.position.y, 0)
        self.assertEqual(world.contactCount, 0)
        self.assertEqual(ground.fixtures[0].filterData.maskBits, 0xFFFF)

    def test_rays_find_the_closest_any_and_all(self):
        class Closest(b2RayCastCallback):
            def __init__(self, **kwargs):
                b2RayCastCallback.__init__(self, **kwargs)
                self.fixture, self.hit = None, False

            def ReportFixture(self, fixture, point, normal, fraction):
                if fixture.body.userData == "ignore":
                    return -1.0
                self.hit, self.fixture = True, fixture
                self.point, self.normal = b2Vec2(point), b2Vec2(normal)
                return fraction

        class Each(b2RayCastCallback):
            def __init__(self, **kwargs):
                b2RayCastCallback.__init__(self, **kwargs)
                self.fixtures, self.points = [], []

            def ReportFixture(self, fixture, point, normal, fraction):
                self.fixtures.append(fixture)
                self.points.append(point)
                return self.goOn

        world = b2World()
        bodies = [world.CreateStaticBody(position=(3 * i, 0), shapes=circleShape(radius=1), userData=["ignore", i][i > 0])
                  for i in range(4)]
        closest = Closest()
        world.RayCast(closest, (-5, 0), b2Vec2(20, 0))
        self.assertEqual((closest.hit, closest.fixture.body), (True, bodies[1]))
        self.assertLess((closest.point - (2, 0)).length + (closest.normal - (-1, 0)).length, 1e-5)
        for goOn, count in ((1.0, 4), (0.0, 1)):
            each = Each(goOn=goOn)
            world.RayCast(each, point1=(-5, 0), point2=(20, 0))
            self.assertEqual((len(each.fixtures), len(each.points)), (count, count))

    def test_chains_loops_and_edges_hold_bodies(self):
        world = b2World(gravity=(0, -10))
        hills = [(x, math.sin(x)) for x in range(-20, 21)]
        for make in (lambda body: body.CreateEdgeChain(hills), lambda body: body.CreateChainFixture(vertices=hills),
                     lambda body: body.CreateLoopFixture(vertices=hills + [(20, -5), (-20, -5)]),
                     lambda body: body.CreateFixturesFromShapes([b2EdgeShape(vertices=pair) for pair in zip(hills, hills[1:])]),
                     lambda body: body.CreateFixture(shape=chainShape(vertices_chain=hills), friction=0.9)):
            ground = world.CreateStaticBody()
            make(ground)
            ball = world.CreateDynamicBody(position=(0.3, 3), bullet=True)
            ball.CreateCircleFixture(radius=0.4, density=1, friction=0.9)
            settle(world, 90)
            self.assertGreater(ball.position.y, -2)
            self.assertGreater(sum(edge.contact.touching for edge in ball.contacts), 0)
            world.DestroyBody(ball)
            world.DestroyBody(ground)

    def test_polygons_are_sliced_and_grown(self):
        world = b2World(gravity=(0, -10))
        world.CreateStaticBody(shapes=polygonShape(box=(20, 1)))
        body = world.CreateDynamicBody(position=(0, 4), angle=0.3, fixtures=fixtureDef(shape=polygonShape(box=(2, 1)), density=1))
        vertices = body.fixtures[0].shape.vertices
        halves = [[v if v[0] * side > 0 else (0, v[1]) for v in vertices] for side in (1, -1)]
        pieces = [world.CreateDynamicBody(position=body.position, angle=body.angle, linearVelocity=body.linearVelocity,
                                          fixtures=fixtureDef(shape=polygonShape(vertices=half), density=body.fixtures[0].density))
                  for half in halves]
        mass = body.mass
        world.DestroyBody(body)
        self.assertAlmostEqual(sum(piece.mass for piece in pieces), mass, 4)
        for i in range(30):
            for piece in pieces:
                piece.fixtures[0].shape.vertices = [b2Vec2(v) * 1.01 for v in piece.fixtures[0].shape.vertices]
                piece.ResetMassData()
            settle(world, 4)
        self.assertAlmostEqual(sum(piece.mass for piece in pieces), mass * 1.01 ** 60, 2)
        self.assertTrue(all(piece.position.y > 0.5 for piece in pieces))


class Tire:
    def __init__(self, car, anchor, maxDrive):
        self.body = car.world.CreateDynamicBody(position=(0, 0))
        self.body.CreatePolygonFixture(box=(0.5, 1.25), density=1.0)
        self.body.userData = {"obj": self}
        self.maxDrive, self.traction, self.areas = maxDrive, 1, []

    @property
    def forward_velocity(self):
        normal = self.body.GetWorldVector((0, 1))
        return normal.dot(self.body.linearVelocity) * normal

    @property
    def lateral_velocity(self):
        normal = self.body.GetWorldVector((1, 0))
        return normal.dot(self.body.linearVelocity) * normal

    def update_friction(self):
        impulse = -self.lateral_velocity * self.body.mass
        if impulse.length > 7.5:
            impulse *= 7.5 / impulse.length
        self.body.ApplyLinearImpulse(self.traction * impulse, self.body.worldCenter, True)
        self.body.ApplyAngularImpulse(0.1 * self.traction * self.body.inertia * -self.body.angularVelocity, True)
        forward = self.forward_velocity
        speed = forward.Normalize()
        self.body.ApplyForce(self.traction * -2 * speed * forward, self.body.worldCenter, True)

    def update_drive(self, desired):
        normal = self.body.GetWorldVector((0, 1))
        speed = self.forward_velocity.dot(normal)
        force = self.maxDrive if desired > speed else -self.maxDrive if desired < speed else 0
        self.body.ApplyForce(self.traction * force * normal, self.body.worldCenter, True)

    def update_traction(self):
        self.traction = max([area["friction"] for area in self.areas], default=1)


class Environments(unittest.TestCase):
    def test_top_down_car_steers_over_areas(self):
        class Areas(b2ContactListener):
            def handle(self, contact, began):
                data = [f.body.userData for f in (contact.fixtureA, contact.fixtureB)]
                area = next((f.userData for f in (contact.fixtureA, contact.fixtureB) if f.userData), None)
                tire = next((d["obj"] for d in data if d and isinstance(d.get("obj"), Tire)), None)
                if area is not None and tire is not None:
                    tire.areas.append(area) if began else tire.areas.remove(area)
                    tire.update_traction()
                    self.count = getattr(self, "count", 0) + 1

            def BeginContact(self, contact):
                self.handle(contact, True)

            def EndContact(self, contact):
                self.handle(contact, False)

        class Car:
            pass

        car, listener = Car(), Areas()
        car.world = b2World(gravity=(0, 0), contactListener=listener)
        ground = car.world.CreateStaticBody(userData={"obj": None})
        ground.CreateFixture(b2FixtureDef(shape=b2PolygonShape(box=(9, 7, (0, 15), 20 * b2_pi / 180)), isSensor=True,
                                          userData={"friction": 0.9}))
        car.body = car.world.CreateDynamicBody(position=(0, 0))
        half = [(1.5, 0), (3, 2.5), (2.8, 5.5), (1, 10)]
        car.body.CreatePolygonFixture(vertices=half + [(-x, y) for x, y in reversed(half)], density=0.1)
        car.tires, car.joints = [], []
        for anchor in ((-3, 0.75), (3, 0.75), (-3, 8.5), (3, 8.5)):
            tire = Tire(car, anchor, 500)
            tire.body.position = car.body.worldCenter + anchor
            car.tires.append(tire)
            car.joints.append(car.world.CreateRevoluteJoint(
                bodyA=car.body, bodyB=tire.body, localAnchorA=anchor, localAnchorB=(0, 0), enableMotor=False,
                maxMotorTorque=1000, enableLimit=True, lowerAngle=0, upperAngle=0))
        for _ in range(240):
            for tire in car.tires:
                tire.update_friction()
                tire.update_drive(100)
            for joint in car.joints[2:]:
                angle = b2Clamp(0.2 - joint.angle, -0.05, 0.05) + joint.angle
                joint.SetLimits(angle, angle)
            car.world.Step(1 / 60, 8, 3)
        self.assertGreater(car.body.position.length, 10)
        self.assertNotEqual(round(car.body.angle, 2), 0)
        self.assertGreater(listener.count, 3)

    def test_lander_lands_with_particles(self):
        class Landing(contactListener):
            def __init__(self, env):
                contactListener.__init__(self)
                self.env = env

            def BeginContact(self, contact):
                if self.env.lander in (contact.fixtureA.body, contact.fixtureB.body):
                    self.env.game_over = True
                for i in range(2):
                    if self.env.legs[i] in [contact.fixtureA.body, contact.fixtureB.body]:
                        self.env.legs[i].ground_contact = self.env.legs[i].has_touched = True

            def EndContact(self, contact):
                for i in range(2):
                    if self.env.legs[i] in [contact.fixtureA.body, contact.fixtureB.body]:
                        self.env.legs[i].ground_contact = False

        class Env:
            game_over = False

        env, rng, SCALE = Env(), random.Random(1), 30.0
        for episode in range(3):
            world = Box2D.b2World()
            env.world, env.particles, env.legs = world, [], []
            world.contactListener_keepref = Landing(env)
            world.contactListener = world.contactListener_keepref
            moon = world.CreateStaticBody(shapes=edgeShape(vertices=[(0, 0), (20, 0)]))
            for x in range(20):
                moon.CreateEdgeFixture(vertices=[(x, 3), (x + 1, 3)], density=0, friction=0.1)
            moon.color1 = moon.color2 = (0.0, 0.0, 0.0)
            env.lander = world.CreateDynamicBody(position=(10, 9), angle=0.0, fixtures=fixtureDef(
                shape=polygonShape(vertices=[(x / SCALE, y / SCALE) for x, y in
                                             ((-14, 17), (-17, 0), (-17, -10), (17, -10), (17, 0), (14, 17))]),
                density=5.0, friction=0.1, categoryBits=0x0010, maskBits=0x001, restitution=0.0))
            env.lander.color1 = (128, 102, 230)
            env.lander.ApplyForceToCenter((rng.uniform(-50, 50), rng.uniform(-50, 50)), True)
            for i in (-1, 1):
                leg = world.CreateDynamicBody(position=(10 - i * 20 / SCALE, 9), angle=i * 0.05, fixtures=fixtureDef(
                    shape=polygonShape(box=(2 / SCALE, 8 / SCALE)), density=1.0, restitution=0.0, categoryBits=0x0020,
                    maskBits=0x001))
                leg.ground_contact = leg.has_touched = False
                rjd = revoluteJointDef(bodyA=env.lander, bodyB=leg, localAnchorA=(0, 0), localAnchorB=(i * 20 / SCALE, 18 / SCALE),
                                       enableMotor=True, enableLimit=True, maxMotorTorque=40, motorSpeed=+0.3 * i)
                if i == -1:
                    rjd.lowerAngle, rjd.upperAngle = +0.9 - 0.5, +0.9
                else:
                    rjd.lowerAngle, rjd.upperAngle = -0.9, -0.9 + 0.5
                leg.joint = world.CreateJoint(rjd)
                env.legs.append(leg)
            for t in range(300):
                pos, vel = env.lander.position, env.lander.linearVelocity
                if vel.y < -1.2 and not env.legs[0].ground_contact:
                    tip = (math.sin(env.lander.angle), math.cos(env.lander.angle))
                    particle = world.CreateDynamicBody(position=(pos[0] - tip[0], pos[1] - tip[1]), angle=0.0, fixtures=fixtureDef(
                        shape=circleShape(radius=2 / SCALE, pos=(0, 0)), density=3.5, friction=0.1, categoryBits=0x0100,
                        maskBits=0x001, restitution=0.3))
                    particle.ttl = 1
                    env.particles.append(particle)
                    while env.particles and env.particles[0].ttl < 0:
                        world.DestroyBody(env.particles.pop(0))
                    particle.ApplyLinearImpulse((tip[0] * 13, -tip[1] * 13), particle.position, True)
                    env.lander.ApplyLinearImpulse((tip[0] * 0.8, tip[1] * 0.8), env.lander.position, True)
                for obj in env.particles:
                    obj.ttl -= 0.15
                for obj in env.particles + [env.lander] + env.legs:
                    for f in obj.fixtures:
                        trans = f.body.transform
                        if type(f.shape) is circleShape:
                            x, y = trans * f.shape.pos * SCALE
                        else:
                            path = [trans * v * SCALE for v in f.shape.vertices]
                world.Step(1.0 / 50, 6 * 30, 2 * 30)
            self.assertTrue(all(leg.has_touched for leg in env.legs))
            self.assertLess(abs(env.lander.linearVelocity.y), 0.1)
            world.contactListener = None
            for body in [moon, env.lander, *env.legs, *env.particles]:
                world.DestroyBody(body)
            self.assertEqual(world.bodyCount, 0)

    def test_hardcore_terrain_is_made_of_one_definition(self):
        world = Box2D.b2World()
        fd_polygon = fixtureDef(shape=polygonShape(vertices=[(0, 0), (1, 0), (1, -1), (0, -1)]), friction=2.5)
        fd_edge = fixtureDef(shape=edgeShape(vertices=[(0, 0), (1, 1)]), friction=2.5, categoryBits=0x0001)
        terrain, xs = [], [i * 0.5 for i in range(60)]
        for i, x in enumerate(xs[:-1]):
            poly = [(x, 3 + 0.2 * math.sin(x)), (xs[i + 1], 3 + 0.2 * math.sin(xs[i + 1]))]
            fd_edge.shape.vertices = poly
            t = world.CreateStaticBody(fixtures=fd_edge)
            t.color1 = (76, 255 if i % 2 == 0 else 204, 76)
            terrain.append(t)
        for x in (8, 14):
            poly = [(x, 3), (x + 1, 3), (x + 1, 4), (x, 4)]
            fd_polygon.shape.vertices = [(p[0], p[1]) for p in poly]
            t = world.CreateStaticBody(fixtures=fd_polygon)
            t.color1, t.color2 = (255, 255, 255), (153, 153, 153)
            terrain.append(t)
        terrain.reverse()
        self.assertNotEqual(terrain[0].fixtures[0].shape.vertices, terrain[1].fixtures[0].shape.vertices)
        hull = world.CreateDynamicBody(position=(4, 6), fixtures=fixtureDef(
            shape=polygonShape(vertices=[(-1, 0.3), (0.2, 0.3), (1.1, 0), (1.1, -0.3), (-1, -0.3)]), density=5.0, friction=0.1,
            categoryBits=0x0020, maskBits=0x001))

        class Lidar(Box2D.b2.rayCastCallback):
            def ReportFixture(self, fixture, point, normal, fraction):
                if (fixture.filterData.categoryBits & 1) == 0:
                    return -1
                self.p2, self.fraction = point, fraction
                return fraction

        lidar = [Lidar() for _ in range(10)]
        for _ in range(30):
            pos = hull.position
            for i in range(10):
                lidar[i].fraction, lidar[i].p1 = 1.0, pos
                lidar[i].p2 = (pos[0] + math.sin(1.5 * i / 10.0) * 5, pos[1] - math.cos(1.5 * i / 10.0) * 5)
                world.RayCast(lidar[i], lidar[i].p1, lidar[i].p2)
            world.Step(1.0 / 50, 180, 60)
        fractions = [ray.fraction for ray in lidar]
        self.assertLess(fractions[0], 0.9)
        self.assertTrue(all(0 <= fraction <= 1 for fraction in fractions))

    def test_track_tiles_are_sensors_of_one_definition(self):
        class Friction(contactListener):
            def __init__(self):
                contactListener.__init__(self)
                self.visited = 0

            def BeginContact(self, contact):
                self.note(contact, True)

            def EndContact(self, contact):
                self.note(contact, False)

            def note(self, contact, begin):
                tile = obj = None
                u1, u2 = contact.fixtureA.body.userData, contact.fixtureB.body.userData
                if u1 and "road_friction" in u1.__dict__:
                    tile, obj = u1, u2
                if u2 and "road_friction" in u2.__dict__:
                    tile, obj = u2, u1
                if not tile or not obj or "tiles" not in obj.__dict__:
                    return
                if begin:
                    obj.tiles.add(tile)
                    self.visited += not tile.road_visited
                    tile.road_visited = True
                else:
                    obj.tiles.remove(tile)

        listener = Friction()
        world = Box2D.b2World((0, 0), contactListener=listener)
        fd_tile = fixtureDef(shape=polygonShape(vertices=[(0, 0), (1, 0), (1, -1), (0, -1)]))
        road = []
        for i in range(8):
            fd_tile.shape.vertices = [(-2, 2 * i), (2, 2 * i), (2, 2 * i + 2), (-2, 2 * i + 2)]
            t = world.CreateStaticBody(fixtures=fd_tile)
            t.userData = t
            t.color, t.road_visited, t.road_friction, t.idx = [102 + i] * 3, False, 1.0, i
            t.fixtures[0].sensor = True
            road.append(t)
        hull = world.CreateDynamicBody(position=(0, 0), fixtures=[
            fixtureDef(shape=polygonShape(vertices=[(-0.6, 1.3), (0.6, 1.3), (0.25, 1.1), (-0.25, 1.1)]), density=1.0),
            fixtureDef(shape=polygonShape(box=(0.25, 1.2)), density=1.0)])
        wheels = []
        for x, y in ((-0.55, 0.8), (0.55, 0.8), (-0.55, -0.8), (0.55, -0.8)):
            w = world.CreateDynamicBody(position=(x, y), fixtures=fixtureDef(
                shape=polygonShape(box=(0.14, 0.27)), density=0.1, categoryBits=0x0020, maskBits=0x001, restitution=0.0))
            w.omega, w.tiles, w.userData = 0.0, set(), w
            w.joint = world.CreateJoint(revoluteJointDef(
                bodyA=hull, bodyB=w, localAnchorA=(x, y), localAnchorB=(0, 0), enableMotor=True, enableLimit=True,
                maxMotorTorque=180 * 900 * 0.02 * 0.02, motorSpeed=0, lowerAngle=-0.4, upperAngle=+0.4))
            wheels.append(w)
        for _ in range(100):
            for w in wheels:
                w.joint.motorSpeed = float(-w.joint.angle)
                forw, side, v = w.GetWorldVector((0, 1)), w.GetWorldVector((1, 0)), w.linearVelocity
                vf, vs = forw[0] * v[0] + forw[1] * v[1], side[0] * v[0] + side[1] * v[1]
                f, p = 3 * (8 - vf) * (1 if w.tiles else 0.6), -vs
                w.ApplyForceToCenter((p * side[0] + f * forw[0], p * side[1] + f * forw[1]), True)
            world.Step(1.0 / 50, 180, 60)
        self.assertEqual(listener.visited, sum(t.road_visited for t in road))
        self.assertGreater(listener.visited, 5)
        for t in road:
            world.DestroyBody(t)
        self.assertTrue(all(not w.tiles for w in wheels))


if __name__ == "__main__":
    unittest.main()
