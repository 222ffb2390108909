// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Random.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kRows = 5;
constexpr float32 kColumnStep = 4.5f; ///< [m]
constexpr float32 kRowStep = 3.0f;    ///< [m]
constexpr float32 kLowestRow = 8.0f;  ///< [m]
constexpr Material kStuff{.density = 1.0f, .friction = 0.4f};

void AddDumbbell(b2Body& body)
{
    AttachCircle(body, 0.6f, kStuff, b2Vec2(-1.0f, 0.0f));
    AttachCircle(body, 0.6f, kStuff, b2Vec2(1.0f, 0.0f));
    AttachBox(body, 1.0f, 0.15f, kStuff);
}

void AddCross(b2Body& body)
{
    AttachBox(body, 1.2f, 0.25f, kStuff);
    AttachBox(body, 0.25f, 1.2f, kStuff);
}

void AddDart(b2Body& body)
{
    AttachPolygon(body, {{-0.9f, -0.9f}, {0.0f, -0.4f}, {0.0f, 1.2f}}, kStuff);
    AttachPolygon(body, {{0.0f, -0.4f}, {0.9f, -0.9f}, {0.0f, 1.2f}}, kStuff);
}

void AddTable(b2Body& body, float32 scale)
{
    AttachBox(body, 2.0f * scale, 0.15f * scale, kStuff, b2Vec2(0.0f, 1.5f * scale));
    AttachBox(body, 0.15f * scale, 0.7f * scale, kStuff, b2Vec2(-1.6f * scale, 0.65f * scale));
    AttachBox(body, 0.15f * scale, 0.7f * scale, kStuff, b2Vec2(1.6f * scale, 0.65f * scale));
}

void AddBowl(b2Body& body)
{
    AttachBox(body, 0.8f, 0.15f, kStuff);
    AttachBox(body, 0.8f, 0.15f, kStuff, b2Vec2(-1.2f, 0.5f), -0.9f);
    AttachBox(body, 0.8f, 0.15f, kStuff, b2Vec2(1.2f, 0.5f), 0.9f);
}

/// Each body is rigid and consists of several shapes. A bowl on the table catches a ball.
/// Dumbbells, crosses, darts and small tables fall around it.
class CompoundShapes : public Scene
{
public:
    explicit CompoundShapes(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-14.0f, 0.0f), b2Vec2(14.0f, 0.0f));
        AddGroundEdge(m_world, b2Vec2(-14.0f, 0.0f), b2Vec2(-14.0f, 8.0f));
        AddGroundEdge(m_world, b2Vec2(14.0f, 0.0f), b2Vec2(14.0f, 8.0f));
        AddTable(*AddBody(m_world, b2_dynamicBody, b2Vec2(0.0f, 0.1f)), 1.6f);
        AddBowl(*AddBody(m_world, b2_dynamicBody, b2Vec2(0.0f, 3.2f)));
        AddBall(m_world, b2Vec2(0.3f, 7.0f), 0.5f, kStuff);

        Random random(settings.seed);
        for (int32 row = 0; row < kRows; ++row)
        {
            for (const int32 column : {-2, -1, 1, 2})
            {
                const float32 x = kColumnStep * static_cast<float32>(column) +
                                  random.Between(-0.3f, 0.3f) + (column > 0 ? 1.5f : -1.5f);
                const float32 angle = random.Between(-b2_pi, b2_pi);
                const b2Vec2 place(x, kLowestRow + kRowStep * static_cast<float32>(row));
                AddKind(row + column + 2, *AddBody(m_world, b2_dynamicBody, place, angle));
            }
        }
    }

private:
    static void AddKind(int32 kind, b2Body& body)
    {
        switch (kind % 4)
        {
        case 0:
            return AddDumbbell(body);
        case 1:
            return AddCross(body);
        case 2:
            return AddDart(body);
        default:
            return AddTable(body, 0.6f);
        }
    }
};

} // namespace

std::unique_ptr<Scene> MakeCompoundShapes(const SceneSettings& settings)
{
    return std::make_unique<CompoundShapes>(settings);
}

} // namespace boxreel
