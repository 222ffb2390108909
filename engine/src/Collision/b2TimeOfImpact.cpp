// SPDX-License-Identifier: MIT
//
// Time of impact by conservative advancement (Mirtich 1996; Catto, "Continuous Collision", GDC
// 2013). At each time the closest features give an axis. The shapes may safely advance while a
// lower bound of their separation along that axis stays above the target.
//
// The bound is of second order. Along a fixed axis n, a vertex with the offset r from its centre is
//   x(t + h) = x(t) + x'(t) h + e,   x' = n.v + w n.(r turned left),   |e| <= w^2 |r| h^2 / 2
// so that the separation along n is at least
//   s(h) = min over B of (b + b' h) - max over A of (a + a' h) - k h^2 / 2
// with k = the sum of w^2 |r|. This is concave: it has one root, and all before it is safe. Without
// rotation the bound is exact, and a shape cast cannot miss. With rotation it never skips a
// contact.
//
// The axis may also rotate with a body. In a frame with the centre c, the velocity u and the
// angular velocity f, the same holds with
//   x' = n.(v - u + w (r turned left) - f (x - c turned left)),
//   |e| <= (|f^2 d + 2 f (d' turned left)| + (w - f)^2 |r|) h^2 / 2,   d = centre - c
// The end of a long rotating side approaches a fixed axis fast; in the frame of its own body it is
// at rest.
#include <Box2D/Collision/b2TimeOfImpact.h>

#include "Distance.h"
#include "ImpactTarget.h"
#include "SearchCounts.h"

#include <Box2D/Common/b2Timer.h>

namespace
{
// Limit of steps; a longer search advances slowly along an almost touching feature, and ends with
// the safe time. A box that rotates with 7500 rad/s takes up to 126 steps (see kMaxSmallMove). With
// 20, 50 and 800 no test changes.
constexpr int32 kMaxSteps = 200;

struct Vector
{
    double x;
    double y;
};

double Dot(const Vector& a, const Vector& b)
{
    return a.x * b.x + a.y * b.y;
}

struct Rotation
{
    double s;
    double c;
};

// A sweep in double precision relative to A's start, independent of the position in the world.
class Motion
{
public:
    Motion(const b2Sweep& sweep, const b2Vec2& origin, const b2DistanceProxy& proxy)
        : m_proxy(proxy), m_localCenter(sweep.localCenter)
    {
        m_start = {static_cast<double>(sweep.c0.x) - origin.x,
                   static_cast<double>(sweep.c0.y) - origin.y};
        m_velocity = {static_cast<double>(sweep.c.x) - sweep.c0.x,
                      static_cast<double>(sweep.c.y) - sweep.c0.y};
        m_startAngle = sweep.a0;
        m_spin = static_cast<double>(sweep.a) - sweep.a0;
        for (int32 i = 0; i < proxy.m_count; ++i)
        {
            const b2Vec2 r = proxy.m_vertices[i] - m_localCenter;
            m_reach = b2Max(m_reach, static_cast<double>(r.Length()));
        }
    }

    void MoveTo(double t)
    {
        m_center = {m_start.x + t * m_velocity.x, m_start.y + t * m_velocity.y};
        const auto [sine, cosine] = box2d::SinCos(m_startAngle + t * m_spin);
        m_q = {sine, cosine};
    }

    // Returns the offset of vertex i from the centre, in world axes.
    Vector Offset(int32 i) const
    {
        const double x = static_cast<double>(m_proxy.m_vertices[i].x) - m_localCenter.x;
        const double y = static_cast<double>(m_proxy.m_vertices[i].y) - m_localCenter.y;
        return {m_q.c * x - m_q.s * y, m_q.s * x + m_q.c * y};
    }

    // Returns the origin of the body's frame.
    Vector Origin() const
    {
        const double x = m_localCenter.x;
        const double y = m_localCenter.y;
        return {m_center.x - (m_q.c * x - m_q.s * y), m_center.y - (m_q.s * x + m_q.c * y)};
    }

    const Rotation& Q() const { return m_q; }
    const Vector& Center() const { return m_center; }
    const Vector& Velocity() const { return m_velocity; }
    double Spin() const { return m_spin; }
    double Reach() const { return m_reach; }
    double RimSpeed() const { return std::fabs(m_spin) * m_reach; }

private:
    const b2DistanceProxy& m_proxy;
    b2Vec2 m_localCenter;
    Vector m_start;
    Vector m_velocity; ///< over the whole sweep
    double m_startAngle;
    double m_spin; ///< over the whole sweep
    double m_reach = 0.0;
    Vector m_center = {0.0, 0.0};
    Rotation m_q = {0.0, 1.0};
};

b2Transform Relative(const Motion& a, const Motion& b)
{
    const Rotation& qA = a.Q();
    const Rotation& qB = b.Q();
    const Vector oA = a.Origin();
    const Vector oB = b.Origin();
    const Vector d = {oB.x - oA.x, oB.y - oA.y};
    b2Transform bInA;
    bInA.p.Set(static_cast<float32>(qA.c * d.x + qA.s * d.y),
               static_cast<float32>(qA.c * d.y - qA.s * d.x));
    bInA.q.s = static_cast<float32>(qA.c * qB.s - qA.s * qB.c);
    bInA.q.c = static_cast<float32>(qA.c * qB.c + qA.s * qB.s);
    return bInA;
}

// Returns a unit vector in A's frame. It is the normal of the closest side of A or B if known,
// because its precision does not depend on the distance. Otherwise it is the direction from the
// closest point of A to that of B.
b2Vec2 ClosestAxis(const b2SimplexCache& cache, const b2DistanceOutput& output,
                   const b2DistanceProxy& a, const b2DistanceProxy& b, const b2Transform& bInA)
{
    const b2Vec2 between = output.pointB - output.pointA;
    if (cache.count == 2)
    {
        const bool isSideOfA = cache.indexA[0] != cache.indexA[1];
        b2Vec2 axis =
            isSideOfA ? a.GetVertex(cache.indexA[1]) - a.GetVertex(cache.indexA[0])
                      : b2Mul(bInA.q, b.GetVertex(cache.indexB[1]) - b.GetVertex(cache.indexB[0]));
        axis = axis.Skew();
        if (axis.Normalize() > 0.0f)
        {
            return b2Dot(axis, between) < 0.0f ? -axis : axis;
        }
    }
    b2Vec2 axis = between;
    axis.Normalize();
    return axis;
}

Vector ToWorld(const Motion& a, const b2Vec2& v)
{
    const Rotation& q = a.Q();
    const Vector world = {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y};
    const double length = std::sqrt(Dot(world, world));
    return {world.x / length, world.y / length};
}

// The motion of the frame of the axis; zero for a fixed axis.
struct Frame
{
    Vector center = {0.0, 0.0};
    Vector velocity = {0.0, 0.0}; ///< over the whole sweep
    double spin = 0.0;            ///< over the whole sweep
};

Vector Minus(const Vector& a, const Vector& b)
{
    return {a.x - b.x, a.y - b.y};
}

// Returns the component along n of r turned left.
double Turned(const Vector& n, const Vector& r)
{
    return n.y * r.x - n.x * r.y;
}

// Returns a bound of the second derivative of a vertex in the frame, over the rest of the sweep.
// The first part is linear in time, so its maximum is at an end.
double Curvature(const Motion& motion, const Frame& frame, double remaining)
{
    const double f = frame.spin;
    const double w = motion.Spin() - f;
    const double own = w * w * motion.Reach();
    if (f == 0.0)
    {
        return own;
    }
    const Vector d = Minus(motion.Center(), frame.center);
    const Vector u = Minus(motion.Velocity(), frame.velocity);
    const Vector now = {f * f * d.x - 2.0 * f * u.y, f * f * d.y + 2.0 * f * u.x};
    const Vector end = {now.x + remaining * f * f * u.x, now.y + remaining * f * f * u.y};
    return own + std::sqrt(b2Max(Dot(now, now), Dot(end, end)));
}

// A vertex along the axis: its position and speed.
struct Mark
{
    double x;
    double speed;

    double At(double h) const { return x + speed * h; }
};

struct Marks
{
    Mark marks[b2_polygonCapacity];
    int32 count = 0;

    void Fill(const Motion& motion, const b2DistanceProxy& proxy, const Vector& n,
              const Frame& frame)
    {
        count = b2Min(proxy.m_count, b2_polygonCapacity);
        const Vector d = Minus(motion.Center(), frame.center);
        const double x = Dot(n, motion.Center());
        const double speed =
            Dot(n, Minus(motion.Velocity(), frame.velocity)) - frame.spin * Turned(n, d);
        const double spin = motion.Spin() - frame.spin;
        for (int32 i = 0; i < count; ++i)
        {
            const Vector r = motion.Offset(i);
            marks[i] = {x + Dot(n, r), speed + spin * Turned(n, r)};
        }
    }

    int32 Lowest(double h, double sign) const
    {
        int32 lowest = 0;
        for (int32 i = 1; i < count; ++i)
        {
            lowest = sign * marks[i].At(h) < sign * marks[lowest].At(h) ? i : lowest;
        }
        return lowest;
    }
};

// Returns the time for which the bound stays above the target; at most `maximum`. Negative if the
// shapes are closer than the target already. The root of the pair that is closest at h is not
// before that of the whole bound, so h decreases monotonically to it.
double SafeStep(const Marks& a, const Marks& b, double curvature, double target, double maximum,
                int32& iterations)
{
    double h = maximum;
    int32 lastA = -1;
    int32 lastB = -1;
    while (true)
    {
        ++iterations;
        const int32 i = a.Lowest(h, -1.0);
        const int32 j = b.Lowest(h, 1.0);
        const double gap = b.marks[j].x - a.marks[i].x - target;
        const double speed = b.marks[j].speed - a.marks[i].speed;
        const bool isSafe = gap + speed * h - 0.5 * curvature * h * h >= 0.0;
        if (isSafe || (i == lastA && j == lastB))
        {
            return h;
        }
        if (gap <= 0.0)
        {
            return -1.0;
        }
        const double root = 2.0 * gap / (std::sqrt(speed * speed + 2.0 * curvature * gap) - speed);
        if (!(root < h))
        {
            return h;
        }
        h = root;
        lastA = i;
        lastB = j;
    }
}

class Search
{
public:
    Search(const b2TOIInput& input, box2d::SearchCounts& counts)
        : m_input(input), m_counts(counts), m_a(input.sweepA, input.sweepA.c0, input.proxyA),
          m_b(input.sweepB, input.sweepA.c0, input.proxyB)
    {
        m_target = box2d::ImpactDistance(input.proxyA.m_radius + input.proxyB.m_radius);
        const double x = m_b.Velocity().x - m_a.Velocity().x;
        const double y = m_b.Velocity().y - m_a.Velocity().y;
        m_fastest = std::sqrt(x * x + y * y) + m_a.RimSpeed() + m_b.RimSpeed();
    }

    b2TOIOutput Run()
    {
        int32 steps = 0;
        const b2TOIOutput output = Advance(steps);
        ++m_counts.toiCalls;
        m_counts.toiIters += steps;
        m_counts.toiMaxIters = b2Max(m_counts.toiMaxIters, steps);
        return output;
    }

private:
    b2TOIOutput Advance(int32& steps)
    {
        double t = 0.0;
        while (steps < kMaxSteps)
        {
            ++steps;
            m_a.MoveTo(t);
            m_b.MoveTo(t);
            const b2Transform bInA = Relative(m_a, m_b);
            b2DistanceOutput closest;
            box2d::ShapeDistance(&closest, &m_cache, m_input.proxyA, m_input.proxyB, bInA, false);
            m_counts.AddDistance(closest.iterations);
            if (closest.distance <= 0.0f)
            {
                return {b2TOIOutput::e_overlapped, static_cast<float32>(t)};
            }
            if (closest.distance < m_target + box2d::kImpactTolerance)
            {
                return {b2TOIOutput::e_touching, static_cast<float32>(t)};
            }
            const double remaining = m_input.tMax - t;
            const double h = Step(closest, bInA, remaining);
            if (h >= remaining)
            {
                return {b2TOIOutput::e_separated, m_input.tMax};
            }
            t += h;
        }
        return {b2TOIOutput::e_failed, static_cast<float32>(t)};
    }

    double Step(const b2DistanceOutput& closest, const b2Transform& bInA, double remaining)
    {
        const b2Vec2 axis = ClosestAxis(m_cache, closest, m_input.proxyA, m_input.proxyB, bInA);
        const Vector n = ToWorld(m_a, axis);
        double h = -1.0;
        const Motion* side = SpinningSide();
        if (side != nullptr)
        {
            h = Step(n, {side->Center(), side->Velocity(), side->Spin()}, remaining);
        }
        if (h < remaining)
        {
            h = b2Max(h, Step(n, Frame(), remaining));
        }
        if (h > 0.0)
        {
            return h;
        }
        // The axis is too inexact for large and close shapes: bound by the maximum speed of any
        // point.
        const double gap = static_cast<double>(closest.distance) - m_target;
        return gap < m_fastest * remaining ? gap / m_fastest : remaining;
    }

    double Step(const Vector& n, const Frame& frame, double remaining) const
    {
        Marks a;
        Marks b;
        a.Fill(m_a, m_input.proxyA, n, frame);
        b.Fill(m_b, m_input.proxyB, n, frame);
        const double curvature =
            Curvature(m_a, frame, remaining) + Curvature(m_b, frame, remaining);
        int32 iterations = 0;
        const double step = SafeStep(a, b, curvature, m_target, remaining, iterations);
        m_counts.AddAdvance(iterations);
        return step;
    }

    // Returns the body whose frame the axis may use: the one with the closest side, if it rotates.
    const Motion* SpinningSide() const
    {
        if (m_cache.count != 2)
        {
            return nullptr;
        }
        const Motion& side = m_cache.indexA[0] != m_cache.indexA[1] ? m_a : m_b;
        return side.Spin() != 0.0 ? &side : nullptr;
    }

    const b2TOIInput& m_input;
    box2d::SearchCounts& m_counts;
    Motion m_a;
    Motion m_b;
    float32 m_target;
    double m_fastest; ///< bound of the relative speed of two points
    b2SimplexCache m_cache;
};
} // namespace

b2TOIOutput box2d::FindImpact(const b2TOIInput& input, bool isTimed, SearchCounts& counts)
{
    if (!B2_REQUIRE(input.proxyA.m_count > 0 && input.proxyB.m_count > 0,
                    "b2TimeOfImpact needs shapes with vertices; call b2DistanceProxy::Set first."))
    {
        return {b2TOIOutput::e_failed, 0.0f};
    }
    if (!isTimed)
    {
        return Search(input, counts).Run();
    }
    const b2Timer timer;
    const b2TOIOutput output = Search(input, counts).Run();
    const float32 time = timer.GetMilliseconds();
    counts.toiTime += time;
    counts.toiMaxTime = b2Max(counts.toiMaxTime, time);
    return output;
}

void b2TimeOfImpact(b2TOIOutput* output, const b2TOIInput* input)
{
    box2d::SearchCounts counts;
    *output = box2d::FindImpact(*input, true, counts);
    counts.Publish();
}
