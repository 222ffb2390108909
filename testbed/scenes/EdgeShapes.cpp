// SPDX-License-Identifier: MIT
#include <scenes/Notes.h>
#include <scenes/Parts.h>
#include <scenes/SampleRain.h>
#include <scenes/Scenes.h>

#include <cmath>

namespace boxreel
{

namespace
{

constexpr int32 kEdgeCount = 48;
constexpr float32 kHalfWidth = 12.0f; ///< of the ground [m]
constexpr float32 kRayTop = 13.0f;    ///< [m]
constexpr float32 kRayBottom = -4.0f; ///< [m]
constexpr float32 kRaySpeed = 4.0f;   ///< to and fro [m/s]
constexpr float32 kRayReach = 11.0f;  ///< [m]

/// Hills and dales, higher towards the ends so that nothing leaves.
b2Vec2 GroundPoint(int32 i)
{
    const float32 x =
        kHalfWidth * (2.0f * static_cast<float32>(i) / static_cast<float32>(kEdgeCount) - 1.0f);
    const float32 rise = x * x / (kHalfWidth * kHalfWidth);
    return b2Vec2(x, 1.2f * b2Rot(1.3f * x).c + 4.0f * rise * rise);
}

class Nearest : public b2RayCastCallback
{
public:
    float32 ReportFixture(b2Fixture*, const b2Vec2& where, const b2Vec2& up,
                          float32 fraction) override
    {
        isHit = true;
        point = where;
        normal = up;
        return fraction;
    }

    bool isHit = false;
    b2Vec2 point;
    b2Vec2 normal;
};

class EdgeShapes : public SampleRain
{
public:
    explicit EdgeShapes(const SceneSettings& settings) : SampleRain(settings, 8.0f, 12.0f)
    {
        for (int32 i = 0; i < kEdgeCount; ++i)
        {
            AddGroundEdge(m_world, GroundPoint(i), GroundPoint(i + 1));
        }
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        const Nearest hit = Cast();
        return {{"below the ray",
                 hit.isHit ? WithUnit(hit.point.y - Origin().y, "m high") : "nothing"}};
    }

    void Draw(b2Draw& draw) const override
    {
        const Nearest hit = Cast();
        draw.DrawSegment(RayStart(), hit.isHit ? hit.point : RayEnd(), kYellow);
        if (hit.isHit)
        {
            DrawDot(draw, hit.point, kOrange);
            DrawArrow(draw, hit.point, hit.point + hit.normal, kOrange);
        }
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 5.5f), .halfSize = b2Vec2(12.5f, 8.0f)};
    }

private:
    /// To and fro, from the right end on [m].
    float32 RayPlace() const
    {
        const float32 way = Time() * kRaySpeed;
        const float32 period = 4.0f * kRayReach;
        const float32 within = way - period * std::floor(way / period);
        return b2Abs(2.0f * kRayReach - within) - kRayReach;
    }

    b2Vec2 RayStart() const { return Origin() + b2Vec2(RayPlace(), kRayTop); }
    b2Vec2 RayEnd() const { return Origin() + b2Vec2(RayPlace(), kRayBottom); }

    Nearest Cast() const
    {
        Nearest nearest;
        m_world.RayCast(&nearest, RayStart(), RayEnd());
        return nearest;
    }
};

} // namespace

std::unique_ptr<Scene> MakeEdgeShapes(const SceneSettings& settings)
{
    return std::make_unique<EdgeShapes>(settings);
}

} // namespace boxreel
