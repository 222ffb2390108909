// SPDX-License-Identifier: MIT
#pragma once

#include "JointKind.h"

#include <Box2D/Dynamics/Joints/b2MouseJoint.h>

namespace box2d
{

template <>
struct JointAccess::Kind<b2MouseJoint> : NoMotor
{
    using Definition = b2MouseJointDef;
    static constexpr JointHold kHold = JointHold::kTarget;
    static constexpr bool kHoldsToWorld = true;
    static constexpr JointLines kLines = JointLines::kLink;
    static constexpr uint32 kFormat = 0;

    static bool IsSound(const Definition& d)
    {
        return IsTarget(d.target) && AreForces(d.maxForce, 0.0f) &&
               IsSpring(d.frequencyHz, d.dampingRatio);
    }
    static bool HasSpring(const b2MouseJoint&) { return true; }
    static SpringState SpringOf(const b2MouseJoint& joint, const JointPair& pair);

    template <class Archive>
    static void Visit(Archive& archive, b2MouseJoint& j)
    {
        static_assert(kHasSize<b2MouseJoint, 176>, "Say here what becomes of the new member.");
        archive(j.m_localAnchorB, j.m_target, j.m_maxForce, j.m_frequencyHz, j.m_dampingRatio);
        archive(j.m_impulse);
    }
};

} // namespace box2d
