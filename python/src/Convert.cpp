// SPDX-License-Identifier: MIT
#include "Convert.h"

#include <base/Quoting.h>

#include <cctype>
#include <limits>
#include <string_view>

namespace boxreel::python
{
namespace
{

thread_local const char* t_misuse = nullptr;
PyObject* g_error = nullptr;     // b2Error, which lives as long as the process
PyObject* g_typeError = nullptr; // programs of the 2.3 module catch ValueError for some of these

void NoteMisuse(const char* sentence, const char*, int)
{
    if (t_misuse == nullptr) // the first one explains the others
    {
        t_misuse = sentence;
    }
}

/// Returns a sentence of the engine with the names of Python: "b2Body.transform" for
/// "b2Body::SetTransform".
std::string InPython(std::string sentence)
{
    constexpr std::string_view kSave = "b2SaveSnapshot";
    if (const std::size_t at = sentence.find(kSave); at != std::string::npos)
    {
        sentence.replace(at, kSave.size(), "boxreel.save");
    }
    for (std::size_t at = sentence.find("::"); at != std::string::npos; at = sentence.find("::"))
    {
        sentence.replace(at, 2, ".");
        if (sentence.compare(at + 1, 3, "Set") == 0)
        {
            sentence.erase(at + 1, 3);
            sentence[at + 1] = char(std::tolower(static_cast<unsigned char>(sentence[at + 1])));
        }
    }
    return sentence;
}

/// Forgets an error that says that a value is of another type. Others, which a method of the
/// program has raised, are its own.
void ClearTypeError()
{
    for (PyObject* const kind : {PyExc_TypeError, PyExc_OverflowError, PyExc_IndexError,
                                 PyExc_AttributeError, PyExc_ValueError})
    {
        if (PyErr_ExceptionMatches(kind) != 0)
        {
            PyErr_Clear();
            return;
        }
    }
    throw py::error_already_set();
}

template <class Whole>
Whole WholeNumber(py::handle value, const char* name)
{
    const py::object index = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    if (!index)
    {
        ClearTypeError();
        ThrowType(name, "a whole number", value);
    }
    const long long number = PyLong_AsLongLong(index.ptr());
    const bool failed = number == -1 && PyErr_Occurred() != nullptr;
    PyErr_Clear();
    if (failed || number < std::numeric_limits<Whole>::min() ||
        number > std::numeric_limits<Whole>::max())
    {
        ThrowMisuse(std::string(name) + ": expected a whole number from " +
                    std::to_string(std::numeric_limits<Whole>::min()) + " to " +
                    std::to_string(std::numeric_limits<Whole>::max()) + ", not " + Shown(value));
    }
    return static_cast<Whole>(number);
}

/// Reads `count` numbers of a sequence; false if it is not a sequence or has another length.
bool Numbers(py::handle value, float32* numbers, Py_ssize_t count)
{
    if (PyUnicode_Check(value.ptr()) || !PySequence_Check(value.ptr()))
    {
        return false;
    }
    // By its length and not by iteration, which need not end. A conversion may change the sequence.
    const Py_ssize_t size = PySequence_Size(value.ptr());
    if (size != count)
    {
        if (size < 0)
        {
            ClearTypeError();
        }
        return false;
    }
    for (Py_ssize_t i = 0; i < count; ++i)
    {
        const auto item = py::reinterpret_steal<py::object>(PySequence_GetItem(value.ptr(), i));
        const double number = item ? PyFloat_AsDouble(item.ptr()) : -1.0;
        if (number == -1.0 && PyErr_Occurred() != nullptr)
        {
            ClearTypeError();
            return false;
        }
        numbers[i] = static_cast<float32>(number);
    }
    return true;
}

template <class T>
T Registered(py::handle value, const char* name, const char* expected)
{
    if (!py::isinstance<T>(value))
    {
        ThrowType(name, expected, value);
    }
    return value.cast<T&>();
}

} // namespace

std::string Shown(py::handle value)
{
    return std::string(py::bytes(py::str(value).attr("encode")("utf-8", "backslashreplace")));
}

std::string TypeName(py::handle value)
{
    if (PyType_Check(value.ptr())) // a class instead of an object
    {
        return "the class " + Shown(value.attr("__name__"));
    }
    return value.is_none() ? "None" : Quoted(Shown(py::type::handle_of(value).attr("__name__")));
}

void ThrowType(const char* name, const char* expected, py::handle value)
{
    const std::string sentence =
        std::string(name) + ": expected " + expected + ", not " + TypeName(value);
    PyErr_SetString(g_typeError, sentence.c_str());
    throw py::error_already_set();
}

void ThrowMisuse(const std::string& sentence)
{
    PyErr_SetString(g_error, InPython(sentence).c_str());
    throw py::error_already_set();
}

void CheckMisuse()
{
    if (t_misuse != nullptr)
    {
        const char* sentence = t_misuse;
        t_misuse = nullptr;
        ThrowMisuse(sentence);
    }
}

void InstallMisuse(py::module_& module)
{
    const py::tuple bases =
        py::make_tuple(py::handle(PyExc_ValueError), py::handle(PyExc_AssertionError),
                       py::handle(PyExc_RuntimeError));
    g_error = PyErr_NewExceptionWithDoc(
        "Box2D.b2Error",
        "What the engine refuses: a number out of range, an object that was destroyed, a change of "
        "a "
        "locked world. Derived from the exceptions that programs catch for these.",
        bases.ptr(), nullptr);
    if (g_error == nullptr)
    {
        throw py::error_already_set();
    }
    module.attr("b2Error") = py::handle(g_error);
    const py::tuple types =
        py::make_tuple(py::handle(PyExc_TypeError), py::handle(PyExc_ValueError));
    g_typeError = PyErr_NewExceptionWithDoc("Box2D.b2TypeError", "An argument of a wrong type.",
                                            types.ptr(), nullptr);
    if (g_typeError == nullptr)
    {
        throw py::error_already_set();
    }
    module.attr("b2TypeError") = py::handle(g_typeError);
    b2SetMisuse(NoteMisuse);
}

bool IsNumber(py::handle value)
{
    return PyNumber_Check(value.ptr()) != 0 && PySequence_Check(value.ptr()) == 0;
}

bool IsVec2(py::handle value)
{
    float32 ignored[2];
    return py::isinstance<b2Vec2>(value) || Numbers(value, ignored, 2);
}

template <>
double From<double>(py::handle value, const char* name)
{
    const double number = PyFloat_AsDouble(value.ptr());
    if (number == -1.0 && PyErr_Occurred() != nullptr)
    {
        ClearTypeError();
        ThrowType(name, "a number", value);
    }
    return number;
}

template <>
float32 From<float32>(py::handle value, const char* name)
{
    return static_cast<float32>(From<double>(value, name));
}

template <>
bool From<bool>(py::handle value, const char* name)
{
    const int truth = PyObject_IsTrue(value.ptr());
    if (truth < 0)
    {
        ClearTypeError();
        ThrowType(name, "True or False", value);
    }
    return truth != 0;
}

template <>
int32 From<int32>(py::handle value, const char* name)
{
    return WholeNumber<int32>(value, name);
}

template <>
uint16 From<uint16>(py::handle value, const char* name)
{
    return WholeNumber<uint16>(value, name);
}

template <>
int16 From<int16>(py::handle value, const char* name)
{
    return WholeNumber<int16>(value, name);
}

template <>
uint32 From<uint32>(py::handle value, const char* name)
{
    return WholeNumber<uint32>(value, name);
}

template <>
std::string From<std::string>(py::handle value, const char* name)
{
    if (!PyUnicode_Check(value.ptr()))
    {
        ThrowType(name, "a text", value);
    }
    Py_ssize_t size = 0;
    const char* const text = PyUnicode_AsUTF8AndSize(value.ptr(), &size);
    if (text == nullptr)
    {
        PyErr_Clear();
        ThrowMisuse(std::string(name) + ": " + Quoted(Shown(value)) +
                    " cannot be written as UTF-8; remove the surrogates");
    }
    return {text, static_cast<std::size_t>(size)};
}

template <>
b2Vec2 From<b2Vec2>(py::handle value, const char* name)
{
    if (py::isinstance<b2Vec2>(value))
    {
        return value.cast<b2Vec2&>();
    }
    float32 xy[2];
    if (!Numbers(value, xy, 2))
    {
        ThrowType(name, "a b2Vec2 or two numbers", value);
    }
    return {xy[0], xy[1]};
}

template <>
b2Vec3 From<b2Vec3>(py::handle value, const char* name)
{
    if (py::isinstance<b2Vec3>(value))
    {
        return value.cast<b2Vec3&>();
    }
    float32 xyz[3];
    if (!Numbers(value, xyz, 3))
    {
        ThrowType(name, "a b2Vec3 or three numbers", value);
    }
    return {xyz[0], xyz[1], xyz[2]};
}

template <>
b2Transform From<b2Transform>(py::handle value, const char* name)
{
    if (py::isinstance<b2Transform>(value))
    {
        return value.cast<b2Transform&>();
    }
    if (PySequence_Check(value.ptr()) != 0 && py::len(value) == 2)
    {
        const py::sequence pair = py::reinterpret_borrow<py::sequence>(value);
        b2Transform transform;
        transform.Set(From<b2Vec2>(py::object(pair[0]), name),
                      From<float32>(py::object(pair[1]), name));
        return transform;
    }
    ThrowType(name, "a b2Transform or (position, angle)", value);
}

template <>
b2Color From<b2Color>(py::handle value, const char* name)
{
    if (py::isinstance<b2Color>(value))
    {
        return value.cast<b2Color&>();
    }
    float32 rgba[4] = {0.0f, 0.0f, 0.0f, 1.0f};
    if (!Numbers(value, rgba, 3) && !Numbers(value, rgba, 4))
    {
        ThrowType(name, "a b2Color or three numbers", value);
    }
    return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

template <>
b2AABB From<b2AABB>(py::handle value, const char* name)
{
    return Registered<b2AABB>(value, name, "a b2AABB");
}

template <>
b2Rot From<b2Rot>(py::handle value, const char* name)
{
    return Registered<b2Rot>(value, name, "a b2Rot");
}

template <>
b2MassData From<b2MassData>(py::handle value, const char* name)
{
    return Registered<b2MassData>(value, name, "a b2MassData");
}

py::list ItemsOf(py::handle value, const char* name)
{
    if (PyUnicode_Check(value.ptr()) || !py::isinstance<py::iterable>(value))
    {
        ThrowType(name, "a list of points", value);
    }
    py::list items;
    if (PySequence_Check(value.ptr()) == 0 || !py::hasattr(value, "__len__"))
    {
        for (const py::handle item : value)
        {
            items.append(item);
        }
        return items;
    }
    for (std::size_t i = 0; i < py::len(value); ++i)
    {
        items.append(value[py::int_(i)]);
    }
    return items;
}

template <>
std::vector<b2Vec2> From<std::vector<b2Vec2>>(py::handle value, const char* name)
{
    std::vector<b2Vec2> points;
    for (const py::handle point : ItemsOf(value, name))
    {
        points.push_back(From<b2Vec2>(point, name));
    }
    return points;
}

py::list TuplesOf(const b2Vec2* points, int32 count)
{
    py::list tuples(count);
    for (int32 i = 0; i < count; ++i)
    {
        tuples[static_cast<std::size_t>(i)] =
            py::make_tuple(static_cast<double>(points[i].x), static_cast<double>(points[i].y));
    }
    return tuples;
}

} // namespace boxreel::python
