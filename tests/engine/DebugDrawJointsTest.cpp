// SPDX-License-Identifier: MIT
// Joints as lines: which points of a joint a drawing connects.
#include "DynamicsScene.h"

#include <gmock/gmock.h>

#include <utility>

namespace
{

using dynamics::Scene;
using testing::UnorderedElementsAre;

using Spot = std::pair<float32, float32>;
using Line = std::pair<Spot, Spot>; // the lesser end first

Line Between(const b2Vec2& a, const b2Vec2& b)
{
    return std::minmax(Spot(a.x, a.y), Spot(b.x, b.y));
}

class LineRecorder : public b2Draw
{
public:
    std::vector<Line> lines;

    void DrawPolygon(const b2Vec2*, int32, const b2Color&) override {}
    void DrawSolidPolygon(const b2Vec2*, int32, const b2Color&) override {}
    void DrawCircle(const b2Vec2&, float32, const b2Color&) override {}
    void DrawSolidCircle(const b2Vec2&, float32, const b2Vec2&, const b2Color&) override {}
    void DrawSegment(const b2Vec2& a, const b2Vec2& b, const b2Color&) override
    {
        lines.push_back(Between(a, b));
    }
    void DrawTransform(const b2Transform&) override {}
};

std::vector<Line> LinesOf(b2World& world)
{
    LineRecorder draw;
    draw.SetFlags(b2Draw::e_jointBit);
    world.SetDebugDraw(&draw);
    world.DrawDebugData();
    world.SetDebugDraw(nullptr);
    return draw.lines;
}

} // namespace

TEST(DebugDrawJoints, DrawsAPulleyAsItsRopeOverTheGroundAnchors)
{
    Scene scene;
    const b2Vec2 groundA(-3.0f, 5.0f);
    const b2Vec2 groundB(2.0f, 6.0f);
    const b2Vec2 anchorA(-3.0f, 1.0f);
    const b2Vec2 anchorB(2.0f, 0.5f);
    b2PulleyJointDef def;
    def.Initialize(scene.Box(-3.0f, 0.0f), scene.Box(2.0f, 0.0f), groundA, groundB, anchorA,
                   anchorB, 1.0f);
    scene.world.CreateJoint(&def);
    EXPECT_THAT(LinesOf(scene.world),
                UnorderedElementsAre(Between(groundA, anchorA), Between(groundA, groundB),
                                     Between(groundB, anchorB)));
}

TEST(DebugDrawJoints, DrawsMouseJointFromTargetToAnchor)
{
    Scene scene;
    b2MouseJointDef def;
    def.bodyA = scene.Body(b2_staticBody, 10.0f, 10.0f);
    def.bodyB = scene.Box(0.0f, 0.0f);
    def.target.Set(0.25f, 0.25f);
    auto* const joint = static_cast<b2MouseJoint*>(scene.world.CreateJoint(&def));
    joint->SetTarget(b2Vec2(4.0f, 3.0f));
    EXPECT_THAT(LinesOf(scene.world),
                UnorderedElementsAre(Between(b2Vec2(4.0f, 3.0f), b2Vec2(0.25f, 0.25f))))
        << "nothing from the first body, which takes no part";
}

TEST(DebugDrawJoints, DrawsAHingeAsLinesFromBothOrigins)
{
    Scene scene;
    b2RevoluteJointDef def;
    const b2Vec2 hinge(1.0f, 2.0f);
    def.Initialize(scene.Box(0.0f, 0.0f), scene.Box(3.0f, 0.0f), hinge);
    scene.world.CreateJoint(&def);
    EXPECT_THAT(LinesOf(scene.world),
                UnorderedElementsAre(Between(b2Vec2(0.0f, 0.0f), hinge), Between(hinge, hinge),
                                     Between(b2Vec2(3.0f, 0.0f), hinge)));
}
