// SPDX-License-Identifier: MIT
#include "ScenePlay.h"

#include <fstream>

// The scene that is made by what b2World::Dump wrote.
namespace boxreel
{
namespace
{

std::string s_log;

void Collect(const char* text)
{
    s_log += text;
}

/// Without the first line, which makes the world.
std::string Dumped(b2World& world)
{
    s_log.clear();
    b2SetLog(Collect);
    world.Dump();
    b2SetLog(nullptr);
    return s_log.substr(s_log.find('\n') + 1);
}

/// Without the comments at its beginning.
std::string Stored()
{
    std::ifstream file(BOXREEL_DUMP_SHELL);
    std::string text;
    for (std::string line; std::getline(file, line);)
    {
        if (!line.starts_with("//"))
        {
            text += line + "\n";
        }
    }
    return text;
}

TEST(DumpShellScene, DumpsTheTextItIsBuiltFrom)
{
    const auto scene = Make("Dump Shell");
    const std::string dumped = Dumped(scene->World());
    if (dumped != Stored())
    {
        const std::string path = testing::TempDir() + "DumpShell.inc";
        std::ofstream(path) << dumped;
        ADD_FAILURE() << "the dump is in " << path;
    }
}

TEST(DumpShellScene, ContinuesMotionAndRestsWithAllStones)
{
    const auto scene = Make("Dump Shell");
    b2Body& shell = Named(*scene, "shell");
    EXPECT_GT(b2Abs(shell.GetAngularVelocity()), 0.3f) << "in the middle of a motion";
    const float32 start = shell.GetAngle();
    Play(*scene, 12.0f);
    EXPECT_GT(b2Abs(shell.GetAngle() - start), 0.1f);
    EXPECT_LT(b2Abs(shell.GetAngularVelocity()), 0.02f);
    const std::vector<b2Body*> movers = Movers(*scene);
    ASSERT_EQ(movers.size(), 1u + 6u + 2u);
    for (std::size_t i = 1; i <= 6; ++i)
    {
        EXPECT_LT(movers[i]->GetLinearVelocity().Length(), 0.05f);
        EXPECT_LT(b2Distance(movers[i]->GetPosition(), shell.GetWorldPoint(b2Vec2(0.0f, 2.6f))),
                  4.0f);
    }
    EXPECT_LT(WidestHingeGap(*scene), 0.02f) << "the bar hangs on";
}

} // namespace
} // namespace boxreel
