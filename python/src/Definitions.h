// SPDX-License-Identifier: MIT
#pragma once

#include "WorldObject.h"

namespace boxreel::python
{

/// Definitions from dictionaries of their fields. A name that is unknown is left to the caller.
b2BodyDef BodyDefFrom(const py::dict& fields);
b2FixtureDef FixtureDefFrom(const py::dict& fields);
/// Creates a joint from the fields of the definition class `name`.
b2Joint* CreateJointFrom(WorldObject& owner, const std::string& name, const py::dict& fields);

} // namespace boxreel::python
