// SPDX-License-Identifier: MIT
#pragma once

#include "JointKind.h"

#include <Box2D/Dynamics/Joints/b2WeldJoint.h>

namespace box2d
{

template <>
struct JointAccess::Kind<b2WeldJoint> : NoMotor
{
    using Definition = b2WeldJointDef;
    static constexpr JointHold kHold = JointHold::kPoint;
    static constexpr bool kHoldsToWorld = false;
    static constexpr JointLines kLines = JointLines::kToOrigins;
    static constexpr uint32 kFormat = 0;

    static bool IsSound(const Definition& d)
    {
        return AreAnchors(d.localAnchorA, d.localAnchorB) && IsAngle(d.referenceAngle) &&
               IsSpring(d.frequencyHz, d.dampingRatio);
    }
    static bool HasSpring(const b2WeldJoint& j) { return j.GetFrequency() > 0.0f; }
    static SpringState SpringOf(const b2WeldJoint& joint, const JointPair& pair);

    template <class Archive>
    static void Visit(Archive& archive, b2WeldJoint& j)
    {
        static_assert(kHasSize<b2WeldJoint, 176>, "Say here what becomes of the new member.");
        archive(j.m_localAnchorA, j.m_localAnchorB, j.m_referenceAngle, j.m_frequencyHz,
                j.m_dampingRatio);
        archive(j.m_impulse, j.m_angularImpulse);
    }
};

} // namespace box2d
