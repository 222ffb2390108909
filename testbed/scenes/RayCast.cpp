// SPDX-License-Identifier: MIT
#include <scenes/Notes.h>
#include <scenes/Random.h>
#include <scenes/Samples.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kRange = 11.0f;       ///< of a ray [m]
constexpr float32 kTurningSpeed = 0.5f; ///< [rad/s]
constexpr int32 kRayCount = 3;

constexpr int32 kSampleCount = 24;
constexpr float32 kInnerOrbit = 3.0f; ///< [m]
constexpr float32 kOuterOrbit = 9.5f; ///< [m]
constexpr float32 kSize = 0.8f;       ///< [m]
constexpr uint16 kGlass = 0x0002;     ///< category of what rays pass

constexpr KeyBinding kKeys[] = {{'s', "stops the rays or lets them turn"}};

struct Hit
{
    b2Vec2 point;
    b2Vec2 normal;
    float32 fraction;
};

/// The answers that a ray-cast callback can give: go on but no farther than here; end; go on.
enum class Wish
{
    Closest,
    Any,
    All
};

class Hits : public b2RayCastCallback
{
public:
    explicit Hits(Wish wish) : m_wish(wish) {}

    float32 ReportFixture(b2Fixture* fixture, const b2Vec2& point, const b2Vec2& normal,
                          float32 fraction) override
    {
        if (fixture->GetFilterData().categoryBits == kGlass)
        {
            return -1.0f;
        }
        if (m_wish == Wish::Closest)
        {
            hits.clear();
        }
        hits.push_back({point, normal, fraction});
        return m_wish == Wish::Closest ? fraction : m_wish == Wish::Any ? 0.0f : 1.0f;
    }

    std::vector<Hit> hits;

private:
    Wish m_wish;
};

/// Three rays rotate about the middle. The orange one finds the closest shape, the blue one any,
/// the yellow one all on its path. All of them ignore the discs.
class RayCast : public Scene
{
public:
    explicit RayCast(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetGravity(b2Vec2(0.0f, 0.0f));
        m_center = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, 0.0f));
        Random random(settings.seed);
        for (int32 i = 0; i < kSampleCount; ++i)
        {
            // Every other one on the inner half, each in a sector of its own.
            const float32 share = static_cast<float32>(i) / static_cast<float32>(kSampleCount);
            const float32 middle = 0.5f * (kInnerOrbit + kOuterOrbit);
            const float32 distance = i % 2 == 0 ? random.Between(kInnerOrbit, middle - kSize)
                                                : random.Between(middle + kSize, kOuterOrbit);
            const b2Vec2 place = distance * b2Rot(2.0f * b2_pi * share).GetXAxis();
            const float32 angle = random.Between(-b2_pi, b2_pi);
            b2Body* body = AddSample(m_world, i % kSampleKinds, place, angle, kSize, {});
            body->SetAngularVelocity(random.Between(-1.0f, 1.0f));
            if (i % kSampleKinds == kSampleKinds - 1)
            {
                body->GetFixtureList()->SetFilterData({.categoryBits = kGlass});
            }
        }
    }

    void Step(const StepSettings& settings) override
    {
        Scene::Step(settings);
        m_angle += m_isTurning ? settings.timeStep * kTurningSpeed : 0.0f;
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }
    void KeyDown(char key) override { m_isTurning = m_isTurning != (key == 's'); }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        const std::vector<Hit> closest = Cast(Wish::Closest);
        const std::vector<Hit> any = Cast(Wish::Any);
        return {{"closest (orange)", Distance(closest)},
                {"any (blue)", Distance(any)},
                {"all (yellow)", std::to_string(Cast(Wish::All).size())}};
    }

    void Draw(b2Draw& draw) const override
    {
        DrawRay(draw, Wish::Closest, kOrange);
        DrawRay(draw, Wish::Any, kSkyBlue);
        DrawRay(draw, Wish::All, kYellow);
    }

    void VisitState(SceneState& state) override { state(m_center, m_angle, m_isTurning); }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 0.0f), .halfSize = b2Vec2(11.2f, 11.2f)};
    }

private:
    b2Vec2 EndOf(Wish wish) const
    {
        const float32 apart = 2.0f * b2_pi / static_cast<float32>(kRayCount);
        const b2Rot direction(m_angle + apart * static_cast<float32>(wish));
        return m_center->GetPosition() + kRange * direction.GetXAxis();
    }

    std::vector<Hit> Cast(Wish wish) const
    {
        Hits callback(wish);
        m_world.RayCast(&callback, m_center->GetPosition(), EndOf(wish));
        return callback.hits;
    }

    static std::string Distance(const std::vector<Hit>& hits)
    {
        return hits.empty() ? "none" : WithUnit(kRange * hits.front().fraction, "m");
    }

    void DrawRay(b2Draw& draw, Wish wish, const b2Color& color) const
    {
        const std::vector<Hit> hits = Cast(wish);
        const bool goesOn = hits.empty() || wish == Wish::All;
        draw.DrawSegment(m_center->GetPosition(), goesOn ? EndOf(wish) : hits.front().point, color);
        for (const Hit& hit : hits)
        {
            DrawDot(draw, hit.point, color);
            DrawArrow(draw, hit.point, hit.point + hit.normal, color);
        }
    }

    b2Body* m_center;       ///< of the rays
    float32 m_angle = 0.3f; ///< of the first ray [rad]
    bool m_isTurning = true;
};

} // namespace

std::unique_ptr<Scene> MakeRayCast(const SceneSettings& settings)
{
    return std::make_unique<RayCast>(settings);
}

} // namespace boxreel
