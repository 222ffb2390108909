// SPDX-License-Identifier: MIT
#include "CollisionSupport.h"

#include <Collision/Manifolds.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{
// Cases in which two answers are closer together than this say nothing [m].
constexpr double kAmbiguous = 1.0e-3;
constexpr double kSkins = 2.0 * b2_polygonRadius;
constexpr double kPreferA = 0.1 * b2_linearSlop;

typedef std::vector<Vec> Polygon;

Polygon Place(const b2PolygonShape& shape, const b2Transform& xf)
{
    Polygon polygon;
    for (int32 i = 0; i < shape.m_count; ++i)
    {
        polygon.push_back(Transformed(xf, shape.m_vertices[i]));
    }
    return polygon;
}

Vec Normal(const Polygon& p, std::size_t i)
{
    const Vec e = p[(i + 1) % p.size()] - p[i];
    return Unit({e.y, -e.x});
}

// The best and second best separating face.
struct Best
{
    std::size_t face = 0;
    double separation = -1.0e30;
    double second = -1.0e30;
};

Best FindBest(const Polygon& a, const Polygon& b)
{
    Best best;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        double separation = 1.0e30;
        for (const Vec& v : b)
        {
            separation = std::min(separation, Dot(Normal(a, i), v - a[i]));
        }
        if (separation > best.separation)
        {
            best.second = best.separation;
            best.separation = separation;
            best.face = i;
        }
        else
        {
            best.second = std::max(best.second, separation);
        }
    }
    return best;
}

// Keeps the part of the segment below n.x = offset; false if there is none.
bool CutBelow(Vec* p, Vec* q, Vec n, double offset)
{
    const double hp = Dot(n, *p) - offset;
    const double hq = Dot(n, *q) - offset;
    if (hp > 0.0 && hq > 0.0)
    {
        return false;
    }
    if (hp > 0.0 || hq > 0.0)
    {
        const Vec cut = *p + (hp / (hp - hq)) * (*q - *p);
        (hp > 0.0 ? *p : *q) = cut;
    }
    return true;
}

struct Plain
{
    bool isClear = true;
    Vec normal;              ///< from the reference polygon
    std::vector<Vec> points; ///< of the incident polygon's core
};

Plain ClipPlainly(const Polygon& reference, const Polygon& incident, std::size_t face)
{
    Plain plain;
    plain.normal = Normal(reference, face);
    std::size_t side = 0;
    double minimum = 2.0;
    double second = 2.0;
    for (std::size_t i = 0; i < incident.size(); ++i)
    {
        const double facing = Dot(plain.normal, Normal(incident, i));
        if (facing < minimum)
        {
            second = minimum;
            minimum = facing;
            side = i;
        }
        else
        {
            second = std::min(second, facing);
        }
    }
    plain.isClear = second - minimum > kAmbiguous;
    Vec p = incident[side];
    Vec q = incident[(side + 1) % incident.size()];
    const Vec v1 = reference[face];
    const Vec v2 = reference[(face + 1) % reference.size()];
    const Vec along = Unit(v2 - v1);
    if (!CutBelow(&p, &q, -1.0 * along, kSkins - Dot(along, v1)) ||
        !CutBelow(&p, &q, along, kSkins + Dot(along, v2)))
    {
        return plain;
    }
    for (const Vec& v : {p, q})
    {
        const double height = Dot(plain.normal, v - v1);
        plain.isClear = plain.isClear && std::fabs(height - kSkins) > kAmbiguous;
        if (height <= kSkins)
        {
            plain.points.push_back(v);
        }
    }
    plain.isClear = plain.isClear && Length(q - p) > kAmbiguous;
    return plain;
}
} // namespace

TEST(Manifold, EqualsPlainClippingForPolygons)
{
    Random random(61);
    int twoPoints = 0;
    int onePoint = 0;
    for (int i = 0; i < 30000; ++i)
    {
        const b2PolygonShape a = random.Polygon(1.0f);
        const b2PolygonShape b = random.Polygon(1.0f);
        const b2Transform xfA = random.Transform(1.0f);
        const b2Transform xfB = random.Transform(1.0f);
        const Polygon pa = Place(a, xfA);
        const Polygon pb = Place(b, xfB);
        const Best bestA = FindBest(pa, pb);
        const Best bestB = FindBest(pb, pa);
        b2Manifold manifold;
        b2CollidePolygons(&manifold, &a, xfA, &b, xfB);
        const double separation = std::max(bestA.separation, bestB.separation);
        if (separation > kSkins + kAmbiguous)
        {
            ASSERT_EQ(manifold.pointCount, 0);
            continue;
        }
        const bool isFaceB = bestB.separation > bestA.separation + kPreferA;
        const Best& best = isFaceB ? bestB : bestA;
        const Plain plain =
            isFaceB ? ClipPlainly(pb, pa, bestB.face) : ClipPlainly(pa, pb, bestA.face);
        if (std::fabs(bestB.separation - bestA.separation - kPreferA) < 0.1 * kAmbiguous ||
            best.separation - best.second < kAmbiguous || separation > kSkins - kAmbiguous ||
            !plain.isClear)
        {
            continue;
        }
        ASSERT_EQ(manifold.pointCount, static_cast<int32>(plain.points.size())) << i;
        if (manifold.pointCount == 0)
        {
            continue;
        }
        ASSERT_EQ(manifold.type, isFaceB ? b2Manifold::e_faceB : b2Manifold::e_faceA) << i;
        b2WorldManifold world;
        world.Initialize(&manifold, xfA, a.m_radius, xfB, b.m_radius);
        const double sign = isFaceB ? -1.0 : 1.0;
        ASSERT_NEAR(world.normal.x, sign * plain.normal.x, 1.0e-5);
        ASSERT_NEAR(world.normal.y, sign * plain.normal.y, 1.0e-5);
        for (int32 k = 0; k < manifold.pointCount; ++k)
        {
            const Vec expected = plain.points[static_cast<std::size_t>(k)];
            const b2Vec2 actual = b2Mul(isFaceB ? xfA : xfB, manifold.points[k].localPoint);
            ASSERT_NEAR(actual.x, expected.x, 1.0e-4) << i;
            ASSERT_NEAR(actual.y, expected.y, 1.0e-4) << i;
        }
        twoPoints += manifold.pointCount == 2 ? 1 : 0;
        onePoint += manifold.pointCount == 1 ? 1 : 0;
    }
    EXPECT_GT(twoPoints, 3000);
    EXPECT_GT(onePoint, 500);
}

// The face of the first from which the other is furthest, one vertex after the other.
int32 PlainFace(const b2PolygonShape& polygon, const b2PolygonShape& other,
                const b2Transform& otherInPolygon, float32* separation)
{
    int32 face = 0;
    *separation = -b2_maxFloat;
    for (int32 i = 0; i < polygon.m_count; ++i)
    {
        float32 deepest = b2_maxFloat;
        for (int32 j = 0; j < other.m_count; ++j)
        {
            const b2Vec2 v = b2Mul(otherInPolygon, other.m_vertices[j]);
            deepest = b2Min(deepest, b2Dot(polygon.m_normals[i], v - polygon.m_vertices[i]));
        }
        if (deepest > *separation)
        {
            *separation = deepest;
            face = i;
        }
    }
    return face;
}

TEST(Manifold, HasTheFaceOfAPlainSearchToTheBit)
{
    Random random(64);
    int touching = 0;
    int apart = 0;
    for (int i = 0; i < 20000; ++i)
    {
        b2PolygonShape a = random.Polygon(1.0f);
        b2PolygonShape b = random.Polygon(random.Integer(0, 3) == 0 ? 1000.0f : 1.0f);
        if (i % 4 == 0)
        {
            a.SetAsBox(random.Real(0.1f, 1.0f), random.Real(0.1f, 1.0f));
        }
        b2Transform bInA = random.Transform(i % 2 == 0 ? 2.0f : 0.5f);
        if (i % 8 == 0) // the same polygon in the same place, or turned by a quarter
        {
            b = a;
            bInA = b2Transform(random.Integer(0, 1) == 0 ? b2Vec2_zero : bInA.p, b2Rot());
            bInA.q = random.Integer(0, 1) == 0 ? bInA.q : b2Rot(0.5f * b2_pi);
        }
        const b2Transform aInB(b2MulT(bInA.q, -bInA.p), b2MulT(bInA.q, b2Rot()));
        float32 separationA;
        float32 separationB;
        const int32 faceA = PlainFace(a, b, bInA, &separationA);
        const int32 faceB = PlainFace(b, a, aInB, &separationB);

        b2Manifold manifold;
        box2d::CollidePolygons(&manifold, a, b, bInA);
        const float32 radius = a.m_radius + b.m_radius;
        if (separationA > radius || separationB > radius)
        {
            ASSERT_EQ(manifold.pointCount, 0) << i;
            ++apart;
            continue;
        }
        const bool isFaceB = separationB > separationA + 0.1f * b2_linearSlop;
        ASSERT_EQ(manifold.type, isFaceB ? b2Manifold::e_faceB : b2Manifold::e_faceA) << i;
        ASSERT_EQ(manifold.localNormal, isFaceB ? b.m_normals[faceB] : a.m_normals[faceA]) << i;
        ++touching;
    }
    EXPECT_GT(touching, 5000);
    EXPECT_GT(apart, 2000);
}

TEST(Manifold, HasTwoPointsMidwayBetweenStackedBoxes)
{
    b2PolygonShape ground;
    ground.SetAsBox(10.0f, 1.0f);
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    const b2Transform xfA;
    const b2Transform xfB(b2Vec2(2.0f, 1.51f), b2Rot());
    b2Manifold manifold;
    b2CollidePolygons(&manifold, &ground, xfA, &box, xfB);
    ASSERT_EQ(manifold.pointCount, 2);
    b2WorldManifold world;
    world.Initialize(&manifold, xfA, ground.m_radius, xfB, box.m_radius);
    EXPECT_EQ(world.normal, b2Vec2(0.0f, 1.0f));
    for (int32 i = 0; i < 2; ++i)
    {
        EXPECT_NEAR(std::fabs(world.points[i].x - 2.0f), 0.5f, 1.0e-6f);
        EXPECT_NEAR(world.points[i].y, 1.005f, 1.0e-6f);
        EXPECT_NEAR(world.separations[i], -0.01f, 1.0e-6f);
    }
}

TEST(Manifold, KeepsItsIdsWhileABoxSlidesAndRocks)
{
    b2PolygonShape ground;
    ground.SetAsBox(10.0f, 1.0f);
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    b2Manifold before;
    b2CollidePolygons(&before, &ground, b2Transform(), &box,
                      b2Transform(b2Vec2(0.0f, 1.5f), b2Rot()));
    ASSERT_EQ(before.pointCount, 2);
    for (int i = 0; i < 1000; ++i)
    {
        const float f = static_cast<float>(i);
        const b2Transform xf(b2Vec2(0.005f * f, 1.505f),
                             b2Rot(0.01f * (i % 2 == 0 ? 1.0f : -1.0f)));
        b2Manifold after;
        b2CollidePolygons(&after, &ground, b2Transform(), &box, xf);
        b2PointState state1[2];
        b2PointState state2[2];
        b2GetPointStates(state1, state2, &before, &after);
        ASSERT_EQ(state2[0], b2_persistState) << i;
        ASSERT_EQ(state2[1], b2_persistState) << i;
        before = after;
    }
}

TEST(Manifold, KeepsItsReferenceFaceBetweenAlignedBoxes)
{
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    Random random(62);
    for (int i = 0; i < 2000; ++i)
    {
        const b2Transform xf{b2Vec2{random.Real(-0.2f, 0.2f), 1.0f + random.Real(-0.01f, 0.01f)},
                             b2Rot(random.Real(-1.0e-4f, 1.0e-4f))};
        b2Manifold manifold;
        b2CollidePolygons(&manifold, &box, b2Transform(), &box, xf);
        ASSERT_EQ(manifold.type, b2Manifold::e_faceA);
        ASSERT_EQ(manifold.pointCount, 2);
    }
}

// The internal form has no more to go by than the relative transform.
TEST(Manifold, DoesNotDependOnThePlaceInTheWorld)
{
    Random random(63);
    for (int i = 0; i < 2000; ++i)
    {
        const b2PolygonShape a = random.Polygon(1.0f);
        const b2PolygonShape b = random.Polygon(1.0f);
        const b2Transform bInA = random.Transform(1.0f);
        b2Manifold expected;
        box2d::CollidePolygons(&expected, a, b, bInA);
        b2Manifold actual;
        b2CollidePolygons(&actual, &a, b2Transform(), &b, bInA);
        ASSERT_EQ(actual.pointCount, expected.pointCount);
        for (int32 k = 0; k < actual.pointCount; ++k)
        {
            ASSERT_EQ(actual.points[k].localPoint, expected.points[k].localPoint);
            ASSERT_EQ(actual.points[k].id.key, expected.points[k].id.key);
        }
    }
}

TEST(Manifold, HasItsPointMidwayBetweenCircles)
{
    b2CircleShape a;
    a.m_radius = 1.0f;
    b2CircleShape b;
    b.m_radius = 0.5f;
    const b2Transform xfB(b2Vec2(0.0f, 1.4f), b2Rot(1.0f));
    b2Manifold manifold;
    b2CollideCircles(&manifold, &a, b2Transform(), &b, xfB);
    ASSERT_EQ(manifold.pointCount, 1);
    b2WorldManifold world;
    world.Initialize(&manifold, b2Transform(), a.m_radius, xfB, b.m_radius);
    EXPECT_EQ(world.normal, b2Vec2(0.0f, 1.0f));
    EXPECT_NEAR(world.points[0].y, 0.95f, 1.0e-6f);
    EXPECT_NEAR(world.separations[0], -0.1f, 1.0e-6f);
    b2CollideCircles(&manifold, &a, b2Transform(), &b, b2Transform(b2Vec2(1.6f, 0.0f), b2Rot()));
    EXPECT_EQ(manifold.pointCount, 0);
    b2CollideCircles(&manifold, &a, b2Transform(), &b, b2Transform());
    world.Initialize(&manifold, b2Transform(), a.m_radius, b2Transform(), b.m_radius);
    EXPECT_EQ(world.normal, b2Vec2(1.0f, 0.0f));
}

TEST(Manifold, HasTheNearestPointForPolygonAndCircle)
{
    Random random(64);
    int corners = 0;
    int faces = 0;
    for (int i = 0; i < 20000; ++i)
    {
        const b2PolygonShape a = random.Polygon(1.0f);
        const b2Transform xfA = random.Transform(1.0f);
        b2CircleShape b;
        b.m_radius = random.Real(0.1f, 0.5f);
        const b2Transform xfB = random.Transform(2.0f);
        const Polygon pa = Place(a, xfA);
        const Vec c = ToVec(xfB.p);
        // The point of the outline that is nearest to the centre.
        double minimum = 1.0e30;
        Vec nearest;
        bool isInside = true;
        bool isCorner = false;
        for (std::size_t k = 0; k < pa.size(); ++k)
        {
            const Vec e = pa[(k + 1) % pa.size()] - pa[k];
            isInside = isInside && Cross(e, c - pa[k]) > 0.0;
            const double t = Dot(c - pa[k], e) / Dot(e, e);
            const Vec p = pa[k] + std::clamp(t, 0.0, 1.0) * e;
            if (Length(c - p) < minimum)
            {
                minimum = Length(c - p);
                nearest = p;
                isCorner = t < 0.0 || t > 1.0;
            }
        }
        b2Manifold manifold;
        b2CollidePolygonAndCircle(&manifold, &a, xfA, &b, xfB);
        const double radius = static_cast<double>(a.m_radius) + b.m_radius;
        if (isInside)
        {
            ASSERT_EQ(manifold.pointCount, 1);
            continue;
        }
        if (std::fabs(minimum - radius) < 1.0e-4 || minimum < 1.0e-3)
        {
            continue;
        }
        ASSERT_EQ(manifold.pointCount, minimum < radius ? 1 : 0) << i;
        if (manifold.pointCount == 1)
        {
            b2WorldManifold world;
            world.Initialize(&manifold, xfA, a.m_radius, xfB, b.m_radius);
            const Vec normal = Unit(c - nearest);
            ASSERT_NEAR(world.normal.x, normal.x, 1.0e-3) << i;
            ASSERT_NEAR(world.normal.y, normal.y, 1.0e-3) << i;
            ASSERT_NEAR(world.separations[0], minimum - radius, 1.0e-4) << i;
            (isCorner ? corners : faces) += 1;
        }
    }
    EXPECT_GT(corners, 300);
    EXPECT_GT(faces, 500);
}

TEST(PointStates, ReportAddedKeptAndRemovedPoints)
{
    b2Manifold before;
    before.pointCount = 2;
    before.points[0].id.key = 1;
    before.points[1].id.key = 2;
    b2Manifold after;
    after.pointCount = 2;
    after.points[0].id.key = 2;
    after.points[1].id.key = 3;
    b2PointState state1[2];
    b2PointState state2[2];
    b2GetPointStates(state1, state2, &before, &after);
    EXPECT_EQ(state1[0], b2_removeState);
    EXPECT_EQ(state1[1], b2_persistState);
    EXPECT_EQ(state2[0], b2_persistState);
    EXPECT_EQ(state2[1], b2_addState);
    after.pointCount = 0;
    b2GetPointStates(state1, state2, &before, &after);
    EXPECT_EQ(state2[0], b2_nullState);
}

TEST(ClipSegment, KeepsWhatIsBelowTheLine)
{
    b2ClipVertex in[2];
    in[0].v.Set(-1.0f, 0.0f);
    in[1].v.Set(3.0f, 2.0f);
    in[0].id.cf.indexB = 5;
    b2ClipVertex out[2];
    ASSERT_EQ(b2ClipSegmentToLine(out, in, b2Vec2(1.0f, 0.0f), 1.0f, 7), 2);
    EXPECT_EQ(out[0].v, b2Vec2(-1.0f, 0.0f));
    EXPECT_EQ(out[1].v, b2Vec2(1.0f, 1.0f));
    EXPECT_EQ(out[1].id.cf.indexA, 7);
    EXPECT_EQ(out[1].id.cf.indexB, 5);
    EXPECT_EQ(out[1].id.cf.typeB, b2ContactFeature::e_face);
    EXPECT_EQ(b2ClipSegmentToLine(out, in, b2Vec2(1.0f, 0.0f), -2.0f, 0), 0);
}
