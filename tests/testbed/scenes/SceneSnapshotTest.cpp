// SPDX-License-Identifier: MIT
#include "EveryScene.h"

#include <golden/StateHash.h>
#include <scenes/Scene.h>
#include <scenes/SceneSnapshot.h>
#include <scenes/SceneState.h>

#include <gtest/gtest.h>

#include <vector>

/// Every scene continues from a snapshot as without one. A scene that omits a member in VisitState
/// does not.
namespace boxreel
{
namespace
{

constexpr int kSteps = 400;

std::unique_ptr<Scene> Make(const SceneEntry& entry, int32 subSteps)
{
    std::unique_ptr<Scene> scene = entry.create(SceneSettings{});
    scene->World().SetSubStepCount(subSteps);
    return scene;
}

/// In a newly created scene, with other threads.
std::vector<std::uint64_t> StatesFrom(const SceneEntry& entry, const std::vector<uint8>& bytes,
                                      int first)
{
    const std::unique_ptr<Scene> scene = entry.create(SceneSettings{});
    scene->World().SetThreadCount(first % 2 + 1);
    EXPECT_EQ(RestoreScene(*scene, bytes), "");
    EXPECT_TRUE(SaveScene(*scene) == bytes);
    std::vector<std::uint64_t> states;
    for (int step = first; step < kSteps; ++step)
    {
        scene->Step(scene->PreferredSteps());
        states.push_back(StateHash(scene->World()));
    }
    return states;
}

void ExpectGoesOn(const SceneEntry& entry, int32 subSteps)
{
    const std::unique_ptr<Scene> scene = Make(entry, subSteps);
    std::vector<std::uint64_t> states;
    std::vector<std::vector<uint8>> saved;
    const int moments[] = {1, 97, 300};
    for (int step = 1; step <= kSteps; ++step)
    {
        scene->Step(scene->PreferredSteps());
        states.push_back(StateHash(scene->World()));
        if (std::find(std::begin(moments), std::end(moments), step) != std::end(moments))
        {
            saved.push_back(SaveScene(*scene));
        }
    }
    for (std::size_t i = 0; i < saved.size(); ++i)
    {
        EXPECT_TRUE(StatesFrom(entry, saved[i], moments[i]) ==
                    std::vector(states.begin() + moments[i], states.end()))
            << "from step " << moments[i] << ": does its VisitState list all that it keeps?";
    }
}

class SnapshotOfScene : public testing::TestWithParam<SceneCase>
{};

TEST_P(SnapshotOfScene, ContinuesBitForBit)
{
    ExpectGoesOn(*GetParam(), 1);
}

TEST_P(SnapshotOfScene, ContinuesBitForBitInSubSteps)
{
    ExpectGoesOn(*GetParam(), 4);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SnapshotOfScene, testing::ValuesIn(EveryScene()), CaseName);

class Keeper : public Scene
{
public:
    Keeper() : Scene(SceneSettings{})
    {
        b2BodyDef definition;
        definition.type = b2_dynamicBody;
        b2Body* const first = m_world.CreateBody(&definition);
        body = m_world.CreateBody(&definition);
        b2WeldJointDef weld;
        weld.Initialize(first, body, b2Vec2(0.0f, 0.0f));
        m_world.CreateJoint(&weld);
        joint = m_world.CreateJoint(&weld);
        m_world.CreateJoint(&weld);
    }

    void VisitState(SceneState& state) override
    {
        state(body, none, joint, flag, small, large, number, random);
    }

    b2Body* body = nullptr;
    b2Body* none = nullptr;
    b2Joint* joint = nullptr;
    bool flag = false;
    uint8 small = 0;
    double large = 0.0;
    int32 number = 0;
    Random random{1};
};

TEST(SceneSnapshot, KeepsPointersNumbersAndRandomState)
{
    Keeper saved;
    saved.flag = true;
    saved.small = 200;
    saved.large = -1e300;
    saved.number = -7;
    saved.random.Next();
    const std::vector<uint8> bytes = SaveScene(saved);
    Keeper restored;
    restored.none = restored.body;
    ASSERT_EQ(RestoreScene(restored, bytes), "");
    EXPECT_EQ(restored.body, restored.World().GetBodyList());
    EXPECT_EQ(restored.none, nullptr);
    EXPECT_EQ(restored.joint, restored.World().GetJointList()->GetNext());
    EXPECT_TRUE(restored.flag);
    EXPECT_EQ(restored.small, 200);
    EXPECT_EQ(restored.large, -1e300);
    EXPECT_EQ(restored.number, -7);
    EXPECT_EQ(restored.random.Next(), saved.random.Next());
}

TEST(SceneSnapshot, IsRefusedForSceneOfAnotherKind)
{
    Keeper keeper;
    keeper.number = 5;
    const std::vector<uint8> before = SaveScene(keeper);
    Scene plain{SceneSettings{}};
    EXPECT_NE(RestoreScene(keeper, SaveScene(plain)).find("another kind"), std::string::npos);
    EXPECT_TRUE(SaveScene(keeper) == before);
    EXPECT_EQ(keeper.body, keeper.World().GetBodyList());
    EXPECT_NE(RestoreScene(plain, before).find("another kind"), std::string::npos);
    EXPECT_EQ(plain.World().GetBodyCount(), 0);
}

TEST(SceneSnapshot, IsRefusedWithAnyByteChangedOrMissing)
{
    Keeper keeper;
    const std::vector<uint8> whole = SaveScene(keeper);
    for (std::size_t i = 0; i < whole.size(); ++i)
    {
        std::vector<uint8> bytes = whole;
        bytes[i] ^= 64;
        EXPECT_NE(RestoreScene(keeper, bytes), "") << i;
        EXPECT_NE(RestoreScene(keeper, std::span(whole).first(i)), "") << i;
    }
    EXPECT_TRUE(SaveScene(keeper) == whole);
}

} // namespace
} // namespace boxreel
