// SPDX-License-Identifier: MIT
#pragma once

#include "JointKind.h"

#include <Box2D/Dynamics/Joints/b2RevoluteJoint.h>

namespace box2d
{

template <>
struct JointAccess::Kind<b2RevoluteJoint>
    : SpeedMotor<b2RevoluteJoint, &b2RevoluteJoint::GetMaxMotorTorque>, NoSpring
{
    using Definition = b2RevoluteJointDef;
    static constexpr JointHold kHold = JointHold::kPoint;
    static constexpr bool kHoldsToWorld = false;
    static constexpr JointLines kLines = JointLines::kToOrigins;
    static constexpr uint32 kFormat = 0;

    static bool IsSound(const Definition& d)
    {
        return AreAnchors(d.localAnchorA, d.localAnchorB) && IsAngle(d.referenceAngle) &&
               AreLimits(d.enableLimit, d.lowerAngle, d.upperAngle) &&
               IsMotor(d.motorSpeed, d.maxMotorTorque);
    }

    /// True if the joint holds its point and applies no torque. Only such hinges may be part of a
    /// HingeTree; others are solved as rows.
    static bool IsFree(const b2RevoluteJoint& j)
    {
        return !j.IsMotorEnabled() && !j.IsLimitEnabled();
    }

    template <class Archive>
    static void Visit(Archive& archive, b2RevoluteJoint& j)
    {
        static_assert(kHasSize<b2RevoluteJoint, 200>,
                      "Say here what becomes of the new member, and in IsFree.");
        archive(j.m_localAnchorA, j.m_localAnchorB, j.m_referenceAngle, j.m_enableLimit,
                j.m_lowerAngle, j.m_upperAngle, j.m_enableMotor, j.m_motorSpeed,
                j.m_maxMotorTorque);
        archive(j.m_impulse, j.m_motorImpulse, j.m_limitImpulse);
    }
};

} // namespace box2d
