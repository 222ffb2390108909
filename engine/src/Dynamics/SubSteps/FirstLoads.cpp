// SPDX-License-Identifier: MIT
#include "FirstLoads.h"

#include "../Islands/SleepRule.h"
#include "../Solver/SolverMemory.h"
#include "../State/World.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>

namespace box2d
{

namespace
{

/// A contact whose vertical part is below this fraction of its impulse does not support a body.
/// That is a slope of 60 degrees, where the impulse would be twice the weight. The first iterations
/// correct it, so no verdict changes from 0.05 to 0.95.
constexpr double kMinLift = 0.5;
/// Relative determinant from which on the contacts of a body also balance its moment. Two contacts
/// that are nearer than 6e-5 of their levers count as one: the levers are rounded by 1e-7. From
/// 1e-14 to 1e-3 no test fails. With 1e9 no moment is balanced, and stacks do not carry their loads
/// in the first step.
constexpr double kMinDeterminant = 1e-9;

std::size_t At(int32 index)
{
    return std::size_t(index);
}

bool IsAtRest(const BodyData& body)
{
    return IsSlow(body.linearVelocity, body.angularVelocity) && body.jointList == nullptr;
}

} // namespace

void FirstLoads::Find(const World& world, SolverMemory& arrays, float32 duration)
{
    m_points.clear();
    if (world.settings.gravity.LengthSquared() > 0.0f)
    {
        GatherPoints(world, arrays);
    }
    if (m_points.empty())
    {
        return;
    }
    SortFromTheTop(world);
    const double weight = double(duration) * double(world.settings.gravity.Length());
    for (const int32 index : m_order)
    {
        const BodyData& body = Data(*world.awakeBodies[At(index - 1)]);
        m_bodies[At(index)].lift += weight * double(body.gravityScale) / double(body.invMass);
    }
    for (const int32 index : m_order)
    {
        PassOn(index);
    }
}

void FirstLoads::GatherPoints(const World& world, SolverMemory& arrays)
{
    for (int32 i = 0; i < arrays.colorCount; ++i)
    {
        ContactBlocks& blocks = arrays.contacts[arrays.colors[i]];
        blocks.ForLanes([&](int32 index, int32 lane) {
            ContactBlock& block = blocks.Contacts(index);
            if (block.fresh)
            {
                GatherPoint(world, block, lane);
            }
        });
    }
}

void FirstLoads::GatherPoint(const World& world, ContactBlock& block, int32 lane)
{
    const int32 a = block.bodyA[lane];
    const int32 b = block.bodyB[lane];
    const ContactData& contact = Data(*block.contact[lane]);
    if (contact.lastShare >= 0.0f || !IsAtRest(Data(*contact.bodyA)) ||
        !IsAtRest(Data(*contact.bodyB)))
    {
        return;
    }
    const b2Vec2& g = world.settings.gravity;
    const double up =
        -(double(block.normalX[lane]) * double(g.x) + double(block.normalY[lane]) * double(g.y)) /
        double(g.Length());
    const bool isUpperB = up > 0.0;
    if (!(b2Abs(up) > kMinLift) ||
        (isUpperB ? block.masses.invMassB : block.masses.invMassA)[lane] == 0.0f)
    {
        return;
    }
    for (int32 i = 0; i < block.pointCount; ++i)
    {
        PointLanes& p = block.points[i];
        // The impulse acts along the normal on B, and against it on A.
        const double momentA = -double(p.normalLeverA[lane]);
        const double momentB = double(p.normalLeverB[lane]);
        float32* impulse = &p.normalImpulse[lane];
        const auto order = int32(m_points.size());
        m_points.push_back(isUpperB ? Point{impulse, b, a, order, up, momentB, momentA}
                                    : Point{impulse, a, b, order, -up, momentA, momentB});
    }
}

void FirstLoads::SortFromTheTop(const World& world)
{
    const auto depth = [&](int32 index) {
        const Pose& pose = Data(*world.awakeBodies[At(index - 1)]).pose;
        return pose.x * double(world.settings.gravity.x) +
               pose.y * double(world.settings.gravity.y);
    };
    std::sort(m_points.begin(), m_points.end(), [](const Point& a, const Point& b) {
        return a.upper != b.upper ? a.upper < b.upper : a.order < b.order;
    });
    m_bodies.assign(world.awakeBodies.size() + 2, Body());
    m_order.clear();
    for (std::size_t i = 0; i < m_points.size(); ++i)
    {
        const int32 upper = m_points[i].upper;
        if (m_order.empty() || m_order.back() != upper)
        {
            m_order.push_back(upper);
            m_bodies[At(upper)].firstPoint = int32(i);
        }
    }
    std::sort(m_order.begin(), m_order.end(),
              [&](int32 a, int32 b) { return depth(a) != depth(b) ? depth(a) < depth(b) : a < b; });
}

/// Distributes a body's weight and load to the bodies below it, with the minimum sum of squared
/// impulses. Each is lift * x + moment * y, where x and y satisfy the balance of force and moment.
/// Negative impulses are set to zero.
void FirstLoads::PassOn(int32 index)
{
    const Body& body = m_bodies[At(index)];
    Point* const first = m_points.data() + body.firstPoint;
    Point* last = first;
    while (last != m_points.data() + m_points.size() && last->upper == index)
    {
        ++last;
    }
    bool pulls = true;
    while (pulls && first != last)
    {
        double ll = 0.0;
        double lm = 0.0;
        double mm = 0.0;
        for (const Point* p = first; p != last; ++p)
        {
            ll += p->lift * p->lift;
            lm += p->lift * p->upperMoment;
            mm += p->upperMoment * p->upperMoment;
        }
        const double determinant = ll * mm - lm * lm;
        const bool turns =
            determinant > kMinDeterminant * ll * mm; // otherwise one point, or all in a line
        const double x = turns ? (mm * body.lift - lm * body.moment) / determinant : body.lift / ll;
        const double y = turns ? (ll * body.moment - lm * body.lift) / determinant : 0.0;
        const auto isPulling = [&](const Point& p) { return p.lift * x + p.upperMoment * y < 0.0; };
        Point* const end = std::remove_if(first, last, isPulling);
        pulls = end != last;
        last = end;
        for (Point* p = first; p != last && !pulls; ++p)
        {
            const double impulse = p->lift * x + p->upperMoment * y;
            *p->impulse = float32(impulse);
            m_bodies[At(p->lower)].lift += impulse * p->lift;
            m_bodies[At(p->lower)].moment -= impulse * p->lowerMoment;
        }
    }
}

} // namespace box2d
