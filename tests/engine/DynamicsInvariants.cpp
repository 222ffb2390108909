// SPDX-License-Identifier: MIT
#include "DynamicsInvariants.h"

#include <Dynamics/State/Access.h>
#include <Dynamics/State/World.h>

#include <Box2D/Box2D.h>

#include <map>
#include <set>

namespace dynamics
{
namespace
{

using box2d::BodyData;
using box2d::ConstraintGraph;
using box2d::ContactData;
using box2d::Data;
using box2d::JointAccess;
using box2d::World;

bool IsListed(const BodyData& body)
{
    return body.IsAwake() && body.IsActive() && body.mobility != box2d::Mobility::Static;
}

bool IsPushed(const BodyData& body)
{
    return IsListed(body) && body.IsDynamic();
}

/// One walk; stops at the first finding.
class Walker
{
public:
    Walker(World& world, bool afterStep) : m_world(world), m_afterStep(afterStep) {}

    std::string Run()
    {
        if (CheckBodies() && CheckProxies() && CheckContacts() && CheckJoints() && CheckColors() &&
            CheckIslands() && m_afterStep)
        {
            CheckHangingTogether();
        }
        return m_finding;
    }

private:
    bool Expect(bool condition, const char* sentence)
    {
        if (!condition)
        {
            m_finding = sentence;
        }
        return condition;
    }

    bool CheckBodies()
    {
        int32 count = 0;
        std::size_t listed = 0;
        const b2Body* previous = nullptr;
        for (b2Body* b = m_world.bodyList; b; b = b->GetNext())
        {
            const BodyData& body = Data(*b);
            const std::size_t place = std::size_t(body.awakeIndex);
            if (!Expect(body.prev == previous, "the list of bodies is not doubly linked") ||
                !Expect(body.world == &m_world, "a body belongs to another world") ||
                !Expect((body.awakeIndex != -1) == IsListed(body),
                        "a body's place among the awake is not what its state says") ||
                !Expect(body.awakeIndex == -1 ||
                            (place < m_world.awakeBodies.size() && m_world.awakeBodies[place] == b),
                        "a body is not where it believes to be among the awake") ||
                !Expect(IsFinite(body), "a body is not finite") ||
                !Expect(!body.IsDynamic() || body.invMass > 0.0f, "a dynamic body has no mass"))
            {
                return false;
            }
            listed += body.awakeIndex != -1 ? 1 : 0;
            previous = b;
            ++count;
        }
        return Expect(count == m_world.bodyCount, "the count of bodies is wrong") &&
               Expect(listed == m_world.awakeBodies.size(), "there are strangers among the awake");
    }

    static bool IsFinite(const BodyData& body)
    {
        return body.transform.p.IsValid() && body.linearVelocity.IsValid() &&
               b2IsValid(body.angularVelocity) && b2IsValid(float32(body.pose.angle)) &&
               b2IsValid(body.transform.q.s) && b2IsValid(body.mass) && b2IsValid(body.invMass) &&
               b2IsValid(body.inertia) && b2IsValid(body.invInertia) && body.localCenter.IsValid();
    }

    bool CheckProxies()
    {
        int32 count = 0;
        for (b2Body* b = m_world.bodyList; b; b = b->GetNext())
        {
            const BodyData& body = Data(*b);
            int32 fixtures = 0;
            for (b2Fixture* f = b->GetFixtureList(); f; f = f->GetNext())
            {
                ++fixtures;
                const int32 children = body.IsActive() ? f->GetShape()->GetChildCount() : 0;
                if (!Expect(f->GetBody() == b, "a fixture belongs to another body") ||
                    !Expect(box2d::FixtureAccess::ProxyCount(*f) == children,
                            "a fixture has not as many proxies as its body's state says"))
                {
                    return false;
                }
                for (int32 child = 0; child < children; ++child)
                {
                    if (!CheckProxy(body, box2d::FixtureAccess::Proxies(*f)[child], *f, child))
                    {
                        return false;
                    }
                    ++count;
                }
            }
            if (!Expect(fixtures == body.fixtureCount, "a body's count of fixtures is wrong"))
            {
                return false;
            }
        }
        for (int32 i = 0; i < box2d::Proxies::kTreeCount; ++i)
        {
            const char* why = m_world.proxies.TreeOf(static_cast<box2d::Mobility>(i)).WhyInvalid();
            if (!Expect(why == nullptr, why))
            {
                return false;
            }
        }
        return Expect(count == m_world.proxies.Count(), "the count of proxies is wrong");
    }

    /// A body's origin is rounded again in each step. The box of a tiny shape has no margin for
    /// that.
    static b2AABB Rounded(const b2AABB& box, const BodyData& body)
    {
        const float32 far = b2Abs(body.worldCenter.x) + b2Abs(body.worldCenter.y) + body.maxExtent;
        const b2Vec2 rounding(4.0f * b2_epsilon * far, 4.0f * b2_epsilon * far);
        b2AABB result;
        result.lowerBound = box.lowerBound - rounding;
        result.upperBound = box.upperBound + rounding;
        return result;
    }

    bool CheckProxy(const BodyData& body, const b2FixtureProxy& proxy, const b2Fixture& fixture,
                    int32 child)
    {
        if (!Expect(box2d::Proxies::MobilityOf(proxy.proxyId) == body.mobility,
                    "a proxy is in another tree than its body's mobility says") ||
            !Expect(m_world.proxies.Get(proxy.proxyId) == &proxy, "a tree's leaf is another proxy"))
        {
            return false;
        }
        const b2AABB& box = m_world.proxies.FatBox(proxy.proxyId);
        b2AABB tight;
        fixture.GetShape()->ComputeAABB(&tight, body.transform, child);
        return Expect(Rounded(box, body).Contains(tight),
                      "a shape has left the box that stands for it") &&
               Expect(proxy.fixture == &fixture && proxy.childIndex == child,
                      "a proxy stands for another child") &&
               Expect(box.lowerBound == proxy.aabb.lowerBound &&
                          box.upperBound == proxy.aabb.upperBound,
                      "a proxy's box is not that of its tree");
    }

    bool CheckContacts()
    {
        int32 count = 0;
        std::size_t awake = 0;
        const b2Contact* previous = nullptr;
        for (b2Contact* contact = m_world.contactList; contact; contact = contact->GetNext())
        {
            const ContactData& c = Data(*contact);
            if (!Expect(c.prev == previous, "the list of contacts is not doubly linked") ||
                !CheckContact(*contact, c))
            {
                return false;
            }
            m_contactEdges.insert({&c.edgeA, c.bodyA});
            m_contactEdges.insert({&c.edgeB, c.bodyB});
            awake += c.awakeIndex != -1 ? 1 : 0;
            previous = contact;
            ++count;
        }
        return Expect(count == m_world.contactCount, "the count of contacts is wrong") &&
               Expect(awake == m_world.awakeContacts.size(),
                      "there are strangers among the awake contacts") &&
               CheckContactEdges();
    }

    bool CheckContact(b2Contact& contact, const ContactData& c)
    {
        const BodyData& a = Data(*c.bodyA);
        const BodyData& b = Data(*c.bodyB);
        const std::size_t place = std::size_t(c.awakeIndex);
        const bool solved = c.IsTouching() && !c.IsSensor() && (IsPushed(a) || IsPushed(b));
        const bool linked = c.IsTouching() && !c.IsSensor() && a.island != -1 && b.island != -1;
        return Expect(c.bodyA == c.FixtureA()->GetBody() && c.bodyB == c.FixtureB()->GetBody(),
                      "a contact's fixtures are not of its bodies") &&
               Expect(c.bodyA != c.bodyB && (a.IsDynamic() || b.IsDynamic()),
                      "a contact is between bodies that cannot collide") &&
               Expect(a.IsActive() && b.IsActive(), "a contact has an inactive body") &&
               Expect(m_world.pairs.Contains(Proxy(c.FixtureA(), c.ChildA()),
                                             Proxy(c.FixtureB(), c.ChildB())),
                      "a contact is not in the set of pairs") &&
               Expect((c.awakeIndex != -1) == (IsListed(a) || IsListed(b)),
                      "a contact's place among the awake is not what its bodies say") &&
               Expect(c.awakeIndex == -1 || (place < m_world.awakeContacts.size() &&
                                             m_world.awakeContacts[place] == &contact),
                      "a contact is not where it believes to be among the awake") &&
               Expect((c.color != -1) == solved, "a contact's colour is not what its state says") &&
               Expect(((c.flags & box2d::kContactLinked) != 0) == linked,
                      "a contact's link is not what its state says") &&
               Expect(c.IsSensor() == (c.FixtureA()->IsSensor() || c.FixtureB()->IsSensor()),
                      "a contact does not know of its sensor") &&
               Expect(!linked || a.island == b.island, "a contact's bodies are of two islands");
    }

    static int32 Proxy(b2Fixture* fixture, int32 child)
    {
        return box2d::FixtureAccess::Proxies(*fixture)[child].proxyId;
    }

    bool CheckContactEdges()
    {
        std::size_t found = 0;
        for (b2Body* b = m_world.bodyList; b; b = b->GetNext())
        {
            const b2ContactEdge* previous = nullptr;
            for (b2ContactEdge* edge = b->GetContactList(); edge; edge = edge->next)
            {
                const auto known = m_contactEdges.find(edge);
                if (!Expect(known != m_contactEdges.end() && known->second == b,
                            "a body's contact is not in the world's list") ||
                    !Expect(edge->prev == previous, "a body's contacts are not doubly linked") ||
                    !Expect(edge->other != b, "a contact edge leads back"))
                {
                    return false;
                }
                previous = edge;
                ++found;
            }
        }
        return Expect(found == m_contactEdges.size(), "a body misses one of its contacts");
    }

    bool CheckJoints()
    {
        int32 count = 0;
        const b2Joint* previous = nullptr;
        std::map<const b2JointEdge*, const b2Body*> edges;
        for (b2Joint* joint = m_world.jointList; joint; joint = joint->GetNext())
        {
            const BodyData& a = Data(*joint->GetBodyA());
            const BodyData& b = Data(*joint->GetBodyB());
            const bool active = a.IsActive() && b.IsActive();
            const bool linked = active && a.island != -1 && b.island != -1;
            if (!Expect(JointAccess::Prev(*joint) == previous,
                        "the list of joints is not doubly linked") ||
                !Expect((JointAccess::SolverIndex(*joint) != -1) ==
                            (active && (IsPushed(a) || IsPushed(b))),
                        "whether a joint is solved is not what its state says") ||
                !Expect(JointAccess::Linked(*joint) == linked,
                        "a joint's link is not what its state says") ||
                !Expect(!linked || a.island == b.island, "a joint's bodies are of two islands"))
            {
                return false;
            }
            edges.insert({&JointAccess::EdgeA(*joint), joint->GetBodyA()});
            edges.insert({&JointAccess::EdgeB(*joint), joint->GetBodyB()});
            previous = joint;
            ++count;
        }
        return Expect(count == m_world.jointCount, "the count of joints is wrong") &&
               CheckJointEdges(edges);
    }

    bool CheckJointEdges(const std::map<const b2JointEdge*, const b2Body*>& edges)
    {
        std::size_t found = 0;
        for (b2Body* b = m_world.bodyList; b; b = b->GetNext())
        {
            const b2JointEdge* previous = nullptr;
            for (b2JointEdge* edge = b->GetJointList(); edge; edge = edge->next)
            {
                const auto known = edges.find(edge);
                if (!Expect(known != edges.end() && known->second == b,
                            "a body's joint is not in the world's list") ||
                    !Expect(edge->prev == previous, "a body's joints are not doubly linked"))
                {
                    return false;
                }
                previous = edge;
                ++found;
            }
        }
        return Expect(found == edges.size(), "a body misses one of its joints");
    }

    bool CheckColors()
    {
        std::map<const b2Body*, uint32> masks;
        for (int32 color = 0; color < ConstraintGraph::kColorCount; ++color)
        {
            std::set<const b2Body*> bodies;
            const auto& list = m_world.graph.Contacts(color);
            if (!Expect((m_world.graph.UsedColors() >> color & 1u) == (list.empty() ? 0u : 1u),
                        "a colour is wrongly known to have contacts, or none"))
            {
                return false;
            }
            for (std::size_t i = 0; i < list.size(); ++i)
            {
                const ContactData& c = Data(*list[i]);
                if (!Expect(c.color == color && c.colorIndex == int32(i),
                            "a contact is not where it believes to be in its colour") ||
                    !Take(*c.bodyA, color, bodies, masks) || !Take(*c.bodyB, color, bodies, masks))
                {
                    return false;
                }
            }
        }
        const auto& joints = m_world.graph.Joints();
        for (std::size_t i = 0; i < joints.size(); ++i)
        {
            if (!Expect(JointAccess::SolverIndex(*joints[i]) == int32(i),
                        "a joint is not where it believes to be among the solved"))
            {
                return false;
            }
        }
        for (b2Body* b = m_world.bodyList; b; b = b->GetNext())
        {
            if (!Expect(Data(*b).colorMask == masks[b],
                        "a body's mask of colours is not that of its constraints"))
            {
                return false;
            }
        }
        return true;
    }

    bool Take(const b2Body& body, int32 color, std::set<const b2Body*>& bodies,
              std::map<const b2Body*, uint32>& masks)
    {
        if (color == ConstraintGraph::kOverflow || !Data(body).IsDynamic())
        {
            return true;
        }
        masks[&body] |= 1u << color;
        return Expect(bodies.insert(&body).second, "two constraints of a colour share a body");
    }

    bool CheckIslands()
    {
        std::map<int32, int32> members;
        for (b2Body* b = m_world.bodyList; b; b = b->GetNext())
        {
            const BodyData& body = Data(*b);
            if (!Expect((body.island != -1) == (body.IsDynamic() && body.IsActive()),
                        "a body's island is not what its state says"))
            {
                return false;
            }
            if (body.island != -1)
            {
                ++members[body.island];
            }
        }
        for (const auto& [index, count] : members)
        {
            const box2d::Islands::Island& island = m_world.islands.At(index);
            const b2Body* previous = nullptr;
            int32 found = 0;
            for (b2Body* b = island.first; b; b = Data(*b).islandNext)
            {
                if (!Expect(Data(*b).islandPrev == previous, "an island is not doubly linked") ||
                    !Expect(Data(*b).island == index, "an island has a body of another one"))
                {
                    return false;
                }
                previous = b;
                ++found;
            }
            if (!Expect(found == count && found == island.count,
                        "an island's count of bodies is wrong") ||
                !Expect(island.last == previous, "an island's last body is another one"))
            {
                return false;
            }
        }
        return true;
    }

    // Connected bodies are awake or asleep together.
    void CheckHangingTogether()
    {
        for (b2Contact* contact = m_world.contactList; contact; contact = contact->GetNext())
        {
            const ContactData& c = Data(*contact);
            Expect((c.flags & box2d::kContactLinked) == 0 ||
                       Data(*c.bodyA).IsAwake() == Data(*c.bodyB).IsAwake(),
                   "of two touching bodies one sleeps and one is awake");
        }
        for (b2Joint* joint = m_world.jointList; joint; joint = joint->GetNext())
        {
            Expect(!JointAccess::Linked(*joint) ||
                       joint->GetBodyA()->IsAwake() == joint->GetBodyB()->IsAwake(),
                   "of two joined bodies one sleeps and one is awake");
        }
    }

    World& m_world;
    bool m_afterStep;
    std::string m_finding;
    std::map<const b2ContactEdge*, const b2Body*> m_contactEdges;
};

} // namespace

std::string WhyBroken(b2World& world, bool afterStep)
{
    if (world.GetBodyList() == nullptr)
    {
        return world.GetBodyCount() == 0 && world.GetContactCount() == 0 &&
                       world.GetJointCount() == 0 && world.GetProxyCount() == 0
                   ? ""
                   : "an empty world counts something";
    }
    return Walker(*box2d::Data(*world.GetBodyList()).world, afterStep).Run();
}

} // namespace dynamics
