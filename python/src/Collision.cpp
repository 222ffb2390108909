// SPDX-License-Identifier: MIT
#include "Bind.h"
#include "Module.h"
#include "Shapes.h"

/// Boxes, manifolds, rays, distances and times of impact: what programs use without a world.
namespace boxreel::python
{
namespace
{

int32 ChildOf(const ShapeObject& shape, int32 child, const char* name)
{
    if (child < 0 || child >= shape.Get().GetChildCount())
    {
        ThrowMisuse(std::string(name) + ": " + std::to_string(child) +
                    " is out of range; the shape has " +
                    std::to_string(shape.Get().GetChildCount()) + " children");
    }
    return child;
}

/// The proxy refers to the shape, so that conversions come before: they may run code.
b2DistanceProxy ProxyOf(const ShapeObject& shape, int32 index, const char* name)
{
    b2DistanceProxy proxy;
    proxy.Set(&shape.Get(), ChildOf(shape, index, name));
    CheckMisuse();
    if (proxy.GetVertexCount() < 1)
    {
        ThrowMisuse("the shape has no vertices");
    }
    return proxy;
}

void BindBoxes(py::module_& module)
{
    py::class_<b2RayCastInput> input(module, "b2RayCastInput",
                                     "A ray from p1 to p1 + maxFraction * (p2 - p1).");
    KeywordInit<b2RayCastInput>(input);
    Member<&b2RayCastInput::p1>(input, "p1", "Start [m].");
    Member<&b2RayCastInput::p2>(input, "p2", "End at fraction 1 [m].");
    Member<&b2RayCastInput::maxFraction>(input, "maxFraction", "Length as a multiple of p2 - p1.");
    Copies(
        input, [](const b2RayCastInput& r) { return py::make_tuple(r.p1, r.p2, r.maxFraction); },
        [](const py::tuple& s) {
            return b2RayCastInput{From<b2Vec2>(s[0], ""), From<b2Vec2>(s[1], ""),
                                  From<float32>(s[2], "")};
        });

    py::class_<b2RayCastOutput> output(module, "b2RayCastOutput", "Where a ray hits.");
    KeywordInit<b2RayCastOutput>(output);
    Member<&b2RayCastOutput::normal>(output, "normal", "Unit normal of the surface.");
    Member<&b2RayCastOutput::fraction>(output, "fraction", "Fraction of the ray.");
    Copies(
        output, [](const b2RayCastOutput& r) { return py::make_tuple(r.normal, r.fraction); },
        [](const py::tuple& s) {
            return b2RayCastOutput{From<b2Vec2>(s[0], ""), From<float32>(s[1], "")};
        });

    py::class_<b2AABB> box(module, "b2AABB", "An axis-aligned box: lowerBound=, upperBound=.");
    box.def(py::init([](py::handle lower, py::handle upper) {
                b2AABB value;
                value.lowerBound = From<b2Vec2>(lower, "lowerBound");
                value.upperBound = From<b2Vec2>(upper, "upperBound");
                return value;
            }),
            py::arg("lowerBound"), py::arg("upperBound"));
    KeywordInit<b2AABB>(box);
    Member<&b2AABB::lowerBound>(box, "lowerBound", "Lower left corner [m].");
    Member<&b2AABB::upperBound>(box, "upperBound", "Upper right corner [m].");
    box.def_property_readonly("valid", &b2AABB::IsValid,
                              "True if the bounds are sorted and finite.")
        .def_property_readonly("center", &b2AABB::GetCenter, "Centre [m].")
        .def_property_readonly("extents", &b2AABB::GetExtents,
                               "Half the width and half the height [m].")
        .def_property_readonly("perimeter", &b2AABB::GetPerimeter, "Perimeter [m].")
        .def("Contains", &b2AABB::Contains, py::arg("aabb"), "True if the other box is inside.")
        .def("__contains__",
             [](const b2AABB& self, py::handle item) {
                 if (py::isinstance<b2AABB>(item))
                 {
                     return self.Contains(item.cast<b2AABB&>());
                 }
                 const b2Vec2 point = From<b2Vec2>(item, "point");
                 return self.Contains(b2AABB{point, point});
             })
        .def(
            "overlaps", [](const b2AABB& a, const b2AABB& b) { return b2TestOverlap(a, b); },
            py::arg("aabb"), "True if the boxes overlap.")
        .def(
            "Combine", [](b2AABB& self, const b2AABB& a) { self.Combine(a); }, py::arg("aabb"),
            "Grows to contain the other box.")
        .def(
            "Combine", [](b2AABB& self, const b2AABB& a, const b2AABB& b) { self.Combine(a, b); },
            py::arg("aabb1"), py::arg("aabb2"), "Becomes the smallest box that contains both.")
        .def(
            "RayCast",
            [](const b2AABB& self, const b2RayCastInput& ray) {
                b2RayCastOutput result;
                const bool hit = self.RayCast(&result, ray);
                return py::make_tuple(hit, result);
            },
            py::arg("input"), "Returns (hit, b2RayCastOutput).")
        .def(
            "RayCast",
            [](const b2AABB& self, b2RayCastOutput& result, const b2RayCastInput& ray) {
                return self.RayCast(&result, ray);
            },
            py::arg("output"), py::arg("input"),
            "Returns whether the ray hits, and fills the output.")
        .def(
            "__eq__",
            [](const b2AABB& a, const b2AABB& b) {
                return a.lowerBound == b.lowerBound && a.upperBound == b.upperBound;
            },
            py::is_operator())
        .def("__repr__", [](py::handle self) {
            return "b2AABB(lowerBound=" + std::string(py::repr(self.attr("lowerBound"))) +
                   ", upperBound=" + std::string(py::repr(self.attr("upperBound"))) + ")";
        });
    Copies(
        box, [](const b2AABB& b) { return py::make_tuple(b.lowerBound, b.upperBound); },
        [](const py::tuple& s) {
            return b2AABB{From<b2Vec2>(s[0], ""), From<b2Vec2>(s[1], "")};
        });

    py::class_<b2MassData> mass(module, "b2MassData",
                                "Mass [kg], centre [m] and rotational inertia [kg m^2].");
    KeywordInit<b2MassData>(mass);
    Member<&b2MassData::mass>(mass, "mass", "Mass [kg].");
    Member<&b2MassData::center>(mass, "center", "Centre of mass [m].");
    Member<&b2MassData::I>(mass, "I", "Rotational inertia about the origin [kg m^2].");
    Copies(
        mass, [](const b2MassData& m) { return py::make_tuple(m.mass, m.center, m.I); },
        [](const py::tuple& s) {
            return b2MassData{From<float32>(s[0], ""), From<b2Vec2>(s[1], ""),
                              From<float32>(s[2], "")};
        });

    py::class_<b2Filter> filter(module, "b2Filter", "Decides which fixtures collide.");
    KeywordInit<b2Filter>(filter);
    Member<&b2Filter::categoryBits>(filter, "categoryBits",
                                    "Categories of the fixture, 0 to 65535.");
    Member<&b2Filter::maskBits>(filter, "maskBits",
                                "Categories that it collides with, 0 to 65535.");
    Member<&b2Filter::groupIndex>(filter, "groupIndex",
                                  "Group that always or never collides; 0: none.");
    Copies(
        filter,
        [](const b2Filter& f) { return py::make_tuple(f.categoryBits, f.maskBits, f.groupIndex); },
        [](const py::tuple& s) {
            return b2Filter{From<uint16>(s[0], ""), From<uint16>(s[1], ""), From<int16>(s[2], "")};
        });
}

void BindManifolds(py::module_& module)
{
    py::class_<b2ContactFeature> feature(module, "b2ContactFeature",
                                         "The features that make a contact point.");
    feature.attr("e_vertex") = int(b2ContactFeature::e_vertex);
    feature.attr("e_face") = int(b2ContactFeature::e_face);
    feature.def_readonly("indexA", &b2ContactFeature::indexA, "Vertex or face of shape A.")
        .def_readonly("indexB", &b2ContactFeature::indexB, "Vertex or face of shape B.")
        .def_readonly("typeA", &b2ContactFeature::typeA, "e_vertex or e_face.")
        .def_readonly("typeB", &b2ContactFeature::typeB, "e_vertex or e_face.");
    Copies(feature);

    py::class_<b2ContactID> id(module, "b2ContactID",
                               "Identifies a contact point from step to step.");
    id.def_property_readonly(
          "key", [](const b2ContactID& i) { return i.key; }, "The features as one number.")
        .def_property_readonly(
            "cf", [](const b2ContactID& i) { return i.cf; }, "The features.");
    Copies(id);

    py::class_<b2ManifoldPoint> point(module, "b2ManifoldPoint", "A contact point.");
    point
        .def_readonly("localPoint", &b2ManifoldPoint::localPoint,
                      "Position; its frame depends on the manifold [m].")
        .def_readonly("normalImpulse", &b2ManifoldPoint::normalImpulse, "Normal impulse [N s].")
        .def_readonly("tangentImpulse", &b2ManifoldPoint::tangentImpulse, "Friction impulse [N s].")
        .def_readonly("id", &b2ManifoldPoint::id, "Features that made it.")
        .def_property_readonly(
            "isNew", [](const b2ManifoldPoint& p) { return p.normalImpulse == 0.0f; },
            "True if it has no impulse yet.");
    Copies(point);

    py::class_<b2Manifold> manifold(module, "b2Manifold",
                                    "The contact of two shapes: a normal and up to two points.");
    manifold.def(py::init<>());
    manifold.attr("e_circles") = int(b2Manifold::e_circles);
    manifold.attr("e_faceA") = int(b2Manifold::e_faceA);
    manifold.attr("e_faceB") = int(b2Manifold::e_faceB);
    manifold
        .def_property_readonly(
            "points",
            [](const b2Manifold& m) {
                py::list points;
                for (int32 i = 0; i < m.pointCount; ++i)
                {
                    points.append(m.points[i]);
                }
                return points;
            },
            "The contact points, a list of b2ManifoldPoint.")
        .def_readonly("localNormal", &b2Manifold::localNormal,
                      "Unit normal, in the frame of a body.")
        .def_readonly("localPoint", &b2Manifold::localPoint, "Reference point [m].")
        .def_property_readonly(
            "type_", [](const b2Manifold& m) { return int(m.type); },
            "e_circles, e_faceA or e_faceB.")
        .def_property_readonly(
            "type", [](const b2Manifold& m) { return int(m.type); },
            "e_circles, e_faceA or e_faceB.")
        .def_readonly("pointCount", &b2Manifold::pointCount, "Number of points, 0 to 2.");
    Copies(manifold);

    py::class_<b2WorldManifold> world(module, "b2WorldManifold", "A manifold in the world.");
    world.def(py::init<>())
        .def_readonly("normal", &b2WorldManifold::normal, "Unit normal from A to B.")
        .def_property_readonly(
            "points",
            [](const b2WorldManifold& m) { return TuplesOf(m.points, b2_maxManifoldPoints); },
            "Both points [m]; those beyond the manifold's pointCount are (0, 0).")
        .def_property_readonly(
            "separations",
            [](const b2WorldManifold& m) {
                return py::make_tuple(m.separations[0], m.separations[1]);
            },
            "Separations of the points [m]; negative: overlap.")
        .def(
            "Initialize",
            [](b2WorldManifold& m, const b2Manifold& local, py::handle xfA, py::handle radiusA,
               py::handle xfB, py::handle radiusB) {
                m.Initialize(&local, From<b2Transform>(xfA, "xfA"),
                             From<float32>(radiusA, "radiusA"), From<b2Transform>(xfB, "xfB"),
                             From<float32>(radiusB, "radiusB"));
            },
            py::arg("manifold"), py::arg("xfA"), py::arg("radiusA"), py::arg("xfB"),
            py::arg("radiusB"), "Computes the manifold in the world.");
    Copies(world);

    py::class_<b2ContactImpulse> impulse(module, "b2ContactImpulse",
                                         "Impulses of a contact in a step [N s].");
    impulse.def(py::init([] { return b2ContactImpulse{}; }))
        .def_readonly("count", &b2ContactImpulse::count, "Number of points, 0 to 2.")
        .def_property_readonly(
            "normalImpulses",
            [](const b2ContactImpulse& i) {
                return py::make_tuple(i.normalImpulses[0], i.normalImpulses[1]);
            },
            "Normal impulses [N s].")
        .def_property_readonly(
            "tangentImpulses",
            [](const b2ContactImpulse& i) {
                return py::make_tuple(i.tangentImpulses[0], i.tangentImpulses[1]);
            },
            "Friction impulses [N s].");
    Copies(impulse);

    module.def("_clip", [](const py::sequence& points, const py::sequence& ids, py::handle normal,
                           py::handle offset, py::handle vertexIndexA) {
        b2ClipVertex in[2];
        for (std::size_t i = 0; i < 2; ++i)
        {
            const py::object made = ids[i];
            in[i].v = From<b2Vec2>(py::object(points[i]), "vIn");
            in[i].id = py::isinstance<b2ContactID>(made) ? made.cast<b2ContactID>() : b2ContactID();
        }
        b2ClipVertex out[2];
        const int32 count = b2ClipSegmentToLine(out, in, From<b2Vec2>(normal, "normal"),
                                                From<float32>(offset, "offset"),
                                                From<int32>(vertexIndexA, "vertexIndexA"));
        py::list left;
        for (int32 i = 0; i < count; ++i)
        {
            left.append(py::make_tuple(out[i].v, out[i].id));
        }
        return left;
    });
    module.def(
        "b2GetPointStates",
        [](py::handle old, py::handle current) {
            if (!py::isinstance<b2Manifold>(old) || !py::isinstance<b2Manifold>(current))
            {
                ThrowType("b2GetPointStates", "two b2Manifold",
                          py::isinstance<b2Manifold>(old) ? current : old);
            }
            const b2Manifold& first = old.cast<const b2Manifold&>();
            const b2Manifold& second = current.cast<const b2Manifold&>();
            b2PointState state1[b2_maxManifoldPoints];
            b2PointState state2[b2_maxManifoldPoints];
            b2GetPointStates(state1, state2, &first, &second);
            return py::make_tuple(py::make_tuple(int(state1[0]), int(state1[1])),
                                  py::make_tuple(int(state2[0]), int(state2[1])));
        },
        py::arg("manifold1"), py::arg("manifold2"),
        "Returns the states of both manifolds' points: (state1, state2).");
}

/// Adds a function for two shapes: `name(nameA, xfA, nameB, xfB)` returns a manifold. The module
/// of the 2.3 generation also takes the manifold to fill as first argument.
template <class A, class B>
void Collide(py::module_& module, const char* name, const char* nameA, const char* nameB,
             void (*collide)(b2Manifold*, const A*, const b2Transform&, const B*,
                             const b2Transform&))
{
    const auto compute = [collide](const ShapeOf<A>& a, py::handle xfA, const ShapeOf<B>& b,
                                   py::handle xfB) {
        const b2Transform transformA = From<b2Transform>(xfA, "xfA");
        const b2Transform transformB = From<b2Transform>(xfB, "xfB");
        if constexpr (std::is_same_v<A, b2PolygonShape>)
        {
            if (a.Get().m_count < 3)
            {
                ThrowMisuse("the polygon has no vertices");
            }
        }
        if constexpr (std::is_same_v<B, b2PolygonShape>)
        {
            if (b.Get().m_count < 3)
            {
                ThrowMisuse("the polygon has no vertices");
            }
        }
        b2Manifold manifold;
        collide(&manifold, &a.Get(), transformA, &b.Get(), transformB);
        return Checked(manifold);
    };
    module.def(name, compute, py::arg(nameA), py::arg("xfA"), py::arg(nameB), py::arg("xfB"),
               "Returns the manifold of two shapes.");
    module.def(
        name,
        [compute](b2Manifold& manifold, const ShapeOf<A>& a, py::handle xfA, const ShapeOf<B>& b,
                  py::handle xfB) { manifold = compute(a, xfA, b, xfB); },
        py::arg("manifold"), py::arg(nameA), py::arg("xfA"), py::arg(nameB), py::arg("xfB"),
        "Computes the manifold of two shapes.");
}

void BindQueries(py::module_& module)
{
    Collide(module, "b2CollideCircles", "circleA", "circleB", &b2CollideCircles);
    Collide(module, "b2CollidePolygonAndCircle", "polygonA", "circleB", &b2CollidePolygonAndCircle);
    Collide(module, "b2CollidePolygons", "polygonA", "polygonB", &b2CollidePolygons);
    Collide(module, "b2CollideEdgeAndCircle", "edgeA", "circleB", &b2CollideEdgeAndCircle);
    Collide(module, "b2CollideEdgeAndPolygon", "edgeA", "polygonB", &b2CollideEdgeAndPolygon);
    module.def(
        "b2TestOverlap", [](const b2AABB& a, const b2AABB& b) { return b2TestOverlap(a, b); },
        py::arg("a"), py::arg("b"), "True if the boxes overlap.");
    module.def(
        "b2TestOverlap",
        [](const ShapeObject& a, py::handle indexA, const ShapeObject& b, py::handle indexB,
           py::handle xfA, py::handle xfB) {
            const int32 first = From<int32>(indexA, "idxA");
            const int32 second = From<int32>(indexB, "idxB");
            const b2Transform transformA = From<b2Transform>(xfA, "transformA");
            const b2Transform transformB = From<b2Transform>(xfB, "transformB");
            return Checked(b2TestOverlap(&a.Get(), ChildOf(a, first, "idxA"), &b.Get(),
                                         ChildOf(b, second, "idxB"), transformA, transformB));
        },
        py::arg("shapeA"), py::arg("idxA"), py::arg("shapeB"), py::arg("idxB"),
        py::arg("transformA"), py::arg("transformB"),
        "True if the shapes, or these children, overlap.");
    module.def("_distance", [](const ShapeObject& a, py::handle indexA, const ShapeObject& b,
                               py::handle indexB, py::handle xfA, py::handle xfB, bool useRadii) {
        const int32 first = From<int32>(indexA, "idxA");
        const int32 second = From<int32>(indexB, "idxB");
        b2DistanceInput input;
        input.transformA = From<b2Transform>(xfA, "transformA");
        input.transformB = From<b2Transform>(xfB, "transformB");
        input.proxyA = ProxyOf(a, first, "idxA");
        input.proxyB = ProxyOf(b, second, "idxB");
        input.useRadii = useRadii;
        b2SimplexCache cache;
        b2DistanceOutput output;
        b2Distance(&output, &cache, &input);
        CheckMisuse();
        return py::make_tuple(output.pointA, output.pointB, output.distance, output.iterations);
    });
    module.def("_time_of_impact",
               [](const ShapeObject& a, py::handle indexA, const ShapeObject& b, py::handle indexB,
                  const b2Sweep& sweepA, const b2Sweep& sweepB, py::handle tMax) {
                   const int32 first = From<int32>(indexA, "idxA");
                   const int32 second = From<int32>(indexB, "idxB");
                   b2TOIInput input;
                   input.tMax = From<float32>(tMax, "tMax");
                   input.sweepA = sweepA;
                   input.sweepB = sweepB;
                   input.proxyA = ProxyOf(a, first, "idxA");
                   input.proxyB = ProxyOf(b, second, "idxB");
                   b2TOIOutput output;
                   b2TimeOfImpact(&output, &input);
                   CheckMisuse();
                   return py::make_tuple(int(output.state), output.t);
               });
}

} // namespace

void BindCollision(py::module_& module)
{
    BindBoxes(module);
    BindManifolds(module);
    BindQueries(module);
}

} // namespace boxreel::python
