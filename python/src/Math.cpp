// SPDX-License-Identifier: MIT
#include "Bind.h"
#include "Module.h"

#include <cstdio>

/// Vectors, matrices, rotations, transforms, sweeps and colours.
namespace boxreel::python
{
namespace
{

const py::object& NotImplemented()
{
    static const py::object* value =
        new py::object(py::reinterpret_borrow<py::object>(Py_NotImplemented));
    return *value;
}

std::string Text(const char* format, double a, double b, double c = 0.0, double d = 0.0)
{
    char text[160];
    std::snprintf(text, sizeof text, format, a, b, c, d);
    return text;
}

/// Converts an index of Python, which may be negative, to one of `count` items.
int32 Index(py::ssize_t index, int32 count)
{
    const py::ssize_t positive = index < 0 ? index + count : index;
    if (positive < 0 || positive >= count)
    {
        throw py::index_error("index " + std::to_string(index) + " is out of range for " +
                              std::to_string(count) + " numbers");
    }
    return static_cast<int32>(positive);
}

float32& At(b2Vec2& v, int32 i)
{
    return i == 0 ? v.x : v.y;
}
float32& At(b2Vec3& v, int32 i)
{
    return i == 0 ? v.x : i == 1 ? v.y : v.z;
}
float32& At(b2Color& c, int32 i)
{
    return i == 0 ? c.r : i == 1 ? c.g : i == 2 ? c.b : c.a;
}

template <class T>
inline constexpr int32 kCount = 2;
template <>
inline constexpr int32 kCount<b2Vec3> = 3;
template <>
inline constexpr int32 kCount<b2Color> = 3;

template <class T>
py::tuple TupleOf(T& value)
{
    py::tuple tuple(kCount<T>);
    for (int32 i = 0; i < kCount<T>; ++i)
    {
        tuple[static_cast<std::size_t>(i)] = static_cast<double>(At(value, i));
    }
    return tuple;
}

/// The value as a T, or nothing if it is neither one nor a sequence of numbers.
template <class T>
bool Try(py::handle value, T& result)
{
    try
    {
        result = From<T>(value, "");
        return true;
    }
    catch (const py::type_error&)
    {
        return false;
    }
}
template <>
bool Try<b2Vec2>(py::handle value, b2Vec2& result)
{
    if (!IsVec2(value))
    {
        return false;
    }
    result = From<b2Vec2>(value, "");
    return true;
}

template <class T>
T Scaled(T value, float32 factor)
{
    for (int32 i = 0; i < kCount<T>; ++i)
    {
        At(value, i) *= factor;
    }
    return value;
}

template <class T>
T Added(T a, T b, float32 sign)
{
    for (int32 i = 0; i < kCount<T>; ++i)
    {
        At(a, i) += sign * At(b, i);
    }
    return a;
}

float32 Inverse(py::handle divisor)
{
    const float32 number = From<float32>(divisor, "divisor");
    if (number == 0.0f)
    {
        PyErr_SetString(PyExc_ZeroDivisionError, "division of a vector by zero");
        throw py::error_already_set();
    }
    return 1.0f / number;
}

/// The common methods of vectors and colours: arithmetic, indices, iteration.
template <class T, class Class>
void Arithmetic(Class& type)
{
    using Self = T&;
    type.def("__len__", [](Self) { return kCount<T>; })
        .def(
            "__getitem__", [](Self self, py::ssize_t i) { return At(self, Index(i, kCount<T>)); },
            py::arg("index"))
        .def(
            "__setitem__",
            [](Self self, py::ssize_t i, py::handle value) {
                At(self, Index(i, kCount<T>)) = From<float32>(value, "value");
            },
            py::arg("index"), py::arg("value"))
        .def("__iter__", [](Self self) { return py::iter(TupleOf(self)); })
        .def("__eq__",
             [](Self self, py::handle other) -> py::object {
                 T value;
                 if (!Try<T>(other, value))
                 {
                     return NotImplemented();
                 }
                 bool equal = true;
                 for (int32 i = 0; i < kCount<T>; ++i)
                 {
                     equal = equal && At(self, i) == At(value, i);
                 }
                 return py::bool_(equal);
             })
        .def("__neg__", [](Self self) { return Scaled(self, -1.0f); })
        .def("__pos__", [](Self self) { return self; });
    type.attr("__hash__") = py::none(); // it can be changed
    const auto sum = [&type](const char* name, float32 first, float32 second) {
        type.def(name, [first, second](Self self, py::handle other) -> py::object {
            T value;
            return Try<T>(other, value) ? py::cast(Added(Scaled(self, first), value, second))
                                        : NotImplemented();
        });
    };
    sum("__add__", 1.0f, 1.0f);
    sum("__radd__", 1.0f, 1.0f);
    sum("__sub__", 1.0f, -1.0f);
    sum("__rsub__", -1.0f, 1.0f);
    const auto times = [](Self self, py::handle factor) -> py::object {
        return IsNumber(factor) ? py::cast(Scaled(self, From<float32>(factor, "factor")))
                                : NotImplemented();
    };
    const auto over = [](Self self, py::handle divisor) -> py::object {
        return IsNumber(divisor) ? py::cast(Scaled(self, Inverse(divisor))) : NotImplemented();
    };
    type.def("__mul__", times).def("__rmul__", times).def("__truediv__", over).def("__div__", over);
    // In place, so that other names of the same vector see the change.
    type.def("__iadd__", [](py::object self, py::handle other) {
        T& value = self.cast<T&>();
        value = Added(value, From<T>(other, "other"), 1.0f);
        return self;
    });
    type.def("__isub__", [](py::object self, py::handle other) {
        T& value = self.cast<T&>();
        value = Added(value, From<T>(other, "other"), -1.0f);
        return self;
    });
    type.def("__imul__", [](py::object self, py::handle factor) {
        T& value = self.cast<T&>();
        value = Scaled(value, From<float32>(factor, "factor"));
        return self;
    });
    type.def("__itruediv__", [](py::object self, py::handle divisor) {
        T& value = self.cast<T&>();
        value = Scaled(value, Inverse(divisor));
        return self;
    });
}

void BindVec2(py::module_& module)
{
    py::class_<b2Vec2> type(module, "b2Vec2", "A vector or point with the components x and y.");
    type.def(py::init<>());
    type.def(py::init([](py::handle x, py::handle y) {
                 return b2Vec2(From<float32>(x, "x"), From<float32>(y, "y"));
             }),
             py::arg("x"), py::arg("y"));
    type.def(py::init([](py::handle other) { return From<b2Vec2>(other, "b2Vec2"); }),
             py::arg("other"));
    type.def(py::init([](const py::kwargs& keywords) {
        b2Vec2 value;
        SetKeywords(py::cast(&value, py::return_value_policy::reference), keywords);
        return value;
    }));
    Member<&b2Vec2::x>(type, "x", "First component.");
    Member<&b2Vec2::y>(type, "y", "Second component.");
    Arithmetic<b2Vec2>(type);
    Copies(
        type, [](b2Vec2 v) { return TupleOf(v); },
        [](const py::tuple& state) { return From<b2Vec2>(state, "state"); });
    type.def("__repr__", [](const b2Vec2& v) { return Text("b2Vec2(%g,%g)", v.x, v.y); })
        .def("__abs__", [](const b2Vec2& v) { return b2Abs(v); })
        .def_property(
            "tuple", [](b2Vec2& v) { return TupleOf(v); },
            [](b2Vec2& v, py::handle value) { v = From<b2Vec2>(value, "tuple"); },
            "The components as a tuple.")
        .def_property(
            "length", &b2Vec2::Length,
            [](b2Vec2& v, py::handle value) {
                const float32 length = From<float32>(value, "length");
                v.Normalize();
                v *= length;
            },
            "Length, in the unit of the components.")
        .def_property_readonly("lengthSquared", &b2Vec2::LengthSquared, "Squared length.")
        .def_property_readonly("valid", &b2Vec2::IsValid, "True if both components are finite.")
        .def_property_readonly("skew", &b2Vec2::Skew, "Rotated by 90 degrees counter-clockwise.")
        .def(
            "dot",
            [](const b2Vec2& v, py::handle other) {
                return b2Dot(v, From<b2Vec2>(other, "other"));
            },
            py::arg("other"), "Returns the dot product.")
        .def(
            "cross",
            [](const b2Vec2& v, py::handle other) -> py::object {
                return IsNumber(other) ? py::cast(b2Cross(v, From<float32>(other, "other")))
                                       : py::cast(b2Cross(v, From<b2Vec2>(other, "other")));
            },
            py::arg("other"),
            "Returns the cross product with a vector (a number) or a number (a vector).")
        .def("Normalize", &b2Vec2::Normalize,
             "Makes this a unit vector and returns the former length.")
        .def("Length", &b2Vec2::Length, "Returns the length.")
        .def("LengthSquared", &b2Vec2::LengthSquared, "Returns the squared length.")
        .def("IsValid", &b2Vec2::IsValid, "True if both components are finite.")
        .def("Skew", &b2Vec2::Skew, "Returns the vector rotated by 90 degrees counter-clockwise.")
        .def(
            "Set",
            [](b2Vec2& v, py::handle x, py::handle y) {
                v.Set(From<float32>(x, "x"), From<float32>(y, "y"));
            },
            py::arg("x"), py::arg("y"), "Sets both components.")
        .def("SetZero", &b2Vec2::SetZero, "Sets both components to 0.");
    py::implicitly_convertible<py::tuple, b2Vec2>();
}

void BindVec3(py::module_& module)
{
    py::class_<b2Vec3> type(module, "b2Vec3", "A vector with the components x, y and z.");
    type.def(py::init<>());
    type.def(py::init([](py::handle x, py::handle y, py::handle z) {
                 return b2Vec3(From<float32>(x, "x"), From<float32>(y, "y"), From<float32>(z, "z"));
             }),
             py::arg("x"), py::arg("y"), py::arg("z"));
    type.def(py::init([](py::handle other) { return From<b2Vec3>(other, "b2Vec3"); }),
             py::arg("other"));
    type.def(py::init([](const py::kwargs& keywords) {
        b2Vec3 value;
        SetKeywords(py::cast(&value, py::return_value_policy::reference), keywords);
        return value;
    }));
    Member<&b2Vec3::x>(type, "x", "First component.");
    Member<&b2Vec3::y>(type, "y", "Second component.");
    Member<&b2Vec3::z>(type, "z", "Third component.");
    Arithmetic<b2Vec3>(type);
    Copies(
        type, [](b2Vec3 v) { return TupleOf(v); },
        [](const py::tuple& state) { return From<b2Vec3>(state, "state"); });
    type.def("__repr__", [](const b2Vec3& v) { return Text("b2Vec3(%g,%g,%g)", v.x, v.y, v.z); })
        .def_property(
            "tuple", [](b2Vec3& v) { return TupleOf(v); },
            [](b2Vec3& v, py::handle value) { v = From<b2Vec3>(value, "tuple"); },
            "The components as a tuple.")
        .def_property_readonly(
            "length", [](const b2Vec3& v) { return b2Sqrt(b2Dot(v, v)); }, "Length.")
        .def_property_readonly(
            "lengthSquared", [](const b2Vec3& v) { return b2Dot(v, v); }, "Squared length.")
        .def_property_readonly(
            "valid",
            [](const b2Vec3& v) { return b2IsValid(v.x) && b2IsValid(v.y) && b2IsValid(v.z); },
            "True if all components are finite.")
        .def(
            "dot",
            [](const b2Vec3& v, py::handle other) {
                return b2Dot(v, From<b2Vec3>(other, "other"));
            },
            py::arg("other"), "Returns the dot product.")
        .def(
            "cross",
            [](const b2Vec3& v, py::handle other) {
                return b2Cross(v, From<b2Vec3>(other, "other"));
            },
            py::arg("other"), "Returns the cross product.")
        .def(
            "Normalize",
            [](b2Vec3& v) {
                const float32 length = b2Sqrt(b2Dot(v, v));
                if (length >= b2_epsilon)
                {
                    v *= 1.0f / length;
                }
                return length;
            },
            "Makes this a unit vector and returns the former length.")
        .def(
            "Set",
            [](b2Vec3& v, py::handle x, py::handle y, py::handle z) {
                v.Set(From<float32>(x, "x"), From<float32>(y, "y"), From<float32>(z, "z"));
            },
            py::arg("x"), py::arg("y"), py::arg("z"), "Sets all components.")
        .def("SetZero", &b2Vec3::SetZero, "Sets all components to 0.");
}

b2Mat22 Sum(const b2Mat22& a, const b2Mat22& b, float32 sign)
{
    return {a.ex + sign * b.ex, a.ey + sign * b.ey};
}
b2Mat33 Sum(const b2Mat33& a, const b2Mat33& b, float32 sign)
{
    return {a.ex + sign * b.ex, a.ey + sign * b.ey, a.ez + sign * b.ez};
}

/// Adds sums and differences. Those in place change the matrix itself, as other names see it.
template <class T>
void Sums(py::class_<T>& type)
{
    const auto sum = [&type](const char* name, const char* inPlace, float32 sign) {
        type.def(
            name, [sign](const T& a, const T& b) { return Sum(a, b, sign); }, py::is_operator());
        type.def(
            inPlace,
            [sign](py::object self, const T& b) {
                T& a = self.cast<T&>();
                a = Sum(a, b, sign);
                return self;
            },
            py::is_operator());
    };
    sum("__add__", "__iadd__", 1.0f);
    sum("__sub__", "__isub__", -1.0f);
}

void BindMatrices(py::module_& module)
{
    py::class_<b2Mat22> m22(module, "b2Mat22", "A 2-by-2 matrix of the columns ex and ey.");
    Member<&b2Mat22::ex>(m22, "ex", "First column.");
    Member<&b2Mat22::ey>(m22, "ey", "Second column.");
    Member<&b2Mat22::ex>(m22, "col1", "First column, as ex.");
    Member<&b2Mat22::ey>(m22, "col2", "Second column, as ey.");
    m22.def_property_readonly("inverse", &b2Mat22::GetInverse, "The inverse; zero if singular.")
        .def_property(
            "angle", [](const b2Mat22& m) { return b2Atan2(m.ex.y, m.ex.x); },
            [](b2Mat22& m, py::handle angle) {
                const b2Rot q(From<float32>(angle, "angle"));
                m = b2Mat22(q.c, -q.s, q.s, q.c);
            },
            "Angle of a rotation matrix [rad].");
    m22.def(py::init([](py::handle ex, py::handle ey) {
                return b2Mat22(From<b2Vec2>(ex, "ex"), From<b2Vec2>(ey, "ey"));
            }),
            py::arg("ex"), py::arg("ey"));
    m22.def(py::init([](py::handle a11, py::handle a12, py::handle a21, py::handle a22) {
                return b2Mat22(From<float32>(a11, "a11"), From<float32>(a12, "a12"),
                               From<float32>(a21, "a21"), From<float32>(a22, "a22"));
            }),
            py::arg("a11"), py::arg("a12"), py::arg("a21"), py::arg("a22"));
    m22.def(py::init([] { return b2Mat22(1.0f, 0.0f, 0.0f, 1.0f); })); // as in the 2.3 module
    KeywordInit<b2Mat22>(m22);
    m22.def("__mul__",
            [](const b2Mat22& m, py::handle other) -> py::object {
                if (py::isinstance<b2Mat22>(other))
                {
                    return py::cast(b2Mul(m, other.cast<b2Mat22&>()));
                }
                return IsVec2(other) ? py::cast(b2Mul(m, From<b2Vec2>(other, "")))
                                     : NotImplemented();
            })
        .def("__abs__", [](const b2Mat22& m) { return b2Abs(m); })
        .def(
            "__eq__",
            [](const b2Mat22& a, const b2Mat22& b) { return a.ex == b.ex && a.ey == b.ey; },
            py::is_operator())
        .def("__repr__",
             [](const b2Mat22& m) {
                 return Text("b2Mat22(ex=b2Vec2(%g,%g), ey=b2Vec2(%g,%g))", m.ex.x, m.ex.y, m.ey.x,
                             m.ey.y);
             })
        .def("GetInverse", &b2Mat22::GetInverse, "Returns the inverse; zero if singular.")
        .def(
            "Solve", [](const b2Mat22& m, py::handle b) { return m.Solve(From<b2Vec2>(b, "b")); },
            py::arg("b"), "Returns x with A x = b.")
        .def(
            "Set",
            [](b2Mat22& m, py::handle ex, py::handle ey) {
                m.Set(From<b2Vec2>(ex, "ex"), From<b2Vec2>(ey, "ey"));
            },
            py::arg("ex"), py::arg("ey"), "Sets both columns.")
        .def("SetIdentity", &b2Mat22::SetIdentity, "Sets the identity.")
        .def("SetZero", &b2Mat22::SetZero, "Sets all numbers to 0.");
    Sums(m22);
    Copies(
        m22, [](const b2Mat22& m) { return py::make_tuple(m.ex, m.ey); },
        [](const py::tuple& s) {
            return b2Mat22(From<b2Vec2>(s[0], "ex"), From<b2Vec2>(s[1], "ey"));
        });

    py::class_<b2Mat33> m33(module, "b2Mat33", "A 3-by-3 matrix of the columns ex, ey and ez.");
    Member<&b2Mat33::ex>(m33, "ex", "First column.");
    Member<&b2Mat33::ey>(m33, "ey", "Second column.");
    Member<&b2Mat33::ez>(m33, "ez", "Third column.");
    Member<&b2Mat33::ex>(m33, "col1", "First column, as ex.");
    Member<&b2Mat33::ey>(m33, "col2", "Second column, as ey.");
    Member<&b2Mat33::ez>(m33, "col3", "Third column, as ez.");
    m33.def(py::init([](py::handle ex, py::handle ey, py::handle ez) {
                return b2Mat33(From<b2Vec3>(ex, "ex"), From<b2Vec3>(ey, "ey"),
                               From<b2Vec3>(ez, "ez"));
            }),
            py::arg("ex"), py::arg("ey"), py::arg("ez"));
    m33.def(py::init([] {
        return b2Mat33({1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f});
    }));
    KeywordInit<b2Mat33>(m33);
    m33.def("__mul__",
            [](const b2Mat33& m, py::handle v) { return b2Mul(m, From<b2Vec3>(v, "vector")); })
        .def(
            "GetInverse22",
            [](const b2Mat33& m) {
                b2Mat33 inverse;
                m.GetInverse22(&inverse);
                return inverse;
            },
            "Returns the inverse of the upper left 2x2 part; zero if singular.")
        .def(
            "GetSymInverse33",
            [](const b2Mat33& m) {
                b2Mat33 inverse;
                m.GetSymInverse33(&inverse);
                return inverse;
            },
            "Returns the inverse of a symmetric matrix; zero if singular.")
        .def(
            "Solve33",
            [](const b2Mat33& m, py::handle b) { return m.Solve33(From<b2Vec3>(b, "b")); },
            py::arg("b"), "Returns x with A x = b.")
        .def(
            "Solve22",
            [](const b2Mat33& m, py::handle b) { return m.Solve22(From<b2Vec2>(b, "b")); },
            py::arg("b"), "Returns x with A x = b for the upper left block.")
        .def("SetZero", &b2Mat33::SetZero, "Sets all numbers to 0.");
    Sums(m33);
    Copies(
        m33, [](const b2Mat33& m) { return py::make_tuple(m.ex, m.ey, m.ez); },
        [](const py::tuple& s) {
            return b2Mat33(From<b2Vec3>(s[0], "ex"), From<b2Vec3>(s[1], "ey"),
                           From<b2Vec3>(s[2], "ez"));
        });
}

py::object TimesRot(const b2Rot& q, py::handle other)
{
    if (py::isinstance<b2Rot>(other))
    {
        return py::cast(b2Mul(q, other.cast<b2Rot&>()));
    }
    return IsVec2(other) ? py::cast(b2Mul(q, From<b2Vec2>(other, ""))) : NotImplemented();
}

py::object TimesTransform(const b2Transform& xf, py::handle other)
{
    if (py::isinstance<b2Transform>(other))
    {
        return py::cast(b2Mul(xf, other.cast<b2Transform&>()));
    }
    return IsVec2(other) ? py::cast(b2Mul(xf, From<b2Vec2>(other, ""))) : NotImplemented();
}

void BindTransforms(py::module_& module)
{
    py::class_<b2Rot> rot(module, "b2Rot", "A rotation, as the sine and cosine of its angle.");
    rot.def(py::init([](py::handle angle) { return b2Rot(From<float32>(angle, "angle")); }),
            py::arg("angle"));
    KeywordInit<b2Rot>(rot);
    Member<&b2Rot::s>(rot, "s", "Sine of the angle.");
    Member<&b2Rot::c>(rot, "c", "Cosine of the angle.");
    rot.def_property(
           "angle", &b2Rot::GetAngle,
           [](b2Rot& q, py::handle angle) { q.Set(From<float32>(angle, "angle")); }, "Angle [rad].")
        .def_property_readonly("x_axis", &b2Rot::GetXAxis, "The rotated x axis.")
        .def_property_readonly("y_axis", &b2Rot::GetYAxis, "The rotated y axis.")
        .def("GetAngle", &b2Rot::GetAngle, "Returns the angle [rad].")
        .def("GetXAxis", &b2Rot::GetXAxis, "Returns the rotated x axis.")
        .def("GetYAxis", &b2Rot::GetYAxis, "Returns the rotated y axis.")
        .def(
            "Set", [](b2Rot& q, py::handle angle) { q.Set(From<float32>(angle, "angle")); },
            py::arg("angle"), "Sets the angle [rad].")
        .def("SetIdentity", &b2Rot::SetIdentity, "Sets the angle to 0.")
        .def("__mul__", TimesRot)
        .def("__repr__", [](const b2Rot& q) { return Text("b2Rot(angle=%g)", q.GetAngle(), 0.0); });
    Copies(
        rot, [](const b2Rot& q) { return py::make_tuple(q.s, q.c); },
        [](const py::tuple& s) {
            b2Rot q;
            q.s = From<float32>(s[0], "s");
            q.c = From<float32>(s[1], "c");
            return q;
        });

    py::class_<b2Transform> xf(module, "b2Transform",
                               "A rotation, then a translation: the pose of a frame.");
    xf.def(py::init([](py::handle position, const b2Rot& rotation) {
               return b2Transform(From<b2Vec2>(position, "position"), rotation);
           }),
           py::arg("position"), py::arg("R"));
    KeywordInit<b2Transform>(xf);
    Member<&b2Transform::p>(xf, "position", "Origin of the frame [m].");
    Member<&b2Transform::p>(xf, "p", "Origin of the frame [m].");
    Member<&b2Transform::q>(xf, "R", "The rotation.");
    Member<&b2Transform::q>(xf, "q", "The rotation.");
    xf.def_property(
          "angle", [](const b2Transform& t) { return t.q.GetAngle(); },
          [](b2Transform& t, py::handle angle) { t.q.Set(From<float32>(angle, "angle")); },
          "Angle of the rotation [rad].")
        .def(
            "Set",
            [](b2Transform& t, py::handle position, py::handle angle) {
                t.Set(From<b2Vec2>(position, "position"), From<float32>(angle, "angle"));
            },
            py::arg("position"), py::arg("angle"), "Sets the position [m] and the angle [rad].")
        .def("SetIdentity", &b2Transform::SetIdentity, "Sets the identity.")
        .def("__mul__", TimesTransform)
        .def("__repr__", [](const b2Transform& t) {
            return Text("b2Transform(position=b2Vec2(%g,%g), angle=%g)", t.p.x, t.p.y,
                        t.q.GetAngle());
        });
    Copies(
        xf, [](const b2Transform& t) { return py::make_tuple(t.p, t.q.s, t.q.c); },
        [](const py::tuple& s) {
            b2Transform t;
            t.p = From<b2Vec2>(s[0], "position");
            t.q.s = From<float32>(s[1], "s");
            t.q.c = From<float32>(s[2], "c");
            return t;
        });

    py::class_<b2Sweep> sweep(module, "b2Sweep", "The motion of a body during a step.");
    KeywordInit<b2Sweep>(sweep);
    Member<&b2Sweep::localCenter>(sweep, "localCenter", "Centre of mass in the body's frame [m].");
    Member<&b2Sweep::c0>(sweep, "c0", "Centre of mass at alpha0 [m].");
    Member<&b2Sweep::c>(sweep, "c", "Centre of mass at the end [m].");
    Member<&b2Sweep::a0>(sweep, "a0", "Angle at alpha0 [rad].");
    Member<&b2Sweep::a>(sweep, "a", "Angle at the end [rad].");
    Member<&b2Sweep::alpha0>(sweep, "alpha0", "Fraction of the step before the start, 0 to 1.");
    sweep
        .def(
            "GetTransform",
            [](const b2Sweep& s, py::handle beta) {
                b2Transform t;
                s.GetTransform(&t, From<float32>(beta, "beta"));
                return t;
            },
            py::arg("beta"), "Returns the transform at a fraction of the step, 0 to 1.")
        .def(
            "GetTransform",
            [](const b2Sweep& s, b2Transform& result, py::handle beta) {
                s.GetTransform(&result, From<float32>(beta, "beta"));
            },
            py::arg("xf"), py::arg("beta"), "Sets xf to the transform at a fraction of the step.")
        .def(
            "Advance",
            [](b2Sweep& s, py::handle alpha) {
                if (s.alpha0 >= 1.0f)
                {
                    ThrowMisuse("b2Sweep.Advance: alpha0 must be below 1");
                }
                s.Advance(From<float32>(alpha, "alpha"));
            },
            py::arg("alpha"), "Advances the start to a fraction of the step.")
        .def("Normalize", &b2Sweep::Normalize, "Removes whole turns from both angles.")
        .def("__repr__", [](const b2Sweep& s) {
            return Text("b2Sweep(c0=b2Vec2(%g,%g), c=b2Vec2(%g,%g)", s.c0.x, s.c0.y, s.c.x, s.c.y) +
                   Text(", a0=%g, a=%g)", s.a0, s.a);
        });
    Copies(
        sweep,
        [](const b2Sweep& s) {
            return py::make_tuple(s.localCenter, s.c0, s.c, s.a0, s.a, s.alpha0);
        },
        [](const py::tuple& state) {
            b2Sweep s;
            s.localCenter = From<b2Vec2>(state[0], "localCenter");
            s.c0 = From<b2Vec2>(state[1], "c0");
            s.c = From<b2Vec2>(state[2], "c");
            s.a0 = From<float32>(state[3], "a0");
            s.a = From<float32>(state[4], "a");
            s.alpha0 = From<float32>(state[5], "alpha0");
            return s;
        });
}

void BindColor(py::module_& module)
{
    py::class_<b2Color> type(module, "b2Color", "A colour. Channels run from 0 to 1.");
    type.def(py::init<>());
    type.def(py::init([](py::handle r, py::handle g, py::handle b, py::handle a) {
                 return b2Color(From<float32>(r, "r"), From<float32>(g, "g"), From<float32>(b, "b"),
                                From<float32>(a, "a"));
             }),
             py::arg("r"), py::arg("g"), py::arg("b"), py::arg("a") = 1.0);
    type.def(py::init([](py::handle other) { return From<b2Color>(other, "b2Color"); }),
             py::arg("other"));
    KeywordInit<b2Color>(type);
    Member<&b2Color::r>(type, "r", "Red, 0 to 1.");
    Member<&b2Color::g>(type, "g", "Green, 0 to 1.");
    Member<&b2Color::b>(type, "b", "Blue, 0 to 1.");
    Member<&b2Color::a>(type, "a", "Opacity, 0 to 1.");
    Arithmetic<b2Color>(type);
    Copies(
        type, [](const b2Color& c) { return py::make_tuple(c.r, c.g, c.b, c.a); },
        [](const py::tuple& state) { return From<b2Color>(state, "state"); });
    type.def_property(
            "list", [](b2Color& c) { return py::list(TupleOf(c)); },
            [](b2Color& c, py::handle value) { c = From<b2Color>(value, "list"); },
            "Red, green and blue as a list.")
        .def_property_readonly(
            "bytes",
            [](const b2Color& c) {
                py::list bytes;
                for (const float32 channel : {c.r, c.g, c.b})
                {
                    bytes.append(int(255 * channel));
                }
                return bytes;
            },
            "Red, green and blue from 0 to 255, as a list.")
        .def(
            "Set",
            [](b2Color& c, py::handle r, py::handle g, py::handle b, py::handle a) {
                c.Set(From<float32>(r, "r"), From<float32>(g, "g"), From<float32>(b, "b"),
                      From<float32>(a, "a"));
            },
            py::arg("r"), py::arg("g"), py::arg("b"), py::arg("a") = 1.0,
            "Sets the channels, 0 to 1.")
        .def("__repr__", [](const b2Color& c) { return Text("b2Color(%g,%g,%g)", c.r, c.g, c.b); });
}

} // namespace

void BindMath(py::module_& module)
{
    BindVec2(module);
    BindVec3(module);
    BindMatrices(module);
    BindTransforms(module);
    BindColor(module);
}

} // namespace boxreel::python
