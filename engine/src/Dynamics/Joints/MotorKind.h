// SPDX-License-Identifier: MIT
#pragma once

#include "JointKind.h"

#include <Box2D/Dynamics/Joints/b2MotorJoint.h>

namespace box2d
{

template <>
struct JointAccess::Kind<b2MotorJoint> : NoSpring
{
    using Definition = b2MotorJointDef;
    static constexpr JointHold kHold = JointHold::kSlide;
    static constexpr bool kHoldsToWorld = false;
    static constexpr JointLines kLines = JointLines::kToOrigins;
    static constexpr uint32 kFormat = 0;

    static bool IsSound(const Definition& d)
    {
        return IsTarget(d.linearOffset) && IsAngle(d.angularOffset) &&
               AreForces(d.maxForce, d.maxTorque) && IsShare(d.correctionFactor);
    }
    static bool HasMotor(const b2MotorJoint&) { return true; }
    /// It drives towards a place, where it rests.
    static bool IsDriven(const b2MotorJoint&) { return false; }
    static double MaxPower(const b2MotorJoint& joint, const JointPair& pair, double step);

    template <class Archive>
    static void Visit(Archive& archive, b2MotorJoint& j)
    {
        static_assert(kHasSize<b2MotorJoint, 176>, "Say here what becomes of the new member.");
        archive(j.m_linearOffset, j.m_angularOffset, j.m_maxForce, j.m_maxTorque,
                j.m_correctionFactor);
        archive(j.m_impulse, j.m_angularImpulse);
    }
};

} // namespace box2d
