// SPDX-License-Identifier: MIT
#include <Box2D/Collision/Shapes/b2ChainShape.h>

#include <memory>
#include <new>

b2ChainShape::~b2ChainShape()
{
    Clear();
}

b2ChainShape::b2ChainShape(const b2ChainShape& other) : b2Shape(other)
{
    *this = other;
}

b2ChainShape& b2ChainShape::operator=(const b2ChainShape& other)
{
    if (this == &other)
    {
        return *this;
    }
    Clear();
    b2Shape::operator=(other);
    if (other.m_count > 0)
    {
        m_vertices =
            static_cast<b2Vec2*>(b2Alloc(other.m_count * static_cast<int32>(sizeof(b2Vec2))));
        std::uninitialized_copy_n(other.m_vertices, other.m_count, m_vertices);
        m_count = other.m_count;
    }
    m_prevVertex = other.m_prevVertex;
    m_nextVertex = other.m_nextVertex;
    m_hasPrevVertex = other.m_hasPrevVertex;
    m_hasNextVertex = other.m_hasNextVertex;
    m_oneSided = other.m_oneSided;
    return *this;
}

void b2ChainShape::Clear()
{
    if (m_vertices != nullptr)
    {
        b2Free(m_vertices);
    }
    m_vertices = nullptr;
    m_count = 0;
    m_hasPrevVertex = false;
    m_hasNextVertex = false;
    m_oneSided = false;
}

void b2ChainShape::TakeVertices(const b2Vec2* vertices, int32 count, int32 minimum, bool isLoop)
{
    B2_REQUIRE(m_vertices == nullptr,
               "The chain already has vertices; call Clear before creating it again.");
    Clear();
    if (!B2_REQUIRE(vertices != nullptr && count >= minimum,
                    "A chain needs at least 2 vertices, a loop at least 3.") ||
        count == INT32_MAX)
    {
        return;
    }

    constexpr float32 slop2 = b2_linearSlop * b2_linearSlop;
    m_vertices = static_cast<b2Vec2*>(b2Alloc((count + 1) * static_cast<int32>(sizeof(b2Vec2))));
    for (int32 i = 0; i < count; ++i)
    {
        const bool isFinite = B2_REQUIRE(vertices[i].IsValid(),
                                         "A chain has a vertex that is not finite; look for NaN.");
        const bool isApart =
            isFinite &&
            B2_REQUIRE(m_count == 0 ||
                           b2DistanceSquared(m_vertices[m_count - 1], vertices[i]) > slop2,
                       "A chain's neighbouring vertices must be more than b2_linearSlop apart; "
                       "leave one of them out.");
        if (isApart)
        {
            new (&m_vertices[m_count++]) b2Vec2(vertices[i]);
        }
    }
    if (isLoop && m_count > 1 &&
        !B2_REQUIRE(b2DistanceSquared(m_vertices[0], m_vertices[m_count - 1]) > slop2,
                    "A loop closes itself; leave out the last vertex when it repeats the first."))
    {
        --m_count;
    }
    if (m_count < minimum)
    {
        Clear();
    }
}

void b2ChainShape::CreateLoop(const b2Vec2* vertices, int32 count)
{
    TakeVertices(vertices, count, 3, true);
    if (m_count == 0)
    {
        return;
    }
    new (&m_vertices[m_count++]) b2Vec2(m_vertices[0]);
    SetPrevVertex(m_vertices[m_count - 2]);
    SetNextVertex(m_vertices[1]);
}

void b2ChainShape::CreateChain(const b2Vec2* vertices, int32 count)
{
    TakeVertices(vertices, count, 2, false);
}

void b2ChainShape::CreateChain(const b2Vec2* vertices, int32 count, const b2Vec2& prevVertex,
                               const b2Vec2& nextVertex)
{
    CreateChain(vertices, count);
    SetPrevVertex(prevVertex);
    SetNextVertex(nextVertex);
    m_oneSided = true;
}

void b2ChainShape::SetPrevVertex(const b2Vec2& prevVertex)
{
    m_prevVertex = prevVertex;
    m_hasPrevVertex = true;
}

void b2ChainShape::SetNextVertex(const b2Vec2& nextVertex)
{
    m_nextVertex = nextVertex;
    m_hasNextVertex = true;
}

b2Shape* b2ChainShape::Clone(b2BlockAllocator* allocator) const
{
    return new (allocator->Allocate(sizeof(b2ChainShape))) b2ChainShape(*this);
}

void b2ChainShape::GetChildEdge(b2EdgeShape* edge, int32 index) const
{
    if (!B2_REQUIRE(0 <= index && index < GetChildCount(),
                    "A chain's children are numbered from 0 to GetChildCount() - 1."))
    {
        return;
    }
    const bool isFirst = index == 0;
    const bool isLast = index == m_count - 2;
    edge->m_radius = m_radius;
    edge->m_vertex1 = m_vertices[index];
    edge->m_vertex2 = m_vertices[index + 1];
    edge->m_vertex0 = isFirst ? m_prevVertex : m_vertices[index - 1];
    edge->m_vertex3 = isLast ? m_nextVertex : m_vertices[index + 2];
    edge->m_hasVertex0 = !isFirst || m_hasPrevVertex;
    edge->m_hasVertex3 = !isLast || m_hasNextVertex;
    edge->m_oneSided = m_oneSided;
}

bool b2ChainShape::TestPoint(const b2Transform& transform, const b2Vec2& p) const
{
    B2_NOT_USED(transform);
    B2_NOT_USED(p);
    return false;
}

bool b2ChainShape::RayCast(b2RayCastOutput* output, const b2RayCastInput& input,
                           const b2Transform& xf, int32 childIndex) const
{
    b2EdgeShape edge;
    GetChildEdge(&edge, childIndex);
    edge.m_oneSided = false; // rays meet both sides, as in 2.4
    return edge.RayCast(output, input, xf, 0);
}

void b2ChainShape::ComputeAABB(b2AABB* aabb, const b2Transform& xf, int32 childIndex) const
{
    b2EdgeShape edge;
    GetChildEdge(&edge, childIndex);
    edge.ComputeAABB(aabb, xf, 0);
}

void b2ChainShape::ComputeMass(b2MassData* massData, float32 density) const
{
    B2_NOT_USED(density);
    *massData = b2MassData();
}
