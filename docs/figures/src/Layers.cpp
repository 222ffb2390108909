// SPDX-License-Identifier: MIT
#include "Drawings.h"
#include "Setup.h"
#include "Sketch.h"

using namespace boxreel;

namespace figures
{
namespace
{

constexpr double kLegendLeft = 462.0; // [px]
constexpr double kLegendTop = 34.0;
constexpr double kRow = 27.0;

/// A small world of bodies of each kind.
void Furnish(b2World& world)
{
    AddBody(world, b2_staticBody, Edge(b2Vec2(-2.7f, 0.0f), b2Vec2(2.6f, 0.0f)),
            b2Vec2(-0.1f, -1.5f));
    AddBody(world, b2_dynamicBody, Box(0.4f, 0.3f), b2Vec2(-2.1f, -1.18f));
    AddBody(world, b2_dynamicBody, Box(0.3f, 0.3f), b2Vec2(-2.0f, -0.55f), Degrees(4.0f));
    AddBody(world, b2_kinematicBody, Box(0.6f, 0.12f), b2Vec2(1.75f, -0.4f));
    AddBody(world, b2_dynamicBody, Disc(0.32f), b2Vec2(1.6f, 0.05f));
    AddBody(world, b2_dynamicBody, Box(0.35f, 0.25f), b2Vec2(0.7f, -1.235f))->SetAwake(false);
    AddBody(world, b2_dynamicBody, Box(0.35f, 0.25f), b2Vec2(1.9f, 1.2f))->SetActive(false);
    b2Body* const beam = AddBody(world, b2_staticBody, Box(0.3f, 0.15f), b2Vec2(-0.2f, 1.6f));
    b2Body* const bob = AddBody(world, b2_dynamicBody, Box(0.3f, 0.3f), b2Vec2(0.7f, 0.4f));
    b2RevoluteJointDef def;
    def.Initialize(beam, bob, b2Vec2(-0.2f, 1.45f));
    world.CreateJoint(&def);
}

/// Adds the text of a line of the legend, to the right of its sign.
void AddRow(Sketch& sketch, double row, std::string_view name)
{
    sketch.Caption(kLegendLeft + 34.0, kLegendTop + row * kRow, Side::Right, name);
}

b2Vec2 SignAt(const Sketch& sketch, double row)
{
    return sketch.AtPixel(kLegendLeft + 13.0, kLegendTop + row * kRow);
}

void AddSwatch(Sketch& sketch, double row, Paint color, std::string_view name)
{
    const b2Vec2 at = SignAt(sketch, row);
    const Vec2 corners[4] = {From(sketch.Shifted(at, -11, -7)), From(sketch.Shifted(at, 11, -7)),
                             From(sketch.Shifted(at, 11, 7)), From(sketch.Shifted(at, -11, 7))};
    sketch.List().layer = DrawLayer::Shapes;
    sketch.List().owner = kNoOwner;
    sketch.List().AddSolidPolygon(corners, 4, color);
    AddRow(sketch, row, name);
}

} // namespace

Figure DrawDebugLayers()
{
    constexpr Paint kJoint = ColorRole::Joint;
    Sketch sketch(640, 340, b2Vec2(1.05f, 0.1f), 80.0);
    b2World world(b2Vec2(0.0f, -10.0f));
    Furnish(world);
    Run(world, 30);
    sketch.Draw(world, b2Draw::e_shapeBit | b2Draw::e_jointBit | b2Draw::e_aabbBit |
                           b2Draw::e_pairBit | b2Draw::e_centerOfMassBit);

    sketch.Note(b2Vec2(0.04f, 0.9f), 44.0, 20.0, "a joint");
    sketch.Note(b2Vec2(-0.85f, -1.41f), 6.0, 40.0, "a pair");
    sketch.Caption(kLegendLeft, kLegendTop, Side::Right, "e_shapeBit:");
    AddSwatch(sketch, 1.0, kFixed, "static");
    AddSwatch(sketch, 2.0, kDriven, "kinematic");
    AddSwatch(sketch, 3.0, kMoving, "dynamic");
    AddSwatch(sketch, 4.0, kQuiet, "asleep");
    AddSwatch(sketch, 5.0, ColorRole::InactiveBody, "inactive");
    const b2Vec2 joint = SignAt(sketch, 6.4);
    sketch.Bar(sketch.Shifted(joint, -11, 0), sketch.Shifted(joint, 11, 0), kJoint);
    AddRow(sketch, 6.4, "e_jointBit");
    const b2Vec2 box = SignAt(sketch, 7.4);
    sketch.Outline({sketch.Shifted(box, -11, -7), sketch.Shifted(box, 11, -7),
                    sketch.Shifted(box, 11, 7), sketch.Shifted(box, -11, 7)},
                   kBox);
    AddRow(sketch, 7.4, "e_aabbBit");
    const b2Vec2 pair = SignAt(sketch, 8.4);
    sketch.Bar(sketch.Shifted(pair, -11, 0), sketch.Shifted(pair, 11, 0), kPair);
    AddRow(sketch, 8.4, "e_pairBit");
    const b2Vec2 center = sketch.Shifted(SignAt(sketch, 9.6), -8.0, -8.0);
    sketch.List().layer = DrawLayer::CentersOfMass;
    sketch.List().AddTransform(From(center), {1.0f, 0.0f}, float(18.0 / 80.0));
    AddRow(sketch, 9.6, "e_centerOfMassBit");
    return sketch.Finished();
}

} // namespace figures
