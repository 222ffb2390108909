// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Samples.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

#include <vector>

namespace boxreel
{

namespace
{

constexpr int32 kSeams = 20;                                                ///< in a ground
constexpr float32 kHalfWidth = 10.0f;                                       ///< of a ground [m]
constexpr float32 kTile = 2.0f * kHalfWidth / static_cast<float32>(kSeams); ///< [m]
constexpr float32 kLanes[] = {8.0f, 4.0f, 0.0f}; ///< heights: tiles, edges, chain [m]

constexpr float32 kSpeed = 5.0f; ///< [m/s]
constexpr float32 kRoom = 1.0f;  ///< from where they turn to the end [m]
constexpr float32 kSize = 0.6f;  ///< of a character [m]

constexpr Material kSlippery{.density = 20.0f, .friction = 0.0f};
constexpr KeyBinding kKeys[] = {{'a', "sends them to the left"}, {'d', "sends them to the right"}};

constexpr float32 SeamPlace(int32 i)
{
    return -kHalfWidth + kTile * static_cast<float32>(i);
}

/// Typical characters of games: bodies that cannot rotate, a box, an octagon and a disc. They move
/// on three flat grounds made of several parts. The seams between the parts must have no effect.
class CharacterCollision : public Scene
{
public:
    explicit CharacterCollision(const SceneSettings& settings) : Scene(settings)
    {
        AddTiles(kLanes[0]);
        AddEdges(kLanes[1]);
        AddChain(kLanes[2]);
        for (const float32 height : kLanes)
        {
            const float32 half = 0.7071f * kSize; // of the box, whose size is to its corners
            AddCharacter(2, b2Vec2(-7.0f, height + half));
            AddCharacter(3, b2Vec2(-5.0f, height + kSize));
            AddCharacter(4, b2Vec2(-3.0f, height + 0.9f * kSize));
        }
    }

    void Step(const StepSettings& settings) override
    {
        for (b2Body* character : m_characters)
        {
            const float32 x = m_ground->GetLocalPoint(character->GetPosition()).x;
            if (b2Abs(x) > kHalfWidth - kRoom && x * character->GetLinearVelocity().x >= 0.0f)
            {
                character->SetLinearVelocity(b2Vec2(x > 0.0f ? -kSpeed : kSpeed, 0.0f));
            }
        }
        Scene::Step(settings);
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        for (b2Body* character : m_characters)
        {
            const float32 speed = key == 'a' ? -kSpeed : kSpeed;
            if (key == 'a' || key == 'd')
            {
                character->SetLinearVelocity(b2Vec2(speed, character->GetLinearVelocity().y));
            }
        }
    }

    void VisitState(SceneState& state) override
    {
        for (b2Body*& character : m_characters)
        {
            state(character);
        }
        state(m_ground);
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 4.5f), .halfSize = b2Vec2(10.5f, 5.5f)};
    }

private:
    // They pass each other by: only the grounds are of interest.
    void AddCharacter(int32 kind, const b2Vec2& place)
    {
        b2Body* body = AddBody(m_world, b2_dynamicBody, place);
        body->SetFixedRotation(true);
        AttachSample(*body, kind, kSize, kSlippery)->SetFilterData({.groupIndex = -1});
        body->SetLinearVelocity(b2Vec2(kSpeed, 0.0f));
        m_characters.push_back(body);
    }

    void AddTiles(float32 top)
    {
        m_ground = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, top));
        for (int32 i = 0; i < kSeams; ++i)
        {
            const b2Vec2 center(SeamPlace(i) + 0.5f * kTile, -0.5f * kTile);
            AttachBox(*m_ground, 0.5f * kTile, 0.5f * kTile, kSlippery, center);
        }
    }

    void AddEdges(float32 top)
    {
        m_ground = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, top));
        for (int32 i = 0; i < kSeams; ++i)
        {
            b2EdgeShape edge;
            edge.Set(b2Vec2(SeamPlace(i), 0.0f), b2Vec2(SeamPlace(i + 1), 0.0f));
            m_ground->CreateFixture(&edge, 0.0f)->SetFriction(0.0f);
        }
    }

    void AddChain(float32 top)
    {
        m_ground = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, top));
        std::vector<b2Vec2> line;
        for (int32 i = 0; i <= kSeams; ++i)
        {
            line.emplace_back(SeamPlace(i), 0.0f);
        }
        b2ChainShape chain;
        chain.CreateChain(line.data(), static_cast<int32>(line.size()));
        m_ground->CreateFixture(&chain, 0.0f)->SetFriction(0.0f);
    }

    b2Body* m_ground = nullptr; ///< the last one: all have their middle at the same x
    std::vector<b2Body*> m_characters;
};

} // namespace

std::unique_ptr<Scene> MakeCharacterCollision(const SceneSettings& settings)
{
    return std::make_unique<CharacterCollision>(settings);
}

} // namespace boxreel
