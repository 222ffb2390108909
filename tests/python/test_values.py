# SPDX-License-Identifier: MIT
"""Vectors, matrices, transforms, colours, boxes and shapes."""

import copy
import math
import pickle
import unittest

import Box2D
from Box2D import (b2_maxPolygonVertices, b2AABB, b2ChainShape, b2CircleShape, b2Color, b2EdgeShape, b2Error,
                   b2LoopShape, b2Mat22, b2Mat33, b2PolygonShape, b2RayCastInput, b2RayCastOutput, b2Rot, b2Sweep,
                   b2Transform, b2Vec2, b2Vec3)


class OldNames(unittest.TestCase):
    """What programs of the 2.3 module rely on beside the values themselves."""

    def test_functions_take_tuples(self):
        self.assertEqual(tuple(Box2D.b2Abs((-1, 2))), (1, 2))
        self.assertEqual(Box2D.b2Dot((1, 2, 3), Box2D.b2Vec3(1, 2, 3)), 14)
        self.assertEqual(tuple(Box2D.b2Cross((1, 0, 0), Box2D.b2Vec3(0, 1, 0))), (0, 0, 1))

    def test_shapes_have_the_functions_of_cpp(self):
        chain = Box2D.b2ChainShape()
        chain.CreateLoop([(0, 0), (1, 0), (0, 1)])
        self.assertEqual(chain.GetChildCount(), 3)
        with self.assertRaises(Box2D.b2Error):
            chain.CreateLoop([(0, 0), (1, 0)])
        box = Box2D.b2PolygonShape(box=(1, 2))
        self.assertEqual((box.GetVertexCount(), abs(box.GetVertex(0).x), box.Validate()), (4, 1, True))
        with self.assertRaises(IndexError):
            box.GetVertex(4)
        edge = Box2D.b2EdgeShape()
        edge.Set((0, 0), (3, 4))
        self.assertEqual(tuple(edge.vertex2), (3, 4))
        self.assertEqual(tuple(Box2D.b2AABB(lowerBound=(0, 0), upperBound=(2, 4)).GetCenter()), (1, 2))

    def test_counters_are_read_and_set(self):
        Box2D.b2Globals.b2_gjkCalls = 0
        Box2D.b2Distance(shapeA=b2CircleShape(radius=1), shapeB=b2CircleShape(radius=1, pos=(5, 0)),
                         transformA=b2Transform(), transformB=b2Transform(), useRadii=True)
        self.assertEqual(Box2D.b2Globals.b2_gjkCalls, 1)
        with self.assertRaises(AttributeError):
            Box2D.b2Globals.b2_pi = 3

    def test_comparison_with_other_types_is_false(self):
        for value in (b2AABB(), b2Mat22(), b2PolygonShape(box=(1, 1))):
            self.assertFalse(value == None)  # noqa: E711
            self.assertTrue(value != 1)
            self.assertNotIn(value, ["text"])

    def test_shapes_of_a_fixture_are_equal(self):
        world = Box2D.b2World()
        fixture = world.CreateStaticBody().CreatePolygonFixture(shape=b2PolygonShape(box=(1, 2)))
        self.assertEqual(fixture.shape, fixture.shape)
        self.assertNotEqual(fixture.shape, b2PolygonShape(box=(1, 1)))

    def test_wrong_types_of_vertices_are_also_value_errors(self):
        for make in (lambda: b2PolygonShape(vertices=[(1, 2, 3)] * 3), lambda: b2PolygonShape(vertices=None),
                     lambda: b2EdgeShape(vertices=None), lambda: b2PolygonShape(box=(1, 2, 3, 4, 5))):
            for kind in (TypeError, ValueError):
                with self.assertRaises(kind):
                    make()


class Vectors(unittest.TestCase):
    def test_arithmetic_takes_tuples(self):
        a = b2Vec2(1, 2)
        self.assertEqual(a + (1, 1), (2, 3))
        self.assertEqual((1, 1) + a, b2Vec2(2, 3))
        self.assertEqual(a - (1, 1), (0, 1))
        self.assertEqual((1, 1) - a, (0, -1))
        self.assertEqual(2 * a, a * 2)
        self.assertEqual(a / 2, (0.5, 1))
        self.assertEqual(-a, (-1, -2))
        self.assertNotEqual(a, (1, 3))

    def test_in_place_operators_change_the_object(self):
        a = b = b2Vec2(1, 2)
        a += (1, 0)
        a *= 2
        a -= b2Vec2(0, 1)
        a /= 1
        self.assertIs(a, b)
        self.assertEqual(b, (4, 3))

    def test_behaves_as_a_sequence(self):
        a = b2Vec2((3, 4))
        x, y = a
        self.assertEqual((x, y, len(a), a[-1], a.tuple, list(a)), (3, 4, 2, 4, (3, 4), [3, 4]))
        a[0] = 6
        self.assertEqual(a.x, 6)
        with self.assertRaises(IndexError):
            a[2]

    def test_has_length_and_products(self):
        a = b2Vec2(3, 4)
        self.assertEqual((a.length, a.lengthSquared, a.dot((1, 1)), a.cross((1, 0)), a.skew), (5, 25, 7, -4, (-4, 3)))
        self.assertEqual(a.cross(2), (8, -6))
        self.assertEqual(a.Normalize(), 5)
        self.assertAlmostEqual(a.length, 1, 6)
        self.assertFalse(b2Vec2(math.nan, 0).valid)

    def test_takes_keywords(self):
        self.assertEqual(b2Vec2(x=1, y=2), (1, 2))
        self.assertEqual(b2Vec2(y=2), (0, 2))
        self.assertEqual(b2Vec3(x=1, z=3), (1, 0, 3))
        with self.assertRaises(TypeError):
            b2Vec2(z=1)

    def test_refuses_other_values(self):
        for value in ("ab", (1, 2, 3), 5, None):
            with self.assertRaises(TypeError):
                b2Vec2(value)
        with self.assertRaises(TypeError):
            b2Vec2(1, 2) + 1
        with self.assertRaises(ZeroDivisionError):
            b2Vec2(1, 2) / 0

    def test_copies_and_pickles(self):
        for value in (b2Vec2(1, 2), b2Vec3(1, 2, 3), b2Color(0.5, 0.25, 1, 0.5), b2Mat22((1, 2), (3, 4)),
                      b2AABB((0, 0), (1, 1))):
            for twin in (copy.copy(value), copy.deepcopy(value), pickle.loads(pickle.dumps(value)), value.copy()):
                self.assertEqual(value, twin)
                self.assertIsNot(value, twin)

    def test_three_components_are_computed(self):
        a = b2Vec3(1, 2, 3)
        self.assertEqual(a + (1, 1, 1), (2, 3, 4))
        self.assertEqual(a.dot((1, 1, 1)), 6)
        self.assertEqual(b2Vec3(1, 0, 0).cross((0, 1, 0)), (0, 0, 1))


class Matrices(unittest.TestCase):
    def test_matrices_solve_and_invert(self):
        m = b2Mat22((2, 1), (1, 3))
        self.assertEqual(m * m.Solve((1, 2)), (1, 2))
        self.assertEqual(m.inverse * (m * (1, 0)), (1, 0))
        n = b2Mat33((2, 0, 0), (0, 4, 0), (0, 0, 8))
        self.assertEqual(n.Solve33((2, 4, 8)), (1, 1, 1))
        self.assertEqual(n.Solve22((2, 4)), (1, 1))

    def test_matrices_begin_as_the_identity(self):
        self.assertEqual(b2Mat22(), b2Mat22((1, 0), (0, 1)))
        m = b2Mat33()
        self.assertEqual((m.ex, m.ey, m.ez), ((1, 0, 0), (0, 1, 0), (0, 0, 1)))

    def test_matrices_subtract(self):
        m = n = b2Mat22((1, 2), (3, 4))
        self.assertEqual((m - m, m + m - m), (b2Mat22((0, 0), (0, 0)), m))
        n -= b2Mat22()
        n += b2Mat22((1, 1), (1, 1))
        self.assertEqual((m is n, m.col1, m.col2), (True, (1, 3), (4, 4)))
        big = b2Mat33() - b2Mat33()
        self.assertEqual((big.col1, big.col2, big.col3), ((0, 0, 0),) * 3)
        with self.assertRaises(TypeError):
            m - 3

    def test_transform_rotates_then_moves(self):
        t = b2Transform(position=(1, 0), angle=math.pi / 2)
        moved = t * (1, 0)
        self.assertAlmostEqual(moved.x, 1, 6)
        self.assertAlmostEqual(moved.y, 1, 6)
        back = Box2D.b2MulT(t, moved)
        self.assertAlmostEqual(back.x, 1, 6)
        self.assertAlmostEqual(t.R.angle, math.pi / 2, 6)
        t.position.x = 5
        self.assertEqual(t.position, (5, 0))

    def test_rotation_multiplies_and_sweep_interpolates(self):
        self.assertAlmostEqual((b2Rot(0.5) * b2Rot(0.25)).angle, 0.75, 6)
        sweep = b2Sweep(c0=(0, 0), c=(2, 0), a=1.0)
        self.assertEqual(sweep.GetTransform(0.5).position, (1, 0))

    def test_sweep_fills_a_transform(self):
        transform = b2Transform()
        self.assertIsNone(b2Sweep(c=(2, 0)).GetTransform(transform, 0.5))
        self.assertEqual(transform.position, (1, 0))

    def test_colour_has_a_list_of_bytes(self):
        self.assertEqual(b2Color(1, 1, 1).bytes + [127], [255, 255, 255, 127])

    def test_colour_has_bytes_and_a_list(self):
        c = b2Color(1, 0.5, 0)
        self.assertEqual((c.bytes, c.list, tuple(c * 0.5)), ([255, 127, 0], [1, 0.5, 0], (0.5, 0.25, 0)))

    def test_box_has_extents_and_overlaps(self):
        box = b2AABB(lowerBound=b2Vec2(0, 0) - (1, 1), upperBound=(1, 2))
        self.assertEqual((box.center, box.extents, box.perimeter, box.valid), ((0, 0.5), (1, 1.5), 10, True))
        self.assertIn((0, 0), box)
        self.assertNotIn((3, 0), box)
        self.assertTrue(Box2D.b2TestOverlap(box, b2AABB((0, 0), (5, 5))))


class Shapes(unittest.TestCase):
    def test_polygon_is_made_of_a_box_or_vertices(self):
        box = b2PolygonShape(box=(1, 2))
        self.assertEqual(box.vertices, [(-1, -2), (1, -2), (1, 2), (-1, 2)])
        self.assertEqual(b2PolygonShape(box=(1, 1, (2, 3), 0)).centroid, (2, 3))
        triangle = b2PolygonShape(vertices=[(0, 0), (1, 0), b2Vec2(0, 1)])
        self.assertEqual((triangle.vertexCount, len(triangle.normals), triangle.valid), (3, 3, True))

    def test_collisions_take_the_names_of_the_headers(self):
        box, ball, edge, here = b2PolygonShape(box=(1, 1)), b2CircleShape(radius=1), b2EdgeShape(vertices=[(-1, 0), (1, 0)]), b2Transform()
        for call, names in ((Box2D.b2CollidePolygons, {"polygonA": box, "polygonB": box}),
                            (Box2D.b2CollidePolygonAndCircle, {"polygonA": box, "circleB": ball}),
                            (Box2D.b2CollideCircles, {"circleA": ball, "circleB": ball}),
                            (Box2D.b2CollideEdgeAndCircle, {"edgeA": edge, "circleB": ball}),
                            (Box2D.b2CollideEdgeAndPolygon, {"edgeA": edge, "polygonB": box})):
            self.assertGreater(call(xfA=here, xfB=here, **names).pointCount, 0)
        self.assertAlmostEqual(Box2D.b2MixFriction(friction1=0.4, friction2=0.9), 0.6, places=6)

    def test_polygon_holds_16_vertices(self):
        self.assertEqual(b2_maxPolygonVertices, 16)
        circle = [(math.cos(math.tau * i / 16), math.sin(math.tau * i / 16)) for i in range(16)]
        world = Box2D.b2World()
        wheel = world.CreateDynamicBody(position=(0, 2)).CreatePolygonFixture(vertices=circle, density=1)
        self.assertEqual(wheel.shape.vertexCount, 16)
        self.assertAlmostEqual(wheel.body.mass, 8 * math.sin(math.tau / 16), places=5)

    def test_polygon_refuses_invalid_vertices(self):
        for vertices in ((2, 1), [(0, 0), (1, 1)], [(0, 0), (1, 0), (2, 0)], [(i, i * i) for i in range(17)]):
            with self.assertRaises(ValueError):
                b2PolygonShape(vertices=vertices)
        with self.assertRaises(ValueError):
            b2PolygonShape(box=(0, 1))
        with self.assertRaises(TypeError):
            b2PolygonShape(vertices=3)
        with self.assertRaises(TypeError):
            b2PolygonShape(boxes=(1, 1))

    def test_an_empty_list_clears_a_polygon(self):
        polygon = b2PolygonShape(box=(1, 1), radius=0.5)
        polygon.vertices = []
        self.assertEqual((polygon.vertexCount, polygon.valid, polygon.radius), (0, False, 0.5))
        self.assertEqual(b2PolygonShape(vertices=[]).vertices, [])

    def test_an_edge_may_lack_a_neighbour(self):
        edge = b2EdgeShape(vertices=[None, (0, 0), (1, 0), (2, 0)])
        self.assertEqual((edge.hasVertex0, edge.hasVertex3, edge.vertices), (False, True, [(0, 0), (1, 0)]))
        edge.vertices = [(-1, 0), (0, 0), (1, 0), None]
        self.assertEqual((edge.hasVertex0, edge.hasVertex3, edge.vertex0), (True, False, (-1, 0)))
        edge.vertices = [None, (0, 0), (1, 0), None]
        self.assertEqual((edge.hasVertex0, edge.hasVertex3), (False, False))
        with self.assertRaises(TypeError):
            b2EdgeShape(vertices=[(0, 0), None])

    def test_circle_has_mass_and_bounds(self):
        circle = b2CircleShape(radius=2, pos=(1, 0))
        self.assertTrue(circle.TestPoint(b2Transform(), (2.5, 0)))
        self.assertAlmostEqual(circle.getMass(1).mass, 4 * math.pi, 5)
        self.assertEqual(circle.getAABB(b2Transform(), 0).upperBound, (3, 2))

    def test_edge_and_chain_take_vertices(self):
        edge = b2EdgeShape(vertices=[(0, 0), (1, 0)])
        self.assertEqual(edge.vertices, [(0, 0), (1, 0)])
        edge.vertices = [(-1, 0), (0, 0), (1, 0), (2, 0)]
        self.assertEqual((edge.vertex0, edge.vertex1, edge.hasVertex3), ((-1, 0), (0, 0), True))
        points = [(0, 0), (1, 0), (1, 1)]
        self.assertEqual(b2ChainShape(vertices_chain=points).childCount, 2)
        loop = b2LoopShape(vertices=points)
        self.assertEqual((loop.childCount, loop.getChildEdge(2).vertices), (3, [(1, 1), (0, 0)]))
        with self.assertRaises(ValueError):
            loop.getChildEdge(3)

    def test_shapes_are_hit_by_rays(self):
        hit, normal, fraction = b2PolygonShape(box=(1, 1)).RayCast((-3, 0), (3, 0), 1, b2Transform(), 0)
        self.assertTrue(hit)
        self.assertEqual(normal, (-1, 0))
        self.assertAlmostEqual(fraction, 1 / 3, 2)
        output = b2RayCastOutput()
        ray = b2RayCastInput(p1=(-3, 0), p2=(3, 0), maxFraction=1)
        self.assertIs(b2CircleShape(radius=1).RayCast(output, ray, b2Transform(), 0), True)
        self.assertEqual(output.normal, (-1, 0))
        self.assertIs(b2CircleShape(radius=1, pos=(0, 9)).RayCast(output, ray, b2Transform(), 0), False)

    def test_copies_and_pickles(self):
        for shape in (b2PolygonShape(box=(1, 2)), b2CircleShape(radius=1, pos=(2, 3)),
                      b2EdgeShape(vertices=[(0, 0), (1, 0), (2, 0)]), b2LoopShape(vertices=[(0, 0), (1, 0), (1, 1)])):
            for twin in (copy.copy(shape), copy.deepcopy(shape), pickle.loads(pickle.dumps(shape))):
                self.assertEqual((type(twin), twin.vertices, twin.radius), (type(shape), shape.vertices, shape.radius))

    def test_rays_and_manifolds_are_copied(self):
        for value, name in ((b2RayCastInput(p1=(1, 2), maxFraction=3), "p1"), (b2RayCastOutput(normal=(0, 1)), "normal"),
                            (Box2D.b2Manifold(), "pointCount"), (Box2D.b2WorldManifold(), "points")):
            for twin in (copy.copy(value), copy.deepcopy(value), value.copy()):
                self.assertEqual(getattr(twin, name), getattr(value, name))

    def test_a_box_fills_the_output_of_a_ray(self):
        output = b2RayCastOutput()
        box = b2AABB((-1, -1), (1, 1))
        self.assertIs(box.RayCast(output, b2RayCastInput(p1=(-3, 0), p2=(3, 0), maxFraction=1)), True)
        self.assertEqual(output.normal, (-1, 0))
        self.assertIs(box.RayCast(output, b2RayCastInput(p1=(-3, 9), p2=(3, 9), maxFraction=1)), False)

    def test_distance_and_time_of_impact_are_computed(self):
        box, circle = b2PolygonShape(box=(1, 1)), b2CircleShape(radius=1)
        result = Box2D.b2Distance(shapeA=box, shapeB=circle, transformB=b2Transform(position=(5, 0), angle=0),
                                  useRadii=False)
        self.assertAlmostEqual(result.distance, 4, 5)
        self.assertEqual(result.pointA.x, 1)
        state, t = Box2D.b2TimeOfImpact(shapeA=box, shapeB=circle, sweepA=b2Sweep(),
                                        sweepB=b2Sweep(c0=(6, 0), c=(0, 0)), tMax=1)
        self.assertEqual(state, Box2D.b2TOIOutput.e_touching)
        self.assertAlmostEqual(t, 4 / 6, 2)

    def test_inputs_of_distance_and_impact_are_read(self):
        box, circle = Box2D.b2DistanceProxy(b2PolygonShape(box=(1, 1))), Box2D.b2DistanceProxy(b2CircleShape(radius=1))
        self.assertEqual((box.GetVertexCount(), box.GetSupportVertex((1, 1)), circle.radius), (4, (1, 1), 1))
        place = b2Transform(position=(5, 0), angle=0)
        result = Box2D.b2Distance(Box2D.b2DistanceInput(proxyA=box, proxyB=circle, transformB=place))
        self.assertAlmostEqual(result.distance, 3, 1)
        state, t = Box2D.b2TimeOfImpact(Box2D.b2TOIInput(proxyA=box, proxyB=circle, sweepB=b2Sweep(c0=(6, 0)), tMax=1))
        self.assertEqual(state, Box2D.b2TOIOutput.e_touching)
        self.assertAlmostEqual(t, 4 / 6, 2)
        chain = Box2D.b2DistanceProxy(b2LoopShape(vertices=[(0, 0), (1, 0), (1, 1)]), 1)
        self.assertEqual(chain.vertices, [(1, 0), (1, 1)])
        with self.assertRaisesRegex(TypeError, "shapeA: expected a shape, not None"):
            Box2D.b2Distance(Box2D.b2DistanceInput())
        with self.assertRaisesRegex(TypeError, "transformA"):
            Box2D.b2DistanceInput(tranformA=box)

    def test_segments_are_clipped(self):
        ends = [Box2D.b2ClipVertex(v=(-1, 0)), Box2D.b2ClipVertex(v=(3, 0))]
        self.assertEqual([end.v for end in Box2D.b2ClipSegmentToLine(ends, (1, 0), 1, 2)], [(-1, 0), (1, 0)])
        self.assertEqual(Box2D.b2ClipSegmentToLine(ends, (1, 0), 1, 2)[1].id.cf.indexA, 2)
        self.assertEqual(Box2D.b2ClipSegmentToLine([(3, 0), (4, 0)], (1, 0), 1), [])
        for wrong in (3, [(1, 0)], [(1, 0), (2, "a")]):
            with self.assertRaisesRegex(TypeError, "vIn"):
                Box2D.b2ClipSegmentToLine(wrong, (1, 0), 1)

    def test_arguments_by_name_are_listed(self):
        for call, text in ((lambda: b2CircleShape(1), "pos=, radius="), (lambda: b2PolygonShape([(0, 0)]), "box=.*vertices="),
                           (lambda: b2Vec2(1, 2)[:], "__getitem__: expected .index., not .'slice'.")):
            with self.assertRaisesRegex(TypeError, text):
                call()

    def test_helper_functions_return_their_values(self):
        self.assertTrue(Box2D.b2CheckPolygon(b2PolygonShape(box=(1, 1))))
        with self.assertRaises(ValueError):
            Box2D.b2CheckPolygon(b2PolygonShape())
        shape = b2CircleShape()
        self.assertEqual((Box2D.b2ShapeCompare(shape, shape), Box2D.b2ShapeCompare(shape, b2CircleShape())), (True, False))
        self.assertEqual((str(Box2D.b2Version()), Box2D.b2_maxBlockSize), ("2.3.0", 640))
        self.assertEqual(Box2D.b2ContactPoint(position=(1, 2)).position, (1, 2))
        self.assertTrue(all(-1 <= Box2D.b2Random() <= 1 and 2 <= Box2D.b2Random(2, 3) <= 3 for _ in range(100)))

    def test_manifold_has_points_and_states(self):
        a, b = b2PolygonShape(box=(1, 1)), b2PolygonShape(box=(1, 1))
        manifold = Box2D.b2Manifold()
        Box2D.b2CollidePolygons(manifold, a, b2Transform(), b, b2Transform(position=(1.9, 0), angle=0))
        self.assertEqual(manifold.pointCount, 2)
        before = Box2D.b2Manifold()
        self.assertEqual(Box2D.b2GetPointStates(before, manifold)[1], (Box2D.b2_addState, Box2D.b2_addState))
        with self.assertRaises(b2Error):
            Box2D.b2CollidePolygons(b2PolygonShape(), b2Transform(), b, b2Transform())


if __name__ == "__main__":
    unittest.main()
