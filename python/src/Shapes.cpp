// SPDX-License-Identifier: MIT
#include "Shapes.h"

#include "Bind.h"
#include "Module.h"

namespace boxreel::python
{
namespace
{

using Circle = ShapeOf<b2CircleShape>;
using Edge = ShapeOf<b2EdgeShape>;
using Polygon = ShapeOf<b2PolygonShape>;
using Chain = ShapeOf<b2ChainShape>;

int32 Child(const b2Shape& shape, py::handle index)
{
    const int32 child = From<int32>(index, "childIndex");
    if (child < 0 || child >= shape.GetChildCount())
    {
        ThrowMisuse("childIndex: " + std::to_string(child) + " is out of range; the shape has " +
                    std::to_string(shape.GetChildCount()) + " children");
    }
    return child;
}

void SetVertices(Polygon& self, py::handle value)
{
    if (IsVec2(value)) // the kind of error that programs catch
    {
        ThrowMisuse("vertices: expected a list of at least 3 points, not one point");
    }
    const std::vector<b2Vec2> points = From<std::vector<b2Vec2>>(value, "vertices");
    const int32 count = static_cast<int32>(points.size());
    if (const char* reason =
            count > 0 ? b2PolygonShape::WhyNotConvex(points.data(), count) : nullptr)
    {
        ThrowMisuse(reason);
    }
    self.Change([&](b2PolygonShape& shape) {
        if (count > 0)
        {
            shape.Set(points.data(), count);
            return;
        }
        const float32 radius = shape.m_radius;
        shape = b2PolygonShape();
        shape.m_radius = radius;
    });
}

void SetBox(Polygon& self, py::handle width, py::handle height, py::handle center, py::handle angle)
{
    const float32 hx = From<float32>(width, "box");
    const float32 hy = From<float32>(height, "box");
    const b2Vec2 middle = From<b2Vec2>(center, "box");
    const float32 turn = From<float32>(angle, "box");
    self.Change([&](b2PolygonShape& shape) {
        const float32 radius = shape.m_radius;
        shape.SetAsBox(hx, hy, middle, turn);
        shape.m_radius = radius;
    });
}

void SetBoxTuple(Polygon& self, py::handle value)
{
    const bool isSequence = PySequence_Check(value.ptr()) != 0 && PyUnicode_Check(value.ptr()) == 0;
    const std::size_t count = isSequence ? py::len(value) : 0;
    if (count < 2 || count > 4)
    {
        ThrowType("box", "(hx, hy), (hx, hy, center) or (hx, hy, center, angle)", value);
    }
    const py::sequence box = py::reinterpret_borrow<py::sequence>(value);
    SetBox(self, py::object(box[0]), py::object(box[1]),
           count > 2 ? py::object(box[2]) : py::object(py::make_tuple(0.0, 0.0)),
           count > 3 ? py::object(box[3]) : py::object(py::float_(0.0)));
}

/// Sets an edge by 2 points, or by 3 or 4 with its neighbours', which may be None.
void SetVertices(Edge& self, py::handle value)
{
    const py::list points = ItemsOf(value, "vertices");
    const std::size_t count = points.size();
    if (count < 2 || count > 4)
    {
        ThrowMisuse("vertices: an edge has 2 points, up to 4 with those of its neighbours; got " +
                    std::to_string(count));
    }
    const std::size_t first = count == 4 ? 1 : 0;
    const py::object before = first == 1 ? py::object(points[0]) : py::none();
    const py::object after = count > 2 ? py::object(points[count - 1]) : py::none();
    const b2Vec2 start = From<b2Vec2>(py::object(points[first]), "vertices");
    const b2Vec2 end = From<b2Vec2>(py::object(points[first + 1]), "vertices");
    const b2Vec2 vertex0 = before.is_none() ? b2Vec2() : From<b2Vec2>(before, "vertices");
    const b2Vec2 vertex3 = after.is_none() ? b2Vec2() : From<b2Vec2>(after, "vertices");
    self.Change([&](b2EdgeShape& edge) {
        edge.Set(start, end);
        edge.m_hasVertex0 = !before.is_none();
        edge.m_vertex0 = vertex0;
        edge.m_hasVertex3 = !after.is_none();
        edge.m_vertex3 = vertex3;
    });
}

void SetVertices(Chain& self, py::handle value, bool isLoop)
{
    const std::vector<b2Vec2> points = From<std::vector<b2Vec2>>(value, "vertices");
    const int32 count = static_cast<int32>(points.size());
    if (isLoop && count < 3)
    {
        ThrowMisuse("vertices: a loop has at least 3 points; got " + std::to_string(count));
    }
    self.Change([&](b2ChainShape& chain) {
        chain.Clear();
        if (isLoop && count > 2)
        {
            chain.CreateLoop(points.data(), count);
        }
        else
        {
            chain.CreateChain(points.data(), count);
        }
    });
}

py::object ChildEdge(const Chain& self, py::handle index)
{
    b2EdgeShape edge;
    const int32 child = From<int32>(index, "childIndex");
    self.Get().GetChildEdge(&edge, Child(self.Get(), py::int_(child)));
    CheckMisuse();
    auto object = std::make_unique<Edge>();
    object->shape = edge;
    return py::cast(std::move(object));
}

/// A polygon without vertices has no inside, and the engine's functions answer at random for it.
const b2Shape& RequireVertices(const ShapeObject& self)
{
    const b2Shape& shape = self.Get();
    if (shape.GetType() == b2Shape::e_polygon &&
        static_cast<const b2PolygonShape&>(shape).m_count < 3)
    {
        ThrowMisuse("the polygon has no vertices; set its vertices or its box first");
    }
    return shape;
}

/// Casts a ray. The child is checked last, because conversions may run code that changes the shape.
bool CastInto(b2RayCastOutput& output, const ShapeObject& self, const b2RayCastInput& input,
              py::handle transform, py::handle child)
{
    const b2Transform xf = From<b2Transform>(transform, "transform");
    const int32 index = Child(RequireVertices(self), child);
    return Checked(self.Get().RayCast(&output, input, xf, index));
}

py::object CastRay(const ShapeObject& self, const b2RayCastInput& input, py::handle transform,
                   py::handle child)
{
    b2RayCastOutput output;
    const bool hit = CastInto(output, self, input, transform, child);
    return py::make_tuple(hit, output.normal, static_cast<double>(output.fraction));
}

template <class Class>
void CopiesOf(Class& type)
{
    using T = typename Class::type;
    const auto copy = [](const T& self) {
        auto other = std::make_unique<T>();
        other->shape = self.Get();
        return other;
    };
    type.def("copy", copy, "Returns a copy.")
        .def("__copy__", copy)
        .def(
            "__deepcopy__", [copy](const T& self, py::handle) { return copy(self); },
            py::arg("memo"));
}

void BindBase(py::module_& module)
{
    py::class_<ShapeObject> type(module, "b2Shape", "The base class of shapes.");
    type.attr("e_circle") = int(b2Shape::e_circle);
    type.attr("e_edge") = int(b2Shape::e_edge);
    type.attr("e_polygon") = int(b2Shape::e_polygon);
    type.attr("e_chain") = int(b2Shape::e_chain);
    type.def_property_readonly(
            "type", [](const ShapeObject& s) { return int(s.Get().GetType()); },
            "One of e_circle, e_edge, e_polygon and e_chain.")
        .def_property_readonly(
            "childCount", [](const ShapeObject& s) { return s.Get().GetChildCount(); },
            "Number of edges of a chain; 1 for other shapes.")
        .def_property(
            "radius", [](const ShapeObject& s) { return s.Get().m_radius; },
            [](ShapeObject& s, py::handle value) {
                const float32 radius = From<float32>(value, "radius");
                if (!b2IsValid(radius) || radius < 0.0f)
                {
                    ThrowMisuse("radius: expected a finite number that is not negative");
                }
                s.SetRadius(radius);
            },
            "Radius of a circle, or of the skin of another shape [m].")
        .def(
            "TestPoint",
            [](const ShapeObject& s, py::handle xf, py::handle p) {
                const b2Transform transform = From<b2Transform>(xf, "xf");
                const b2Vec2 point = From<b2Vec2>(p, "p");
                return Checked(RequireVertices(s).TestPoint(transform, point));
            },
            py::arg("xf"), py::arg("p"), "True if the world point [m] is inside.")
        .def(
            "RayCast",
            [](const ShapeObject& s, b2RayCastOutput& output, const b2RayCastInput& input,
               py::handle xf, py::handle child) { return CastInto(output, s, input, xf, child); },
            py::arg("output"), py::arg("input"), py::arg("transform"), py::arg("childIndex") = 0,
            "Returns whether the ray hits, and fills the output.")
        .def(
            "RayCast",
            [](const ShapeObject& s, py::handle p1, py::handle p2, py::handle fraction,
               py::handle xf, py::handle child) {
                const b2RayCastInput input{From<b2Vec2>(p1, "p1"), From<b2Vec2>(p2, "p2"),
                                           From<float32>(fraction, "maxFraction")};
                return CastRay(s, input, xf, child);
            },
            py::arg("p1"), py::arg("p2"), py::arg("maxFraction"), py::arg("transform"),
            py::arg("childIndex") = 0,
            "Returns (hit, normal, fraction) of a ray from p1 to p2 [m].")
        .def(
            "RayCast",
            [](const ShapeObject& s, const b2RayCastInput& input, py::handle xf, py::handle child) {
                return CastRay(s, input, xf, child);
            },
            py::arg("input"), py::arg("transform"), py::arg("childIndex") = 0,
            "Returns (hit, normal, fraction) of the ray of a b2RayCastInput.")
        .def(
            "getAABB",
            [](const ShapeObject& s, py::handle xf, py::handle child) {
                const b2Transform transform = From<b2Transform>(xf, "transform");
                const int32 index = Child(RequireVertices(s), child);
                b2AABB box;
                s.Get().ComputeAABB(&box, transform, index);
                return Checked(box);
            },
            py::arg("transform"), py::arg("childIndex") = 0,
            "Returns the bounding box of a child [m].")
        .def(
            "getMass",
            [](const ShapeObject& s, py::handle density) {
                const float32 amount = From<float32>(density, "density");
                b2MassData mass;
                RequireVertices(s).ComputeMass(&mass, amount);
                return Checked(mass);
            },
            py::arg("density"), "Returns the mass data for a density [kg/m^2].");
    type.attr("ComputeAABB") = type.attr("getAABB");
    type.attr("ComputeMass") = type.attr("getMass");
}

void BindCircle(py::module_& module)
{
    py::class_<Circle, ShapeObject> type(module, "b2CircleShape", "A solid circle: radius=, pos=.");
    KeywordInit<Circle>(type);
    type.def_property(
            "pos", [](const Circle& s) { return s.Get().m_p; },
            [](Circle& s, py::handle value) {
                const b2Vec2 pos = From<b2Vec2>(value, "pos");
                s.Change([&](b2CircleShape& circle) { circle.m_p = pos; });
            },
            "Centre [m].")
        .def_property_readonly(
            "vertices", [](const Circle& s) { return TuplesOf(&s.Get().m_p, 1); },
            "The centre, in a list [m].")
        .def_property_readonly(
            "vertexCount", [](const Circle&) { return 1; }, "Always 1.")
        .def("__repr__",
             [](const Circle& s) {
                 return "b2CircleShape(radius=" +
                        std::string(py::str(py::float_(double(s.Get().m_radius)))) +
                        ", pos=" + std::string(py::repr(py::cast(s.Get().m_p))) + ")";
             })
        .def(py::pickle(
            [](const Circle& s) { return py::make_tuple(s.Get().m_radius, s.Get().m_p); },
            [](const py::tuple& state) {
                auto circle = std::make_unique<Circle>();
                circle->shape.m_radius = From<float32>(state[0], "radius");
                circle->shape.m_p = From<b2Vec2>(state[1], "pos");
                return circle;
            }));
    CopiesOf(type);
}

template <auto member, class Class>
void GhostVertex(Class& type, const char* name)
{
    type.def_property(
        name, [](const Edge& s) { return s.Get().*member; },
        [name](Edge& s, py::handle value) {
            using Part = std::remove_reference_t<decltype(s.shape.*member)>;
            const Part part = From<Part>(value, name);
            s.Change([&](b2EdgeShape& edge) { edge.*member = part; });
        },
        "A vertex [m]; vertex0 and vertex3 are those of the neighbours.");
}

void BindEdge(py::module_& module)
{
    py::class_<Edge, ShapeObject> type(module, "b2EdgeShape", "A line segment: vertices=[a, b].");
    KeywordInit<Edge>(type);
    GhostVertex<&b2EdgeShape::m_vertex0>(type, "vertex0");
    GhostVertex<&b2EdgeShape::m_vertex1>(type, "vertex1");
    GhostVertex<&b2EdgeShape::m_vertex2>(type, "vertex2");
    GhostVertex<&b2EdgeShape::m_vertex3>(type, "vertex3");
    GhostVertex<&b2EdgeShape::m_hasVertex0>(type, "hasVertex0");
    GhostVertex<&b2EdgeShape::m_hasVertex3>(type, "hasVertex3");
    const auto all = [](const Edge& s) {
        const b2Vec2 points[4] = {s.Get().m_vertex0, s.Get().m_vertex1, s.Get().m_vertex2,
                                  s.Get().m_vertex3};
        return TuplesOf(points, 4);
    };
    type.def_property(
            "vertices",
            [](const Edge& s) {
                const b2Vec2 points[2] = {s.Get().m_vertex1, s.Get().m_vertex2};
                return TuplesOf(points, 2);
            },
            [](Edge& s, py::handle value) { SetVertices(s, value); },
            "The two ends [m]. May be set with those of the neighbours: 3 or 4 points.")
        .def_property(
            "all_vertices", all, [](Edge& s, py::handle value) { SetVertices(s, value); },
            "The vertex before, the two ends, and the vertex after [m].")
        .def_property_readonly(
            "vertexCount", [](const Edge&) { return 2; }, "Always 2.")
        .def("__iter__", [](py::handle s) { return py::iter(s.attr("vertices")); })
        .def("__repr__",
             [](py::handle s) {
                 return "b2EdgeShape(vertices=" + std::string(py::repr(s.attr("vertices"))) + ")";
             })
        .def(py::pickle(
            [](const Edge& s) {
                const b2EdgeShape& e = s.Get();
                return py::make_tuple(e.m_vertex0, e.m_vertex1, e.m_vertex2, e.m_vertex3,
                                      e.m_hasVertex0, e.m_hasVertex3, e.m_oneSided, e.m_radius);
            },
            [](const py::tuple& state) {
                auto edge = std::make_unique<Edge>();
                b2EdgeShape& e = edge->shape;
                e.m_vertex0 = From<b2Vec2>(state[0], "");
                e.m_vertex1 = From<b2Vec2>(state[1], "");
                e.m_vertex2 = From<b2Vec2>(state[2], "");
                e.m_vertex3 = From<b2Vec2>(state[3], "");
                e.m_hasVertex0 = From<bool>(state[4], "");
                e.m_hasVertex3 = From<bool>(state[5], "");
                e.m_oneSided = From<bool>(state[6], "");
                e.m_radius = From<float32>(state[7], "");
                return edge;
            }));
    CopiesOf(type);
}

void BindPolygon(py::module_& module)
{
    py::class_<Polygon, ShapeObject> type(
        module, "b2PolygonShape",
        "A convex polygon: vertices=[…], or box=(hx, hy[, center, angle]).");
    KeywordInit<Polygon>(type);
    type.def_property(
            "vertices",
            [](const Polygon& s) { return TuplesOf(s.Get().m_vertices, s.Get().m_count); },
            [](Polygon& s, py::handle value) { SetVertices(s, value); },
            "The vertices, counter-clockwise [m]. Setting them takes their convex hull.")
        .def_property(
            "box", [](py::handle s) { return s.attr("vertices"); },
            [](Polygon& s, py::handle value) { SetBoxTuple(s, value); },
            "Half-width and half-height [m], and optionally a centre [m] and an angle [rad].")
        .def_property_readonly(
            "normals",
            [](const Polygon& s) { return TuplesOf(s.Get().m_normals, s.Get().m_count); },
            "Outward unit normals of the edges.")
        .def_property_readonly(
            "centroid", [](const Polygon& s) { return s.Get().m_centroid; },
            "Centroid of the area [m].")
        .def_property_readonly(
            "vertexCount", [](const Polygon& s) { return s.Get().m_count; }, "Number of vertices.")
        .def_property_readonly(
            "valid", [](const Polygon& s) { return s.Get().m_count >= 3 && s.Get().Validate(); },
            "True if the polygon is convex and has a size.")
        .def(
            "SetAsBox",
            [](Polygon& s, py::handle hx, py::handle hy, py::handle center, py::handle angle) {
                SetBox(s, hx, hy, center, angle);
            },
            py::arg("hx"), py::arg("hy"), py::arg("center") = py::make_tuple(0.0, 0.0),
            py::arg("angle") = 0.0, "Sets a box of half-width hx and half-height hy [m].")
        .def("__iter__", [](py::handle s) { return py::iter(s.attr("vertices")); })
        .def("__len__", [](const Polygon& s) { return s.Get().m_count; })
        .def("__repr__",
             [](py::handle s) {
                 return "b2PolygonShape(vertices=" + std::string(py::repr(s.attr("vertices"))) +
                        ")";
             })
        .def(py::pickle(
            [](const Polygon& s) {
                return py::make_tuple(TuplesOf(s.Get().m_vertices, s.Get().m_count),
                                      TuplesOf(s.Get().m_normals, s.Get().m_count),
                                      s.Get().m_centroid, s.Get().m_radius);
            },
            [](const py::tuple& state) {
                auto polygon = std::make_unique<Polygon>();
                const std::vector<b2Vec2> vertices = From<std::vector<b2Vec2>>(state[0], "");
                const std::vector<b2Vec2> normals = From<std::vector<b2Vec2>>(state[1], "");
                b2PolygonShape& shape = polygon->shape;
                shape.m_count =
                    int32(std::min({vertices.size(), normals.size(), std::size(shape.m_vertices)}));
                std::copy_n(vertices.begin(), shape.m_count, shape.m_vertices);
                std::copy_n(normals.begin(), shape.m_count, shape.m_normals);
                shape.m_centroid = From<b2Vec2>(state[2], "");
                shape.m_radius = From<float32>(state[3], "");
                return polygon;
            }));
    type.attr("__bool__") =
        py::cpp_function([](const Polygon&) { return true; }, py::is_method(type));
    CopiesOf(type);
}

void BindChain(py::module_& module)
{
    py::class_<Chain, ShapeObject> type(
        module, "b2ChainShape",
        "Connected edges: vertices_chain=[…] is open; vertices=[…] or vertices_loop=[…] closed.");
    KeywordInit<Chain>(type);
    const auto vertices = [](const Chain& s) {
        return TuplesOf(s.Get().m_vertices, s.Get().m_count);
    };
    const auto loop = [](Chain& s, py::handle value) { SetVertices(s, value, true); };
    type.def_property("vertices", vertices, loop,
                      "The vertices [m]. Setting them makes a closed loop.")
        .def_property("vertices_loop", vertices, loop,
                      "The vertices [m]. Setting them makes a closed loop.")
        .def_property(
            "vertices_chain", vertices,
            [](Chain& s, py::handle value) { SetVertices(s, value, false); },
            "The vertices [m]. Setting them makes an open chain.")
        .def_property_readonly(
            "vertexCount", [](const Chain& s) { return s.Get().m_count; },
            "Number of vertices; a loop stores its first one twice.")
        .def_property_readonly(
            "edges",
            [](const Chain& s) {
                py::list edges;
                for (int32 i = 0; i < s.Get().GetChildCount(); ++i)
                {
                    edges.append(ChildEdge(s, py::int_(i)));
                }
                return edges;
            },
            "The edges, as a list of b2EdgeShape.")
        .def_property(
            "prevVertex", [](const Chain& s) { return s.Get().m_prevVertex; },
            [](Chain& s, py::handle value) {
                const b2Vec2 vertex = From<b2Vec2>(value, "prevVertex");
                s.Change([&](b2ChainShape& chain) { chain.SetPrevVertex(vertex); });
            },
            "The vertex before the first [m].")
        .def_property(
            "nextVertex", [](const Chain& s) { return s.Get().m_nextVertex; },
            [](Chain& s, py::handle value) {
                const b2Vec2 vertex = From<b2Vec2>(value, "nextVertex");
                s.Change([&](b2ChainShape& chain) { chain.SetNextVertex(vertex); });
            },
            "The vertex after the last [m].")
        .def("getChildEdge", ChildEdge, py::arg("index"),
             "Returns an edge with the vertices of its neighbours.")
        .def("__iter__", [](py::handle s) { return py::iter(s.attr("vertices")); })
        .def("__len__", [](const Chain& s) { return s.Get().m_count; })
        .def("__repr__",
             [](py::handle s) {
                 return "b2ChainShape(vertices=" + std::string(py::repr(s.attr("vertices"))) + ")";
             })
        .def(py::pickle(
            [](const Chain& s) {
                const b2ChainShape& c = s.Get();
                return py::make_tuple(TuplesOf(c.m_vertices, c.m_count), c.m_prevVertex,
                                      c.m_nextVertex, c.m_hasPrevVertex, c.m_hasNextVertex,
                                      c.m_oneSided, c.m_radius);
            },
            [](const py::tuple& state) {
                auto chain = std::make_unique<Chain>();
                SetVertices(*chain, state[0], false);
                b2ChainShape& c = chain->shape;
                c.m_prevVertex = From<b2Vec2>(state[1], "");
                c.m_nextVertex = From<b2Vec2>(state[2], "");
                c.m_hasPrevVertex = From<bool>(state[3], "");
                c.m_hasNextVertex = From<bool>(state[4], "");
                c.m_oneSided = From<bool>(state[5], "");
                c.m_radius = From<float32>(state[6], "");
                return chain;
            }));
    type.attr("__bool__") =
        py::cpp_function([](const Chain&) { return true; }, py::is_method(type));
    type.attr("GetChildEdge") = type.attr("getChildEdge");
    CopiesOf(type);
}

} // namespace

ShapeObject& ShapeFrom(py::handle value, const char* name)
{
    if (!py::isinstance<ShapeObject>(value))
    {
        ThrowType(name, "a shape", value);
    }
    return value.cast<ShapeObject&>();
}

py::object ShapeOfFixture(const py::object& fixture, const b2Shape& shape)
{
    const auto copy = [&fixture](const auto& original) {
        auto object = std::make_unique<ShapeOf<std::remove_cvref_t<decltype(original)>>>();
        object->shape = original;
        object->fixture = py::weakref(fixture);
        return py::cast(std::move(object));
    };
    switch (shape.GetType())
    {
    case b2Shape::e_circle:
        return copy(static_cast<const b2CircleShape&>(shape));
    case b2Shape::e_edge:
        return copy(static_cast<const b2EdgeShape&>(shape));
    case b2Shape::e_polygon:
        return copy(static_cast<const b2PolygonShape&>(shape));
    default:
        return copy(static_cast<const b2ChainShape&>(shape));
    }
}

void BindShapes(py::module_& module)
{
    BindBase(module);
    BindCircle(module);
    BindEdge(module);
    BindPolygon(module);
    BindChain(module);
}

} // namespace boxreel::python
