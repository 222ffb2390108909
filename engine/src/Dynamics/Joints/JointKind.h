// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Access.h"
#include "JointChecks.h"
#include "JointEnergy.h"

/// The parts that describe a kind of joint. JointAccess::Kind<Joint> (RevoluteKind.h and so on) has
///   Definition     the class of its definition
///   kHold          where it holds its bodies
///   kHoldsToWorld  true if it holds bodies to the world even if both are dynamic
///   kLines         how b2World::DrawDebugData shows it
///   IsSound        true if a definition can be made into a joint; asserts report the error
///   HasSpring, SpringOf, HasMotor, IsDriven, MaxPower   see JointEnergy.h
///   Visit          saves and restores it; see Snapshot/Archive.h
///   kFormat        part of a snapshot's version: 1 higher with every change of what Visit stores,
///                  of its order or meaning, or of how a step uses it
/// and that of hinges IsFree (RevoluteKind.h). None of them has a default: a kind without a motor
/// or a spring uses NoMotor and NoSpring.
namespace box2d
{

enum class JointHold : uint8
{
    kPoint,  ///< at a point of each body
    kLine,   ///< along a line between the points
    kSlide,  ///< both at B's point, which moves in the frame of A
    kTarget, ///< only B
};

enum class JointLines : uint8
{
    kToOrigins,  ///< between the anchors, and from each to the origin of its body
    kLink,       ///< between the anchors
    kOverPulley, ///< from each anchor to its ground anchor, and between these
};

struct NoMotor
{
    static bool HasMotor(const b2Joint&) { return false; }
    static bool IsDriven(const b2Joint&) { return false; }
    static double MaxPower(const b2Joint&, const JointPair&, double) { return 0.0; }
};

/// A motor with a target speed and a maximum force or torque.
template <class Joint, auto maxForce>
struct SpeedMotor
{
    static bool HasMotor(const Joint& joint) { return joint.IsMotorEnabled(); }
    /// A joint whose motor cannot move its bodies may rest.
    static bool IsDriven(const Joint& joint)
    {
        const float32 wanted = joint.IsMotorEnabled() ? joint.GetMotorSpeed() : 0.0f;
        return wanted != 0.0f && joint.GetJointSpeed() / wanted > 0.5f;
    }
    static double MaxPower(const Joint& joint, const JointPair&, double)
    {
        return double(b2Abs(joint.GetMotorSpeed())) * double((joint.*maxForce)());
    }
};

struct NoSpring
{
    static bool HasSpring(const b2Joint&) { return false; }
    static SpringState SpringOf(const b2Joint&, const JointPair&) { return {}; }
};

} // namespace box2d
