// SPDX-License-Identifier: MIT
#include <scenes/Samples.h>

namespace boxreel
{

b2Fixture* AttachSample(b2Body& body, int32 kind, float32 size, const Material& material)
{
    const float32 s = size;
    const float32 diagonal = 0.7071f * s; // of a circle's radius at 45 degrees
    switch (kind)
    {
    case 0:
        return AttachPolygon(body, {{-0.866f * s, -0.5f * s}, {0.866f * s, -0.5f * s}, {0.0f, s}},
                             material);
    case 1:
        return AttachPolygon(body,
                             {{-0.8f * s, -0.6f * s},
                              {0.8f * s, -0.6f * s},
                              {0.4f * s, 0.6f * s},
                              {-0.4f * s, 0.6f * s}},
                             material);
    case 2:
        return AttachBox(body, diagonal, diagonal, material);
    case 3:
        return AttachPolygon(body,
                             {{s, 0.0f},
                              {diagonal, diagonal},
                              {0.0f, s},
                              {-diagonal, diagonal},
                              {-s, 0.0f},
                              {-diagonal, -diagonal},
                              {0.0f, -s},
                              {diagonal, -diagonal}},
                             material);
    default:
        return AttachCircle(body, 0.9f * s, material);
    }
}

b2Body* AddSample(b2World& world, int32 kind, const b2Vec2& position, float32 angle, float32 size,
                  const Material& material)
{
    b2Body* body = AddBody(world, b2_dynamicBody, position, angle);
    AttachSample(*body, kind, size, material);
    return body;
}

} // namespace boxreel
