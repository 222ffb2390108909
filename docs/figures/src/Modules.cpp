// SPDX-License-Identifier: MIT
#include "Drawings.h"
#include "Sketch.h"

using namespace boxreel;

namespace figures
{
namespace
{

constexpr float32 kTop = -34.0f; // of the boxes [px]
constexpr float32 kBottom = -134.0f;
constexpr float32 kWidth = 160.0f;

void AddModule(Sketch& sketch, float32 left, Paint color, std::string_view name,
               std::string_view holds)
{
    const Vec2 corners[4] = {
        {left, kBottom}, {left + kWidth, kBottom}, {left + kWidth, kTop}, {left, kTop}};
    sketch.List().layer = DrawLayer::Shapes;
    sketch.List().AddSolidPolygon(corners, 4, color);
    const b2Vec2 head(left + 0.5f * kWidth, kTop - 10.0f);
    sketch.Label(head, Side::Below, name, kInk, 0.0);
    sketch.Label(sketch.Shifted(head, 0.0, -24.0), Side::Below, holds, kInk, 0.0);
}

} // namespace

Figure DrawModules()
{
    // A metre is a pixel here: this is the one figure without a world.
    Sketch sketch(640, 200, b2Vec2(320.0f, -100.0f), 1.0);
    AddModule(sketch, 20.0f, kFixed, "Common", "settings, memory,\nvectors, matrices");
    AddModule(sketch, 240.0f, kDriven, "Collision",
              "shapes, manifolds,\ndistance, queries,\nbroad-phase");
    AddModule(sketch, 460.0f, kMoving, "Dynamics", "world, bodies,\nfixtures, contacts,\njoints");
    for (const float32 left : {240.0f, 460.0f})
    {
        const b2Vec2 tail(left - 4.0f, 0.5f * (kTop + kBottom));
        sketch.ArrowAlong(tail, b2Vec2(-1.0f, 0.0f), 52.0);
        sketch.Label(sketch.Shifted(tail, -26.0, 0.0), Side::Above, "uses", kInk, 4.0);
    }
    const b2Vec2 right(540.0f, kBottom - 4.0f);
    const b2Vec2 left(100.0f, kBottom - 4.0f);
    const b2Vec2 down(0.0f, -24.0f);
    sketch.Line(right, right + down);
    sketch.Line(right + down, left + down);
    sketch.Arrow(left + down, left);
    sketch.Label(b2Vec2(320.0f, kBottom - 28.0f), Side::Below, "uses", kInk, 4.0);
    return sketch.Finished();
}

} // namespace figures
