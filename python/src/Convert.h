// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

/// Values of Python as values of the engine, with errors that name the argument. Used by all files
/// of the module instead of pybind11's own conversions, because those list C++ signatures.
namespace boxreel::python
{

namespace py = pybind11;

/// Returns the type of a value for an error: "'str'", or "None".
std::string TypeName(py::handle value);

/// Throws an error that is a TypeError and a ValueError: "angle: expected a number, not 'str'".
[[noreturn]] void ThrowType(const char* name, const char* expected, py::handle value);

/// Keeps Python's lock released. At the end of the program Python stops threads that ask for the
/// lock, by unwinding their stacks, which a destructor must allow.
class WithoutLock
{
public:
    WithoutLock() : m_state(PyEval_SaveThread()) {}
    ~WithoutLock() noexcept(false) { PyEval_RestoreThread(m_state); }
    WithoutLock(const WithoutLock&) = delete;
    WithoutLock& operator=(const WithoutLock&) = delete;

private:
    PyThreadState* m_state;
};

/// Keeps the garbage collector off, which runs code of the program (`__del__`) that may destroy
/// what a list is made of.
class WithoutCollector
{
public:
    WithoutCollector() : m_was(PyGC_Disable() != 0) {}
    ~WithoutCollector()
    {
        if (m_was)
        {
            PyGC_Enable();
        }
    }
    WithoutCollector(const WithoutCollector&) = delete;
    WithoutCollector& operator=(const WithoutCollector&) = delete;

private:
    bool m_was;
};

/// Returns str(value) for a sentence; half of a surrogate pair is written as an escape.
std::string Shown(py::handle value);

/// Throws b2Error with the sentence.
[[noreturn]] void ThrowMisuse(const std::string& sentence);

/// Throws b2Error if the engine refused a call of this thread since the last check.
void CheckMisuse();

/// Returns the result of a call, unless the engine refused that.
template <class T>
T Checked(T result)
{
    CheckMisuse();
    return result;
}

/// Registers b2Error, and lets the engine report refused calls instead of aborting.
void InstallMisuse(py::module_& module);

/// True if the value is a number, and no vector, which has an arithmetic too.
bool IsNumber(py::handle value);

/// True if the value is a b2Vec2 or a sequence of two numbers.
bool IsVec2(py::handle value);

/// Returns the value as a T. `name` is the argument in the error.
template <class T>
T From(py::handle value, const char* name);

template <>
float32 From<float32>(py::handle value, const char* name);
template <>
double From<double>(py::handle value, const char* name);
template <>
bool From<bool>(py::handle value, const char* name);
template <>
int32 From<int32>(py::handle value, const char* name);
template <>
uint16 From<uint16>(py::handle value, const char* name);
template <>
int16 From<int16>(py::handle value, const char* name);
template <>
uint32 From<uint32>(py::handle value, const char* name);
/// Refuses half of a surrogate pair, which UTF-8 cannot say.
template <>
std::string From<std::string>(py::handle value, const char* name);
template <>
b2Vec2 From<b2Vec2>(py::handle value, const char* name);
template <>
b2Vec3 From<b2Vec3>(py::handle value, const char* name);
template <>
b2Rot From<b2Rot>(py::handle value, const char* name);
template <>
b2Transform From<b2Transform>(py::handle value, const char* name);
template <>
b2Color From<b2Color>(py::handle value, const char* name);
template <>
b2AABB From<b2AABB>(py::handle value, const char* name);
template <>
b2MassData From<b2MassData>(py::handle value, const char* name);
template <>
b2Filter From<b2Filter>(py::handle value, const char* name);
/// Returns the items of a list or another iterable. A sequence has as many as its length says,
/// because its iteration need not end.
py::list ItemsOf(py::handle value, const char* name);
template <>
std::vector<b2Vec2> From<std::vector<b2Vec2>>(py::handle value, const char* name);

/// Returns the points as a list of tuples, which is how the module returns vertices.
py::list TuplesOf(const b2Vec2* points, int32 count);

} // namespace boxreel::python
