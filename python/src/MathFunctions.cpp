// SPDX-License-Identifier: MIT
#include "Bind.h"
#include "Module.h"

/// The functions of vectors, matrices, rotations, transforms and numbers.
namespace boxreel::python
{
namespace
{

/// Returns a new reference, or passes on the exception that was set instead of it.
py::object Owned(PyObject* result)
{
    if (result == nullptr)
    {
        throw py::error_already_set();
    }
    return py::reinterpret_steal<py::object>(result);
}

py::object Product(py::handle a, py::handle b)
{
    if (!py::isinstance<b2Transform>(a) && !py::isinstance<b2Rot>(a) &&
        !py::isinstance<b2Mat22>(a) && !py::isinstance<b2Mat33>(a))
    {
        ThrowType("a", "a b2Transform, b2Rot, b2Mat22 or b2Mat33", a);
    }
    return Owned(PyNumber_Multiply(a.ptr(), b.ptr()));
}

py::object Absolute(py::handle a)
{
    const bool isVector = !IsNumber(a) && !py::isinstance<b2Mat22>(a);
    return isVector ? py::cast(b2Abs(From<b2Vec2>(a, "a"))) : Owned(PyNumber_Absolute(a.ptr()));
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
    if (py::isinstance<b2Vec3>(a) || py::isinstance<b2Vec3>(b))
    {
        return py::cast(b2Cross(From<b2Vec3>(a, "a"), From<b2Vec3>(b, "b")));
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
            return py::isinstance<b2Vec3>(a) || py::isinstance<b2Vec3>(b)
                       ? b2Dot(From<b2Vec3>(a, "a"), From<b2Vec3>(b, "b"))
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
    module.def("b2Abs", Absolute, py::arg("a"),
               "Returns the absolute value of a number, or of each component.");
    module.def(
        "b2Mul22", [](const b2Mat33& m, py::handle v) { return b2Mul22(m, From<b2Vec2>(v, "v")); },
        py::arg("A"), py::arg("v"), "Returns the upper left block of A times v.");
    const auto ofNumber = [&module](const char* name, auto function, const char* doc) {
        module.def(
            name, [function](py::handle x) { return function(From<float32>(x, "x")); },
            py::arg("x"), doc);
    };
    ofNumber(
        "b2IsValid", [](float32 x) { return b2IsValid(x); }, "True if the number is finite.");
    ofNumber(
        "b2Sqrt", [](float32 x) { return b2Sqrt(x); }, "Returns the square root.");
    ofNumber(
        "b2InvSqrt", [](float32 x) { return b2InvSqrt(x); }, "Returns one over the square root.");
    const auto ofTwo = [&module](const char* name, const char* first, const char* second,
                                 float32 (*function)(float32, float32), const char* doc) {
        module.def(
            name,
            [=](py::handle a, py::handle b) {
                return function(From<float32>(a, first), From<float32>(b, second));
            },
            py::arg(first), py::arg(second), doc);
    };
    ofTwo(
        "b2Atan2", "y", "x", [](float32 y, float32 x) { return b2Atan2(y, x); },
        "Returns the angle of the vector (x, y) [rad].");
    ofTwo("b2MixFriction", "friction1", "friction2", &b2MixFriction,
          "Returns the friction of a contact of two fixtures.");
    ofTwo("b2MixRestitution", "restitution1", "restitution2", &b2MixRestitution,
          "Returns the restitution of a contact of two fixtures.");
    module.def(
        "b2NextPowerOfTwo", [](py::handle x) { return b2NextPowerOfTwo(From<uint32>(x, "x")); },
        py::arg("x"), "Returns the smallest power of two above x.");
    module.def(
        "b2IsPowerOfTwo", [](py::handle x) { return b2IsPowerOfTwo(From<uint32>(x, "x")); },
        py::arg("x"), "True if x is a power of two.");
}

} // namespace boxreel::python
