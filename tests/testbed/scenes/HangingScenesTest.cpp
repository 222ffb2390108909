// SPDX-License-Identifier: MIT
#include "ScenePlay.h"

// Scenes of what hangs.
namespace boxreel
{
namespace
{

TEST(JointGridScene, SwingsFromItsNailAndStaysWhole)
{
    const auto scene = Make("Joint Grid");
    ASSERT_EQ(Movers(*scene).size(), 16u * 16u - 1u);
    const b2Body* corner = Movers(*scene).back();
    float32 widest = 0.0f;
    float32 leftmost = 100.0f;
    Play(*scene, 4.0f, [&] {
        widest = std::max(widest, WidestHingeGap(*scene));
        leftmost = std::min(leftmost, corner->GetPosition().x);
    });
    EXPECT_LT(widest, 0.3f);
    EXPECT_LT(leftmost, -9.5f) << "it swings past its nail, which is at -7.5 m";
}

} // namespace
} // namespace boxreel
