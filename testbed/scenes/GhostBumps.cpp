// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

#include <array>

namespace boxreel
{

namespace
{

constexpr int32 kPieces = 40;       ///< of each track
constexpr float32 kPiece = 1.0f;    ///< length [m]
constexpr float32 kApart = 4.0f;    ///< from track to track [m]
constexpr float32 kSpeed = 8.0f;    ///< of the boxes at the start [m/s]
constexpr float32 kHalfSize = 0.4f; ///< [m]
constexpr Material kIce{.density = 1.0f, .friction = 0.0f};
constexpr Material kBuffer{.friction = 0.0f, .restitution = 1.0f}; ///< at both ends

/// Three tracks, level to the last bit: of boxes side by side, of edges, and of one chain. A seam
/// between two that know nothing of each other may catch what slides over it; on the chain none
/// can.
class GhostBumps : public Scene
{
public:
    explicit GhostBumps(const SceneSettings& settings) : Scene(settings)
    {
        const float32 left = -0.5f * kPiece * kPieces;
        b2Body* ground = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, 0.0f));
        std::array<b2Vec2, kPieces + 1> corners;
        for (int32 i = 0; i <= kPieces; ++i)
        {
            corners[std::size_t(i)] = b2Vec2(left + kPiece * static_cast<float32>(i), 0.0f);
        }
        for (int32 i = 0; i < kPieces; ++i)
        {
            const b2Vec2 from = corners[std::size_t(i)], to = corners[std::size_t(i + 1)];
            AttachBox(*ground, 0.5f * kPiece, 0.25f, kIce,
                      0.5f * (from + to) + b2Vec2(0.0f, 2.0f * kApart - 0.25f));
            b2EdgeShape edge;
            edge.Set(from + b2Vec2(0.0f, kApart), to + b2Vec2(0.0f, kApart));
            Attach(*ground, edge);
        }
        b2ChainShape chain;
        chain.CreateChain(corners.data(), kPieces + 1);
        Attach(*ground, chain);
        for (const float32 side : {-1.0f, 1.0f})
        {
            AttachBox(*ground, 0.25f, 1.5f * kApart, kBuffer,
                      b2Vec2(side * (-left + 0.25f), 1.5f * kApart - 0.5f));
        }
        for (int32 track = 0; track < 3; ++track)
        {
            const float32 y = kApart * static_cast<float32>(track) + kHalfSize;
            b2Body* box = AddBox(m_world, b2Vec2(left + 2.0f, y), kHalfSize, kHalfSize, kIce);
            box->SetLinearVelocity(b2Vec2(kSpeed, 0.0f));
        }
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, kApart), .halfSize = b2Vec2(21.0f, 7.0f)};
    }

private:
    static void Attach(b2Body& body, const b2Shape& shape)
    {
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.friction = kIce.friction;
        body.CreateFixture(&fixture);
    }
};

} // namespace

std::unique_ptr<Scene> MakeGhostBumps(const SceneSettings& settings)
{
    return std::make_unique<GhostBumps>(settings);
}

} // namespace boxreel
