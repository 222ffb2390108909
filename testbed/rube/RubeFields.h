// SPDX-License-Identifier: MIT
#pragma once

#include "RubeScene.h"

/// The list of the members of a scene file that are a number, a vector or a yes. For each of them,
/// in the order of a written file, VisitFields calls visit(name, member, range, getter). The reader
/// (RubeText.cpp), the writer (RubeWriter.cpp) and the exporter (RubeExport.cpp) each pass a
/// visitor of their own. The getter is that of the engine's class, or nullptr.
namespace boxreel
{

/// The numbers that a member may have, and its value if the file has none. For a yes or no, only
/// the latter is given.
struct RubeRange
{
    float32 minimum = 0.0f;
    float32 maximum = 0.0f;
    float32 fallback = 0.0f;
    const char* oldName = nullptr; ///< in old files
    bool isRequired = false;
};

// Limits that no sane scene reaches and that keep every later product finite.
constexpr float32 kFarthest = 1e6f;   ///< coordinates and lengths: floats are 6 cm apart there [m]
constexpr float32 kFastest = 1e6f;    ///< velocities [m/s, rad/s]
constexpr float32 kStrongest = 1e12f; ///< forces, torques, masses, densities
constexpr float32 kLargest = 1e6f;    ///< everything without a unit, damping and frequencies

constexpr RubeRange kPoint{-kFarthest, kFarthest};
constexpr RubeRange kLength{0.0f, kFarthest};
constexpr RubeRange kAngle{-1e6f, 1e6f}; ///< [rad]
constexpr RubeRange kSpeed{-kFastest, kFastest};
constexpr RubeRange kForce{0.0f, kStrongest};
constexpr RubeRange kNumber{0.0f, kLargest};
constexpr RubeRange kAxis{-kFarthest, kFarthest, 0.0f, "localAxis1"};

void VisitFields(RubeWorld& world, const auto& visit)
{
    visit("gravity", world.gravity, RubeRange{-kLargest, kLargest}, &b2World::GetGravity);
    visit("allowSleep", world.allowSleep, true, &b2World::GetAllowSleeping);
    visit("autoClearForces", world.autoClearForces, true, &b2World::GetAutoClearForces);
    visit("warmStarting", world.warmStarting, true, &b2World::GetWarmStarting);
    visit("continuousPhysics", world.continuousPhysics, true, &b2World::GetContinuousPhysics);
    visit("subStepping", world.subStepping, false, &b2World::GetSubStepping);
    visit("stepsPerSecond", world.stepsPerSecond, RubeRange{1.0f, 100000.0f, 60.0f}, nullptr);
    visit("velocityIterations", world.velocityIterations, RubeRange{1.0f, 1000.0f, 8.0f}, nullptr);
    visit("positionIterations", world.positionIterations, RubeRange{1.0f, 1000.0f, 3.0f}, nullptr);
}

void VisitFields(b2BodyDef& body, const auto& visit)
{
    visit("type", body.type, RubeRange{0.0f, 2.0f}, &b2Body::GetType);
    visit("position", body.position, kPoint, &b2Body::GetPosition);
    visit("angle", body.angle, kAngle, &b2Body::GetAngle);
    visit("linearVelocity", body.linearVelocity, kSpeed, &b2Body::GetLinearVelocity);
    visit("angularVelocity", body.angularVelocity, kSpeed, &b2Body::GetAngularVelocity);
    visit("linearDamping", body.linearDamping, kNumber, &b2Body::GetLinearDamping);
    visit("angularDamping", body.angularDamping, kNumber, &b2Body::GetAngularDamping);
    visit("gravityScale", body.gravityScale, RubeRange{-kLargest, kLargest, 1.0f},
          &b2Body::GetGravityScale);
    visit("bullet", body.bullet, false, &b2Body::IsBullet);
    visit("allowSleep", body.allowSleep, true, &b2Body::IsSleepingAllowed);
    visit("awake", body.awake, false, &b2Body::IsAwake);
    visit("active", body.active, true, &b2Body::IsActive);
    visit("fixedRotation", body.fixedRotation, false, &b2Body::IsFixedRotation);
}

void VisitFields(b2FixtureDef& fixture, const auto& visit)
{
    // Some writers print the sixteen bits as a signed number; -1 and 65535 are the same mask.
    const auto categories = [](const b2Fixture& f) { return f.GetFilterData().categoryBits; };
    const auto mask = [](const b2Fixture& f) { return f.GetFilterData().maskBits; };
    const auto group = [](const b2Fixture& f) { return f.GetFilterData().groupIndex; };
    b2Filter& filter = fixture.filter;
    visit("density", fixture.density, kForce, &b2Fixture::GetDensity);
    visit("friction", fixture.friction, kNumber, &b2Fixture::GetFriction);
    visit("restitution", fixture.restitution, kNumber, &b2Fixture::GetRestitution);
    visit("sensor", fixture.isSensor, false, &b2Fixture::IsSensor);
    visit("filter-categoryBits", filter.categoryBits, RubeRange{-32768, 65535, 1}, categories);
    visit("filter-maskBits", filter.maskBits, RubeRange{-32768, 65535, 65535}, mask);
    visit("filter-groupIndex", filter.groupIndex, RubeRange{-32768, 32767}, group);
}

// ---- Joints

/// Of revolute and prismatic joints.
template <class Joint>
void VisitLimitAndMotor(auto& joint, float32& lower, float32& upper, RubeRange range,
                        const auto& visit)
{
    visit("refAngle", joint.referenceAngle, kAngle, &Joint::GetReferenceAngle);
    visit("enableLimit", joint.enableLimit, false, &Joint::IsLimitEnabled);
    visit("lowerLimit", lower, range, &Joint::GetLowerLimit);
    visit("upperLimit", upper, range, &Joint::GetUpperLimit);
    visit("enableMotor", joint.enableMotor, false, &Joint::IsMotorEnabled);
    visit("motorSpeed", joint.motorSpeed, kSpeed, &Joint::GetMotorSpeed);
}

template <class Joint>
void VisitSpring(auto& joint, const auto& visit)
{
    visit("frequency", joint.frequencyHz, kNumber, &Joint::GetFrequency);
    visit("dampingRatio", joint.dampingRatio, kNumber, &Joint::GetDampingRatio);
}

void VisitFields(std::monostate&, const auto&) {}

void VisitFields(RubeRevolute& joint, const auto& visit)
{
    using Joint = b2RevoluteJoint;
    VisitLimitAndMotor<Joint>(joint, joint.lowerAngle, joint.upperAngle, kAngle, visit);
    visit("maxMotorTorque", joint.maxMotorTorque, kForce, &Joint::GetMaxMotorTorque);
}

void VisitFields(RubeDistance& joint, const auto& visit)
{
    visit("length", joint.length, kLength, &b2DistanceJoint::GetLength);
    VisitSpring<b2DistanceJoint>(joint, visit);
}

void VisitFields(RubePrismatic& joint, const auto& visit)
{
    using Joint = b2PrismaticJoint;
    visit("localAxisA", joint.localAxisA, kAxis, &Joint::GetLocalAxisA);
    VisitLimitAndMotor<Joint>(joint, joint.lowerTranslation, joint.upperTranslation, kPoint, visit);
    visit("maxMotorForce", joint.maxMotorForce, kForce, &Joint::GetMaxMotorForce);
}

void VisitFields(RubePulley& joint, const auto& visit)
{
    visit("groundAnchorA", joint.groundAnchorA, kPoint, &b2PulleyJoint::GetGroundAnchorA);
    visit("groundAnchorB", joint.groundAnchorB, kPoint, &b2PulleyJoint::GetGroundAnchorB);
    visit("lengthA", joint.lengthA, kLength, &b2PulleyJoint::GetDefinedLengthA);
    visit("lengthB", joint.lengthB, kLength, &b2PulleyJoint::GetDefinedLengthB);
    visit("ratio", joint.ratio, RubeRange{0.0f, kLargest, 1.0f}, &b2PulleyJoint::GetRatio);
}

void VisitFields(RubeMouse& joint, const auto& visit)
{
    visit("target", joint.target, kPoint, &b2MouseJoint::GetTarget);
    visit("maxForce", joint.maxForce, kForce, &b2MouseJoint::GetMaxForce);
    VisitSpring<b2MouseJoint>(joint, visit);
}

void VisitFields(RubeGear& joint, const auto& visit)
{
    // The builder checks that there are such joints.
    constexpr RubeRange kIndex{.maximum = 1e9f, .isRequired = true};
    visit("joint1", joint.index1, kIndex, nullptr);
    visit("joint2", joint.index2, kIndex, nullptr);
    visit("ratio", joint.ratio, RubeRange{-kLargest, kLargest, 1.0f}, &b2GearJoint::GetRatio);
}

void VisitFields(RubeWheel& joint, const auto& visit)
{
    visit("localAxisA", joint.localAxisA, kAxis, &b2WheelJoint::GetLocalAxisA);
    visit("enableMotor", joint.enableMotor, false, &b2WheelJoint::IsMotorEnabled);
    visit("motorSpeed", joint.motorSpeed, kSpeed, &b2WheelJoint::GetMotorSpeed);
    visit("maxMotorTorque", joint.maxMotorTorque, kForce, &b2WheelJoint::GetMaxMotorTorque);
    visit("springFrequency", joint.frequencyHz, kNumber, &b2WheelJoint::GetSpringFrequencyHz);
    visit("springDampingRatio", joint.dampingRatio, kNumber, &b2WheelJoint::GetSpringDampingRatio);
}

void VisitFields(RubeMotor& joint, const auto& visit)
{
    // Old files have the offset where other joints have their anchor.
    constexpr RubeRange kOffset{-kFarthest, kFarthest, 0.0f, "anchorA"};
    constexpr RubeRange kCorrection{0.0f, 1.0f, 0.3f};
    visit("linearOffset", joint.linearOffset, kOffset, &b2MotorJoint::GetLinearOffset);
    visit("refAngle", joint.angularOffset, kAngle, &b2MotorJoint::GetAngularOffset);
    visit("maxForce", joint.maxForce, kForce, &b2MotorJoint::GetMaxForce);
    visit("maxTorque", joint.maxTorque, kForce, &b2MotorJoint::GetMaxTorque);
    visit("correctionFactor", joint.correctionFactor, kCorrection,
          &b2MotorJoint::GetCorrectionFactor);
}

void VisitFields(RubeWeld& joint, const auto& visit)
{
    visit("refAngle", joint.referenceAngle, kAngle, &b2WeldJoint::GetReferenceAngle);
    VisitSpring<b2WeldJoint>(joint, visit);
}

void VisitFields(RubeFriction& joint, const auto& visit)
{
    visit("maxForce", joint.maxForce, kForce, &b2FrictionJoint::GetMaxForce);
    visit("maxTorque", joint.maxTorque, kForce, &b2FrictionJoint::GetMaxTorque);
}

void VisitFields(RubeRope& joint, const auto& visit)
{
    visit("maxLength", joint.maxLength, kLength, &b2RopeJoint::GetMaxLength);
}

/// The name of a kind in files, its type in the engine, and a joint of it.
struct RubeKindName
{
    const char* name;
    b2JointType type;
    RubeDetails empty;
};

inline const RubeKindName kRubeKinds[] = {{"revolute", e_revoluteJoint, RubeRevolute()},
                                          {"distance", e_distanceJoint, RubeDistance()},
                                          {"prismatic", e_prismaticJoint, RubePrismatic()},
                                          {"pulley", e_pulleyJoint, RubePulley()},
                                          {"mouse", e_mouseJoint, RubeMouse()},
                                          {"gear", e_gearJoint, RubeGear()},
                                          {"wheel", e_wheelJoint, RubeWheel()},
                                          {"motor", e_motorJoint, RubeMotor()},
                                          {"weld", e_weldJoint, RubeWeld()},
                                          {"friction", e_frictionJoint, RubeFriction()},
                                          {"rope", e_ropeJoint, RubeRope()}};

} // namespace boxreel
