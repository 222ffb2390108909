// SPDX-License-Identifier: MIT
#pragma once

#include "Convert.h"

#include <base/Quoting.h>

#include <type_traits>

/// Properties and keyword arguments of plain structs of the engine.
namespace boxreel::python
{

/// Adds a property for a public member. A registered class is returned by reference, so that
/// `transform.position.x = 1` has an effect.
template <auto member, class Class>
void Member(Class& type, const char* name, const char* doc)
{
    using T = typename Class::type;
    type.def_property(
        name, [](T & self) -> auto& { return self.*member; },
        [name](T& self, py::handle value) {
            self.*member = From<std::remove_reference_t<decltype(self.*member)>>(value, name);
        },
        py::return_value_policy::reference_internal, doc);
}

/// Returns "; did you mean 'radius'?" if one of the names, or of the attributes of a class, is
/// near.
std::string HintFor(py::handle name, const py::object& names);

/// Sets each keyword as an attribute of the object; a name that its type lacks is a TypeError.
inline void SetKeywords(py::handle object, const py::kwargs& keywords)
{
    for (const auto& [name, value] : keywords)
    {
        if (!py::hasattr(py::type::handle_of(object), name))
        {
            const py::handle type = py::type::handle_of(object);
            throw py::type_error(Shown(type.attr("__name__")) + " has no attribute " +
                                 Quoted(Shown(name)) +
                                 HintFor(name, py::reinterpret_borrow<py::object>(type)));
        }
        py::setattr(object, name, value);
    }
}

/// Adds `T(**keywords)`: the default value, then each keyword as an attribute.
template <class T, class Class>
void KeywordInit(Class& type)
{
    type.def(py::init([type](const py::kwargs& keywords) {
        auto value = std::make_unique<T>();
        if (!keywords.empty())
        {
            const py::object view = py::cast(value.get(), py::return_value_policy::reference);
            SetKeywords(view, keywords);
        }
        return value;
    }));
}

/// Adds copy() and the protocol of the module `copy`.
template <class Class>
void Copies(Class& type)
{
    using T = typename Class::type;
    type.def(
            "copy", [](const T& self) { return T(self); }, "Returns a copy.")
        .def("__copy__", [](const T& self) { return T(self); })
        .def(
            "__deepcopy__", [](const T& self, py::handle) { return T(self); }, py::arg("memo"));
}

/// Adds copies, and pickling by a tuple of numbers. `numbers` returns the tuple and `make` the
/// value of it.
template <class Class, class Numbers, class Make>
void Copies(Class& type, Numbers numbers, Make make)
{
    using T = typename Class::type;
    Copies(type);
    type.def(py::pickle([numbers](const T& self) { return py::tuple(numbers(self)); },
                        [make](const py::tuple& state) { return make(state); }));
}

} // namespace boxreel::python
