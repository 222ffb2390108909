// SPDX-License-Identifier: MIT
#include "RubeCrowd.h"

#include <Box2D/Box2D.h>

namespace boxreel
{

namespace
{

/// Counts in halves, for a pair of two that move is met from both sides.
class PairCounter : public b2QueryCallback
{
public:
    bool IsTooMany() const { return m_halves > 2 * kMaxPairs; }

    bool ReportFixture(b2Fixture* fixture) override
    {
        m_halves += fixture->GetBody()->GetType() == b2_staticBody ? 2 : 1;
        return !IsTooMany();
    }

private:
    std::size_t m_halves = 0;
};

} // namespace

bool IsTooCrowded(const b2World& world)
{
    PairCounter pairs;
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        if (body->GetType() == b2_staticBody || !body->IsActive())
        {
            continue; // without boxes, or met by those that move
        }
        for (const b2Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
        {
            for (int32 child = 0; child < f->GetShape()->GetChildCount(); ++child)
            {
                world.QueryAABB(&pairs, f->GetAABB(child));
                if (pairs.IsTooMany())
                {
                    return true;
                }
            }
        }
    }
    return false;
}

} // namespace boxreel
