// SPDX-License-Identifier: MIT
#include <scenes/Scenes.h>

#include <map>

namespace boxreel
{

namespace
{

constexpr int32 kShell = 1; ///< its number in the text

/// The text says m_world-> for the world that it fills.
void Fill(b2World* m_world)
{
#include <scenes/DumpShell.inc>
}

/// A shell full of stones, a pearl on a thread and a bar on a hinge, all in motion. They are made
/// by the code that b2World::Dump wrote.
class DumpShell : public Scene
{
public:
    explicit DumpShell(const SceneSettings& settings) : Scene(settings)
    {
        Fill(&m_world);
        for (const b2Body* body = m_world.GetBodyList(); body != nullptr; body = body->GetNext())
        {
            if (body->GetNumber() == kShell)
            {
                Name(*body, "shell");
            }
        }
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 3.5f), .halfSize = b2Vec2(9.0f, 4.5f)};
    }
};

} // namespace

std::unique_ptr<Scene> MakeDumpShell(const SceneSettings& settings)
{
    return std::make_unique<DumpShell>(settings);
}

} // namespace boxreel
