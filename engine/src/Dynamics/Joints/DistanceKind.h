// SPDX-License-Identifier: MIT
#pragma once

#include "JointKind.h"

#include <Box2D/Dynamics/Joints/b2DistanceJoint.h>

namespace box2d
{

template <>
struct JointAccess::Kind<b2DistanceJoint> : NoMotor
{
    using Definition = b2DistanceJointDef;
    static constexpr JointHold kHold = JointHold::kLine;
    static constexpr bool kHoldsToWorld = false;
    static constexpr JointLines kLines = JointLines::kLink;
    static constexpr uint32 kFormat = 0;

    static bool IsSound(const Definition& d)
    {
        return AreAnchors(d.localAnchorA, d.localAnchorB) && IsLength(d.length) &&
               IsSpring(d.frequencyHz, d.dampingRatio) && AreLengthLimits(d.minLength, d.maxLength);
    }
    static bool HasSpring(const b2DistanceJoint& j) { return j.IsSpring(); }
    static SpringState SpringOf(const b2DistanceJoint& joint, const JointPair& pair);

    template <class Archive>
    static void Visit(Archive& archive, b2DistanceJoint& j)
    {
        static_assert(kHasSize<b2DistanceJoint, 208>, "Say here what becomes of the new member.");
        archive(j.m_localAnchorA, j.m_localAnchorB, j.m_length, j.m_frequencyHz, j.m_dampingRatio,
                j.m_minLength, j.m_maxLength, j.m_isLimited, j.m_restLength, j.m_springHz);
        archive(j.m_impulse, j.m_lowerImpulse, j.m_upperImpulse, j.m_axis);
    }
};

} // namespace box2d
