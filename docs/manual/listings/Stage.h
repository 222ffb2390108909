// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

/// The stage of the manual's listings: a world, and short helpers for the objects that exist before
/// a listing begins. Lengths in metres; boxes and balls have density 1.
namespace manual
{

struct Stage
{
    explicit Stage(const b2Vec2& gravity = b2Vec2(0.0f, -10.0f)) : world(gravity) {}

    b2Body* Body(b2BodyType type, float32 x, float32 y)
    {
        b2BodyDef def;
        def.type = type;
        def.position.Set(x, y);
        return world.CreateBody(&def);
    }

    b2Body* Box(float32 x, float32 y, float32 halfWidth = 0.5f, float32 halfHeight = 0.5f,
                b2BodyType type = b2_dynamicBody)
    {
        b2PolygonShape shape;
        shape.SetAsBox(halfWidth, halfHeight);
        b2Body* body = Body(type, x, y);
        body->CreateFixture(&shape, 1.0f);
        return body;
    }

    b2Body* Ball(float32 x, float32 y, float32 radius = 0.5f)
    {
        b2CircleShape shape;
        shape.m_radius = radius;
        b2Body* body = Body(b2_dynamicBody, x, y);
        body->CreateFixture(&shape, 1.0f);
        return body;
    }

    /// 100 m wide, its top at y = 0.
    b2Body* Ground() { return Box(0.0f, -1.0f, 50.0f, 1.0f, b2_staticBody); }

    void Run(float32 seconds)
    {
        const long steps = std::lround(60.0f * seconds);
        for (long i = 0; i < steps; ++i)
        {
            world.Step(1.0f / 60.0f, 8, 3);
        }
    }

    b2World world;
};

/// The text of a page of the manual, for what a listing has to keep of it.
inline std::string PageText(const std::string& name)
{
    std::ifstream file(BOXREEL_MANUAL_PAGES "/" + name);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The part of a page below a heading, up to the next one of any level.
inline std::string SectionText(const std::string& page, const std::string& heading)
{
    const std::string text = PageText(page);
    const std::size_t start = text.find("\n" + heading + "\n");
    return start == std::string::npos ? ""
                                      : text.substr(start, text.find("\n#", start + 1) - start);
}

/// Returns the beginning of the table row with the default of a definition's number.
inline std::string Row(const char* name, double value)
{
    char text[64];
    std::snprintf(text, sizeof text, "| `%s` | %.6g |", name, value);
    return text;
}

inline std::string Row(const char* name, bool value)
{
    return std::string("| `") + name + "` | " + (value ? "true" : "false") + " |";
}

inline std::string Row(const char* name, const b2Vec2& value)
{
    char text[64];
    std::snprintf(text, sizeof text, "| `%s` | (%g, %g) |", name, double(value.x), double(value.y));
    return text;
}

} // namespace manual

/// The page says of this field of a definition what it is unless set.
#define EXPECT_DEFAULT(section, definition, field)                                                 \
    EXPECT_THAT(section, testing::HasSubstr(manual::Row(#field, (definition).field)))
