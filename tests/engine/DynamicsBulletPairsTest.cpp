// SPDX-License-Identifier: MIT
#include "DynamicsInvariants.h"
#include "DynamicsScene.h"

#include <Dynamics/Contacts/Sweeps.h>
#include <Dynamics/State/Access.h>
#include <Dynamics/State/World.h>

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>
#include <utility>

/// Bullets have contacts only with bodies near their paths. No touching pair may be missing after
/// any user change.
namespace
{

using dynamics::Scene;

b2Body* Bullet(Scene& scene, const b2Vec2& place, const b2Vec2& velocity, float32 radius = 0.1f)
{
    b2Body* body = scene.Body(b2_dynamicBody, place.x, place.y);
    Scene::AddBall(body, radius, 0.0f, 1.0f);
    body->SetBullet(true);
    body->SetLinearVelocity(velocity);
    return body;
}

bool HaveContact(const b2Body& a, const b2Body& b)
{
    for (const b2ContactEdge* edge = a.GetContactList(); edge; edge = edge->next)
    {
        if (edge->other == &b)
        {
            return true;
        }
    }
    return false;
}

b2Fixture& FixtureOf(b2Body& body)
{
    return *body.GetFixtureList();
}

bool Overlap(b2Body& a, b2Body& b)
{
    return b2TestOverlap(FixtureOf(a).GetShape(), 0, FixtureOf(b).GetShape(), 0, a.GetTransform(),
                         b.GetTransform());
}

TEST(BulletPairs, HaveNoContactWhenPathsStayApart)
{
    Scene scene(b2Vec2_zero);
    b2Body* one = Bullet(scene, b2Vec2(0.0f, 0.0f), b2Vec2(60.0f, 60.0f));
    b2Body* another = Bullet(scene, b2Vec2(0.6f, -0.6f), b2Vec2(60.0f, 60.0f));
    for (int i = 0; i < 10; ++i)
    {
        scene.Step();
        ASSERT_TRUE(b2TestOverlap(FixtureOf(*one).GetAABB(0), FixtureOf(*another).GetAABB(0)));
        ASSERT_EQ(scene.world.GetContactCount(), 0) << i;
    }
}

TEST(BulletPairs, FindASlowBulletThatHitsOneAtRest)
{
    // After the last fast step one is in the other's box, and does not leave that box on its slow
    // way back. Their pair has to be searched although no box has changed.
    for (const bool asleep : {false, true})
    {
        Scene scene(b2Vec2_zero);
        b2Body* one = Bullet(scene, b2Vec2(0.2f, 0.2f), b2Vec2(60.0f, 60.0f));
        b2Body* another = Bullet(scene, b2Vec2(1.0f, 2.0f), b2Vec2(60.0f, -60.0f));
        scene.Step();
        b2AABB place;
        FixtureOf(*one).GetShape()->ComputeAABB(&place, one->GetTransform(), 0);
        ASSERT_TRUE(FixtureOf(*another).GetAABB(0).Contains(place));
        ASSERT_EQ(scene.world.GetContactCount(), 0);
        one->SetLinearVelocity(b2Vec2_zero);
        if (asleep)
        {
            one->SetAwake(false);
        }
        another->SetLinearVelocity(b2Vec2(-1.2f, 0.3f));
        scene.Step(60);
        EXPECT_LT(one->GetLinearVelocity().x, -1.0f) << "not hit, asleep: " << asleep;
    }
}

TEST(BulletPairs, FindWallAfterBulletTurnsAndSlows)
{
    Scene scene(b2Vec2_zero);
    b2Body* bullet = Bullet(scene, b2Vec2(-10.0f, -7.0f), b2Vec2(60.0f, 60.0f));
    scene.Step();
    // Its box is as large as the wall is long, so there are no others to tell them apart.
    b2Body* wall = scene.Body(b2_staticBody, 0.0f, 0.0f);
    b2EdgeShape edge;
    edge.Set(b2Vec2(-20.0f, -20.0f), b2Vec2(20.0f, 20.0f));
    Scene::Add(wall, edge, 0.0f, 1.0f);
    for (int i = 0; i < 9; ++i)
    {
        scene.Step();
        ASSERT_EQ(scene.world.GetContactCount(), 0) << i;
    }
    bullet->SetLinearVelocity(b2Vec2(1.0f, -1.0f));
    scene.Step(180);
    EXPECT_GT(bullet->GetPosition().y, bullet->GetPosition().x + 0.1f);
    EXPECT_LT(bullet->GetLinearVelocity().x, -0.8f);
}

/// Bullets, slow bodies, platforms and walls, and a program that interferes.
class Crowd
{
public:
    explicit Crowd(unsigned seed) : m_random(seed), m_scene(b2Vec2_zero)
    {
        b2Body* box = m_scene.Body(b2_staticBody, 0.0f, 0.0f);
        const b2Vec2 corners[] = {b2Vec2(-6.0f, -6.0f), b2Vec2(6.0f, -6.0f), b2Vec2(6.0f, 6.0f),
                                  b2Vec2(-6.0f, 6.0f)};
        for (int i = 0; i < 4; ++i)
        {
            b2EdgeShape edge;
            edge.Set(corners[i], corners[(i + 1) % 4]);
            Scene::Add(box, edge, 0.0f, 1.0f);
        }
        for (int i = 0; i < 60; ++i)
        {
            Add(i);
        }
    }

    void Interfere()
    {
        b2Body& body = *m_bodies[m_random() % m_bodies.size()];
        switch (m_random() % 10)
        {
        case 0:
            body.SetAwake(false);
            break;
        case 1:
            body.SetTransform(Place(), Real(-3.0f, 3.0f));
            break;
        case 2:
            body.SetBullet(!body.IsBullet());
            break;
        case 3:
            body.SetLinearVelocity(b2Vec2_zero);
            break;
        case 4:
            body.SetActive(!body.IsActive());
            break;
        case 5:
            body.SetType(static_cast<b2BodyType>(m_random() % 3));
            break;
        default:
            body.SetLinearVelocity(Velocity());
            break;
        }
    }

    /// The bodies that overlap and have no contact, as numbers; counts what overlaps.
    std::string Missing(int& overlaps)
    {
        std::string missing;
        for (std::size_t i = 0; i < m_bodies.size(); ++i)
        {
            for (std::size_t k = 0; k < i; ++k)
            {
                b2Body& a = *m_bodies[k];
                b2Body& b = *m_bodies[i];
                const bool meet = a.IsActive() && b.IsActive() &&
                                  (a.GetType() == b2_dynamicBody || b.GetType() == b2_dynamicBody);
                if (meet && Overlap(a, b))
                {
                    ++overlaps;
                    missing +=
                        HaveContact(a, b) ? "" : std::to_string(k) + "-" + std::to_string(i) + " ";
                }
            }
        }
        return missing;
    }

    int Swept()
    {
        int count = 0;
        for (b2Body* body : m_bodies)
        {
            count += (box2d::Data(*body).flags & box2d::kBodyPathBox) != 0;
        }
        return count;
    }

    b2World& World() { return m_scene.world; }
    void Step() { m_scene.Step(); }

private:
    float32 Real(float32 low, float32 high)
    {
        return low + (high - low) * float32(m_random() % 100001u) / 100000.0f;
    }
    b2Vec2 Place()
    {
        const float32 x = Real(-5.5f, 5.5f);
        return b2Vec2(x, Real(-5.5f, 5.5f));
    }
    b2Vec2 Velocity()
    {
        const float32 speed = m_random() % 2 == 0 ? 2.0f : 90.0f;
        const float32 x = Real(-speed, speed);
        return b2Vec2(x, Real(-speed, speed));
    }

    void Add(int i)
    {
        const b2Vec2 place = Place();
        b2Body* body =
            m_scene.Body(i % 12 == 11 ? b2_kinematicBody : b2_dynamicBody, place.x, place.y);
        if (i % 3 == 0)
        {
            Scene::AddBox(body, Real(0.05f, 0.5f), Real(0.05f, 0.3f), 0.2f, 0.9f);
        }
        else
        {
            Scene::AddBall(body, Real(0.05f, 0.3f), 0.0f, 1.0f);
        }
        if (i % 7 == 0)
        {
            FixtureOf(*body).SetSensor(true);
        }
        body->SetBullet(i % 4 != 0);
        body->SetLinearVelocity(Velocity());
        m_bodies.push_back(body);
    }

    std::mt19937 m_random;
    Scene m_scene;
    std::vector<b2Body*> m_bodies;
};

TEST(BulletPairs, HaveContactsWhenOverlappingAfterAnyUserChange)
{
    int overlaps = 0;
    int swept = 0;
    // In the last two a body is put back in front of a wall at the end of a step, onto another.
    for (const unsigned seed : {0u, 1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u, 9u, 10u, 11u, 368u, 568u})
    {
        Crowd crowd(seed);
        for (int step = 0; step < 300; ++step)
        {
            crowd.Interfere();
            crowd.Step();
            swept += crowd.Swept();
            ASSERT_EQ(crowd.Missing(overlaps), "") << "seed " << seed << ", step " << step;
            ASSERT_EQ(dynamics::WhyBroken(crowd.World(), true), "")
                << "seed " << seed << ", step " << step;
        }
    }
    EXPECT_GT(overlaps, 1000);
    EXPECT_GT(swept, 10000);
}

} // namespace
