// SPDX-License-Identifier: MIT
#include "Corners.h"
#include "Bouncer.h"

#include "../State/World.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>
#include <span>

namespace box2d
{

namespace
{

/// Walls form a corner if the cosine of the angle between their normals is below this: up to an
/// opening of 84 degrees. With 0 the rounding of normals would decide about right angles, where no
/// bounce off one wall drives a body into the other. From -0.5 to 0 no test fails; with -1 there
/// are no corners, and six tests of balls and boxes in corners fail.
constexpr float32 kCornerCosine = -0.1f;

/// The contacts of one body.
class Corner
{
public:
    Corner(const BodyData& body, CornerMemory& memory, const SolverContext& context)
        : m_body(body), m_memory(memory), m_context(context)
    {}

    void Bounce()
    {
        if (!FindWalls())
        {
            return;
        }
        Prepare();
        if ((IsAcute() || RollsOff()) && (PushOut() || Leaves()))
        {
            ForgetImpulses();
        }
    }

private:
    /// False unless the body touches walls at rest, and nothing else, and has no joint.
    bool FindWalls()
    {
        if (m_body.jointList != nullptr)
        {
            return false;
        }
        m_memory.contacts.clear();
        for (const b2ContactEdge* edge = m_body.contactList; edge; edge = edge->next)
        {
            const ContactData& c = Data(*edge->contact);
            if (c.IsSensor() || !c.IsTouching() || c.Form() == 0)
            {
                continue;
            }
            const BodyData& other = Data(*edge->other);
            if (other.IsDynamic() || other.linearVelocity != b2Vec2_zero ||
                other.angularVelocity != 0.0f || c.restitution > 1.0f)
            {
                return false;
            }
            m_memory.contacts.push_back(edge->contact);
        }
        return !m_memory.contacts.empty();
    }

    void Prepare()
    {
        const std::size_t count = m_memory.contacts.size();
        if (m_memory.blocks.size() < count)
        {
            m_memory.blocks.resize(count);
            m_memory.overlaps.resize(count);
        }
        m_memory.totals.assign(count, BlockTotals());
        for (std::size_t i = 0; i < count; ++i)
        {
            PrepareAlone(*m_memory.contacts[i], m_memory.blocks[i], m_memory.overlaps[i],
                         m_context);
        }
    }

    std::span<ContactBlock> Blocks() const
    {
        return std::span(m_memory.blocks).first(m_memory.contacts.size());
    }

    /// Returns the normal of a contact, towards the body.
    b2Vec2 NormalOf(const ContactBlock& block) const
    {
        const b2Vec2 normal(block.normalX[0], block.normalY[0]);
        return block.bodyB[0] == m_body.SolverIndex() ? normal : -normal;
    }

    bool IsAcute() const
    {
        const auto blocks = Blocks();
        for (std::size_t i = 0; i < blocks.size(); ++i)
        {
            for (std::size_t k = 0; k < i; ++k)
            {
                if (b2Dot(NormalOf(blocks[i]), NormalOf(blocks[k])) < kCornerCosine)
                {
                    return true;
                }
            }
        }
        return false;
    }

    /// True if one of two points at a wall leaves it while the other one comes. The iterations of a
    /// step would hold the leaving point at the wall, which is work.
    bool RollsOff() const
    {
        return Blocks().size() == 1 &&
               std::ranges::any_of(Blocks(), [&](const ContactBlock& block) {
                   return block.pointCount == 2 &&
                          NormalSpeedOf(block, 0, 0, m_context.bodies) *
                                  NormalSpeedOf(block, 0, 1, m_context.bodies) <
                              0.0f;
               });
    }

    /// True if anything bounced.
    bool PushOut()
    {
        bool any = false;
        bool bounced = true;
        for (int32 iteration = 0; iteration < kMaxBounces && bounced; ++iteration)
        {
            bounced = false;
            for (std::size_t i = 0; i < Blocks().size(); ++i)
            {
                const float32 restitution = Data(*m_memory.contacts[i]).restitution;
                bounced = (restitution > 0.0f &&
                           Bouncer(m_memory.blocks[i], m_memory.totals[i], 0, m_context)
                               .Bounce(restitution)) ||
                          bounced;
            }
            any = any || bounced;
        }
        return any;
    }

    /// True if a point that a wall pushed in the last step leaves it as fast as after an impact.
    bool Leaves() const
    {
        return std::ranges::any_of(Blocks(), [&](const ContactBlock& block) {
            for (int32 i = 0; i < block.pointCount; ++i)
            {
                if (block.points[i].normalImpulse[0] > 0.0f &&
                    NormalSpeedOf(block, 0, i, m_context.bodies) >
                        m_context.settings.restitutionThreshold)
                {
                    return true;
                }
            }
            return false;
        });
    }

    /// The impulses of the last step are those of impacts, which are over.
    void ForgetImpulses()
    {
        for (std::size_t i = 0; i < m_memory.contacts.size(); ++i)
        {
            b2Manifold& manifold = Data(*m_memory.contacts[i]).manifold;
            const BlockTotals& totals = m_memory.totals[i];
            CornerImpulse impulse = {m_memory.contacts[i], {}, {}};
            for (int32 k = 0; k < manifold.pointCount; ++k)
            {
                manifold.points[k].normalImpulse = manifold.points[k].tangentImpulse = 0.0f;
                impulse.normal[k] = totals.normal[k][0];
                impulse.tangent[k] = totals.tangent[k][0];
            }
            m_memory.impulses.push_back(impulse);
        }
    }

    const BodyData& m_body;
    CornerMemory& m_memory;
    const SolverContext& m_context;
};

/// True if a point of the body may be fast enough for an impact [m/s].
bool MayBounce(const BodyData& body, const SolverContext& context)
{
    const SolverBody& s = context.bodies[body.SolverIndex()];
    return b2Abs(s.v.x) + b2Abs(s.v.y) + b2Abs(s.w) * body.maxExtent >
           context.settings.restitutionThreshold;
}

} // namespace

void BounceInCorners(const World& world, CornerMemory& memory, const SolverContext& context)
{
    for (int32 color = ConstraintGraph::kFirstOfGround; color < ConstraintGraph::kOverflow; ++color)
    {
        for (b2Contact* contact : world.graph.Contacts(color))
        {
            const ContactData& c = Data(*contact);
            const BodyData& body = Data(Data(*c.bodyA).IsDynamic() ? *c.bodyA : *c.bodyB);
            const bool inCorner = ConstraintGraph::IsSecondOfGround(body.colorMask, color);
            const bool rolls =
                c.restitution > 0.0f && c.manifold.pointCount == 2 && body.colorMask == 1u << color;
            if ((inCorner || rolls) && MayBounce(body, context))
            {
                Corner(body, memory, context).Bounce();
            }
        }
    }
}

} // namespace box2d
