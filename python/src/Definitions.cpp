// SPDX-License-Identifier: MIT
#include "Definitions.h"

#include "Module.h"
#include "Shapes.h"

#include <array>

/// One table of fields for each definition. Python's classes of definitions take their names and
/// defaults from here.
namespace boxreel::python
{

/// The shape of a definition must outlive it: the caller holds the dictionary.
template <>
const b2Shape* From<const b2Shape*>(py::handle value, const char* name)
{
    return value.is_none() ? nullptr : &ShapeFrom(value, name).Get();
}

template <>
b2BodyType From<b2BodyType>(py::handle value, const char* name)
{
    const int32 type = From<int32>(value, name);
    if (type < b2_staticBody || type > b2_dynamicBody)
    {
        ThrowMisuse(std::string(name) +
                    ": expected b2_staticBody, b2_kinematicBody or b2_dynamicBody");
    }
    return static_cast<b2BodyType>(type);
}

namespace
{

constexpr std::array kBody = {
    F<b2BodyDef, &b2BodyDef::type>("type"),
    F<b2BodyDef, &b2BodyDef::position>("position"),
    F<b2BodyDef, &b2BodyDef::angle>("angle"),
    F<b2BodyDef, &b2BodyDef::linearVelocity>("linearVelocity"),
    F<b2BodyDef, &b2BodyDef::angularVelocity>("angularVelocity"),
    F<b2BodyDef, &b2BodyDef::linearDamping>("linearDamping"),
    F<b2BodyDef, &b2BodyDef::angularDamping>("angularDamping"),
    F<b2BodyDef, &b2BodyDef::allowSleep>("allowSleep"),
    F<b2BodyDef, &b2BodyDef::awake>("awake"),
    F<b2BodyDef, &b2BodyDef::fixedRotation>("fixedRotation"),
    F<b2BodyDef, &b2BodyDef::bullet>("bullet"),
    F<b2BodyDef, &b2BodyDef::active>("active"),
    F<b2BodyDef, &b2BodyDef::gravityScale>("gravityScale"),
};

constexpr std::array kFixture = {
    F<b2FixtureDef, &b2FixtureDef::shape>("shape"),
    F<b2FixtureDef, &b2FixtureDef::friction>("friction"),
    F<b2FixtureDef, &b2FixtureDef::restitution>("restitution"),
    F<b2FixtureDef, &b2FixtureDef::density>("density"),
    F<b2FixtureDef, &b2FixtureDef::isSensor>("isSensor"),
    F<b2FixtureDef, &b2FixtureDef::filter>("filter"),
};

} // namespace

b2BodyDef BodyDefFrom(const py::dict& fields)
{
    return Fill(kBody, fields);
}

b2FixtureDef FixtureDefFrom(const py::dict& fields)
{
    return Fill(kFixture, fields);
}

void BindDefinitions(py::module_& module)
{
    py::dict defaults;
    defaults["b2BodyDef"] = Defaults(kBody);
    defaults["b2FixtureDef"] = Defaults(kFixture);
    module.attr("_defaults") = defaults; // those of joints follow
}

} // namespace boxreel::python
