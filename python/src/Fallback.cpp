// SPDX-License-Identifier: MIT
#include "Bind.h"
#include "Module.h"

#include <base/Quoting.h>

#include <string_view>

/// Sentences for wrong arguments. Without them pybind11 lists signatures of C++. Each function gets
/// a last overload that takes everything and throws, with the names of the arguments that the
/// function was bound with. Signatures are left out of the documentation.
namespace boxreel::python
{
namespace
{

/// Returns what pybind11 knows of a function: its overloads, a list by `next`.
const py::detail::function_record* RecordOf(const py::object& function)
{
    const py::handle self = PyCFunction_GET_SELF(py::detail::get_function(function).ptr());
#if PYBIND11_VERSION_HEX >= 0x03000000
    return py::detail::function_record_ptr_from_PyObject(self.ptr());
#else
    return py::reinterpret_borrow<py::capsule>(self).get_pointer<py::detail::function_record>();
#endif
}

/// Returns the arguments of the overload that has the most, but for self.
py::list ArgumentsOf(const py::object& function)
{
    py::list longest;
    for (const auto* overload = RecordOf(function); overload != nullptr; overload = overload->next)
    {
        py::list names;
        for (const py::detail::argument_record& argument : overload->args)
        {
            if (argument.name != nullptr && std::string_view(argument.name) != "self")
            {
                names.append(argument.name);
            }
        }
        longest = names.size() > longest.size() ? names : longest;
    }
    return longest;
}

/// True for a function with an overload that takes any keywords: each sets an attribute.
bool TakesAttributes(const py::object& function)
{
    for (const auto* overload = RecordOf(function); overload != nullptr; overload = overload->next)
    {
        if (overload->has_kwargs && overload->nargs == 2) // self and the keywords
        {
            return true;
        }
    }
    return false;
}

/// Returns "radius=, pos=": the attributes that can be set.
py::list SettableOf(py::handle type)
{
    py::list names;
    for (const py::handle name : py::module_::import("builtins").attr("dir")(type))
    {
        const py::object member = type.attr(name);
        if (Py_TYPE(member.ptr()) == &PyProperty_Type && !member.attr("fset").is_none())
        {
            names.append(name + py::str("="));
        }
    }
    return names;
}

std::string Given(const py::args& arguments, const py::kwargs& keywords)
{
    std::string text;
    for (const py::handle argument : arguments)
    {
        text += (text.empty() ? "" : ", ") + TypeName(argument);
    }
    for (const auto& [name, value] : keywords)
    {
        text += (text.empty() ? "" : ", ") + Shown(name) + "=" + TypeName(value);
    }
    return "(" + text + ")";
}

[[noreturn]] void Refuse(const std::string& function, const py::list& names,
                         const py::args& arguments, const py::kwargs& keywords)
{
    const std::string expected = py::str(py::str(", ").attr("join")(names));
    std::string hint;
    for (const auto& [name, value] : keywords)
    {
        if (!names.contains(name))
        {
            hint = "; it has no argument " + Quoted(Shown(name)) + HintFor(name, names);
        }
    }
    throw py::type_error(function + ": expected " +
                         (expected.empty() ? "no arguments" : "(" + expected + ")") + ", not " +
                         Given(arguments, keywords) + hint);
}

void AddTo(const py::object& scope, const std::string& owner, const py::str& key)
{
    const std::string name = key;
    const py::object function = scope.attr(key);
    const py::list names = ArgumentsOf(function);
    if (owner.empty())
    {
        scope.attr(key) = py::cpp_function(
            [name, names](const py::args& arguments, const py::kwargs& keywords) -> py::object {
                Refuse(name, names, arguments, keywords);
            },
            py::name(name.c_str()), py::scope(scope), py::sibling(function));
    }
    else if (name == "__init__")
    {
        // Which attributes there are is asked later: Python's part adds some.
        const bool isByName = names.empty() && TakesAttributes(function);
        const py::handle type = scope;
        scope.attr(key) = py::cpp_function(
            [owner, names, isByName, type](py::detail::value_and_holder&, const py::args& arguments,
                                           const py::kwargs& keywords) {
                Refuse(owner, isByName ? SettableOf(type) : names, arguments, keywords);
            },
            py::name(name.c_str()), py::is_method(scope), py::sibling(function),
            py::detail::is_new_style_constructor());
    }
    else
    {
        const std::string full = owner + "." + name;
        scope.attr(key) = py::cpp_function(
            [full, names](py::handle, const py::args& arguments, const py::kwargs& keywords)
                -> py::object { Refuse(full, names, arguments, keywords); },
            py::name(name.c_str()), py::is_method(scope), py::sibling(function));
    }
}

/// True for functions of pybind11 that programs call.
bool IsPublicFunction(const py::handle key, py::handle value)
{
    const std::string name = py::str(key);
    const bool isItem = name == "__getitem__" || name == "__setitem__";
    return (name[0] != '_' || name == "__init__" || isItem) &&
           (PyCFunction_Check(value.ptr()) || PyInstanceMethod_Check(value.ptr()));
}

void AddToAll(const py::object& scope, const std::string& owner)
{
    for (const py::handle item : py::list(scope.attr("__dict__").attr("items")()))
    {
        const py::tuple pair = py::reinterpret_borrow<py::tuple>(item);
        if (IsPublicFunction(pair[0], pair[1]))
        {
            AddTo(scope, owner, py::str(pair[0]));
        }
    }
}

/// Gives a class without a constructor one that says so.
void RefuseConstruction(const py::object& type, const std::string& name)
{
    const bool isError =
        PyType_IsSubtype(reinterpret_cast<PyTypeObject*>(type.ptr()),
                         reinterpret_cast<PyTypeObject*>(PyExc_BaseException)) != 0;
    // A constructor of pybind11 is an instance method; the slot of its base class is not.
    if (!isError && !PyInstanceMethod_Check(py::object(type.attr("__dict__")["__init__"]).ptr()))
    {
        type.attr("__init__") = py::cpp_function(
            [name](py::handle, const py::args&, const py::kwargs&) {
                throw py::type_error(name + ": it has no constructor; the engine makes these");
            },
            // Not __init__: of a constructor by name pybind11 demands an object of just this class.
            py::name("refuse"), py::is_method(type));
    }
}

/// Refuses objects of `Class.__new__(Class)`, which no constructor has filled. pybind11 asks this
/// function for their memory at the first use.
void RefuseUninitialized(const py::object& type)
{
    if (auto* info = py::detail::get_type_info(reinterpret_cast<PyTypeObject*>(type.ptr())))
    {
        info->operator_new = [](std::size_t) -> void* {
            throw py::type_error("the object is not initialized; call its class to make one");
        };
    }
}

/// Refuses `object.__class__ = other`, for the object would be of the one class in C++ and of the
/// other in Python.
void RefuseOtherClass(const py::object& type, const std::string& name)
{
    const py::cpp_function get([](py::handle self) { return py::type::of(self); },
                               py::is_method(type));
    const py::cpp_function set(
        [name](py::handle, py::handle) {
            PyErr_SetString(PyExc_TypeError, (name + ".__class__ cannot be set").c_str());
            throw py::error_already_set();
        },
        py::is_method(type));
    const py::object property = py::handle(reinterpret_cast<PyObject*>(&PyProperty_Type))(get, set);
    // Into the dictionary, because setting the attribute would set the class of the class.
    auto* const changed = reinterpret_cast<PyTypeObject*>(type.ptr());
    PyDict_SetItemString(changed->tp_dict, "__class__", property.ptr());
    PyType_Modified(changed);
}

} // namespace

std::string HintFor(py::handle name, const py::object& names)
{
    const py::list all =
        PyType_Check(names.ptr()) ? py::module_::import("builtins").attr("dir")(names) : names;
    py::dict known; // by small letters
    for (const py::handle one : all)
    {
        known[one.attr("lower")()] = one;
    }
    // 0.5 is below Python's 0.6, so that `pos` finds `position`.
    const py::object near = py::module_::import("difflib").attr("get_close_matches")(
        name.attr("lower")(), known, 1, 0.5);
    return py::len(near) == 0 ? ""
                              : "; did you mean " + Quoted(Shown(known[near[py::int_(0)]])) + "?";
}

void BindHints(py::module_& module)
{
    module.def("_hint", &HintFor);
    module.def("_kind", &TypeName);
    module.def("_refuse", &Refuse); // of functions that are written in Python
}

void AddFallbacks(py::module_& module)
{
    py::options options;
    options.disable_function_signatures(); // in the documentation that follows
    AddToAll(module, "");
    for (const py::handle item : py::list(module.attr("__dict__").attr("items")()))
    {
        const py::tuple pair = py::reinterpret_borrow<py::tuple>(item);
        if (PyType_Check(py::object(pair[1]).ptr()))
        {
            const py::object type = pair[1];
            AddToAll(type, py::str(pair[0]));
            RefuseConstruction(type, py::str(pair[0]));
            RefuseUninitialized(type);
            if (py::detail::get_type_info(reinterpret_cast<PyTypeObject*>(type.ptr())) != nullptr)
            {
                RefuseOtherClass(type, py::str(pair[0]));
            }
        }
    }
}

} // namespace boxreel::python
