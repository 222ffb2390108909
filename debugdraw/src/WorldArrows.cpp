// SPDX-License-Identifier: MIT
#include "WorldSeen.h"

#include <debugdraw/Arrow.h>
#include <debugdraw/WorldArrows.h>

#include <cmath>

namespace boxreel
{

namespace
{

constexpr double kShortest = 1.5;  // shorter arrows are not legible [px]
constexpr double kHeadReach = 8.0; // upper bound of the head's extent beside the shaft [px]

void AddSeenArrow(const View& view, const b2Vec2& from, const b2Vec2& way, double scale,
                  ColorRole role, DrawList& list)
{
    const Vec2 tail{from.x, from.y};
    const Vec2 tip{float(from.x + way.x * scale), float(from.y + way.y * scale)};
    const double dx = double(tip.x) - tail.x;
    const double dy = double(tip.y) - tail.y;
    const double shortest = kShortest / (view.camera.pixelsPerMeter * view.zoom);
    if (dx * dx + dy * dy >= shortest * shortest && view.Shows(tail, tip, kHeadReach))
    {
        AddArrow(list, view.camera, tail, tip, role);
    }
}

/// Returns half the sum of the sides of the box around a body's shapes [m], 0 without shapes.
double SizeOf(const b2Body& body)
{
    Rect bounds;
    for (const b2Fixture* f = body.GetFixtureList(); f != nullptr; f = f->GetNext())
    {
        for (int32 child = 0; child < f->GetShape()->GetChildCount(); ++child)
        {
            b2AABB box;
            f->GetShape()->ComputeAABB(&box, body.GetTransform(), child);
            bounds.Include(
                Rect{{box.lowerBound.x, box.lowerBound.y}, {box.upperBound.x, box.upperBound.y}});
        }
    }
    return bounds.IsEmpty() ? 0.0
                            : 0.5 * (double(bounds.upper.x) - bounds.lower.x +
                                     double(bounds.upper.y) - bounds.lower.y);
}

} // namespace

void AddVelocities(const b2World& world, const View& view, double seconds, DrawList& list)
{
    list.layer = DrawLayer::Velocities;
    for (const b2Body* const body : AwakeBodies(world))
    {
        list.owner = static_cast<std::uint32_t>(body->GetNumber());
        AddSeenArrow(view, body->GetWorldCenter(), body->GetLinearVelocity(), seconds,
                     ColorRole::Velocity, list);
    }
    list.owner = kNoOwner;
}

void AddJointForces(const b2World& world, const View& view, double metersPerNewton, DrawList& list)
{
    list.layer = DrawLayer::JointForces;
    list.owner = kNoOwner;
    for (const b2Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext())
    {
        AddSeenArrow(view, joint->GetAnchorB(), joint->GetReactionForce(), metersPerNewton,
                     ColorRole::JointForce, list);
    }
}

double MetersPerNewtonFor(const b2World& world, double share)
{
    double mass = 0.0;
    double size = 0.0;
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        if (body->GetType() == b2_dynamicBody)
        {
            mass += body->GetMass();
            size += SizeOf(*body);
        }
    }
    const b2Vec2 gravity = world.GetGravity();
    const double strength =
        std::sqrt(double(gravity.x) * gravity.x + double(gravity.y) * gravity.y);
    const double scale = share * size / (mass * (strength > 0.0 ? strength : 10.0));
    constexpr double kUnknown = 0.01; // default without a size or a mass
    return scale > 0.0 && std::isfinite(scale) ? scale : kUnknown;
}

} // namespace boxreel
