// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/b2Interpolation.h>

#include "../State/World.h"

#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2World.h>

#include <cmath>

namespace
{

using box2d::Data;
using box2d::Pose;

double Distance(const Pose& a, const Pose& b)
{
    const double x = b.x - a.x;
    const double y = b.y - a.y;
    return std::sqrt(x * x + y * y);
}

/// Equal ends give themselves: no rounding.
double Mix(double from, double to, double fraction)
{
    return from == to ? to : from + fraction * (to - from);
}

Pose Between(const Pose& before, const Pose& now, double fraction)
{
    if (fraction >= 1.0)
    {
        return now;
    }
    return {Mix(before.x, now.x, fraction), Mix(before.y, now.y, fraction),
            Mix(before.angle, now.angle, fraction)};
}

/// By a user change, not by a step. A small change is interpolated.
bool HasJumped(const box2d::BodyData& body, const Pose& before, std::uint32_t step)
{
    return body.userMovedAt >= step && Distance(before, body.pose) > double(b2_maxTranslation);
}

bool IsSame(const Pose& a, const Pose& b)
{
    return a.x == b.x && a.y == b.y && a.angle == b.angle;
}

} // namespace

void b2PoseRecord::Save(const b2World& world)
{
    m_entries.clear();
    for (const b2Body* body = world.GetBodyList(); body; body = body->GetNext())
    {
        if (body->GetType() != b2_staticBody)
        {
            m_entries.push_back({body->GetNumber(), Data(*body).pose});
            m_step = Data(*body).world->stepNumber;
        }
    }
}

b2PosesBetween::b2PosesBetween(b2World& world, const b2PoseRecord& before, double fraction)
{
    b2Body* body = world.GetBodyList();
    if (!B2_REQUIRE(!world.IsLocked(),
                    "b2PosesBetween must not be called from inside a callback.") ||
        !B2_REQUIRE(fraction >= 0.0 && fraction <= 1.0,
                    "b2PosesBetween needs a fraction from 0 to 1.") ||
        body == nullptr)
    {
        return;
    }
    m_locked = Data(*body).world;
    m_locked->locked = true;
    auto entry = before.m_entries.begin(); // both lists have descending numbers
    for (; body; body = body->GetNext())
    {
        while (entry != before.m_entries.end() && entry->number > body->GetNumber())
        {
            ++entry;
        }
        if (entry != before.m_entries.end() && entry->number == body->GetNumber())
        {
            const box2d::BodyData& data = Data(*body);
            const bool stays = fraction < 1.0 && HasJumped(data, entry->pose, before.m_step);
            Show(*body, stays ? entry->pose : Between(entry->pose, data.pose, fraction));
        }
    }
}

void b2PosesBetween::Show(b2Body& body, const Pose& pose)
{
    box2d::BodyData& data = Data(body);
    if (IsSame(pose, data.pose))
    {
        return;
    }
    m_owns.push_back(
        {&body, data.pose, data.rotation, data.transform, data.worldCenter, data.room});
    // Rounds up: the conversion to float may lower the distance by 6e-8 of it.
    constexpr double kRoundedUp = 1.0001;
    // The arc is longer than its chord, so this is an upper bound.
    const double distance = Distance(pose, data.pose) +
                            std::fabs(pose.angle - data.pose.angle) * double(data.maxExtent);
    m_farthest = b2Max(m_farthest, float32(kRoundedUp * distance));
    data.pose = pose;
    box2d::SynchronizePose(data);
}

b2PosesBetween::~b2PosesBetween()
{
    for (const Own& own : m_owns)
    {
        box2d::BodyData& data = Data(*own.body);
        data.pose = own.pose;
        data.rotation = own.rotation;
        data.transform = own.transform;
        data.worldCenter = own.worldCenter;
        data.room = own.room;
    }
    if (m_locked)
    {
        m_locked->locked = false;
    }
}
