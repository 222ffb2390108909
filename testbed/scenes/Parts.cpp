// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>

#include <cstdio>

namespace boxreel
{

namespace
{

b2Fixture* Attach(b2Body& body, const b2Shape& shape, const Material& material)
{
    b2FixtureDef definition;
    definition.shape = &shape;
    definition.density = material.density;
    definition.friction = material.friction;
    definition.restitution = material.restitution;
    return body.CreateFixture(&definition);
}

} // namespace

b2Body* AddBody(b2World& world, b2BodyType type, const b2Vec2& position, float32 angle)
{
    b2BodyDef definition;
    definition.type = type;
    definition.position = position;
    definition.angle = angle;
    return world.CreateBody(&definition);
}

b2Fixture* AttachBox(b2Body& body, float32 halfWidth, float32 halfHeight, const Material& material,
                     const b2Vec2& center, float32 angle)
{
    b2PolygonShape shape;
    shape.SetAsBox(halfWidth, halfHeight, center, angle);
    return Attach(body, shape, material);
}

b2Fixture* AttachCircle(b2Body& body, float32 radius, const Material& material,
                        const b2Vec2& center)
{
    b2CircleShape shape;
    shape.m_radius = radius;
    shape.m_p = center;
    return Attach(body, shape, material);
}

b2Fixture* AttachPolygon(b2Body& body, std::initializer_list<b2Vec2> vertices,
                         const Material& material)
{
    b2PolygonShape shape;
    shape.Set(vertices.begin(), static_cast<int32>(vertices.size()));
    return Attach(body, shape, material);
}

b2Body* AddGroundEdge(b2World& world, const b2Vec2& from, const b2Vec2& to)
{
    b2Body* ground = AddBody(world, b2_staticBody, b2Vec2(0.0f, 0.0f));
    b2EdgeShape shape;
    shape.Set(from, to);
    Attach(*ground, shape, Material{});
    return ground;
}

b2Body* AddGroundBox(b2World& world, const b2Vec2& center, float32 halfWidth, float32 halfHeight,
                     float32 angle)
{
    b2Body* ground = AddBody(world, b2_staticBody, center, angle);
    AttachBox(*ground, halfWidth, halfHeight, Material{});
    return ground;
}

b2Body* AddBox(b2World& world, const b2Vec2& center, float32 halfWidth, float32 halfHeight,
               const Material& material, float32 angle)
{
    b2Body* body = AddBody(world, b2_dynamicBody, center, angle);
    AttachBox(*body, halfWidth, halfHeight, material);
    return body;
}

b2Body* AddBall(b2World& world, const b2Vec2& center, float32 radius, const Material& material)
{
    b2Body* body = AddBody(world, b2_dynamicBody, center);
    AttachCircle(*body, radius, material);
    return body;
}

void AddPyramid(b2World& world, const b2Vec2& foot, int32 baseCount, float32 halfSize)
{
    for (int32 row = 0; row < baseCount; ++row)
    {
        const int32 boxes = baseCount - row;
        const float32 left = foot.x - halfSize * static_cast<float32>(boxes - 1);
        const float32 y = foot.y + halfSize * static_cast<float32>(2 * row + 1);
        for (int32 i = 0; i < boxes; ++i)
        {
            AddBox(world, b2Vec2(left + 2.0f * halfSize * static_cast<float32>(i), y), halfSize,
                   halfSize);
        }
    }
}

b2Joint* AddHinge(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& point)
{
    b2RevoluteJointDef definition;
    definition.Initialize(bodyA, bodyB, point);
    return world.CreateJoint(&definition);
}

std::string Rounded(float32 number)
{
    char text[64]; // a float has at most 39 digits before its point
    std::snprintf(text, sizeof text, "%.1f", static_cast<double>(number));
    return text;
}

} // namespace boxreel
