// SPDX-License-Identifier: MIT
#pragma once

#include "Convert.h"

#include <memory>

namespace boxreel::python
{

/// Returns the shape of the fixture, or null if that was destroyed. `fixture` is a weak reference.
const b2Shape* LiveShape(const py::object& fixture);
/// Replaces the shape of the fixture, or throws b2Error.
void SetLiveShape(const py::object& fixture, const b2Shape& shape);

/// A shape of the program, which has its numbers here, or of a fixture, whose numbers it reads and
/// writes. After the fixture's end it has the last ones.
struct ShapeObject
{
    virtual ~ShapeObject() = default;
    /// Returns the numbers. Code of Python may invalidate the reference.
    virtual const b2Shape& Get() const = 0;
    virtual void SetRadius(float32 radius) = 0;

    py::object fixture; ///< weak, because its attributes may hold the shape; null: none
};

template <class Shape>
struct ShapeOf final : ShapeObject
{
    const Shape& Get() const override
    {
        const b2Shape* live = fixture ? LiveShape(fixture) : nullptr;
        // A fixture that a snapshot restored may have a shape of another type.
        return live != nullptr && live->GetType() == shape.GetType()
                   ? static_cast<const Shape&>(*live)
                   : shape;
    }

    void SetRadius(float32 radius) override
    {
        Change([radius](Shape& changed) { changed.m_radius = radius; });
    }

    /// Calls `function` with a copy of the numbers, and then takes that.
    template <class Function>
    void Change(Function function)
    {
        Shape changed = Get();
        function(changed);
        CheckMisuse();
        if (fixture)
        {
            SetLiveShape(fixture, changed);
        }
        shape = changed;
    }

    Shape shape;
};

/// Returns the argument as a shape.
ShapeObject& ShapeFrom(py::handle value, const char* name);

/// Returns the shape of a fixture as an object of its class.
py::object ShapeOfFixture(const py::object& fixture, const b2Shape& shape);

} // namespace boxreel::python
