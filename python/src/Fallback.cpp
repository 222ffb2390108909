// SPDX-License-Identifier: MIT
#include "Bind.h"
#include "Module.h"

#include <regex>
#include <sstream>

/// Sentences for wrong arguments. Without them pybind11 lists signatures of C++. Each function gets
/// a last overload that takes everything and throws. Its text comes from the signatures that
/// pybind11 wrote into the documentation, which the new overload also removes from there.
namespace boxreel::python
{
namespace
{

/// Returns the parameters of the signature in a line, without those that pybind11 has no name for.
py::list ParametersOf(const std::string& signature)
{
    static const std::regex kParameter(R"((?:\(|, )(\w+): )");
    py::list names;
    for (std::sregex_iterator found(signature.begin(), signature.end(), kParameter), end;
         found != end; ++found)
    {
        const std::string name = (*found)[1];
        if (name.rfind("arg", 0) != 0)
        {
            names.append(name);
        }
    }
    return names;
}

/// Returns the longest parameter list of the overloads in a documentation.
py::list ParametersIn(const std::string& doc, const std::string& name)
{
    py::list longest;
    std::istringstream lines(doc);
    for (std::string line; std::getline(lines, line);)
    {
        const std::size_t start = line.find(name + "(");
        if (start != std::string::npos && line.find(") -> ") != std::string::npos)
        {
            const py::list names = ParametersOf(line.substr(start));
            longest = names.size() > longest.size() ? names : longest;
        }
    }
    return longest;
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
        text += (text.empty() ? "" : ", ") + std::string(py::str(name)) + "=" + TypeName(value);
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
            hint =
                "; it has no argument '" + std::string(py::str(name)) + "'" + HintFor(name, names);
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
    const std::string doc = py::str(function.attr("__doc__"));
    py::list names = ParametersIn(doc, name);
    if (!owner.empty() && names.size() > 0)
    {
        names.attr("pop")(0); // self
    }
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
        scope.attr(key) = py::cpp_function(
            [owner, names](py::detail::value_and_holder&, const py::args& arguments,
                           const py::kwargs& keywords) {
                Refuse(owner, names, arguments, keywords);
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
    return (name[0] != '_' || name == "__init__") &&
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
    // A constructor of pybind11 is an instance method; the slot of its base class is none.
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
    return py::len(near) == 0
               ? ""
               : "; did you mean '" + std::string(py::str(known[near[py::int_(0)]])) + "'?";
}

void BindHints(py::module_& module)
{
    module.def("_hint", &HintFor);
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
        }
    }
}

} // namespace boxreel::python
