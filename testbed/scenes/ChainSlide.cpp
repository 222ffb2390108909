// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

#include <array>

namespace boxreel
{

namespace
{

constexpr int32 kPieces = 80;      ///< of the slide
constexpr float32 kRadius = 12.0f; ///< of the slide's quarter circle [m]
constexpr float32 kRunOut = 20.0f; ///< length of the level part [m]
constexpr Material kIce{.density = 1.0f, .friction = 0.0f};

/// A slide of many short pieces: a box without friction gathers speed as on a smooth one, and no
/// corner between two pieces stops it.
class ChainSlide : public Scene
{
public:
    explicit ChainSlide(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // what slides keeps its energy
        std::array<b2Vec2, kPieces + 3> track;
        // From the top of a quarter circle, whose centre is (0, kRadius), to its foot at the
        // origin.
        for (int32 i = 0; i <= kPieces; ++i)
        {
            const b2Rot turned(0.5f * b2_pi * static_cast<float32>(i) / kPieces);
            track[std::size_t(i)] = b2Vec2(-kRadius * turned.c, kRadius - kRadius * turned.s);
        }
        track[kPieces + 1] = b2Vec2(kRunOut, 0.0f);
        track[kPieces + 2] = b2Vec2(kRunOut + 4.0f, 6.0f);
        b2ChainShape shape;
        shape.CreateChain(track.data(), kPieces + 3);
        b2Body* slide = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, 0.0f));
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.friction = kIce.friction;
        slide->CreateFixture(&fixture);
        AddBox(m_world, b2Vec2(-kRadius + 1.0f, kRadius - 2.0f), 0.4f, 0.4f, kIce, -1.2f);
        AddBall(m_world, b2Vec2(-kRadius + 3.6f, kRadius - 7.0f), 0.4f, kIce);
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(6.0f, 6.0f), .halfSize = b2Vec2(19.0f, 7.5f)};
    }
};

} // namespace

std::unique_ptr<Scene> MakeChainSlide(const SceneSettings& settings)
{
    return std::make_unique<ChainSlide>(settings);
}

} // namespace boxreel
