// SPDX-License-Identifier: MIT
#include "JointKinds.h"

#include <Box2D/Common/b2BlockAllocator.h>

namespace box2d
{

namespace
{

bool IsDriven(const b2Joint& joint)
{
    return WithJoint(
        joint, []<class Joint>(const Joint& j) { return JointAccess::Kind<Joint>::IsDriven(j); });
}

} // namespace

bool IsSound(const b2JointDef& def)
{
    return B2_REQUIRE(def.bodyA && def.bodyB, "A joint needs two bodies: set bodyA and bodyB.") &&
           B2_REQUIRE(def.bodyA != def.bodyB, "A joint needs two different bodies.") &&
           B2_REQUIRE(IsJointType(def.type),
                      "b2World::CreateJoint: the definition's type is not that of a joint.") &&
           WithType(def.type, [&def]<class Joint>(JointTag<Joint>) {
               using Kind = JointAccess::Kind<Joint>;
               return Kind::IsSound(static_cast<const typename Kind::Definition&>(def));
           });
}

b2Joint& ConstructJoint(const b2JointDef& def, b2BlockAllocator& allocator)
{
    return *WithType(def.type, [&]<class Joint>(JointTag<Joint>) {
        void* memory = allocator.Allocate(int32(sizeof(Joint)));
        return JointAccess::Construct<Joint>(memory, def);
    });
}

void DestructJoint(b2Joint& joint, b2BlockAllocator& allocator)
{
    const int32 size = WithType(joint.GetType(),
                                []<class Joint>(JointTag<Joint>) { return int32(sizeof(Joint)); });
    JointAccess::Destruct(joint);
    allocator.Free(&joint, size);
}

void KeepDrivenAwake(b2Joint& joint)
{
    BodyData& a = Data(*joint.GetBodyA());
    BodyData& b = Data(*joint.GetBodyB());
    // Seldom asked: what moves fast has no time of rest.
    if ((a.sleepTime > 0.0f || b.sleepTime > 0.0f) && IsDriven(joint))
    {
        a.sleepTime = 0.0f;
        b.sleepTime = 0.0f;
    }
}

} // namespace box2d
