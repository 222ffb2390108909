// SPDX-License-Identifier: MIT
#pragma once

#include "JointKind.h"

#include <Box2D/Dynamics/Joints/b2FrictionJoint.h>

namespace box2d
{

template <>
struct JointAccess::Kind<b2FrictionJoint> : NoMotor, NoSpring
{
    using Definition = b2FrictionJointDef;
    static constexpr JointHold kHold = JointHold::kPoint;
    static constexpr bool kHoldsToWorld = false;
    static constexpr JointLines kLines = JointLines::kToOrigins;
    static constexpr uint32 kFormat = 0;

    static bool IsSound(const Definition& d)
    {
        return AreAnchors(d.localAnchorA, d.localAnchorB) && AreForces(d.maxForce, d.maxTorque);
    }

    template <class Archive>
    static void Visit(Archive& archive, b2FrictionJoint& j)
    {
        static_assert(kHasSize<b2FrictionJoint, 176>, "Say here what becomes of the new member.");
        archive(j.m_localAnchorA, j.m_localAnchorB, j.m_maxForce, j.m_maxTorque);
        archive(j.m_impulse, j.m_angularImpulse);
    }
};

} // namespace box2d
