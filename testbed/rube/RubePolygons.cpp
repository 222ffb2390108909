// SPDX-License-Identifier: MIT
#include "RubePolygons.h"

#include <algorithm>

namespace boxreel
{

namespace
{

/// True if these are the corners that SetAsBox makes, in its order. A file then restores the box
/// bit by bit.
bool IsBox(const std::vector<b2Vec2>& vertices)
{
    if (vertices.size() != 4)
    {
        return false;
    }
    const b2Vec2& half = vertices[2];
    return half.x > 0.0f && half.y > 0.0f && vertices[0] == -half &&
           vertices[1] == b2Vec2(half.x, -half.y) && vertices[3] == b2Vec2(-half.x, half.y);
}

/// Set begins with the rightmost vertex. A shape made with another first vertex, by SetAsBox with
/// an offset, keeps it: contacts are identified by the numbers of vertices.
void BeginWith(const b2Vec2& first, b2PolygonShape& shape)
{
    const auto corners = shape.m_vertices;
    const auto at = std::find(corners, corners + shape.m_count, first) - corners;
    if (at < shape.m_count)
    {
        std::rotate(corners, corners + at, corners + shape.m_count);
        std::rotate(shape.m_normals, shape.m_normals + at, shape.m_normals + shape.m_count);
    }
}

/// A file may say other bits of a normal, not another direction.
bool AreNormals(const std::vector<b2Vec2>& normals, const b2PolygonShape& shape)
{
    constexpr float32 kRounding = 1e-4f;
    bool are = normals.size() == std::size_t(shape.m_count);
    for (std::size_t i = 0; are && i < normals.size(); ++i)
    {
        are = b2Distance(normals[i], shape.m_normals[i]) < kRounding;
    }
    return are;
}

} // namespace

void SetPolygon(const RubePolygon& polygon, b2PolygonShape& shape)
{
    if (IsBox(polygon.vertices))
    {
        shape.SetAsBox(polygon.vertices[2].x, polygon.vertices[2].y);
    }
    else
    {
        shape.Set(polygon.vertices.data(), static_cast<int32>(polygon.vertices.size()));
        BeginWith(polygon.vertices.front(), shape);
    }
    if (AreNormals(polygon.normals, shape))
    {
        std::copy(polygon.normals.begin(), polygon.normals.end(), shape.m_normals);
    }
}

RubePolygon PolygonOf(const b2PolygonShape& shape)
{
    RubePolygon polygon{{shape.m_vertices, shape.m_vertices + shape.m_count}};
    b2PolygonShape back;
    SetPolygon(polygon, back);
    if (!std::equal(shape.m_normals, shape.m_normals + shape.m_count, back.m_normals,
                    back.m_normals + back.m_count))
    {
        polygon.normals.assign(shape.m_normals, shape.m_normals + shape.m_count);
    }
    return polygon;
}

} // namespace boxreel
