// SPDX-License-Identifier: MIT
#include "Bind.h"
#include "Module.h"

/// The functions of vectors, matrices, rotations, transforms and numbers.
namespace boxreel::python
{
namespace
{

py::object Product(py::handle a, py::handle b)
{
    return py::reinterpret_steal<py::object>(PyNumber_Multiply(a.ptr(), b.ptr()));
}

/// Returns inverse(a) b for transforms and rotations, and transpose(a) b for matrices.
py::object InverseProduct(py::handle a, py::handle b)
{
    if (py::isinstance<b2Transform>(a))
    {
        const b2Transform& xf = a.cast<b2Transform&>();
        return py::isinstance<b2Transform>(b) ? py::cast(b2MulT(xf, b.cast<b2Transform&>()))
                                              : py::cast(b2MulT(xf, From<b2Vec2>(b, "b")));
    }
    if (py::isinstance<b2Rot>(a))
    {
        const b2Rot& q = a.cast<b2Rot&>();
        return py::isinstance<b2Rot>(b) ? py::cast(b2MulT(q, b.cast<b2Rot&>()))
                                        : py::cast(b2MulT(q, From<b2Vec2>(b, "b")));
    }
    if (!py::isinstance<b2Mat22>(a))
    {
        ThrowType("a", "a b2Transform, b2Rot or b2Mat22", a);
    }
    const b2Mat22& m = a.cast<b2Mat22&>();
    return py::isinstance<b2Mat22>(b) ? py::cast(b2MulT(m, b.cast<b2Mat22&>()))
                                      : py::cast(b2MulT(m, From<b2Vec2>(b, "b")));
}

py::object Cross(py::handle a, py::handle b)
{
    if (py::isinstance<b2Vec3>(a))
    {
        return py::cast(b2Cross(a.cast<b2Vec3&>(), From<b2Vec3>(b, "b")));
    }
    if (IsNumber(a))
    {
        return py::cast(b2Cross(From<float32>(a, "a"), From<b2Vec2>(b, "b")));
    }
    const b2Vec2 v = From<b2Vec2>(a, "a");
    return IsNumber(b) ? py::cast(b2Cross(v, From<float32>(b, "b")))
                       : py::cast(b2Cross(v, From<b2Vec2>(b, "b")));
}

} // namespace

void BindMathFunctions(py::module_& module)
{
    module.def("b2Mul", Product, py::arg("a"), py::arg("b"),
               "Returns a b, for transforms, rotations and matrices.");
    module.def("b2MulT", InverseProduct, py::arg("a"), py::arg("b"),
               "Returns the inverse of a times b.");
    module.def("b2Cross", Cross, py::arg("a"), py::arg("b"),
               "Returns the cross product of vectors and numbers.");
    module.def(
        "b2Dot",
        [](py::handle a, py::handle b) {
            return py::isinstance<b2Vec3>(a) ? b2Dot(a.cast<b2Vec3&>(), From<b2Vec3>(b, "b"))
                                             : b2Dot(From<b2Vec2>(a, "a"), From<b2Vec2>(b, "b"));
        },
        py::arg("a"), py::arg("b"), "Returns the dot product.");
    module.def(
        "b2DistanceSquared",
        [](py::handle a, py::handle b) {
            return b2DistanceSquared(From<b2Vec2>(a, "a"), From<b2Vec2>(b, "b"));
        },
        py::arg("a"), py::arg("b"), "Returns the squared distance of two points [m^2].");
    module.def("_point_distance", [](py::handle a, py::handle b) {
        return b2Distance(From<b2Vec2>(a, "a"), From<b2Vec2>(b, "b"));
    });
    module.def(
        "b2Abs",
        [](py::handle a) { return py::reinterpret_steal<py::object>(PyNumber_Absolute(a.ptr())); },
        py::arg("a"), "Returns the absolute value of a number, or of each component.");
    module.def(
        "b2Mul22", [](const b2Mat33& m, py::handle v) { return b2Mul22(m, From<b2Vec2>(v, "v")); },
        py::arg("A"), py::arg("v"), "Returns the upper left block of A times v.");
    module.def(
        "b2IsValid", [](double x) { return b2IsValid(static_cast<float32>(x)); }, py::arg("x"),
        "True if the number is finite.");
    module.def(
        "b2Sqrt", [](double x) { return b2Sqrt(static_cast<float32>(x)); }, py::arg("x"),
        "Returns the square root.");
    module.def(
        "b2InvSqrt", [](double x) { return b2InvSqrt(static_cast<float32>(x)); }, py::arg("x"),
        "Returns one over the square root.");
    module.def(
        "b2Atan2",
        [](double y, double x) {
            return b2Atan2(static_cast<float32>(y), static_cast<float32>(x));
        },
        py::arg("y"), py::arg("x"), "Returns the angle of the vector (x, y) [rad].");
    module.def("b2NextPowerOfTwo", &b2NextPowerOfTwo, py::arg("x"),
               "Returns the smallest power of two above x.");
    module.def("b2IsPowerOfTwo", &b2IsPowerOfTwo, py::arg("x"), "True if x is a power of two.");
    const auto mix = [&module](const char* name, float32 (*function)(float32, float32),
                               const char* doc) {
        module.def(name, function, py::arg("a"), py::arg("b"), doc);
    };
    mix("b2MixFriction", &b2MixFriction, "Returns the friction of a contact of two fixtures.");
    mix("b2MixRestitution", &b2MixRestitution,
        "Returns the restitution of a contact of two fixtures.");
}

} // namespace boxreel::python
