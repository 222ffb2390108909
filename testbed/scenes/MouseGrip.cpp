// SPDX-License-Identifier: MIT
#include <scenes/MouseGrip.h>

#include <scenes/SceneState.h>

namespace boxreel
{

namespace
{

constexpr float32 kReach = 0.001f;            // around the point, for the query [m]
constexpr float32 kMaxAcceleration = 1000.0f; // of the body by the joint's force [m/s^2]

/// The youngest dynamic body with a fixture that contains a point.
class BodyAt : public b2QueryCallback
{
public:
    explicit BodyAt(const b2Vec2& point) : m_point(point) {}

    bool ReportFixture(b2Fixture* fixture) override
    {
        b2Body* body = fixture->GetBody();
        const bool isYounger = m_found == nullptr || body->GetNumber() > m_found->GetNumber();
        if (body->GetType() == b2_dynamicBody && isYounger && fixture->TestPoint(m_point))
        {
            m_found = body;
        }
        return true;
    }

    b2Body* Found() const { return m_found; }

private:
    b2Vec2 m_point;
    b2Body* m_found = nullptr;
};

} // namespace

void MouseGrip::Take(b2World& world, const b2Vec2& point)
{
    if (m_joint != nullptr)
    {
        return;
    }
    BodyAt query(point);
    b2AABB around;
    around.lowerBound = point - b2Vec2(kReach, kReach);
    around.upperBound = point + b2Vec2(kReach, kReach);
    world.QueryAABB(&query, around);
    b2Body* body = query.Found();
    if (body == nullptr)
    {
        return;
    }
    if (m_ground == nullptr)
    {
        const b2BodyDef ground;
        m_ground = world.CreateBody(&ground);
    }
    b2MouseJointDef def;
    def.bodyA = m_ground;
    def.bodyB = body;
    def.target = point;
    def.maxForce = kMaxAcceleration * body->GetMass();
    m_joint = world.CreateJoint(&def);
    body->SetAwake(true);
}

void MouseGrip::MoveTo(const b2Vec2& point)
{
    if (m_joint != nullptr)
    {
        static_cast<b2MouseJoint*>(m_joint)->SetTarget(point);
    }
}

void MouseGrip::LetGo(b2World& world)
{
    if (m_joint != nullptr)
    {
        world.DestroyJoint(m_joint);
        m_joint = nullptr;
    }
}

void MouseGrip::Forget(const b2Joint* joint)
{
    if (joint == m_joint)
    {
        m_joint = nullptr;
    }
}

void MouseGrip::VisitState(SceneState& state)
{
    state(m_joint, m_ground);
}

} // namespace boxreel
