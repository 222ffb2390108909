// SPDX-License-Identifier: MIT
#include "RandomWorldsTrial.h"

#include "EnergyAccount.h"

#include <cstdio>
#include <ostream>

namespace stability
{

namespace
{

bool IsFinite(const b2Body& body)
{
    return body.GetPosition().IsValid() && b2IsValid(body.GetAngle()) &&
           body.GetLinearVelocity().IsValid() && b2IsValid(body.GetAngularVelocity());
}

double Beyond(const b2Vec2& point, const b2Vec2& half, double radius)
{
    return radius + double(b2Max(b2Abs(point.x) - half.x, b2Abs(point.y) - half.y));
}

/// Returns the maximum distance of a body's shapes beyond the walls, without the skins of polygons.
double Beyond(const PlannedBody& plan, const b2Body& body, const b2Vec2& half)
{
    double maximum = -1e9;
    for (const PlannedShape& shape : plan.shapes)
    {
        for (const b2Vec2& point : shape.points)
        {
            maximum = b2Max(maximum, Beyond(body.GetWorldPoint(point), half, double(shape.radius)));
        }
    }
    return maximum;
}

/// Watches a world from step to step.
class Watch
{
public:
    explicit Watch(RandomWorld& world) : m_world(world) {}

    void Look(const EnergyAccount& account, Trial& trial)
    {
        const double excess = account.Excess();
        if (excess > trial.excess)
        {
            trial.excess = excess;
            trial.excessTime = m_world.Time();
        }
        for (std::size_t i = 0; i < m_world.Bodies().size(); ++i)
        {
            Look(i, trial);
        }
    }

private:
    void Look(std::size_t index, Trial& trial)
    {
        const b2Body& body = *m_world.Bodies()[index];
        const b2Vec2 half = m_world.Plan().half;
        trial.finite = trial.finite && IsFinite(body);
        const double out = Beyond(m_world.Plan().bodies[index], body, half);
        if (out > trial.out)
        {
            trial.out = out;
            trial.outTime = m_world.Time();
            trial.outBody = int(index);
        }
        trial.centreOut = b2Max(trial.centreOut, Beyond(body.GetWorldCenter(), half, 0.0));
    }

    RandomWorld& m_world;
};

void PrintLine(std::ostream& out, RandomWorld& world, const EnergyAccount& account,
               const Trial& trial)
{
    float32 fastest = 0.0f;
    std::size_t which = 0;
    for (std::size_t i = 0; i < world.Bodies().size(); ++i)
    {
        const float32 speed = world.Bodies()[i]->GetLinearVelocity().Length();
        which = speed > fastest ? i : which;
        fastest = b2Max(fastest, speed);
    }
    char line[256];
    std::snprintf(line, sizeof line,
                  "%7.3f %12.4f %12.4f %12.4f %12.4f %12.4f %9.4f%% %8.2f (%2zu) %8.4f\n",
                  double(world.Time()), account.Kinetic(), account.Potential(), account.Stored(),
                  account.Total(), account.Allowed(), 100.0 * account.Excess(), double(fastest),
                  which, trial.out);
    out << line;
}

} // namespace

Trial RunWorld(const WorldPlan& plan, std::ostream* timeLine)
{
    RandomWorld world(plan);
    EnergyAccount account(world);
    Watch watch(world);
    Trial trial;
    if (timeLine != nullptr)
    {
        *timeLine << "   time      kinetic    potential       stored        total      allowed"
                     "     excess  fastest body   outside\n";
        PrintLine(*timeLine, world, account, trial);
    }
    while (!world.IsOver() && trial.finite)
    {
        account.BeforeTargets();
        world.MoveTargets();
        account.AfterTargets();
        account.BeforeStep();
        world.Step();
        account.AfterStep();
        watch.Look(account, trial);
        if (timeLine != nullptr)
        {
            PrintLine(*timeLine, world, account, trial);
        }
    }
    return trial;
}

std::string WhyFailed(const Trial& trial)
{
    char text[256] = "";
    if (!trial.finite)
    {
        return "A body is no longer at a finite place.";
    }
    if (trial.centreOut > 0.0 || trial.out > kMaxOut)
    {
        std::snprintf(text, sizeof text, "Body %d is %.3f m beyond the walls at %.3f s.",
                      trial.outBody, trial.out, double(trial.outTime));
    }
    if (trial.excess > kMaxExcess)
    {
        std::snprintf(text, sizeof text, "There is %.2f %% more energy than was put in at %.3f s.",
                      100.0 * trial.excess, double(trial.excessTime));
    }
    return text;
}

WorldPlan Reduced(WorldPlan plan)
{
    const auto fails = [](const WorldPlan& p) { return !WhyFailed(RunWorld(p)).empty(); };
    for (bool changed = true; changed;)
    {
        changed = false;
        for (int i = int(plan.bodies.size()) - 1; i >= 0; --i)
        {
            WorldPlan less = plan;
            less.RemoveBody(i);
            if (fails(less))
            {
                plan = less;
                changed = true;
            }
        }
        for (int i = int(plan.joints.size()) - 1; i >= 0; --i)
        {
            WorldPlan less = plan;
            if (i < int(less.joints.size()))
            {
                less.RemoveJoint(i);
                if (fails(less))
                {
                    plan = less;
                    changed = true;
                }
            }
        }
    }
    return plan;
}

} // namespace stability
