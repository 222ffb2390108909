// SPDX-License-Identifier: MIT
#pragma once

#include "Convert.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <type_traits>

/// Objects of the engine as objects of Python.
///
/// A body, fixture or joint has one Python object, its handle, for its whole life. The engine's
/// user data refer to it, and the engine's object owns a reference, so that attributes that a
/// program adds stay. A handle outlives its object and then refuses every use. A world owns its
/// objects, and no handle keeps a world alive: a world without references is destroyed at once, not
/// by the garbage collector.
namespace boxreel::python
{

struct WorldObject;

/// The common members of all handles.
struct HandleBase
{
    WorldObject* world = nullptr; ///< null once the object is destroyed
    PyObject* self = nullptr;     ///< the Python object, not owned
    std::uint64_t number = 0;     ///< in the order of creation in the world; snapshots refer to it
    int kind = 0;                 ///< see KindOf
    py::object userData = py::none();
};

/// Throws b2Error for a handle whose object is destroyed, or whose world another thread steps.
void RequireUsable(const HandleBase& handle, const char* kind);

template <class T>
inline constexpr const char* kKind = "object";
template <>
inline constexpr const char* kKind<b2Body> = "body";
template <>
inline constexpr const char* kKind<b2Fixture> = "fixture";
template <>
inline constexpr const char* kKind<b2Joint> = "joint";

/// The handle of a body, fixture or joint.
template <class T>
struct Handle : HandleBase
{
    using Object = T;
    T* object = nullptr;

    T& Get() const
    {
        RequireUsable(*this, kKind<T>);
        return *object;
    }
};

using BodyHandle = Handle<b2Body>;
using FixtureHandle = Handle<b2Fixture>;
using JointHandle = Handle<b2Joint>;

/// The handle of one class of joints, so that each has its class in Python.
template <class T>
struct JointHandleOf : JointHandle
{
    using Object = T;
    T& Get() const { return static_cast<T&>(JointHandle::Get()); }
};

/// Returns a number for the class of an object's handle.
inline int KindOf(const b2Body&)
{
    return 1;
}
inline int KindOf(const b2Fixture&)
{
    return 2;
}
inline int KindOf(const b2Joint& joint)
{
    return 16 + joint.GetType();
}

/// Returns the handle of an object, which is created if it has none.
py::object Wrap(WorldObject& world, b2Body* body);
py::object Wrap(WorldObject& world, b2Fixture* fixture);
py::object Wrap(WorldObject& world, b2Joint* joint);
/// Creates a handle of the class of the joint; Joints.cpp.
JointHandle* NewJointHandle(b2JointType type, py::object& object);

template <>
b2Body* From<b2Body*>(py::handle value, const char* name);
template <>
b2Joint* From<b2Joint*>(py::handle value, const char* name);

/// Lets the garbage collector see the user data of a handle, and the handles and callbacks of a
/// world.
py::custom_type_setup HandleTraversal();
py::custom_type_setup WorldTraversal();

/// Converts a result of the engine: enumerations become numbers.
template <class T>
auto Value(const T& value)
{
    if constexpr (std::is_enum_v<T>)
    {
        return static_cast<int>(value);
    }
    else
    {
        return value;
    }
}

/// Adds a property that can be read. `get` is a member function or takes the object.
template <class Class, class Get>
void ReadOnly(Class& type, const char* name, Get get, const char* doc)
{
    using H = typename Class::type;
    using Object = typename H::Object;
    type.def_property_readonly(
        name,
        [get](const H& handle) {
            return Value(std::invoke(get, static_cast<const Object&>(handle.Get())));
        },
        doc);
}

template <class Class, class Get, class Object, class Result, class Argument>
void Property(Class& type, const char* name, Get get, Result (Object::*set)(Argument),
              const char* doc)
{
    using H = typename Class::type;
    using Self = typename H::Object;
    type.def_property(
        name,
        [get](const H& handle) {
            return Value(std::invoke(get, static_cast<const Self&>(handle.Get())));
        },
        [set, name](H& handle, py::handle value) {
            // The conversion may run code that destroys the object.
            const auto argument = From<std::remove_cvref_t<Argument>>(value, name);
            Self& object = handle.Get();
            (object.*set)(argument);
            CheckMisuse();
        },
        doc);
}

/// Adds the property userData, which is any object.
template <class Class>
void UserData(Class& type)
{
    using H = typename Class::type;
    type.def_property(
        "userData",
        [](const H& handle) {
            handle.Get();
            return handle.userData;
        },
        [](H& handle, py::object value) {
            handle.Get();
            handle.userData = std::move(value);
        },
        "Any object of the program.");
}

/// Adds comparison by identity and a hash, which pybind11 keeps from classes with neither; and
/// `_exists`, which is False once the object is destroyed.
template <class Class>
void Identity(Class& type)
{
    using H = typename Class::type;
    type.def_property_readonly("_exists", [](const H& h) { return h.world != nullptr; });
    type.def("__eq__", [](py::handle a, py::handle b) { return a.is(b); })
        .def("__ne__", [](py::handle a, py::handle b) { return !a.is(b); })
        .def("__hash__", [](py::handle a) { return std::hash<void*>()(a.ptr()); });
}

} // namespace boxreel::python
