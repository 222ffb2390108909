// SPDX-License-Identifier: MIT
#include <scenes/DriftingPair.h>
#include <scenes/Notes.h>
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kArrowLength = 1.5f; ///< of the normal [m]

/// One box drifts through another: the points where they touch and the direction that parts them.
class PolyCollision : public DriftingPair
{
public:
    explicit PolyCollision(const SceneSettings& settings) : DriftingPair(settings)
    {
        Detach(*AttachBox(*m_still, 2.0f, 1.5f, {}, b2Vec2(0.0f, 0.0f), 0.3f));
        Detach(*AttachBox(*m_drifter, 1.5f, 1.0f, {}));
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        const b2Manifold manifold = Collide();
        const b2WorldManifold world = InTheWorld(manifold);
        std::vector<std::pair<std::string, std::string>> rows = {
            {"points", std::to_string(manifold.pointCount)}};
        if (manifold.pointCount > 0)
        {
            rows.emplace_back("separation", WithUnit(world.separations[0], "m"));
        }
        return rows;
    }

    void Draw(b2Draw& draw) const override
    {
        const b2Manifold manifold = Collide();
        const b2WorldManifold world = InTheWorld(manifold);
        for (int32 i = 0; i < manifold.pointCount; ++i)
        {
            const b2Vec2 point = world.points[i];
            DrawDot(draw, point, kOrange);
            DrawArrow(draw, point, point + kArrowLength * world.normal, kYellow);
        }
    }

private:
    const b2PolygonShape& PolygonOf(const b2Body& body) const
    {
        return static_cast<const b2PolygonShape&>(*body.GetFixtureList()->GetShape());
    }

    b2Manifold Collide() const
    {
        b2Manifold manifold;
        b2CollidePolygons(&manifold, &PolygonOf(*m_still), m_still->GetTransform(),
                          &PolygonOf(*m_drifter), m_drifter->GetTransform());
        return manifold;
    }

    b2WorldManifold InTheWorld(const b2Manifold& manifold) const
    {
        b2WorldManifold world;
        world.Initialize(&manifold, m_still->GetTransform(), PolygonOf(*m_still).m_radius,
                         m_drifter->GetTransform(), PolygonOf(*m_drifter).m_radius);
        return world;
    }
};

} // namespace

std::unique_ptr<Scene> MakePolyCollision(const SceneSettings& settings)
{
    return std::make_unique<PolyCollision>(settings);
}

} // namespace boxreel
