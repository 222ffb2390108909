// SPDX-License-Identifier: MIT
#include <scenes/Notes.h>
#include <scenes/Samples.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr uint16 kGroundBits = 0x0001;
constexpr uint16 kBoxBits = 0x0002;
constexpr uint16 kDiscBits = 0x0004;
constexpr uint16 kEverything = 0xFFFF;

// Boxes and discs collide with their own kind and the ground, not with each other.
constexpr b2Filter kBoxes{.categoryBits = kBoxBits, .maskBits = kEverything & ~kDiscBits};
constexpr b2Filter kDiscs{.categoryBits = kDiscBits, .maskBits = kEverything & ~kBoxBits};
// Their masks forbid collisions, but a positive group overrides masks.
constexpr b2Filter kFriends{.categoryBits = kBoxBits, .maskBits = kGroundBits, .groupIndex = 1};
// Their masks allow collisions, but a negative group overrides masks.
constexpr b2Filter kStrangers{.categoryBits = kBoxBits, .groupIndex = -2};

constexpr int32 kColumn = 6;                      ///< bodies in a column
constexpr float32 kStep = 2.2f;                   ///< from body to body [m]
constexpr float32 kSize = 0.8f;                   ///< [m]
constexpr float32 kLanes[] = {-8.0f, 0.0f, 8.0f}; ///< [m]
constexpr float32 kHalfLane = 3.2f;               ///< [m]

/// Left: discs pass through a stack of boxes and both stand on the ground. Middle: a group that
/// always collides makes a tower. Right: a group that never does ends in one heap without height.
class CollisionFiltering : public Scene
{
public:
    explicit CollisionFiltering(const SceneSettings& settings) : Scene(settings)
    {
        for (const float32 x : kLanes)
        {
            AddGroundEdge(m_world, b2Vec2(x - kHalfLane, 0.0f), b2Vec2(x + kHalfLane, 0.0f));
            AddGroundEdge(m_world, b2Vec2(x - kHalfLane, 0.0f), b2Vec2(x - kHalfLane, 2.0f));
            AddGroundEdge(m_world, b2Vec2(x + kHalfLane, 0.0f), b2Vec2(x + kHalfLane, 2.0f));
        }
        for (int32 i = 0; i < kColumn; ++i)
        {
            const float32 y = 1.0f + kStep * static_cast<float32>(i);
            const bool isBox = i < kColumn / 2;
            AddFiltered(isBox ? 2 : 4, b2Vec2(kLanes[0] + (isBox ? 0.0f : 0.1f), y),
                        isBox ? kBoxes : kDiscs);
            AddFiltered(2, b2Vec2(kLanes[1], y), kFriends);
            AddFiltered(i % kSampleKinds, b2Vec2(kLanes[2], y), kStrangers);
        }
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 6.5f), .halfSize = b2Vec2(11.7f, 7.0f)};
    }

private:
    void AddFiltered(int32 kind, const b2Vec2& place, const b2Filter& filter)
    {
        AddSample(m_world, kind, place, 0.0f, kSize, {})->GetFixtureList()->SetFilterData(filter);
    }
};

} // namespace

std::unique_ptr<Scene> MakeCollisionFiltering(const SceneSettings& settings)
{
    return std::make_unique<CollisionFiltering>(settings);
}

} // namespace boxreel
