// SPDX-License-Identifier: MIT
#include "Setup.h"

#include <array>
#include <charconv>

namespace figures
{

b2PolygonShape Box(float32 halfWidth, float32 halfHeight)
{
    b2PolygonShape shape;
    shape.SetAsBox(halfWidth, halfHeight);
    return shape;
}

b2CircleShape Disc(float32 radius)
{
    b2CircleShape shape;
    shape.m_radius = radius;
    return shape;
}

b2EdgeShape Edge(const b2Vec2& from, const b2Vec2& to)
{
    b2EdgeShape shape;
    shape.Set(from, to);
    return shape;
}

b2Body* AddBody(b2World& world, b2BodyType type, const b2Vec2& position, float32 angle)
{
    b2BodyDef def;
    def.type = type;
    def.position = position;
    def.angle = angle;
    return world.CreateBody(&def);
}

b2Body* AddBody(b2World& world, b2BodyType type, const b2Shape& shape, const b2Vec2& position,
                float32 angle)
{
    b2Body* const body = AddBody(world, type, position, angle);
    body->CreateFixture(&shape, 1.0f);
    return body;
}

b2Body* AddGround(b2World& world, const b2Shape& shape)
{
    return AddBody(world, b2_staticBody, shape, b2Vec2(0.0f, 0.0f));
}

void Run(b2World& world, int steps)
{
    for (int step = 0; step < steps; ++step)
    {
        world.Step(1.0f / 60.0f, 8, 3);
    }
}

std::vector<b2Vec2> SkinOf(const b2PolygonShape& shape, const b2Transform& place)
{
    constexpr int kStretches = 8; // of a round corner
    std::vector<b2Vec2> skin;
    for (int32 i = 0; i < shape.m_count; ++i)
    {
        const b2Vec2 from = shape.m_normals[(i + shape.m_count - 1) % shape.m_count];
        const b2Vec2 to = shape.m_normals[i];
        const float32 turn = b2Atan2(b2Cross(from, to), b2Dot(from, to));
        for (int k = 0; k <= kStretches; ++k)
        {
            const b2Rot part(turn * float32(k) / float32(kStretches));
            skin.push_back(b2Mul(place, shape.GetVertex(i) + shape.m_radius * b2Mul(part, from)));
        }
    }
    return skin;
}

std::string Text(double number, int decimals)
{
    std::array<char, 64> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number,
                                   std::chars_format::fixed, decimals);
    return std::string(digits.data(), end.ptr);
}

} // namespace figures
