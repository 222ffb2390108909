// SPDX-License-Identifier: MIT
#include <scenes/DriftingPair.h>
#include <scenes/Notes.h>
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

/// A triangle drifts about a long box; a line joins their closest points.
class DistanceTest : public DriftingPair
{
public:
    explicit DistanceTest(const SceneSettings& settings) : DriftingPair(settings)
    {
        Detach(*AttachBox(*m_still, 2.5f, 0.4f, {}, b2Vec2(0.0f, 0.0f), 0.2f));
        Detach(*AttachPolygon(*m_drifter, {{-1.0f, -0.6f}, {1.0f, -0.6f}, {0.2f, 1.2f}}, {}));
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        const b2DistanceOutput output = Measure();
        return {{"distance", WithUnit(output.distance, "m")},
                {"iterations", std::to_string(output.iterations)}};
    }

    void Draw(b2Draw& draw) const override
    {
        const b2DistanceOutput output = Measure();
        draw.DrawSegment(output.pointA, output.pointB, kYellow);
        DrawDot(draw, output.pointA, kOrange);
        DrawDot(draw, output.pointB, kSkyBlue);
    }

private:
    b2DistanceOutput Measure() const
    {
        b2DistanceInput input;
        input.proxyA.Set(m_still->GetFixtureList()->GetShape(), 0);
        input.proxyB.Set(m_drifter->GetFixtureList()->GetShape(), 0);
        input.transformA = m_still->GetTransform();
        input.transformB = m_drifter->GetTransform();
        input.useRadii = true;
        b2SimplexCache cache;
        b2DistanceOutput output;
        b2Distance(&output, &cache, &input);
        return output;
    }
};

} // namespace

std::unique_ptr<Scene> MakeDistanceTest(const SceneSettings& settings)
{
    return std::make_unique<DistanceTest>(settings);
}

} // namespace boxreel
