// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

/// A list built by hand with one item of every kind. Used by the tests of DrawList and of its text.
inline void FillExample(boxreel::DrawList& list)
{
    using namespace boxreel;
    const Color awake{230, 179, 179};
    const Vec2 box[4] = {{-0.5f, 0.0f}, {0.5f, 0.0f}, {0.5f, 1.0f}, {-0.5f, 1.0f}};
    list.owner = 3;
    list.AddSolidPolygon(box, 4, awake);
    list.AddSolidCircle({1.0f / 3.0f, 2.0f}, 0.25f, {0.0f, 1.0f}, awake);
    list.owner = kNoOwner;
    list.layer = DrawLayer::Joints;
    list.AddSegment({1e-7f, 16777216.0f}, {0.1f, -20.0f}, {128, 204, 204});
    list.layer = DrawLayer::Aabbs;
    list.AddPolygon(box, 3, {230, 77, 230, 128});
    list.layer = DrawLayer::CentersOfMass;
    list.owner = 0;
    list.AddTransform({0.0f, 0.5f}, {1.0f, 0.0f}, 0.4f);
    list.layer = DrawLayer::Contacts;
    list.owner = kNoOwner;
    list.AddPoint({0.0f, -0.0f}, 5.0f, {77, 77, 242});
    list.AddCircle({0.0f, 0.0f}, 1.5f, {0, 0, 0});
    list.layer = DrawLayer::Labels;
    list.AddText({-2.0f, 3.0f}, "a \"box\"\n\\ 5 µm", {230, 230, 230});
}

inline boxreel::DrawList ExampleList()
{
    boxreel::DrawList list;
    FillExample(list);
    return list;
}
