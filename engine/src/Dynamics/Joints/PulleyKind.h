// SPDX-License-Identifier: MIT
#pragma once

#include "JointKind.h"

#include <Box2D/Dynamics/Joints/b2PulleyJoint.h>

namespace box2d
{

template <>
struct JointAccess::Kind<b2PulleyJoint> : NoMotor, NoSpring
{
    using Definition = b2PulleyJointDef;
    static constexpr JointHold kHold = JointHold::kLine;
    static constexpr bool kHoldsToWorld = true;
    static constexpr JointLines kLines = JointLines::kOverPulley;
    static constexpr uint32 kFormat = 0;

    static bool IsSound(const Definition& d)
    {
        return AreAnchors(d.groundAnchorA, d.groundAnchorB) &&
               AreAnchors(d.localAnchorA, d.localAnchorB) && IsLength(d.lengthA) &&
               IsLength(d.lengthB) &&
               B2_REQUIRE(b2IsValid(d.ratio) && d.ratio > 0.0f,
                          "A pulley joint's ratio must be finite and positive.");
    }

    template <class Archive>
    static void Visit(Archive& archive, b2PulleyJoint& j)
    {
        static_assert(kHasSize<b2PulleyJoint, 200>, "Say here what becomes of the new member.");
        archive(j.m_groundAnchorA, j.m_groundAnchorB, j.m_localAnchorA, j.m_localAnchorB,
                j.m_lengthA, j.m_lengthB, j.m_ratio);
        archive(j.m_impulse, j.m_axisA, j.m_axisB);
    }
};

} // namespace box2d
