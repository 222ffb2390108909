// SPDX-License-Identifier: MIT
#include <Dynamics/Joints/JointKinds.h>

#include <gtest/gtest.h>

/// The table of joints: each type has its own class and definition.
namespace
{

using namespace box2d;

TEST(JointKinds, HaveTheDefinitionOfTheirType)
{
    for (int type = e_unknownJoint + 1; IsJointType(b2JointType(type)); ++type)
    {
        EXPECT_EQ(WithType(b2JointType(type),
                           []<class Joint>(JointTag<Joint>) {
                               return typename JointAccess::Kind<Joint>::Definition().type;
                           }),
                  b2JointType(type));
    }
}

TEST(JointKinds, AreElevenAndNoOtherNumber)
{
    int count = 0;
    for (int type = 0; type < 16; ++type)
    {
        count += IsJointType(b2JointType(type));
    }
    EXPECT_EQ(count, 11);
    EXPECT_FALSE(IsJointType(e_unknownJoint));
    EXPECT_FALSE(IsJointType(b2JointType(e_motorJoint + 1)));
}

} // namespace
