// SPDX-License-Identifier: MIT
// Scenes as pages: positions of every step, and sizes.
#include "../testbed/cli/Subprocess.h"
#include "PageReader.h"

#include <Box2D/Dynamics/b2Body.h>
#include <page/PageWriter.h>
#include <session/SessionPanels.h>

#include <gtest/gtest.h>

namespace boxreel
{
namespace
{

constexpr const char* kAllLayers = "shapes,joints,aabbs,pairs,contacts,normals,impulses,friction,"
                                   "centers,masses,velocities,forces,glyphs,names";

SceneSession Open(const std::string& scene, const std::string& layers)
{
    SceneLook look;
    look.collectEverything = true;
    look.layers = *ParseLayers("--draw", layers);
    Result<SceneSource> source = OpenScene(scene);
    EXPECT_TRUE(source);
    Result<SceneSession> session = OpenSession(std::move(*source), look);
    EXPECT_TRUE(session);
    return std::move(*session);
}

std::vector<PageBody> BodiesOf(const SceneSession& session)
{
    std::vector<PageBody> bodies;
    for (const b2Body* b = session.World().GetBodyList(); b != nullptr; b = b->GetNext())
    {
        bodies.push_back({std::uint32_t(b->GetNumber()),
                          {b->GetPosition().x, b->GetPosition().y},
                          b->GetAngle(),
                          "",
                          {b->GetLinearVelocity().x, b->GetLinearVelocity().y},
                          b->GetAngularVelocity()});
    }
    return bodies;
}

class PageScenes : public testing::Test
{
protected:
    /// Writes a page of the scene, and calls `seen` with the list of each frame.
    void Write(const std::string& scene, const std::string& layers, int frames,
               const std::function<void(const DrawList&, const std::vector<PageBody>&)>& seen = {})
    {
        SceneSession session = Open(scene, layers);
        PageSettings settings;
        settings.overwrite = true;
        Result<PageWriter> writer = PageWriter::Open(path, settings);
        ASSERT_TRUE(writer);
        for (int frame = 0; frame < frames; ++frame)
        {
            session.AdvanceTo(frame);
            FrameContent content;
            session.Fill(content);
            const std::vector<PageBody> bodies = BodiesOf(session);
            ASSERT_TRUE(writer->Append(content.list, content.camera, bodies));
            if (seen)
            {
                seen(content.list, bodies);
            }
        }
        ASSERT_TRUE(writer->Close());
    }

    TemporaryFolder folder;
    const std::filesystem::path path = folder / "scene.html";
};

class PageOfScene : public PageScenes, public testing::WithParamInterface<const char*>
{};

TEST_P(PageOfScene, HasPositionsOfDrawListInAllLayers)
{
    std::vector<DrawList> lists;
    Write(GetParam(), kAllLayers, 150,
          [&](const DrawList& list, const auto&) { lists.push_back(list); });
    const test::ReadPage page = test::ReadPageFile(path);
    ASSERT_EQ(page.frames.size(), lists.size());
    for (std::size_t i = 0; i < lists.size() && !HasFailure(); ++i)
    {
        SCOPED_TRACE("frame " + std::to_string(i));
        test::ExpectSameItems(page.frames[i], lists[i], page.fullScale);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PageOfScene,
                         testing::Values("dominos", "car", "far-pyramid", "shape-editing", "web",
                                         "add-pair-stress-test", "confined"),
                         [](const auto& scene) {
                             std::string name = scene.param;
                             std::erase(name, '-');
                             return name;
                         });

TEST_F(PageScenes, HaveTheOriginsOfBodies)
{
    std::vector<PageBody> bodies;
    Write("dominos", "shapes", 300, [&](const DrawList&, const auto& now) { bodies = now; });
    const test::ReadPage page = test::ReadPageFile(path);
    std::size_t compared = 0;
    for (const test::PageOrigin& origin : page.frames.back().origins)
    {
        const auto body = std::find_if(bodies.begin(), bodies.end(), [&](const PageBody& known) {
            return known.number == origin.owner;
        });
        ASSERT_NE(body, bodies.end());
        constexpr double kRounding = 3e-5; // of places, angles and floats [m, rad]
        EXPECT_NEAR(origin.x, double(body->position.x), kRounding) << origin.owner;
        EXPECT_NEAR(origin.y, double(body->position.y), kRounding) << origin.owner;
        EXPECT_NEAR(origin.angle, double(body->angle), kRounding) << origin.owner;
        ++compared;
    }
    EXPECT_GT(compared, 30u);
}

class StatesOfScene : public PageScenes, public testing::WithParamInterface<const char*>
{};

TEST_P(StatesOfScene, EqualThoseOfTheBodies)
{
    std::vector<std::vector<PageBody>> bodies;
    Write(GetParam(), "shapes", 260, // more than a group
          [&](const DrawList&, const auto& now) { bodies.push_back(now); });
    const test::ReadPage page = test::ReadPageFile(path);
    ASSERT_EQ(page.frames.size(), bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        const std::vector<test::PageState>& states = page.frames[i].states;
        ASSERT_EQ(states.size(), bodies[i].size()) << "frame " << i;
        for (const test::PageState& state : states)
        {
            const auto body =
                std::find_if(bodies[i].begin(), bodies[i].end(), [&](const PageBody& known) {
                    return known.number == state.place.owner;
                });
            ASSERT_NE(body, bodies[i].end());
            constexpr double kShown = 0.00051; // half of the last digit on the page [m, rad]
            constexpr double kVelocity = kPageVelocityError + 0.001;
            SCOPED_TRACE("frame " + std::to_string(i) + ", body " + std::to_string(body->number));
            ASSERT_NEAR(state.place.x, double(body->position.x), kShown);
            ASSERT_NEAR(state.place.y, double(body->position.y), kShown);
            ASSERT_NEAR(state.place.angle, double(body->angle), kShown);
            ASSERT_NEAR(state.velocityX, double(body->velocity.x), kVelocity);
            ASSERT_NEAR(state.velocityY, double(body->velocity.y), kVelocity);
            ASSERT_NEAR(state.spin, double(body->spin), kVelocity);
        }
    }
}

// Far from the origin, and where shapes bend, rigid forms cannot place bodies.
INSTANTIATE_TEST_SUITE_P(Scenes, StatesOfScene,
                         testing::Values("dominos", "chain", "far-pyramid", "skier",
                                         "add-pair-stress-test", "tumbler"),
                         [](const auto& scene) {
                             std::string name = scene.param;
                             std::erase(name, '-');
                             return name;
                         });

TEST_F(PageScenes, AreCompact)
{
    constexpr int kTenSeconds = 600; // [frames]
    Write("pyramid", "shapes,joints", kTenSeconds);
    EXPECT_LE(std::filesystem::file_size(path), 250'000u);
    Write("tumbler", "shapes,joints", kTenSeconds);
    EXPECT_LE(std::filesystem::file_size(path), 1'500'000u);
}

} // namespace
} // namespace boxreel
