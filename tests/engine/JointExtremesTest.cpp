// SPDX-License-Identifier: MIT
#include "MixedWorld.h"

#include <gtest/gtest.h>

/// Joints that contradict each other and have long levers.
namespace
{

/// World 15 has a plate of 0.46 kg on two joints to static bodies: a weld with a lever of 17 m, and
/// a wheel joint whose other body is then moved by 22 m. No pose satisfies both.
class WorldFifteen : public testing::TestWithParam<int32>
{
protected:
    WorldFifteen() { m_mixed.world.SetSubStepCount(GetParam()); }

    b2Body* Find(int number)
    {
        b2Body* body = m_mixed.world.GetBodyList();
        while (body->GetNumber() != number)
        {
            body = body->GetNext();
        }
        return body;
    }
    /// Leaves the plate and what holds it.
    void DestroyOthers()
    {
        for (b2Body* body = m_mixed.world.GetBodyList(); body != nullptr;)
        {
            b2Body* const next = body->GetNext();
            const int number = body->GetNumber();
            if (number != kPlate && number != 2 && number != 5)
            {
                m_mixed.world.DestroyBody(body);
            }
            body = next;
        }
    }
    void Step() { m_mixed.world.Step(1.0f / 60.0f, 8, 3); }

    static constexpr int kPlate = 11;
    MixedWorld m_mixed{15};
};

INSTANTIATE_TEST_SUITE_P(SubSteps, WorldFifteen, testing::Values(1, 2, 4, 8, 16),
                         testing::PrintToStringParamName());

/// It goes 19.84 m to where both joints pull equally, and then does not move at all.
TEST_P(WorldFifteen, HoldsAPlateThatTwoJointsPullApart)
{
    DestroyOthers();
    const b2Body* plate = Find(kPlate);
    const b2Vec2 start = plate->GetPosition();
    for (int i = 0; i < 300; ++i)
    {
        Step();
        ASSERT_LT(b2Distance(plate->GetPosition(), start), 22.0f) << "step " << i;
    }
    const b2Vec2 rest = plate->GetPosition();
    for (int i = 0; i < 600; ++i)
    {
        Step();
        ASSERT_LT(b2Distance(plate->GetPosition(), rest), b2_linearSlop) << "step " << i;
    }
    EXPECT_LT(plate->GetLinearVelocity().Length(), 0.001f);
}

/// With all bodies in it, a kinematic body pushes the plate by 8.7 m, with one step by up to 12.2,
/// at up to 112 m/s. The fastest of the others have 24 m/s sideways or upward.
TEST_P(WorldFifteen, ThrowsNoBody)
{
    const b2Body* plate = Find(kPlate);
    const b2Vec2 start = plate->GetPosition();
    for (int i = 0; i < 120; ++i)
    {
        Step();
        ASSERT_LT(b2Distance(plate->GetPosition(), start), 15.0f) << "step " << i;
        for (const b2Body* body = m_mixed.world.GetBodyList(); body; body = body->GetNext())
        {
            if (body->GetType() == b2_dynamicBody && body != plate)
            {
                const b2Vec2 velocity = body->GetLinearVelocity();
                ASSERT_LT(b2Max(b2Abs(velocity.x), velocity.y), 40.0f)
                    << "body " << body->GetNumber() << ", step " << i;
            }
        }
    }
}

} // namespace
