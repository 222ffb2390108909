// SPDX-License-Identifier: MIT
#pragma once

#include "JointKind.h"

#include <Box2D/Dynamics/Joints/b2WheelJoint.h>

namespace box2d
{

template <>
struct JointAccess::Kind<b2WheelJoint> : SpeedMotor<b2WheelJoint, &b2WheelJoint::GetMaxMotorTorque>
{
    using Definition = b2WheelJointDef;
    static constexpr JointHold kHold = JointHold::kSlide;
    static constexpr bool kHoldsToWorld = false;
    static constexpr JointLines kLines = JointLines::kToOrigins;
    static constexpr uint32 kFormat = 0;

    static bool IsSound(const Definition& d)
    {
        return AreAnchors(d.localAnchorA, d.localAnchorB) && IsAxis(d.localAxisA) &&
               IsMotor(d.motorSpeed, d.maxMotorTorque) && IsSpring(d.frequencyHz, d.dampingRatio);
    }
    static bool HasSpring(const b2WheelJoint& j) { return j.GetSpringFrequencyHz() > 0.0f; }
    static SpringState SpringOf(const b2WheelJoint& joint, const JointPair& pair);

    template <class Archive>
    static void Visit(Archive& archive, b2WheelJoint& j)
    {
        static_assert(kHasSize<b2WheelJoint, 200>, "Say here what becomes of the new member.");
        archive(j.m_localAnchorA, j.m_localAnchorB, j.m_localAxisA, j.m_enableMotor,
                j.m_maxMotorTorque, j.m_motorSpeed, j.m_frequencyHz, j.m_dampingRatio);
        archive(j.m_impulse, j.m_springImpulse, j.m_motorImpulse, j.m_axis);
    }
};

} // namespace box2d
