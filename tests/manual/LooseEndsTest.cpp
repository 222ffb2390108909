// SPDX-License-Identifier: MIT
#include "../engine/DynamicsScene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

/// The chapters about loose ends, debug drawing and limitations, section by section.
namespace
{

using dynamics::kStep;
using dynamics::Scene;

struct GameActor
{
    b2Body* body = nullptr;
};

TEST(UserDataSection, LinksAnActorToItsBodyAndBack)
{
    b2World world(b2Vec2_zero);
    b2World* box2Dworld = &world;
    GameActor made;
    GameActor* actor = &made;
    b2BodyDef bodyDef;
    EXPECT_EQ(bodyDef.userData, nullptr) << "none unless given";
    bodyDef.userData = actor;
    actor->body = box2Dworld->CreateBody(&bodyDef);
    EXPECT_EQ(actor->body->GetUserData(), actor);
    EXPECT_EQ(b2FixtureDef().userData, nullptr);
    EXPECT_EQ(b2RevoluteJointDef().userData, nullptr);
}

struct FixtureUserData
{
    int materialIndex;
};

TEST(UserDataSection, StoresAStructureInAFixtureInTheListing)
{
    Scene scene;
    b2Body* body = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
    b2CircleShape someShape;
    someShape.m_radius = 1.0f;

    FixtureUserData* myData = new FixtureUserData;
    myData->materialIndex = 2;
    b2FixtureDef fixtureDef;
    fixtureDef.shape = &someShape;
    fixtureDef.userData = myData;
    b2Fixture* fixture = body->CreateFixture(&fixtureDef);
    EXPECT_EQ(((FixtureUserData*)fixture->GetUserData())->materialIndex, 2);
    // The text deletes the void pointer, which C++ leaves undefined.
    delete (FixtureUserData*)fixture->GetUserData();
    fixture->SetUserData(NULL);
    body->DestroyFixture(fixture);
    EXPECT_EQ(body->GetFixtureList(), nullptr);
}

/// Returns the number of filled bytes of destroyed memory. The memory still belongs to the world.
int FilledBytes(const void* destroyed, std::size_t size)
{
    const auto* bytes = static_cast<const volatile unsigned char*>(destroyed);
    int filled = 0;
    for (std::size_t i = 0; i < size; ++i)
    {
        filled += bytes[i] == 0xFD;
    }
    return filled;
}

TEST(ImplicitDestruction, FillsDestroyedObjectsInDebugBuilds)
{
    Scene scene;
    b2Body* ground = scene.Ground();
    b2Body* body = scene.Box(0.0f, 3.0f);
    const void* fixture = body->GetFixtureList();
    b2RevoluteJointDef hinge;
    hinge.Initialize(ground, body, body->GetPosition());
    const void* joint = scene.world.CreateJoint(&hinge);
    const void* destroyed = body;
    scene.world.DestroyBody(body);
    // All but the links of the list of free blocks.
    const int links = 2 * int(sizeof(void*));
    const bool fills = BOXREEL_ASSERTS != 0;
    EXPECT_EQ(FilledBytes(destroyed, sizeof(b2Body)) >= int(sizeof(b2Body)) - links, fills);
    EXPECT_EQ(FilledBytes(fixture, sizeof(b2Fixture)) >= int(sizeof(b2Fixture)) - links, fills);
    EXPECT_EQ(FilledBytes(joint, sizeof(b2RevoluteJoint)) >= int(sizeof(b2RevoluteJoint)) - links,
              fills);
}

/// The listing: one function, nothing about fixtures.
class MyDestructionListener : public b2DestructionListener
{
    void SayGoodbye(b2Joint* joint) override
    {
        // Here the game would forget the joint.
        gone.push_back(joint);
    }
    using b2DestructionListener::SayGoodbye;

public:
    std::vector<b2Joint*> gone;
};

TEST(ImplicitDestruction, NotifiesListenerOfDestroyedJoints)
{
    Scene scene;
    MyDestructionListener listener;
    MyDestructionListener* myDestructionListener = &listener;
    b2World* myWorld = &scene.world;
    myWorld->SetListener(myDestructionListener);
    b2Body* ground = scene.Ground();
    b2Body* body = scene.Box(0.0f, 3.0f);
    b2RevoluteJointDef hinge;
    hinge.Initialize(ground, body, body->GetPosition());
    b2Joint* explicitly = myWorld->CreateJoint(&hinge);
    b2Joint* implicitly = myWorld->CreateJoint(&hinge);
    myWorld->DestroyJoint(explicitly);
    EXPECT_TRUE(listener.gone.empty()) << "no word of what the program does itself";
    myWorld->DestroyBody(body);
    EXPECT_EQ(listener.gone, std::vector<b2Joint*>{implicitly});
    myWorld->SetListener(nullptr);
}

TEST(ImplicitDestruction, WakesBodiesThatWereJoinedOrTouching)
{
    Scene scene;
    b2Body* ground = scene.Ground();
    b2Body* lower = scene.Box(0.0f, 0.5f + dynamics::kRestingGap);
    b2Body* upper = scene.Box(0.0f, 1.5f + 2.0f * dynamics::kRestingGap);
    b2Body* joined = scene.Box(5.0f, 0.5f + dynamics::kRestingGap);
    b2Body* post = scene.Body(b2_staticBody, 5.0f, 3.0f);
    b2RevoluteJointDef hinge;
    hinge.Initialize(post, joined, joined->GetPosition());
    scene.world.CreateJoint(&hinge);
    scene.Step(180);
    ASSERT_FALSE(upper->IsAwake() || joined->IsAwake());
    scene.world.DestroyBody(lower);
    scene.world.DestroyBody(post);
    EXPECT_TRUE(upper->IsAwake());
    EXPECT_TRUE(joined->IsAwake());
    EXPECT_EQ(scene.world.GetJointCount(), 0);
    EXPECT_NE(ground, nullptr);
}

TEST(PixelsAndCoordinates, ConvertToMetresAndBackByAFactor)
{
    const float32 xPixels = 75.0f;
    float32 xMeters = 0.02f * xPixels;
    EXPECT_FLOAT_EQ(xMeters, 1.5f);
    EXPECT_FLOAT_EQ(50.0f * xMeters, xPixels);
}

/// Records the drawing calls. The name is the manual's.
struct RecordingDraw : public b2DebugDraw
{
    void DrawPolygon(const b2Vec2*, int32, const b2Color&) override { ++polygons; }
    void DrawSolidPolygon(const b2Vec2*, int32, const b2Color&) override { ++solidPolygons; }
    void DrawCircle(const b2Vec2&, float32, const b2Color&) override { ++circles; }
    void DrawSolidCircle(const b2Vec2&, float32, const b2Vec2&, const b2Color&) override
    {
        ++solidCircles;
    }
    void DrawSegment(const b2Vec2&, const b2Vec2&, const b2Color&) override { ++segments; }
    void DrawTransform(const b2Transform&) override { ++transforms; }
    int polygons = 0, solidPolygons = 0, circles = 0, solidCircles = 0;
    int segments = 0, transforms = 0;
};

/// Returns the drawing of a box, a ball and a joint between them.
RecordingDraw DrawnWith(uint32 flags)
{
    Scene scene;
    b2Body* box = scene.Box(0.0f, 0.0f);
    b2Body* ball = scene.Ball(5.0f, 0.0f);
    b2DistanceJointDef def;
    def.Initialize(box, ball, box->GetPosition(), ball->GetPosition());
    scene.world.CreateJoint(&def);
    RecordingDraw draw;
    scene.world.SetDebugDraw(&draw);
    draw.SetFlags(flags);
    scene.world.DrawDebugData();
    scene.world.SetDebugDraw(nullptr);
    return draw;
}

TEST(DebugDrawing, ShowsShapesJointsBoxesAndCentresOfMassAsAsked)
{
    const RecordingDraw shapes = DrawnWith(b2Draw::e_shapeBit);
    EXPECT_EQ(shapes.solidPolygons, 1);
    EXPECT_EQ(shapes.solidCircles, 1);
    EXPECT_EQ(shapes.segments + shapes.polygons + shapes.transforms, 0);
    EXPECT_GE(DrawnWith(b2Draw::e_jointBit).segments, 1);
    EXPECT_EQ(DrawnWith(b2Draw::e_aabbBit).polygons, 2);
    EXPECT_EQ(DrawnWith(b2Draw::e_centerOfMassBit).transforms, 2);
    EXPECT_EQ(DrawnWith(0).solidPolygons, 0);
}

TEST(Limitations, LetABodyRestOnOneOfATenthOfItsMass)
{
    Scene scene;
    scene.Ground();
    b2Body* light = scene.Box(0.0f, 0.5f + dynamics::kRestingGap);
    b2Body* heavy = scene.Box(0.0f, 1.5f + 2.0f * dynamics::kRestingGap);
    heavy->GetFixtureList()->SetDensity(10.0f);
    heavy->ResetMassData();
    scene.Step(300);
    EXPECT_NEAR(light->GetPosition().y, 0.5f + dynamics::kRestingGap, 2.0f * b2_linearSlop);
    EXPECT_NEAR(heavy->GetPosition().y, 1.5f + 2.0f * dynamics::kRestingGap, 4.0f * b2_linearSlop);
}

TEST(Limitations, StretchAChainLittleUnderTenTimesALink)
{
    Scene scene;
    b2Body* previous = scene.Body(b2_staticBody, 0.0f, 0.0f);
    for (int i = 0; i < 10; ++i)
    {
        b2Body* link = scene.Box(0.0f, -0.5f - float32(i), 0.125f, 0.5f);
        link->GetFixtureList()->SetDensity(i == 9 ? 10.0f : 1.0f);
        link->ResetMassData();
        b2RevoluteJointDef hinge;
        hinge.Initialize(previous, link, b2Vec2(0.0f, -float32(i)));
        scene.world.CreateJoint(&hinge);
        previous = link;
    }
    scene.Step(300);
    EXPECT_NEAR(previous->GetPosition().y, -9.5f, 0.1f);
}

TEST(Limitations, IncludeASlopOfHalfACentimetre)
{
    EXPECT_EQ(b2_linearSlop, 0.005f);
    Scene scene;
    scene.Ground();
    b2Body* box = scene.Box(0.0f, 2.0f);
    scene.Step(180);
    EXPECT_NEAR(box->GetPosition().y, 0.5f + dynamics::kRestingGap, b2_linearSlop);
}

TEST(Limitations, LetAJointCloseAgainAfterAFastImpact)
{
    Scene scene(b2Vec2_zero);
    scene.Wall(5.0f);
    b2Body* front = scene.Box(0.0f, 0.0f, 0.25f, 0.25f);
    b2Body* back = scene.Box(-1.0f, 0.0f, 0.25f, 0.25f);
    b2RevoluteJointDef def;
    def.Initialize(front, back, b2Vec2(-0.5f, 0.0f));
    b2Joint* joint = scene.world.CreateJoint(&def);
    front->SetLinearVelocity(b2Vec2(200.0f, 0.0f));
    back->SetLinearVelocity(b2Vec2(200.0f, 0.0f));
    scene.Step(60);
    EXPECT_LT(front->GetPosition().x, 5.0f);
    EXPECT_LT(b2Distance(joint->GetAnchorA(), joint->GetAnchorB()), 2.0f * b2_linearSlop);
}

TEST(Limitations, IncludeTheErrorOfSymplecticEuler)
{
    Scene scene;
    b2Body* body = scene.Box(0.0f, 0.0f);
    scene.Step(60);
    // The sum of g h^2 k, half a step more than the parabola.
    EXPECT_NEAR(body->GetPosition().y, -10.0f * kStep * kStep * 0.5f * 60.0f * 61.0f, 1e-4f);
}

TEST(Limitations, DecreaseWithMoreIterations)
{
    float32 sag[2];
    for (const bool many : {false, true})
    {
        Scene scene;
        scene.Ground();
        const std::vector<b2Body*> boxes = dynamics::Stack(scene, 0.0f, 12);
        for (int i = 0; i < 60; ++i)
        {
            scene.world.Step(kStep, many ? 40 : 2, many ? 20 : 1);
        }
        sag[many] = 12.0f * (1.0f + dynamics::kRestingGap) - 0.5f - boxes.back()->GetPosition().y;
    }
    EXPECT_LT(b2Abs(sag[true]), b2Abs(sag[false]));
}

} // namespace
