// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

/// Manifolds serve while two bodies stay as they are, and no longer.
namespace
{

using namespace dynamics;

/// A wide box on a narrow pedestal: the contact's points are the pedestal's corners, as seen from
/// the box.
class KeptManifold : public testing::Test
{
protected:
    KeptManifold()
    {
        Scene::AddBox(scene.Body(b2_staticBody, 0.0f, -1.0f), 0.5f, 1.0f);
        box = scene.Box(0.0f, 0.515f, 2.0f, 0.5f);
        scene.world.SetAllowSleeping(false);
        scene.Step(120);
    }

    /// Returns the position of the left point on the box, after a step with the box moved or
    /// rotated.
    float32 PointAfter(float32 x, float32 angle = 0.0f)
    {
        box->SetTransform(box->GetPosition() + b2Vec2(x, 0.0f), box->GetAngle() + angle);
        scene.Step(1);
        const b2Contact* contact = box->GetContactList()->contact;
        EXPECT_TRUE(contact->IsTouching());
        const b2Manifold& manifold = *contact->GetManifold();
        EXPECT_EQ(manifold.pointCount, 2);
        return b2Min(manifold.points[0].localPoint.x, manifold.points[1].localPoint.x);
    }

    Scene scene;
    b2Body* box = nullptr;
};

TEST_F(KeptManifold, IsKeptWhileABodyMovesAFractionOfAMillimetre)
{
    const float32 before = PointAfter(0.0f);
    EXPECT_NEAR(before, -0.5f, 0.03f); // and the skins
    EXPECT_EQ(PointAfter(0.0002f), before);
}

TEST_F(KeptManifold, IsRecomputedWhenABodyHasMoved)
{
    const float32 before = PointAfter(0.0f);
    EXPECT_NEAR(PointAfter(0.002f), before - 0.002f, 1e-4f);
}

TEST_F(KeptManifold, IsRecomputedAfterManySmallMoves)
{
    const float32 before = PointAfter(0.0f);
    for (int i = 1; i <= 40; ++i)
    {
        const float32 moved = 0.0002f * float32(i);
        EXPECT_NEAR(PointAfter(0.0002f), before - moved, 0.00055f) << "after " << moved << " m";
    }
}

TEST_F(KeptManifold, IsRecomputedWhenABodyHasTurned)
{
    const b2Contact* contact = box->GetContactList()->contact;
    const b2Vec2 normal = contact->GetManifold()->localNormal;
    PointAfter(0.0f, 0.002f); // 4 mm at the ends
    const b2Vec2 first = contact->GetManifold()->points[0].localPoint;
    const b2Vec2 second = contact->GetManifold()->points[1].localPoint;
    PointAfter(0.0f, -0.002f);
    EXPECT_EQ(contact->GetManifold()->localNormal, normal);
    EXPECT_TRUE(first != contact->GetManifold()->points[0].localPoint ||
                second != contact->GetManifold()->points[1].localPoint);
}

TEST_F(KeptManifold, IsEmptyWhileAFixtureIsASensor)
{
    b2Contact* contact = box->GetContactList()->contact;
    box->GetFixtureList()->SetSensor(true);
    scene.Step(1);
    EXPECT_TRUE(contact->IsTouching());
    EXPECT_EQ(contact->GetManifold()->pointCount, 0);
    box->GetFixtureList()->SetSensor(false);
    scene.Step(1);
    EXPECT_TRUE(contact->IsTouching());
    EXPECT_EQ(contact->GetManifold()->pointCount, 2);
}

struct OnePoint : b2ContactListener
{
    void PreSolve(b2Contact* contact, const b2Manifold*) override
    {
        if (edits)
        {
            contact->GetManifold()->pointCount = 1;
        }
    }
    bool edits = true;
};

TEST_F(KeptManifold, IsRecomputedAfterAListenerChangedIt)
{
    OnePoint listener;
    scene.world.SetContactListener(&listener);
    const b2Manifold& manifold = *box->GetContactList()->contact->GetManifold();
    scene.Step(1);
    EXPECT_EQ(manifold.pointCount, 1);
    listener.edits = false;
    scene.Step(1);
    EXPECT_EQ(manifold.pointCount, 2);
    scene.world.SetContactListener(nullptr);
}

TEST_F(KeptManifold, IsRecomputedWhenEmptied)
{
    b2Manifold& manifold = *box->GetContactList()->contact->GetManifold();
    manifold.pointCount = 0;
    scene.Step(1);
    EXPECT_EQ(manifold.pointCount, 2);
    EXPECT_NEAR(box->GetLinearVelocity().y, 0.0f, 1e-3f);
}

TEST_F(KeptManifold, IsRecomputedWhenItsShapeAndMassChange)
{
    static_cast<b2PolygonShape*>(box->GetFixtureList()->GetShape())->SetAsBox(2.0f, 0.25f);
    box->ResetMassData();
    scene.Step(60);
    EXPECT_NEAR(box->GetPosition().y, 0.265f, 0.01f);
}

TEST_F(KeptManifold, EndsWhenTheBoxIsLifted)
{
    box->SetTransform(box->GetPosition() + b2Vec2(0.0f, 0.05f), 0.0f);
    scene.Step(1);
    EXPECT_FALSE(box->GetContactList() != nullptr && box->GetContactList()->contact->IsTouching());
}

/// The contact of two boxes whose boxes in the tree overlap, and which do not touch.
class ApartContact : public testing::Test
{
protected:
    ApartContact()
    {
        scene.world.SetGravity(b2Vec2_zero);
        scene.world.SetAllowSleeping(false);
        Scene::AddBox(scene.Body(b2_staticBody, 0.0f, 0.0f), 0.5f, 0.5f);
        box = scene.Box(1.1f, 0.0f);
        scene.Step(3);
    }

    b2Contact& Contact() { return *scene.world.GetContactList(); }

    Scene scene;
    b2Body* box = nullptr;
};

TEST_F(ApartContact, IsComputedWhenAShapeGrowsInPlace)
{
    ASSERT_EQ(scene.world.GetContactCount(), 1);
    ASSERT_FALSE(Contact().IsTouching());
    static_cast<b2PolygonShape*>(box->GetFixtureList()->GetShape())->SetAsBox(0.62f, 0.5f);
    box->ResetMassData();
    scene.Step(1);
    ASSERT_EQ(scene.world.GetContactCount(), 1);
    EXPECT_TRUE(Contact().IsTouching());
}

TEST_F(ApartContact, IsEnabledAgainInTheNextStep)
{
    ASSERT_EQ(scene.world.GetContactCount(), 1);
    Contact().SetEnabled(false);
    scene.Step(1);
    EXPECT_TRUE(Contact().IsEnabled());
}

} // namespace
