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

template <class Def>
struct Field
{
    const char* name;
    bool isPointer;
    void (*set)(Def& def, py::handle value, const char* name);
    py::object (*get)(const Def& def);
};

template <class Def, auto member>
constexpr Field<Def> F(const char* name)
{
    using T = std::remove_cvref_t<decltype(std::declval<Def>().*member)>;
    return {
        name, std::is_pointer_v<T>,
        [](Def& def, py::handle value, const char* field) { def.*member = From<T>(value, field); },
        [](const Def& def) -> py::object {
            if constexpr (std::is_pointer_v<T>)
            {
                return py::none();
            }
            else
            {
                return py::cast(Value(def.*member));
            }
        }};
}

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

// The fields of all joints, for the table of each.
#define BOXREEL_JOINT_FIELDS(Def)                                                                  \
    F<Def, &Def::bodyA>("bodyA"), F<Def, &Def::bodyB>("bodyB"),                                    \
        F<Def, &Def::collideConnected>("collideConnected")
#define BOXREEL_ANCHOR_FIELDS(Def)                                                                 \
    BOXREEL_JOINT_FIELDS(Def), F<Def, &Def::localAnchorA>("localAnchorA"),                         \
        F<Def, &Def::localAnchorB>("localAnchorB")

constexpr std::array kRevolute = {
    BOXREEL_ANCHOR_FIELDS(b2RevoluteJointDef),
    F<b2RevoluteJointDef, &b2RevoluteJointDef::referenceAngle>("referenceAngle"),
    F<b2RevoluteJointDef, &b2RevoluteJointDef::enableLimit>("enableLimit"),
    F<b2RevoluteJointDef, &b2RevoluteJointDef::lowerAngle>("lowerAngle"),
    F<b2RevoluteJointDef, &b2RevoluteJointDef::upperAngle>("upperAngle"),
    F<b2RevoluteJointDef, &b2RevoluteJointDef::enableMotor>("enableMotor"),
    F<b2RevoluteJointDef, &b2RevoluteJointDef::motorSpeed>("motorSpeed"),
    F<b2RevoluteJointDef, &b2RevoluteJointDef::maxMotorTorque>("maxMotorTorque"),
};

constexpr std::array kPrismatic = {
    BOXREEL_ANCHOR_FIELDS(b2PrismaticJointDef),
    F<b2PrismaticJointDef, &b2PrismaticJointDef::localAxisA>("localAxisA"),
    F<b2PrismaticJointDef, &b2PrismaticJointDef::referenceAngle>("referenceAngle"),
    F<b2PrismaticJointDef, &b2PrismaticJointDef::enableLimit>("enableLimit"),
    F<b2PrismaticJointDef, &b2PrismaticJointDef::lowerTranslation>("lowerTranslation"),
    F<b2PrismaticJointDef, &b2PrismaticJointDef::upperTranslation>("upperTranslation"),
    F<b2PrismaticJointDef, &b2PrismaticJointDef::enableMotor>("enableMotor"),
    F<b2PrismaticJointDef, &b2PrismaticJointDef::maxMotorForce>("maxMotorForce"),
    F<b2PrismaticJointDef, &b2PrismaticJointDef::motorSpeed>("motorSpeed"),
};

constexpr std::array kDistance = {
    BOXREEL_ANCHOR_FIELDS(b2DistanceJointDef),
    F<b2DistanceJointDef, &b2DistanceJointDef::length>("length"),
    F<b2DistanceJointDef, &b2DistanceJointDef::frequencyHz>("frequencyHz"),
    F<b2DistanceJointDef, &b2DistanceJointDef::dampingRatio>("dampingRatio"),
    F<b2DistanceJointDef, &b2DistanceJointDef::minLength>("minLength"),
    F<b2DistanceJointDef, &b2DistanceJointDef::maxLength>("maxLength"),
};

constexpr std::array kPulley = {
    BOXREEL_ANCHOR_FIELDS(b2PulleyJointDef),
    F<b2PulleyJointDef, &b2PulleyJointDef::groundAnchorA>("groundAnchorA"),
    F<b2PulleyJointDef, &b2PulleyJointDef::groundAnchorB>("groundAnchorB"),
    F<b2PulleyJointDef, &b2PulleyJointDef::lengthA>("lengthA"),
    F<b2PulleyJointDef, &b2PulleyJointDef::lengthB>("lengthB"),
    F<b2PulleyJointDef, &b2PulleyJointDef::ratio>("ratio"),
};

constexpr std::array kMouse = {
    BOXREEL_JOINT_FIELDS(b2MouseJointDef),
    F<b2MouseJointDef, &b2MouseJointDef::target>("target"),
    F<b2MouseJointDef, &b2MouseJointDef::maxForce>("maxForce"),
    F<b2MouseJointDef, &b2MouseJointDef::frequencyHz>("frequencyHz"),
    F<b2MouseJointDef, &b2MouseJointDef::dampingRatio>("dampingRatio"),
};

constexpr std::array kGear = {
    BOXREEL_JOINT_FIELDS(b2GearJointDef),
    F<b2GearJointDef, &b2GearJointDef::joint1>("joint1"),
    F<b2GearJointDef, &b2GearJointDef::joint2>("joint2"),
    F<b2GearJointDef, &b2GearJointDef::ratio>("ratio"),
};

constexpr std::array kWheel = {
    BOXREEL_ANCHOR_FIELDS(b2WheelJointDef),
    F<b2WheelJointDef, &b2WheelJointDef::localAxisA>("localAxisA"),
    F<b2WheelJointDef, &b2WheelJointDef::enableMotor>("enableMotor"),
    F<b2WheelJointDef, &b2WheelJointDef::maxMotorTorque>("maxMotorTorque"),
    F<b2WheelJointDef, &b2WheelJointDef::motorSpeed>("motorSpeed"),
    F<b2WheelJointDef, &b2WheelJointDef::frequencyHz>("frequencyHz"),
    F<b2WheelJointDef, &b2WheelJointDef::dampingRatio>("dampingRatio"),
};

constexpr std::array kWeld = {
    BOXREEL_ANCHOR_FIELDS(b2WeldJointDef),
    F<b2WeldJointDef, &b2WeldJointDef::referenceAngle>("referenceAngle"),
    F<b2WeldJointDef, &b2WeldJointDef::frequencyHz>("frequencyHz"),
    F<b2WeldJointDef, &b2WeldJointDef::dampingRatio>("dampingRatio"),
};

constexpr std::array kFriction = {
    BOXREEL_ANCHOR_FIELDS(b2FrictionJointDef),
    F<b2FrictionJointDef, &b2FrictionJointDef::maxForce>("maxForce"),
    F<b2FrictionJointDef, &b2FrictionJointDef::maxTorque>("maxTorque"),
};

constexpr std::array kRope = {
    BOXREEL_ANCHOR_FIELDS(b2RopeJointDef),
    F<b2RopeJointDef, &b2RopeJointDef::maxLength>("maxLength"),
};

constexpr std::array kMotor = {
    BOXREEL_JOINT_FIELDS(b2MotorJointDef),
    F<b2MotorJointDef, &b2MotorJointDef::linearOffset>("linearOffset"),
    F<b2MotorJointDef, &b2MotorJointDef::angularOffset>("angularOffset"),
    F<b2MotorJointDef, &b2MotorJointDef::maxForce>("maxForce"),
    F<b2MotorJointDef, &b2MotorJointDef::maxTorque>("maxTorque"),
    F<b2MotorJointDef, &b2MotorJointDef::correctionFactor>("correctionFactor"),
};

#undef BOXREEL_ANCHOR_FIELDS
#undef BOXREEL_JOINT_FIELDS

template <class Def, std::size_t count>
Def Fill(const std::array<Field<Def>, count>& table, const py::dict& fields)
{
    Def def;
    // Conversions of numbers may run code that destroys a body, so pointers come last.
    for (const bool isPointer : {false, true})
    {
        for (const Field<Def>& field : table)
        {
            PyObject* value = PyDict_GetItemString(fields.ptr(), field.name);
            if (value != nullptr && field.isPointer == isPointer)
            {
                field.set(def, value, field.name);
            }
        }
    }
    return def;
}

template <class Def, std::size_t count>
py::dict Defaults(const std::array<Field<Def>, count>& table)
{
    const Def def;
    py::dict defaults;
    for (const Field<Def>& field : table)
    {
        defaults[field.name] = field.get(def);
    }
    return defaults;
}

/// Calls `visit` with the name and the table of each joint's definition.
template <class Visit>
void ForEachJoint(Visit visit)
{
    visit("b2RevoluteJointDef", kRevolute);
    visit("b2PrismaticJointDef", kPrismatic);
    visit("b2DistanceJointDef", kDistance);
    visit("b2PulleyJointDef", kPulley);
    visit("b2MouseJointDef", kMouse);
    visit("b2GearJointDef", kGear);
    visit("b2WheelJointDef", kWheel);
    visit("b2WeldJointDef", kWeld);
    visit("b2FrictionJointDef", kFriction);
    visit("b2RopeJointDef", kRope);
    visit("b2MotorJointDef", kMotor);
}

} // namespace

b2BodyDef BodyDefFrom(const py::dict& fields)
{
    return Fill(kBody, fields);
}

b2FixtureDef FixtureDefFrom(const py::dict& fields)
{
    return Fill(kFixture, fields);
}

b2Joint* CreateJointFrom(WorldObject& owner, const std::string& name, const py::dict& fields)
{
    b2Joint* joint = nullptr;
    ForEachJoint([&](const char* known, const auto& table) {
        if (name == known)
        {
            auto def = Fill(table, fields);
            if (def.bodyA == nullptr || def.bodyB == nullptr)
            {
                ThrowMisuse(name + ": bodyA and bodyB must be set");
            }
            owner.RequireUnlocked("b2World.CreateJoint");
            ++owner.epoch; // contacts of bodies that no longer collide are destroyed
            joint = owner.world.CreateJoint(&def);
        }
    });
    CheckMisuse();
    return joint;
}

void BindDefinitions(py::module_& module)
{
    py::dict defaults;
    defaults["b2BodyDef"] = Defaults(kBody);
    defaults["b2FixtureDef"] = Defaults(kFixture);
    ForEachJoint([&](const char* name, const auto& table) { defaults[name] = Defaults(table); });
    module.attr("_defaults") = defaults;
}

} // namespace boxreel::python
