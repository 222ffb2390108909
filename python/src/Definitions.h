// SPDX-License-Identifier: MIT
#pragma once

#include "WorldObject.h"

#include <array>

/// Definitions have one table of fields each, from which Python's classes of definitions take
/// names and defaults.
namespace boxreel::python
{

/// A public member of a definition.
template <class Def>
struct Field
{
    const char* name;
    bool isPointer;
    void (*set)(Def& def, py::handle value, const char* name);
    py::object (*get)(const Def& def);
};

template <class Def, auto member>
constexpr Field<Def> F(const char* name)
{
    using T = std::remove_cvref_t<decltype(std::declval<Def>().*member)>;
    return {
        name, std::is_pointer_v<T>,
        [](Def& def, py::handle value, const char* field) { def.*member = From<T>(value, field); },
        [](const Def& def) -> py::object {
            if constexpr (std::is_pointer_v<T>)
            {
                return py::none();
            }
            else
            {
                return py::cast(Value(def.*member));
            }
        }};
}

/// Returns a definition with the fields that the dictionary has.
template <class Def, std::size_t count>
Def Fill(const std::array<Field<Def>, count>& table, const py::dict& fields)
{
    Def def;
    // Conversions of numbers may run code that destroys a body, so pointers come last.
    for (const bool isPointer : {false, true})
    {
        for (const Field<Def>& field : table)
        {
            PyObject* value = PyDict_GetItemString(fields.ptr(), field.name);
            if (value != nullptr && field.isPointer == isPointer)
            {
                field.set(def, value, field.name);
            }
        }
    }
    return def;
}

/// Returns the value of each field before a program sets it.
template <class Def, std::size_t count>
py::dict Defaults(const std::array<Field<Def>, count>& table)
{
    const Def def;
    py::dict defaults;
    for (const Field<Def>& field : table)
    {
        defaults[field.name] = field.get(def);
    }
    return defaults;
}

template <>
const b2Shape* From<const b2Shape*>(py::handle value, const char* name);
template <>
b2BodyType From<b2BodyType>(py::handle value, const char* name);

/// Definitions from dictionaries of their fields. A name that is unknown is left to the caller.
b2BodyDef BodyDefFrom(const py::dict& fields);
b2FixtureDef FixtureDefFrom(const py::dict& fields);
/// Creates a joint from the fields of the definition class `name`.
b2Joint* CreateJointFrom(WorldObject& owner, const std::string& name, const py::dict& fields);

} // namespace boxreel::python
