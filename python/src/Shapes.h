// SPDX-License-Identifier: MIT
#pragma once

#include "Convert.h"

#include <memory>

namespace boxreel::python
{

/// A shape of a Python program. Shapes of fixtures are copies that cannot be changed, because the
/// engine does not support it.
struct ShapeObject
{
    virtual ~ShapeObject() = default;
    virtual b2Shape& Get() = 0;
    const b2Shape& Get() const { return const_cast<ShapeObject*>(this)->Get(); }

    bool isOfFixture = false;
};

template <class Shape>
struct ShapeOf final : ShapeObject
{
    b2Shape& Get() override { return shape; }
    Shape shape;
};

/// Returns the argument as a shape.
ShapeObject& ShapeFrom(py::handle value, const char* name);

/// Returns a copy of a fixture's shape as an object of its class.
py::object CopyOfShape(const b2Shape& shape);

} // namespace boxreel::python
