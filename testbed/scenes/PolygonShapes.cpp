// SPDX-License-Identifier: MIT
#include <scenes/Notes.h>
#include <scenes/Parts.h>
#include <scenes/SampleRain.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kProbeRadius = 2.0f; ///< [m]
const b2Vec2 kProbePlace(0.0f, 2.2f);  ///< [m]
constexpr float32 kHalfWidth = 6.0f;   ///< of the trough that they fall into [m]

/// The dynamic fixtures whose shapes, not only their boxes, overlap a disc.
class Overlapping : public b2QueryCallback
{
public:
    explicit Overlapping(const b2CircleShape& probe) : m_probe(probe) {}

    bool ReportFixture(b2Fixture* fixture) override
    {
        const b2Body& body = *fixture->GetBody();
        if (body.GetType() == b2_dynamicBody &&
            b2TestOverlap(fixture->GetShape(), 0, &m_probe, 0, body.GetTransform(), b2Transform()))
        {
            found.push_back(fixture);
        }
        return true;
    }

    std::vector<const b2Fixture*> found;

private:
    b2CircleShape m_probe;
};

/// The orange disc is not a body but an overlap query.
class PolygonShapes : public SampleRain
{
public:
    explicit PolygonShapes(const SceneSettings& settings) : SampleRain(settings, 4.5f, 14.0f)
    {
        AddGroundEdge(m_world, b2Vec2(-kHalfWidth, 0.0f), b2Vec2(kHalfWidth, 0.0f));
        AddGroundEdge(m_world, b2Vec2(-kHalfWidth, 0.0f), b2Vec2(-kHalfWidth - 2.0f, 10.0f));
        AddGroundEdge(m_world, b2Vec2(kHalfWidth, 0.0f), b2Vec2(kHalfWidth + 2.0f, 10.0f));
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        return {{"in the disc", std::to_string(Query().size())}};
    }

    void Draw(b2Draw& draw) const override
    {
        draw.DrawCircle(Origin() + kProbePlace, kProbeRadius, kOrange);
        for (const b2Fixture* fixture : Query())
        {
            DrawOutline(draw, *fixture->GetShape(), fixture->GetBody()->GetTransform(), kYellow);
        }
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 7.0f), .halfSize = b2Vec2(8.5f, 7.8f)};
    }

private:
    std::vector<const b2Fixture*> Query() const
    {
        b2CircleShape probe;
        probe.m_p = Origin() + kProbePlace;
        probe.m_radius = kProbeRadius;
        b2AABB box;
        probe.ComputeAABB(&box, b2Transform(), 0);
        Overlapping overlapping(probe);
        m_world.QueryAABB(&overlapping, box);
        return overlapping.found;
    }
};

} // namespace

std::unique_ptr<Scene> MakePolygonShapes(const SceneSettings& settings)
{
    return std::make_unique<PolygonShapes>(settings);
}

} // namespace boxreel
