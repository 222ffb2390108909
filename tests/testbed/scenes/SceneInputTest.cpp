// SPDX-License-Identifier: MIT
#include <golden/StateHash.h>
#include <scenes/Parts.h>
#include <scenes/Scene.h>
#include <scenes/SceneSnapshot.h>

#include <gtest/gtest.h>

#include <cmath>

// The response of every scene to the mouse, bombs and a shifted origin.
namespace boxreel
{
namespace
{

/// Two boxes, one over the other's place, without gravity.
class TwoBoxes : public Scene
{
public:
    TwoBoxes() : Scene(SceneSettings{})
    {
        m_world.SetGravity(b2Vec2(0.0f, 0.0f));
        AddGroundBox(m_world, b2Vec2(10.0f, 0.0f), 1.0f, 1.0f);
        older = AddBox(m_world, b2Vec2(0.0f, 0.0f), 1.0f, 1.0f);
        younger = AddBox(m_world, b2Vec2(0.0f, 5.0f), 1.0f, 1.0f);
    }

    void Steps(int count)
    {
        for (int i = 0; i < count; ++i)
        {
            Step(StepSettings{});
        }
    }

    void JointGone(b2Joint*) override { ++gone; }

    b2Body* older;
    b2Body* younger;
    int gone = 0;
};

TEST(SceneInput, DragsBodyUnderMouse)
{
    TwoBoxes scene;
    scene.MouseDown(b2Vec2(0.5f, 0.0f));
    scene.MouseMove(b2Vec2(-4.0f, -3.0f));
    scene.Steps(300);
    EXPECT_LT((scene.older->GetWorldPoint(b2Vec2(0.5f, 0.0f)) - b2Vec2(-4.0f, -3.0f)).Length(),
              0.05f);
    EXPECT_EQ(scene.younger->GetPosition().y, 5.0f);
}

TEST(SceneInput, RemovesJointOnRelease)
{
    TwoBoxes scene;
    scene.MouseDown(b2Vec2(0.5f, 0.0f));
    EXPECT_EQ(scene.World().GetJointCount(), 1);
    scene.MouseUp(b2Vec2(0.5f, 0.0f));
    EXPECT_EQ(scene.World().GetJointCount(), 0);
    scene.MouseUp(b2Vec2(0.5f, 0.0f));
    EXPECT_EQ(scene.gone, 0);
}

TEST(SceneInput, GripsOnlyDynamicBodies)
{
    TwoBoxes scene;
    scene.MouseDown(b2Vec2(10.0f, 0.0f));
    scene.MouseDown(b2Vec2(-30.0f, 0.0f));
    scene.MouseMove(b2Vec2(0.0f, 0.0f));
    scene.MouseUp(b2Vec2(0.0f, 0.0f));
    EXPECT_EQ(scene.World().GetJointCount(), 0);
    EXPECT_EQ(scene.World().GetBodyCount(), 3);
}

TEST(SceneInput, GripsYoungestOfOverlappingBodies)
{
    TwoBoxes scene;
    scene.younger->SetTransform(b2Vec2(0.5f, 0.0f), 0.0f);
    scene.MouseDown(b2Vec2(0.5f, 0.0f));
    EXPECT_EQ(scene.World().GetJointList()->GetBodyB(), scene.younger);
}

TEST(SceneInput, EndsGripWhenBodyIsDestroyed)
{
    TwoBoxes scene;
    scene.MouseDown(b2Vec2(0.0f, 0.0f));
    scene.World().DestroyBody(scene.older);
    EXPECT_EQ(scene.gone, 1);
    scene.MouseMove(b2Vec2(1.0f, 0.0f));
    scene.MouseUp(b2Vec2(1.0f, 0.0f));
    scene.Steps(10);
}

TEST(SceneInput, ReplacesPreviousBomb)
{
    TwoBoxes scene;
    scene.ThrowBomb(b2Vec2(-20.0f, 0.0f), b2Vec2(60.0f, 0.0f));
    scene.Steps(25);
    EXPECT_GT(scene.older->GetLinearVelocity().x, 1.0f);
    const int32 bodies = scene.World().GetBodyCount();
    scene.ThrowBomb();
    EXPECT_EQ(scene.World().GetBodyCount(), bodies);
    const b2Body* bomb = scene.World().GetBodyList();
    EXPECT_EQ(bomb->GetPosition().y, 30.0f);
    EXPECT_LT(std::abs(bomb->GetPosition().x), 15.0f);
    EXPECT_EQ(bomb->GetLinearVelocity().y, -150.0f);
}

TEST(SceneInput, ShiftsTargetWithOrigin)
{
    TwoBoxes scene;
    scene.MouseDown(b2Vec2(0.0f, 0.0f));
    scene.MouseMove(b2Vec2(1.0f, 0.0f));
    scene.ShiftOrigin(b2Vec2(100.0f, 0.0f));
    scene.Steps(300);
    EXPECT_LT((scene.older->GetPosition() - b2Vec2(-99.0f, 0.0f)).Length(), 0.05f);
}

TEST(SceneInput, KeepsGripAndBombInSnapshots)
{
    TwoBoxes scene;
    scene.ThrowBomb();
    scene.MouseDown(b2Vec2(0.5f, 0.5f));
    scene.MouseMove(b2Vec2(-4.0f, -3.0f));
    scene.Steps(20);
    const std::vector<uint8> saved = SaveScene(scene);
    const auto goOn = [](TwoBoxes& from) {
        from.MouseMove(b2Vec2(3.0f, 1.0f));
        from.Steps(20);
        from.MouseUp(b2Vec2(3.0f, 1.0f));
        from.ThrowBomb();
        from.Steps(20);
        return StateHash(from.World());
    };
    TwoBoxes other;
    ASSERT_EQ(RestoreScene(other, saved), "");
    EXPECT_EQ(goOn(other), goOn(scene));
}

} // namespace
} // namespace boxreel
