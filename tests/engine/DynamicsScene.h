// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

#include <vector>

/// A world and short words for what the tests of the dynamics put into it. Sizes are half widths
/// and radii in metres; everything has density 1 and the default friction unless said.
namespace dynamics
{

inline constexpr float32 kStep = 1.0f / 60.0f;

class Scene
{
public:
    explicit Scene(const b2Vec2& gravity = b2Vec2(0.0f, -10.0f)) : world(gravity) {}

    b2Body* Body(b2BodyType type, float32 x, float32 y, float32 angle = 0.0f)
    {
        b2BodyDef def;
        def.type = type;
        def.position.Set(x, y);
        def.angle = angle;
        return world.CreateBody(&def);
    }

    static b2Fixture* AddBox(b2Body* body, float32 hx, float32 hy, float32 friction = 0.2f,
                             float32 restitution = 0.0f)
    {
        b2PolygonShape shape;
        shape.SetAsBox(hx, hy);
        return Add(body, shape, friction, restitution);
    }

    static b2Fixture* AddBall(b2Body* body, float32 radius, float32 friction = 0.2f,
                              float32 restitution = 0.0f)
    {
        b2CircleShape shape;
        shape.m_radius = radius;
        return Add(body, shape, friction, restitution);
    }

    static b2Fixture* Add(b2Body* body, const b2Shape& shape, float32 friction, float32 restitution)
    {
        b2FixtureDef def;
        def.shape = &shape;
        def.density = 1.0f;
        def.friction = friction;
        def.restitution = restitution;
        return body->CreateFixture(&def);
    }

    b2Body* Box(float32 x, float32 y, float32 hx = 0.5f, float32 hy = 0.5f)
    {
        b2Body* body = Body(b2_dynamicBody, x, y);
        AddBox(body, hx, hy);
        return body;
    }

    b2Body* Ball(float32 x, float32 y, float32 radius = 0.5f)
    {
        b2Body* body = Body(b2_dynamicBody, x, y);
        AddBall(body, radius);
        return body;
    }

    /// Its top is at y = 0, 100 m wide.
    b2Body* Ground()
    {
        b2Body* body = Body(b2_staticBody, 0.0f, -1.0f);
        AddBox(body, 50.0f, 1.0f);
        return body;
    }

    /// A thin upright wall of the given half width.
    b2Body* Wall(float32 x, float32 halfWidth = 0.05f)
    {
        b2Body* body = Body(b2_staticBody, x, 0.0f);
        AddBox(body, halfWidth, 10.0f);
        return body;
    }

    void Step(int count = 1)
    {
        for (int i = 0; i < count; ++i)
        {
            world.Step(kStep, 8, 3);
        }
    }

    b2World world;
};

/// Distance of resting polygons at their corners: their two skins minus the slop.
inline constexpr float32 kRestingGap = 2.0f * b2_polygonRadius - b2_linearSlop;

/// Returns the maximum overlap of all contacts, beyond the skins that they have [m].
inline float32 DeepestOverlap(const b2World& world)
{
    float32 deepest = 0.0f;
    for (const b2Contact* c = world.GetContactList(); c; c = c->GetNext())
    {
        b2WorldManifold points;
        c->GetWorldManifold(&points);
        for (int32 i = 0; i < c->GetManifold()->pointCount && c->IsTouching(); ++i)
        {
            deepest = b2Max(deepest, -points.separations[i]);
        }
    }
    return deepest;
}

/// Adds a stack of unit boxes on y = 0 and returns them, lowest first.
inline std::vector<b2Body*> Stack(Scene& scene, float32 x, int height)
{
    std::vector<b2Body*> boxes;
    for (int i = 0; i < height; ++i)
    {
        boxes.push_back(scene.Box(x, 0.5f + kRestingGap + (1.0f + kRestingGap) * float32(i)));
    }
    return boxes;
}

inline bool AllAwake(const std::vector<b2Body*>& bodies, bool awake)
{
    for (const b2Body* body : bodies)
    {
        if (body->IsAwake() != awake)
        {
            return false;
        }
    }
    return true;
}

} // namespace dynamics
