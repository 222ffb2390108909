// SPDX-License-Identifier: MIT
#pragma once

#include "JointKind.h"

#include <Box2D/Dynamics/Joints/b2GearJoint.h>

class b2Body;

namespace box2d
{

/// The two different bodies a gear connects, one of each of its joints. They are the bodies of the
/// definition, with two exceptions. Other bodies are used if these belong to none of the joints, or
/// if they would leave bodies that the gear moves in two islands. For example, a post on which a
/// gear wheel turns does not connect the wheel to anything. Null if the joints have no two
/// different bodies.
struct GearBodies
{
    b2Body* a = nullptr;
    b2Body* b = nullptr;
};
GearBodies BodiesOf(const b2GearJointDef& def);

/// True if the joint turns or slides, so that a gear can couple it. False for null.
bool CanBeGeared(const b2Joint* joint);

template <>
struct JointAccess::Kind<b2GearJoint> : NoMotor, NoSpring
{
    using Definition = b2GearJointDef;
    static constexpr JointHold kHold = JointHold::kPoint;
    static constexpr bool kHoldsToWorld = true;
    static constexpr JointLines kLines = JointLines::kToOrigins;
    static constexpr uint32 kFormat = 0;

    static bool IsSound(const Definition& d);

    /// Its two joints are known when it is made.
    template <class Archive>
    static void Visit(Archive& archive, b2GearJoint& j)
    {
        static_assert(kHasSize<b2GearJoint, 312>, "Say here what becomes of the new member.");
        for (b2GearJoint::Side* side : {&j.m_side1, &j.m_side2})
        {
            auto& [joint, frame, body, slides, localAnchorFrame, localAnchorBody, localAxis,
                   referenceAngle, axis, armFrame, armBody] = *side;
            archive(localAnchorFrame, localAnchorBody, localAxis, referenceAngle);
            archive(axis, armFrame, armBody);
        }
        archive(j.m_constant, j.m_ratio, j.m_impulse);
    }
};

} // namespace box2d
