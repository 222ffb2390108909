// SPDX-License-Identifier: MIT
#include "Definitions.h"
#include "Module.h"

/// Joints: for each kind a table of its definition's fields, and a class.
namespace boxreel::python
{
namespace
{

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

template <class Joint>
using Class = py::class_<JointHandleOf<Joint>, JointHandle>;

template <class Joint>
Class<Joint> Declare(py::module_& module, const char* name, const char* doc)
{
    return Class<Joint>(module, name, py::dynamic_attr(), HandleTraversal(), doc);
}

/// Returns what acted during a step of 1 / inv_dt seconds, or in the last step.
template <class Class, class Function>
void Reaction(Class& type, const char* name, Function function, const char* doc)
{
    type.def(
        name,
        [function](const typename Class::type& handle, py::handle inverse) {
            const float32 rate = From<float32>(inverse, "inv_dt");
            return Checked(function(handle.Get(), rate));
        },
        py::arg("inv_dt"), doc);
}

void BindBase(py::module_& module)
{
    py::class_<JointHandle> type(
        module, "b2Joint", py::dynamic_attr(), HandleTraversal(),
        "A joint, made by b2World.CreateJoint. It keeps attributes of the program.");
    Identity(type);
    UserData(type);
    ReadOnly(type, "type", &b2Joint::GetType, "The kind of the joint, such as e_revoluteJoint.");
    ReadOnly(type, "anchorA", &b2Joint::GetAnchorA, "Anchor on body A, in the world [m].");
    ReadOnly(type, "anchorB", &b2Joint::GetAnchorB, "Anchor on body B, in the world [m].");
    ReadOnly(type, "active", &b2Joint::IsActive, "True if both bodies are active.");
    ReadOnly(type, "collideConnected", &b2Joint::GetCollideConnected,
             "True if the two bodies collide.");
    type.def_property_readonly(
            "bodyA", [](const JointHandle& h) { return Wrap(*h.world, h.Get().GetBodyA()); },
            "The first body.")
        .def_property_readonly(
            "bodyB", [](const JointHandle& h) { return Wrap(*h.world, h.Get().GetBodyB()); },
            "The second body.")
        .def_property_readonly(
            "next", [](const JointHandle& h) { return Wrap(*h.world, h.Get().GetNext()); },
            "The joint created before this one, or None.")
        .def_property_readonly(
            "world",
            [](const JointHandle& h) {
                h.Get();
                return py::cast(h.world, py::return_value_policy::reference);
            },
            "The world that the joint is in.")
        .def(
            "getAsType", [](py::object self) { return self; },
            "Returns the joint, which has its own class already.")
        .def(
            "Dump", [](JointHandle& h) { h.Get().Dump(); },
            "Writes the joint as code of C++ to standard output.");
    Reaction(
        type, "GetReactionForce",
        [](const b2Joint& j, float32 inverse) { return j.GetReactionForce(inverse); },
        "Returns the force on body B [N] in a step of 1 / inv_dt seconds.");
    Reaction(
        type, "GetReactionTorque",
        [](const b2Joint& j, float32 inverse) { return j.GetReactionTorque(inverse); },
        "Returns the torque on body B [N m] in a step of 1 / inv_dt seconds.");
}

template <class Class>
void LocalAnchors(Class& type)
{
    using Joint = typename Class::type::Object;
    ReadOnly(type, "localAnchorA", &Joint::GetLocalAnchorA, "Anchor in body A's frame [m].");
    ReadOnly(type, "localAnchorB", &Joint::GetLocalAnchorB, "Anchor in body B's frame [m].");
}

/// Adds the limits; `unit` belongs to their documentation.
template <class Class>
void Limits(Class& type, const char* lowerDoc, const char* upperDoc)
{
    using H = typename Class::type;
    using Joint = typename H::Object;
    Property(type, "limitEnabled", &Joint::IsLimitEnabled, &Joint::EnableLimit,
             "True if the limits are enabled.");
    const auto set = [](H& handle, float32 lower, float32 upper) {
        handle.Get().SetLimits(lower, upper);
        CheckMisuse();
    };
    type.def_property(
            "lowerLimit", [](const H& h) { return h.Get().GetLowerLimit(); },
            [set](H& h, py::handle value) {
                set(h, From<float32>(value, "lowerLimit"), h.Get().GetUpperLimit());
            },
            lowerDoc)
        .def_property(
            "upperLimit", [](const H& h) { return h.Get().GetUpperLimit(); },
            [set](H& h, py::handle value) {
                set(h, h.Get().GetLowerLimit(), From<float32>(value, "upperLimit"));
            },
            upperDoc)
        .def_property(
            "limits",
            [](const H& h) {
                return py::make_tuple(h.Get().GetLowerLimit(), h.Get().GetUpperLimit());
            },
            [set](H& h, py::handle value) {
                const b2Vec2 limits = From<b2Vec2>(value, "limits");
                set(h, limits.x, limits.y);
            },
            "Both limits, as (lower, upper).")
        .def(
            "SetLimits",
            [set](H& h, py::handle lower, py::handle upper) {
                set(h, From<float32>(lower, "lower"), From<float32>(upper, "upper"));
            },
            py::arg("lower"), py::arg("upper"), "Sets both limits.");
}

/// Adds the motor of a rotating joint.
template <class Class>
void TorqueMotor(Class& type)
{
    using Joint = typename Class::type::Object;
    Property(type, "motorEnabled", &Joint::IsMotorEnabled, &Joint::EnableMotor,
             "True if the motor is enabled.");
    Property(type, "motorSpeed", &Joint::GetMotorSpeed, &Joint::SetMotorSpeed,
             "Target speed of the motor [rad/s].");
    Property(type, "maxMotorTorque", &Joint::GetMaxMotorTorque, &Joint::SetMaxMotorTorque,
             "Maximum torque of the motor [N m].");
    Reaction(
        type, "GetMotorTorque",
        [](const Joint& j, float32 inverse) { return j.GetMotorTorque(inverse); },
        "Returns the torque of the motor [N m] in a step of 1 / inv_dt seconds.");
    ReadOnly(type, "speed", &Joint::GetJointSpeed, "Relative angular velocity [rad/s].");
}

template <class Class>
void ForceLimits(Class& type)
{
    using Joint = typename Class::type::Object;
    Property(type, "maxForce", &Joint::GetMaxForce, &Joint::SetMaxForce, "Maximum force [N].");
    Property(type, "maxTorque", &Joint::GetMaxTorque, &Joint::SetMaxTorque,
             "Maximum torque [N m].");
}

template <class Class>
void Spring(Class& type)
{
    using Joint = typename Class::type::Object;
    Property(type, "frequency", &Joint::GetFrequency, &Joint::SetFrequency,
             "Frequency of the spring [Hz]; 0: rigid.");
    Property(type, "dampingRatio", &Joint::GetDampingRatio, &Joint::SetDampingRatio,
             "Damping ratio of the spring; 1 is critical.");
}

void BindHinges(py::module_& module)
{
    auto revolute =
        Declare<b2RevoluteJoint>(module, "b2RevoluteJoint", "A hinge: the bodies share a point.");
    LocalAnchors(revolute);
    Limits(revolute, "Lower limit of the angle [rad].", "Upper limit of the angle [rad].");
    TorqueMotor(revolute);
    ReadOnly(revolute, "angle", &b2RevoluteJoint::GetJointAngle,
             "Angle of body B relative to body A [rad].");
    ReadOnly(revolute, "referenceAngle", &b2RevoluteJoint::GetReferenceAngle,
             "Angle between the bodies at angle 0 [rad].");

    auto wheel = Declare<b2WheelJoint>(module, "b2WheelJoint", "A wheel with a suspension.");
    LocalAnchors(wheel);
    TorqueMotor(wheel);
    ReadOnly(wheel, "translation", &b2WheelJoint::GetJointTranslation,
             "Position along the axis [m].");
    ReadOnly(wheel, "localAxisA", &b2WheelJoint::GetLocalAxisA, "Axis in body A's frame.");
    Property(wheel, "springFrequencyHz", &b2WheelJoint::GetSpringFrequencyHz,
             &b2WheelJoint::SetSpringFrequencyHz, "Frequency of the suspension [Hz]; 0: none.");
    Property(wheel, "springDampingRatio", &b2WheelJoint::GetSpringDampingRatio,
             &b2WheelJoint::SetSpringDampingRatio,
             "Damping ratio of the suspension; 1 is critical.");
}

void BindSlider(py::module_& module)
{
    auto prismatic = Declare<b2PrismaticJoint>(module, "b2PrismaticJoint",
                                               "A slider: body B moves along an axis of body A.");
    LocalAnchors(prismatic);
    Limits(prismatic, "Lower limit of the translation [m].", "Upper limit of the translation [m].");
    Property(prismatic, "motorEnabled", &b2PrismaticJoint::IsMotorEnabled,
             &b2PrismaticJoint::EnableMotor, "True if the motor is enabled.");
    Property(prismatic, "motorSpeed", &b2PrismaticJoint::GetMotorSpeed,
             &b2PrismaticJoint::SetMotorSpeed, "Target speed of the motor [m/s].");
    Property(prismatic, "maxMotorForce", &b2PrismaticJoint::GetMaxMotorForce,
             &b2PrismaticJoint::SetMaxMotorForce, "Maximum force of the motor [N].");
    Reaction(
        prismatic, "GetMotorForce",
        [](const b2PrismaticJoint& j, float32 inverse) { return j.GetMotorForce(inverse); },
        "Returns the force of the motor [N] in a step of 1 / inv_dt seconds.");
    ReadOnly(prismatic, "translation", &b2PrismaticJoint::GetJointTranslation,
             "Position along the axis [m].");
    ReadOnly(prismatic, "speed", &b2PrismaticJoint::GetJointSpeed, "Speed along the axis [m/s].");
    ReadOnly(prismatic, "localAxisA", &b2PrismaticJoint::GetLocalAxisA, "Axis in body A's frame.");
    ReadOnly(prismatic, "referenceAngle", &b2PrismaticJoint::GetReferenceAngle,
             "Angle between the bodies [rad].");
    prismatic.def_property_readonly(
        "axis",
        [](const JointHandleOf<b2PrismaticJoint>& h) {
            return h.Get().GetBodyA()->GetWorldVector(h.Get().GetLocalAxisA());
        },
        "Axis in the world.");
}

void BindRopes(py::module_& module)
{
    auto distance =
        Declare<b2DistanceJoint>(module, "b2DistanceJoint", "Keeps two anchors at a distance.");
    LocalAnchors(distance);
    Spring(distance);
    Property(distance, "length", &b2DistanceJoint::GetLength, &b2DistanceJoint::SetLength,
             "Rest length [m].");
    Property(distance, "minLength", &b2DistanceJoint::GetMinLength, &b2DistanceJoint::SetMinLength,
             "Minimum length [m]; 0: none.");
    Property(distance, "maxLength", &b2DistanceJoint::GetMaxLength, &b2DistanceJoint::SetMaxLength,
             "Maximum length [m].");
    ReadOnly(distance, "currentLength", &b2DistanceJoint::GetCurrentLength,
             "Distance of the anchors [m].");

    auto rope = Declare<b2RopeJoint>(module, "b2RopeJoint", "Limits the distance of two anchors.");
    LocalAnchors(rope);
    Property(rope, "maxLength", &b2RopeJoint::GetMaxLength, &b2RopeJoint::SetMaxLength,
             "Maximum length [m].");
    ReadOnly(rope, "limitState", &b2RopeJoint::GetLimitState,
             "e_atUpperLimit while the rope is taut.");

    auto pulley = Declare<b2PulleyJoint>(module, "b2PulleyJoint",
                                         "Two bodies on a rope over two fixed points.");
    LocalAnchors(pulley);
    ReadOnly(pulley, "groundAnchorA", &b2PulleyJoint::GetGroundAnchorA,
             "Fixed point of the rope to A [m].");
    ReadOnly(pulley, "groundAnchorB", &b2PulleyJoint::GetGroundAnchorB,
             "Fixed point of the rope to B [m].");
    ReadOnly(pulley, "lengthA", &b2PulleyJoint::GetLengthA, "Length of the rope to A [m].");
    ReadOnly(pulley, "lengthB", &b2PulleyJoint::GetLengthB, "Length of the rope to B [m].");
    ReadOnly(pulley, "length1", &b2PulleyJoint::GetLengthA, "As lengthA [m].");
    ReadOnly(pulley, "length2", &b2PulleyJoint::GetLengthB, "As lengthB [m].");
    ReadOnly(pulley, "currentLengthA", &b2PulleyJoint::GetCurrentLengthA, "As lengthA [m].");
    ReadOnly(pulley, "currentLengthB", &b2PulleyJoint::GetCurrentLengthB, "As lengthB [m].");
    ReadOnly(pulley, "ratio", &b2PulleyJoint::GetRatio, "Factor of the length to B.");
}

void BindOthers(py::module_& module)
{
    auto mouse = Declare<b2MouseJoint>(module, "b2MouseJoint",
                                       "Pulls a point of body B to a point of the world.");
    Spring(mouse);
    Property(mouse, "target", &b2MouseJoint::GetTarget, &b2MouseJoint::SetTarget,
             "The point of the world [m].");
    Property(mouse, "maxForce", &b2MouseJoint::GetMaxForce, &b2MouseJoint::SetMaxForce,
             "Maximum force [N].");

    auto gear =
        Declare<b2GearJoint>(module, "b2GearJoint", "Couples two revolute or prismatic joints.");
    Property(gear, "ratio", &b2GearJoint::GetRatio, &b2GearJoint::SetRatio,
             "Factor of the second joint's coordinate.");
    gear.def_property_readonly(
            "joint1",
            [](const JointHandleOf<b2GearJoint>& h) { return Wrap(*h.world, h.Get().GetJoint1()); },
            "The first joint.")
        .def_property_readonly(
            "joint2",
            [](const JointHandleOf<b2GearJoint>& h) { return Wrap(*h.world, h.Get().GetJoint2()); },
            "The second joint.");

    auto weld = Declare<b2WeldJoint>(module, "b2WeldJoint", "Fixes two bodies to each other.");
    LocalAnchors(weld);
    Spring(weld);
    ReadOnly(weld, "referenceAngle", &b2WeldJoint::GetReferenceAngle,
             "Angle between the bodies [rad].");

    auto friction = Declare<b2FrictionJoint>(module, "b2FrictionJoint",
                                             "Top-down friction between two bodies.");
    LocalAnchors(friction);
    ForceLimits(friction);

    auto motor = Declare<b2MotorJoint>(module, "b2MotorJoint",
                                       "Drives body B to a pose relative to body A.");
    ForceLimits(motor);
    Property(motor, "linearOffset", &b2MotorJoint::GetLinearOffset, &b2MotorJoint::SetLinearOffset,
             "Target of body B's origin in body A's frame [m].");
    Property(motor, "angularOffset", &b2MotorJoint::GetAngularOffset,
             &b2MotorJoint::SetAngularOffset, "Target of body B's angle minus body A's [rad].");
    Property(motor, "correctionFactor", &b2MotorJoint::GetCorrectionFactor,
             &b2MotorJoint::SetCorrectionFactor,
             "Fraction of the error that a step corrects, 0 to 1.");
}

template <class Joint>
JointHandle* New(py::object& object)
{
    auto* handle = new JointHandleOf<Joint>();
    object = py::cast(handle, py::return_value_policy::take_ownership);
    return handle;
}

} // namespace

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

JointHandle* NewJointHandle(b2JointType type, py::object& object)
{
    switch (type)
    {
    case e_revoluteJoint:
        return New<b2RevoluteJoint>(object);
    case e_prismaticJoint:
        return New<b2PrismaticJoint>(object);
    case e_distanceJoint:
        return New<b2DistanceJoint>(object);
    case e_pulleyJoint:
        return New<b2PulleyJoint>(object);
    case e_mouseJoint:
        return New<b2MouseJoint>(object);
    case e_gearJoint:
        return New<b2GearJoint>(object);
    case e_wheelJoint:
        return New<b2WheelJoint>(object);
    case e_weldJoint:
        return New<b2WeldJoint>(object);
    case e_frictionJoint:
        return New<b2FrictionJoint>(object);
    case e_ropeJoint:
        return New<b2RopeJoint>(object);
    case e_motorJoint:
        return New<b2MotorJoint>(object);
    case e_unknownJoint:
        break;
    }
    throw std::logic_error("a joint of an unknown kind");
}

void BindJoints(py::module_& module)
{
    const py::dict defaults = module.attr("_defaults");
    ForEachJoint([&](const char* name, const auto& table) { defaults[name] = Defaults(table); });
    BindBase(module);
    BindHinges(module);
    BindSlider(module);
    BindRopes(module);
    BindOthers(module);
}

} // namespace boxreel::python
