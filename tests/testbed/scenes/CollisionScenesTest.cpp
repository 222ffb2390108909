// SPDX-License-Identifier: MIT
#include "ScenePlay.h"

#include <gtest/gtest.h>

// Scenes with bodies that slide, spin or are thrown at thin shapes.
namespace boxreel
{
namespace
{

TEST(ChainSlideScene, KeepsEnergyOfBoxAndBall)
{
    const std::unique_ptr<Scene> scene = Make("Chain Slide");
    const b2Body* box = Movers(*scene).front();
    const b2Body* ball = Movers(*scene).back();
    // Until both are on the level part, before the ball comes back from its end.
    float32 fallen = 0.0f;
    const auto energy = [](const b2Body* body) {
        const float32 speed = body->GetLinearVelocity().Length();
        const float32 spin = body->GetAngularVelocity();
        return body->GetMass() * (0.5f * speed * speed + 10.0f * body->GetPosition().y) +
               0.5f * spin * spin * body->GetInertia();
    };
    Play(*scene, 0.8f); // both have landed on the slide
    const float32 ballEnergy = energy(ball);
    const float32 boxEnergy = energy(box);
    Play(*scene, 1.0f, [&] { fallen = std::max(fallen, -box->GetLinearVelocity().y); });
    EXPECT_GT(fallen, 5.0f) << "it slid";
    EXPECT_NEAR(energy(ball) / ballEnergy, 1.0f, 0.01f);
    EXPECT_NEAR(energy(box) / boxEnergy, 1.0f, 0.02f);
}

TEST(GhostBumpsScene, HasNoBumpsAtSeams)
{
    const std::unique_ptr<Scene> scene = Make("Ghost Bumps");
    const std::vector<b2Body*> boxes = Movers(*scene); // on the chain, the edges, the boxes
    std::vector<float32> bumps(3, 0.0f);
    Play(*scene, 4.0f, [&] { // until they have come to the far end
        for (std::size_t i = 0; i < 3; ++i)
        {
            bumps[i] = std::max(bumps[i], std::abs(boxes[i]->GetLinearVelocity().y));
        }
    });
    EXPECT_LT(bumps[0], 1e-5f);
    EXPECT_LT(bumps[1], 1e-5f);
    EXPECT_LT(bumps[2], 1e-2f);
    EXPECT_EQ(boxes[0]->GetLinearVelocity().x, 8.0f);
    Play(*scene, 3.0f);
    EXPECT_NEAR(boxes[0]->GetLinearVelocity().x, -8.0f, 0.01f) << "back from the buffer";
}

TEST(SkinnyBoxScene, KeepsBoxAboveGround)
{
    const std::unique_ptr<Scene> scene = Make("Skinny Box");
    const b2Body* box = Movers(*scene).front();
    float32 lowest = 1.0f;
    Play(*scene, 30.0f, [&] { lowest = std::min(lowest, box->GetPosition().y); });
    EXPECT_GT(lowest, -0.01f);
    EXPECT_EQ(scene->Describe().front().second, "30");
}

TEST(SkinnyBoxScene, ThrowsBoxAgainByKey)
{
    const std::unique_ptr<Scene> scene = Make("Skinny Box");
    ASSERT_EQ(scene->Keys().size(), 1u);
    Play(*scene, 0.5f);
    scene->KeyDown(scene->Keys()[0].key);
    EXPECT_EQ(scene->Describe().front().second, "2");
    EXPECT_EQ(Movers(*scene).front()->GetPosition().y, 10.0f);
}

TEST(SpinnerScene, TurnsBarAndKeepsBodiesInside)
{
    const std::unique_ptr<Scene> scene = Make("Spinner");
    const b2Body* bar = Movers(*scene).front();
    Play(*scene, 10.0f);
    EXPECT_GT(bar->GetAngle(), 25.0f);
    for (const b2Body* body : Movers(*scene))
    {
        EXPECT_LT(std::max(std::abs(body->GetPosition().x), std::abs(body->GetPosition().y)),
                  10.0f);
    }
}

} // namespace
} // namespace boxreel
