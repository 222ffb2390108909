// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kStones = 21;       ///< odd, so that there is a keystone
constexpr float32 kInside = 8.0f;   ///< radius [m]
constexpr float32 kOutside = 10.0f; ///< radius [m]

// A half circle of stones stands as long as the line of thrust is within it. That requires a
// thickness of 0.107 of the mean radius (J. Heyman, "The stone skeleton", 1966); here it is 0.22.
constexpr Material kStone{.density = 2.0f, .friction = 0.8f};

// The load is one of boxes that are lowered on the keystone one by one.
constexpr int32 kLoads = 4;
constexpr float32 kLoadHalfSize = 0.75f; ///< [m]

class Arch : public Scene
{
public:
    explicit Arch(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // thrust goes through twenty joints that only friction holds
        AddGroundEdge(m_world, b2Vec2(-25.0f, 0.0f), b2Vec2(25.0f, 0.0f));
        AddGroundBox(m_world, b2Vec2(-9.0f, 0.5f), 2.0f, 0.5f);
        AddGroundBox(m_world, b2Vec2(9.0f, 0.5f), 2.0f, 0.5f);
        for (int32 i = 0; i < kStones; ++i)
        {
            AddStone(b2_pi * static_cast<float32>(i) / kStones,
                     b2_pi * static_cast<float32>(i + 1) / kStones);
        }
        for (int32 i = 0; i < kLoads; ++i)
        {
            const float32 y = 1.0f + kOutside + kLoadHalfSize + 0.5f;
            AddBox(m_world, b2Vec2(0.0f, y + 1.8f * static_cast<float32>(i)), kLoadHalfSize,
                   kLoadHalfSize);
        }
    }

private:
    /// Between two angles of the half circle, on piers of 1 m.
    void AddStone(float32 from, float32 to)
    {
        const b2Rot first(from), last(to);
        const b2Vec2 corners[] = {kInside * first.GetXAxis(), kOutside * first.GetXAxis(),
                                  kOutside * last.GetXAxis(), kInside * last.GetXAxis()};
        b2Vec2 middle(0.0f, 0.0f);
        for (const b2Vec2& corner : corners)
        {
            middle += 0.25f * corner;
        }
        b2Body* stone = AddBody(m_world, b2_dynamicBody, middle + b2Vec2(0.0f, 1.0f));
        AttachPolygon(
            *stone,
            {corners[0] - middle, corners[1] - middle, corners[2] - middle, corners[3] - middle},
            kStone);
    }
};

} // namespace

std::unique_ptr<Scene> MakeArch(const SceneSettings& settings)
{
    return std::make_unique<Arch>(settings);
}

} // namespace boxreel
