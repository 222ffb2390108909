// SPDX-License-Identifier: MIT
#pragma once

#include "DistanceKind.h"
#include "FrictionKind.h"
#include "GearKind.h"
#include "MotorKind.h"
#include "MouseKind.h"
#include "PrismaticKind.h"
#include "PulleyKind.h"
#include "RevoluteKind.h"
#include "RopeKind.h"
#include "WeldKind.h"
#include "WheelKind.h"

#include <type_traits>

class b2BlockAllocator;

/// The table of joints. A new kind is one case here. The compiler then requires its
/// JointAccess::Kind and its lanes (JointKernels.h).
namespace box2d
{

template <class Joint>
using JointTag = std::type_identity<Joint>;

#pragma GCC diagnostic push
#pragma GCC diagnostic error "-Wswitch" // a word of b2JointType without a case does not compile

/// Returns the result of `function` for the tag of a kind, or a default value for an unknown type.
template <class Function>
constexpr auto WithType(b2JointType type, Function&& function)
{
    switch (type)
    {
    case e_unknownJoint:
        break;
    case e_revoluteJoint:
        return function(JointTag<b2RevoluteJoint>());
    case e_prismaticJoint:
        return function(JointTag<b2PrismaticJoint>());
    case e_distanceJoint:
        return function(JointTag<b2DistanceJoint>());
    case e_pulleyJoint:
        return function(JointTag<b2PulleyJoint>());
    case e_mouseJoint:
        return function(JointTag<b2MouseJoint>());
    case e_gearJoint:
        return function(JointTag<b2GearJoint>());
    case e_wheelJoint:
        return function(JointTag<b2WheelJoint>());
    case e_weldJoint:
        return function(JointTag<b2WeldJoint>());
    case e_frictionJoint:
        return function(JointTag<b2FrictionJoint>());
    case e_ropeJoint:
        return function(JointTag<b2RopeJoint>());
    case e_motorJoint:
        return function(JointTag<b2MotorJoint>());
    }
    return decltype(function(JointTag<b2RevoluteJoint>()))();
}

#pragma GCC diagnostic pop

/// The same for the kind of a joint. `function` gets the joint by its class.
template <class Function>
auto WithJoint(const b2Joint& joint, Function&& function)
{
    return WithType(joint.GetType(), [&]<class Joint>(JointTag<Joint>) {
        return function(static_cast<const Joint&>(joint));
    });
}

/// True if a number is a kind of joint.
constexpr bool IsJointType(b2JointType type)
{
    return WithType(type, [](auto) { return true; });
}

/// True if a definition has two different bodies, and numbers that a solver can work with. With
/// asserts on, the error is reported.
bool IsSound(const b2JointDef& def);
/// From a sound definition; in no list yet.
b2Joint& ConstructJoint(const b2JointDef& def, b2BlockAllocator& allocator);
/// Gives its memory back; it must be out of every list.
void DestructJoint(b2Joint& joint, b2BlockAllocator& allocator);

/// Returns the sum of the kinds' formats, which a snapshot's version contains.
constexpr uint32 JointFormats()
{
    uint32 sum = 0;
    for (int type = e_revoluteJoint; IsJointType(b2JointType(type)); ++type)
    {
        sum += WithType(b2JointType(type), []<class Joint>(JointTag<Joint>) {
            return JointAccess::Kind<Joint>::kFormat;
        });
    }
    return sum;
}

inline JointHold HoldOf(const b2Joint& joint)
{
    return WithType(joint.GetType(),
                    []<class Joint>(JointTag<Joint>) { return JointAccess::Kind<Joint>::kHold; });
}

inline bool HoldsToWorld(const b2Joint& joint)
{
    return WithType(joint.GetType(), []<class Joint>(JointTag<Joint>) {
        return JointAccess::Kind<Joint>::kHoldsToWorld;
    });
}

inline JointLines LinesOf(const b2Joint& joint)
{
    return WithType(joint.GetType(),
                    []<class Joint>(JointTag<Joint>) { return JointAccess::Kind<Joint>::kLines; });
}

/// The bodies of a joint do not rest while its motor moves them at its target speed, even a slow
/// one.
void KeepDrivenAwake(b2Joint& joint);

/// Calls `function` with each joint whose bodies this one moves: a gear's two, or the joint itself.
template <class Function>
void ForParts(b2Joint& joint, Function&& function)
{
    if (joint.GetType() == e_gearJoint)
    {
        auto& gear = static_cast<b2GearJoint&>(joint);
        function(*gear.GetJoint1());
        function(*gear.GetJoint2());
    }
    else
    {
        function(joint);
    }
}

} // namespace box2d
