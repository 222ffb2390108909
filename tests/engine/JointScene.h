// SPDX-License-Identifier: MIT
#pragma once

#include "DynamicsInvariants.h"
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <cmath>

/// Fixtures for the tests of joints: a static post, bodies that do not sleep, and rough handling
/// that every joint must survive.
namespace dynamics
{

inline constexpr float32 kGravity = 10.0f;

class JointScene : public Scene
{
public:
    using Scene::Scene;

    /// A static body without shapes.
    b2Body* Post(float32 x = 0.0f, float32 y = 0.0f) { return Body(b2_staticBody, x, y); }

    /// A box that never sleeps, because rates are measured on it.
    b2Body* Load(float32 x, float32 y, float32 hx = 0.5f, float32 hy = 0.5f)
    {
        b2Body* body = Box(x, y, hx, hy);
        body->SetSleepingAllowed(false);
        return body;
    }

    template <class Joint, class Definition>
    Joint* Create(const Definition& def)
    {
        return static_cast<Joint*>(world.CreateJoint(&def));
    }

    /// Pushes and turns the body at random, up to a hundred times its weight, and hands every state
    /// to `check`.
    template <class Check>
    void Shake(b2Body* body, int steps, const Check& check)
    {
        for (int i = 0; i < steps && !::testing::Test::HasFailure(); ++i)
        {
            const float32 force = 100.0f * kGravity * body->GetMass();
            body->ApplyForceToCenter(b2Vec2(force * Random(), force * Random()));
            body->ApplyTorque(100.0f * body->GetInertia() * Random());
            Step();
            check();
            EXPECT_EQ(WhyBroken(world, true), "") << "step " << i;
        }
    }

    /// From -1 to 1, the same on every machine.
    float32 Random()
    {
        m_state = m_state * 1664525u + 1013904223u;
        return float32(m_state >> 8) / float32(1 << 23) - 1.0f;
    }

private:
    uint32 m_state = 1;
};

} // namespace dynamics
