// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

/// The parts of the module _boxreel, in the order in which Module.cpp calls them.
namespace boxreel::python
{

void BindMath(pybind11::module_& module);
void BindMathFunctions(pybind11::module_& module);
void BindShapes(pybind11::module_& module);
void BindCollision(pybind11::module_& module);
void BindDefinitions(pybind11::module_& module);
void BindContacts(pybind11::module_& module);
void BindBodies(pybind11::module_& module);
void BindJoints(pybind11::module_& module);
void BindWorld(pybind11::module_& module);
void BindPictures(pybind11::module_& module);
void BindFilms(pybind11::module_& module);
void BindScenes(pybind11::module_& module);
void BindGolden(pybind11::module_& module);
void BindHints(pybind11::module_& module);
/// Adds sentences for wrong arguments to all functions; last.
void AddFallbacks(pybind11::module_& module);

} // namespace boxreel::python
