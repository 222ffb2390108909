// SPDX-License-Identifier: MIT
//
// Distance by GJK (Gilbert, Johnson, Keerthi 1988; Catto, "Computing Distance", GDC 2010). The
// distance of two shapes is that of the origin from the set of all differences b - a, which is
// convex. A simplex of one to three of its points moves towards the origin until no support point
// is nearer.
#include <Box2D/Collision/b2Distance.h>

#include "Distance.h"
#include "SearchCounts.h"

#include <Box2D/Collision/Shapes/b2ChainShape.h>
#include <Box2D/Collision/Shapes/b2CircleShape.h>
#include <Box2D/Collision/Shapes/b2EdgeShape.h>
#include <Box2D/Collision/Shapes/b2PolygonShape.h>

// NOLINTNEXTLINE(bugprone-unhandled-self-assignment): it copies the numbers onto themselves.
b2DistanceProxy& b2DistanceProxy::operator=(const b2DistanceProxy& other)
{
    m_buffer[0] = other.m_buffer[0];
    m_buffer[1] = other.m_buffer[1];
    m_vertices = other.m_vertices == other.m_buffer ? m_buffer : other.m_vertices;
    m_count = other.m_count;
    m_radius = other.m_radius;
    return *this;
}

void b2DistanceProxy::Set(const b2Shape* shape, int32 index)
{
    m_radius = shape->m_radius;
    m_vertices = m_buffer;
    m_count = 1;
    switch (shape->GetType())
    {
    case b2Shape::e_circle:
        m_vertices = &static_cast<const b2CircleShape*>(shape)->m_p;
        break;
    case b2Shape::e_polygon:
        m_vertices = static_cast<const b2PolygonShape*>(shape)->m_vertices;
        m_count = static_cast<const b2PolygonShape*>(shape)->m_count;
        break;
    case b2Shape::e_edge:
        m_buffer[0] = static_cast<const b2EdgeShape*>(shape)->m_vertex1;
        m_buffer[1] = static_cast<const b2EdgeShape*>(shape)->m_vertex2;
        m_count = 2;
        break;
    case b2Shape::e_chain: {
        const b2ChainShape* chain = static_cast<const b2ChainShape*>(shape);
        if (B2_REQUIRE(0 <= index && index < chain->GetChildCount(),
                       "A chain's children are numbered from 0 to GetChildCount() - 1."))
        {
            m_vertices = chain->m_vertices + index;
            m_count = 2;
        }
        break;
    }
    default:
        B2_REQUIRE(false, "b2DistanceProxy::Set got a shape of no known type.");
        break;
    }
}

namespace box2d
{
namespace
{
// A bound: convex shapes of 16 vertices need 2 to 5 iterations. With 5 and 80 no test changes.
constexpr int32 kMaxIterations = 20;

struct Vertex
{
    b2Vec2 a;              ///< of A, in A's frame
    b2Vec2 b;              ///< of B, in A's frame
    b2Vec2 w;              ///< b - a
    float32 weight = 0.0f; ///< of the point nearest to the origin; the weights of a simplex sum to
                           ///< 1
    uint8 indexA = 0;
    uint8 indexB = 0;
};

struct Simplex
{
    Vertex v[3];
    int32 count = 0;
};

Vertex MakeVertex(const b2DistanceProxy& proxyA, const b2DistanceProxy& proxyB,
                  const b2Transform& bInA, int32 indexA, int32 indexB)
{
    Vertex vertex;
    vertex.a = proxyA.m_vertices[indexA];
    vertex.b = b2Mul(bInA, proxyB.m_vertices[indexB]);
    vertex.w = vertex.b - vertex.a;
    vertex.weight = 1.0f;
    vertex.indexA = static_cast<uint8>(indexA);
    vertex.indexB = static_cast<uint8>(indexB);
    return vertex;
}

float32 Metric(const Simplex& s)
{
    switch (s.count)
    {
    case 2:
        return b2Distance(s.v[0].w, s.v[1].w);
    case 3:
        return b2Cross(s.v[1].w - s.v[0].w, s.v[2].w - s.v[0].w);
    default:
        return 0.0f;
    }
}

// Starts with the simplex of the last call for these shapes, unless it has changed its size too
// much or lost its area.
Simplex ReadCache(const b2SimplexCache& cache, const b2DistanceProxy& proxyA,
                  const b2DistanceProxy& proxyB, const b2Transform& bInA)
{
    Simplex s;
    if (cache.count <= 3)
    {
        for (int32 i = 0; i < cache.count; ++i)
        {
            if (cache.indexA[i] >= proxyA.m_count || cache.indexB[i] >= proxyB.m_count)
            {
                s.count = 0; // the cache is of another pair of shapes
                break;
            }
            s.v[s.count++] = MakeVertex(proxyA, proxyB, bInA, cache.indexA[i], cache.indexB[i]);
        }
    }
    if (s.count > 1)
    {
        const float32 before = cache.metric;
        const float32 after = Metric(s);
        if (after < 0.5f * before || after > 2.0f * before || after < b2_epsilon)
        {
            s.count = 0;
        }
    }
    if (s.count == 0)
    {
        s.v[s.count++] = MakeVertex(proxyA, proxyB, bInA, 0, 0);
    }
    return s;
}

void WriteCache(b2SimplexCache* cache, const Simplex& s)
{
    cache->metric = Metric(s);
    cache->count = static_cast<uint16>(s.count);
    for (int32 i = 0; i < s.count; ++i)
    {
        cache->indexA[i] = s.v[i].indexA;
        cache->indexB[i] = s.v[i].indexB;
    }
}

void KeepOne(Simplex* s, int32 i)
{
    s->v[0] = s->v[i];
    s->v[0].weight = 1.0f;
    s->count = 1;
}

// The projection of the origin on the segment from i to j; the weights are not normalized.
struct Projection
{
    float32 onI;
    float32 onJ;
};

Projection Project(const Simplex& s, int32 i, int32 j)
{
    const b2Vec2 e = s.v[j].w - s.v[i].w;
    return {b2Dot(s.v[j].w, e), -b2Dot(s.v[i].w, e)};
}

void KeepTwo(Simplex* s, int32 i, int32 j, const Projection& p)
{
    const Vertex first = s->v[i];
    const Vertex second = s->v[j];
    const float32 scale = 1.0f / (p.onI + p.onJ);
    s->v[0] = first;
    s->v[1] = second;
    s->v[0].weight = p.onI * scale;
    s->v[1].weight = p.onJ * scale;
    s->count = 2;
}

void SolveSegment(Simplex* s)
{
    const Projection p = Project(*s, 0, 1);
    if (p.onJ <= 0.0f)
    {
        KeepOne(s, 0);
    }
    else if (p.onI <= 0.0f)
    {
        KeepOne(s, 1);
    }
    else
    {
        KeepTwo(s, 0, 1, p);
    }
}

// Keeps the part of the triangle nearest to the origin. It is a corner if the origin projects
// beyond both of its sides. It is a side if the origin is outside and projects onto it. Otherwise
// it is the whole triangle.
void SolveTriangle(Simplex* s)
{
    const Projection p01 = Project(*s, 0, 1);
    const Projection p12 = Project(*s, 1, 2);
    const Projection p20 = Project(*s, 2, 0);
    if (p01.onJ <= 0.0f && p20.onI <= 0.0f)
    {
        KeepOne(s, 0);
        return;
    }
    if (p01.onI <= 0.0f && p12.onJ <= 0.0f)
    {
        KeepOne(s, 1);
        return;
    }
    if (p12.onI <= 0.0f && p20.onJ <= 0.0f)
    {
        KeepOne(s, 2);
        return;
    }

    // Areas of the triangles of the origin and each side, positive inside.
    const b2Vec2 w0 = s->v[0].w;
    const b2Vec2 w1 = s->v[1].w;
    const b2Vec2 w2 = s->v[2].w;
    const float32 area = b2Cross(w1 - w0, w2 - w0);
    const float32 area01 = area * b2Cross(w0, w1);
    const float32 area12 = area * b2Cross(w1, w2);
    const float32 area20 = area * b2Cross(w2, w0);
    if (area01 <= 0.0f && p01.onI > 0.0f && p01.onJ > 0.0f)
    {
        KeepTwo(s, 0, 1, p01);
    }
    else if (area12 <= 0.0f && p12.onI > 0.0f && p12.onJ > 0.0f)
    {
        KeepTwo(s, 1, 2, p12);
    }
    else if (area20 <= 0.0f && p20.onI > 0.0f && p20.onJ > 0.0f)
    {
        KeepTwo(s, 2, 0, p20);
    }
    else
    {
        const float32 scale = 1.0f / (area01 + area12 + area20);
        s->v[0].weight = area12 * scale;
        s->v[1].weight = area20 * scale;
        s->v[2].weight = area01 * scale;
    }
}

void Solve(Simplex* s)
{
    if (s->count == 2)
    {
        SolveSegment(s);
    }
    else if (s->count == 3)
    {
        SolveTriangle(s);
    }
}

// Returns the direction from the simplex towards the origin.
b2Vec2 SearchDirection(const Simplex& s)
{
    if (s.count == 1)
    {
        return -s.v[0].w;
    }
    // Normal to the segment, on the origin's side: more precise than the nearest point when that is
    // close.
    const b2Vec2 across = (s.v[1].w - s.v[0].w).Skew();
    return b2Dot(across, s.v[0].w) > 0.0f ? -across : across;
}

bool Contains(const Simplex& s, const Vertex& vertex)
{
    for (int32 i = 0; i < s.count; ++i)
    {
        if (s.v[i].indexA == vertex.indexA && s.v[i].indexB == vertex.indexB)
        {
            return true;
        }
    }
    return false;
}

int32 Iterate(Simplex* s, const b2DistanceProxy& proxyA, const b2DistanceProxy& proxyB,
              const b2Transform& bInA)
{
    int32 iterations = 0;
    while (true)
    {
        const Simplex before = *s;
        Solve(s);
        if (s->count == 3 || iterations == kMaxIterations)
        {
            return iterations; // the origin is inside, or rounding prevents progress
        }
        const b2Vec2 d = SearchDirection(*s);
        if (d.LengthSquared() < b2_epsilon * b2_epsilon)
        {
            return iterations; // the origin is on the simplex
        }
        ++iterations;
        const Vertex vertex = MakeVertex(proxyA, proxyB, bInA, proxyA.GetSupport(-d),
                                         proxyB.GetSupport(b2MulT(bInA.q, d)));
        // A repeated support point means no further progress.
        if (Contains(before, vertex))
        {
            return iterations;
        }
        s->v[s->count++] = vertex;
    }
}

void WriteOutput(b2DistanceOutput* output, const Simplex& s)
{
    output->pointA.SetZero();
    output->pointB.SetZero();
    for (int32 i = 0; i < s.count; ++i)
    {
        const float32 weight = s.count == 1 ? 1.0f : s.v[i].weight;
        output->pointA += weight * s.v[i].a;
        output->pointB += weight * s.v[i].b;
    }
    if (s.count == 3)
    {
        output->pointB = output->pointA;
    }
    output->distance = b2Distance(output->pointA, output->pointB);
}

// Moves the points from the cores to the skins; overlapping skins touch half-way.
void ApplyRadii(b2DistanceOutput* output, float32 radiusA, float32 radiusB)
{
    b2Vec2 normal = output->pointB - output->pointA;
    if (output->distance > radiusA + radiusB && output->distance > b2_epsilon)
    {
        normal.Normalize();
        output->distance -= radiusA + radiusB;
        output->pointA += radiusA * normal;
        output->pointB -= radiusB * normal;
    }
    else
    {
        output->pointA = 0.5f * (output->pointA + output->pointB);
        output->pointB = output->pointA;
        output->distance = 0.0f;
    }
}
} // namespace

void ShapeDistance(b2DistanceOutput* output, b2SimplexCache* cache, const b2DistanceProxy& proxyA,
                   const b2DistanceProxy& proxyB, const b2Transform& bInA, bool useRadii)
{
    if (!B2_REQUIRE(proxyA.m_count > 0 && proxyB.m_count > 0,
                    "b2Distance needs shapes with vertices; call b2DistanceProxy::Set first."))
    {
        *output = b2DistanceOutput();
        output->distance = b2_maxFloat;
        cache->count = 0;
        return;
    }
    Simplex s = ReadCache(*cache, proxyA, proxyB, bInA);
    output->iterations = Iterate(&s, proxyA, proxyB, bInA);
    WriteOutput(output, s);
    WriteCache(cache, s);
    if (useRadii)
    {
        ApplyRadii(output, proxyA.m_radius, proxyB.m_radius);
    }
}

bool TestOverlap(const b2Shape& shapeA, int32 indexA, const b2Shape& shapeB, int32 indexB,
                 const b2Transform& bInA)
{
    b2DistanceProxy proxyA;
    b2DistanceProxy proxyB;
    proxyA.Set(&shapeA, indexA);
    proxyB.Set(&shapeB, indexB);
    b2SimplexCache cache;
    b2DistanceOutput output;
    ShapeDistance(&output, &cache, proxyA, proxyB, bInA, true);
    return output.distance < 10.0f * b2_epsilon;
}
} // namespace box2d

void b2Distance(b2DistanceOutput* output, b2SimplexCache* cache, const b2DistanceInput* input)
{
    box2d::ShapeDistance(output, cache, input->proxyA, input->proxyB,
                         b2MulT(input->transformA, input->transformB), input->useRadii);
    output->pointA = b2Mul(input->transformA, output->pointA);
    output->pointB = b2Mul(input->transformA, output->pointB);
    box2d::SearchCounts counts;
    counts.AddDistance(output->iterations);
    counts.Publish();
}
