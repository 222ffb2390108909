// SPDX-License-Identifier: MIT
#include "ScenePlay.h"

// Scenes of what hangs.
namespace boxreel
{
namespace
{

TEST(JointGridScene, SagsAndWavesLikeACloth)
{
    const auto scene = Make("Joint Grid");
    const std::vector<b2Body*> balls = Movers(*scene);
    ASSERT_EQ(balls.size(), 16u * 16u - 2u);
    // A stiff plate would do neither.
    const b2Body* free = balls[13];  // the end of the top row
    const b2Body* middle = balls[4]; // of the top row, between the nails
    const float32 freeStart = free->GetPosition().y;
    const float32 middleStart = middle->GetPosition().y;
    float32 lowest = freeStart;
    float32 longest = 0.0f;
    Play(*scene, 6.0f, [&] {
        lowest = std::min(lowest, free->GetPosition().y);
        for (b2Joint* joint = scene->World().GetJointList(); joint; joint = joint->GetNext())
        {
            longest = std::max(longest, b2Distance(joint->GetAnchorA(), joint->GetAnchorB()));
        }
    });
    EXPECT_LT(lowest, freeStart - 4.0f) << "the free end falls";
    EXPECT_LT(middle->GetPosition().y, middleStart - 1.0f) << "it sags between the nails";
    EXPECT_LT(longest, 2.0f) << "springs of a metre that are torn out";
    EXPECT_GT(longest, 1.05f);
}

} // namespace
} // namespace boxreel
