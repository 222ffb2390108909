// SPDX-License-Identifier: MIT
#pragma once

#include "JointKind.h"

#include <Box2D/Dynamics/Joints/b2PrismaticJoint.h>

namespace box2d
{

template <>
struct JointAccess::Kind<b2PrismaticJoint>
    : SpeedMotor<b2PrismaticJoint, &b2PrismaticJoint::GetMaxMotorForce>, NoSpring
{
    using Definition = b2PrismaticJointDef;
    static constexpr JointHold kHold = JointHold::kSlide;
    static constexpr bool kHoldsToWorld = false;
    static constexpr JointLines kLines = JointLines::kToOrigins;
    static constexpr uint32 kFormat = 0;

    static bool IsSound(const Definition& d)
    {
        return AreAnchors(d.localAnchorA, d.localAnchorB) && IsAxis(d.localAxisA) &&
               IsAngle(d.referenceAngle) &&
               AreLimits(d.enableLimit, d.lowerTranslation, d.upperTranslation) &&
               IsMotor(d.motorSpeed, d.maxMotorForce);
    }

    template <class Archive>
    static void Visit(Archive& archive, b2PrismaticJoint& j)
    {
        static_assert(kHasSize<b2PrismaticJoint, 216>, "Say here what becomes of the new member.");
        archive(j.m_localAnchorA, j.m_localAnchorB, j.m_localAxisA, j.m_referenceAngle,
                j.m_enableLimit, j.m_lowerTranslation, j.m_upperTranslation, j.m_enableMotor,
                j.m_maxMotorForce, j.m_motorSpeed);
        archive(j.m_impulse, j.m_motorImpulse, j.m_limitImpulse, j.m_axis);
    }
};

} // namespace box2d
