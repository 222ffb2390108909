// SPDX-License-Identifier: MIT
#pragma once

#include "JointKind.h"

#include <Box2D/Dynamics/Joints/b2RopeJoint.h>

namespace box2d
{

template <>
struct JointAccess::Kind<b2RopeJoint> : NoMotor, NoSpring
{
    using Definition = b2RopeJointDef;
    static constexpr JointHold kHold = JointHold::kLine;
    static constexpr bool kHoldsToWorld = false;
    static constexpr JointLines kLines = JointLines::kToOrigins;
    static constexpr uint32 kFormat = 0;

    static bool IsSound(const Definition& d)
    {
        return AreAnchors(d.localAnchorA, d.localAnchorB) && IsLength(d.maxLength);
    }

    template <class Archive>
    static void Visit(Archive& archive, b2RopeJoint& j)
    {
        static_assert(kHasSize<b2RopeJoint, 176>, "Say here what becomes of the new member.");
        archive(j.m_localAnchorA, j.m_localAnchorB, j.m_maxLength);
        archive(j.m_impulse, j.m_axis, j.m_length);
    }
};

} // namespace box2d
