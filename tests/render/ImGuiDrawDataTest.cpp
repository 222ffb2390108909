// SPDX-License-Identifier: MIT
#include "ImGuiDrawData.h"

#include "Pictures.h"
#include "SoftShapes.h"

#include <imgui_internal.h>
#include <render/PanelStroke.h>

#include <functional>

using namespace boxreel;

namespace
{

constexpr ImU32 kInk = IM_COL32(10, 20, 30, 255);
const ImVec2 kWhiteTexel{0.25f, 0.75f};

/// Returns the copy of a list filled by `draw`.
Overlay Copied(const std::function<void(ImDrawList&)>& draw)
{
    ImDrawListSharedData shared;
    shared.TexUvWhitePixel = kWhiteTexel;
    shared.ClipRectFullscreen = {0.0f, 0.0f, 64.0f, 64.0f};
    shared.SetCircleTessellationMaxError(0.3f);
    ImDrawList list(&shared);
    list._ResetForNewFrame();
    list.PushClipRectFullScreen();
    draw(list);
    ImDrawList* lists[] = {&list};
    ImDrawData data;
    data.Valid = true;
    const auto setLists = [&](auto& all) { // a vector since Dear ImGui 1.89.8
        if constexpr (requires { all.push_back(&list); })
        {
            all.push_back(&list);
        }
        else
        {
            all = lists;
        }
    };
    setLists(data.CmdLists);
    data.CmdListsCount = 1;
    Overlay overlay;
    CopyDrawData(data, 64, 64, overlay);
    return overlay;
}

std::vector<Vec2> Positions(const Overlay& overlay)
{
    std::vector<Vec2> positions;
    for (const OverlayVertex& v : overlay.vertices)
    {
        positions.push_back(v.position);
    }
    return positions;
}

} // namespace

// Dear ImGui places them with an estimate of 1 / sqrt that is off by up to 4e-4.
TEST(ImGuiDrawData, HasUprightLinesExactlyOnTheirPixels)
{
    const Overlay level = Copied([](ImDrawList& list) { list.AddLine({3, 20}, {37, 20}, kInk); });
    EXPECT_THAT(Positions(level), testing::ElementsAre(Vec2{3.5f, 20}, Vec2{37.5f, 20},
                                                       Vec2{37.5f, 21}, Vec2{3.5f, 21}));
    const Overlay upright = Copied([](ImDrawList& list) { list.AddLine({8, 2}, {8, 33}, kInk); });
    EXPECT_THAT(Positions(upright),
                testing::ElementsAre(Vec2{9, 2.5f}, Vec2{9, 33.5f}, Vec2{8, 33.5f}, Vec2{8, 2.5f}));
}

TEST(ImGuiDrawData, KeepsRectanglesAndLettersAsTheyAre)
{
    const Overlay overlay = Copied([](ImDrawList& list) {
        list.AddRectFilled({3, 4}, {20, 9}, kInk);
        list.PrimReserve(6, 4);
        list.PrimRectUV({5, 5}, {9, 12}, {0.5f, 0.5f}, {0.625f, 0.75f}, kInk);
    });
    ASSERT_EQ(overlay.vertices.size(), 8u);
    EXPECT_EQ(overlay.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7}));
    EXPECT_EQ(overlay.vertices[2], (OverlayVertex{{20, 9}, {0.25f, 0.75f}, {10, 20, 30, 255}}));
    EXPECT_EQ(overlay.vertices[6], (OverlayVertex{{9, 12}, {0.625f, 0.75f}, {10, 20, 30, 255}}));
    ASSERT_EQ(overlay.commands.size(), 1u);
    EXPECT_EQ(overlay.commands[0].indexCount, 12u);
}

TEST(ImGuiDrawData, GivesRoundShapesAndTrianglesSoftEdges)
{
    const std::vector<Vec2> corners{{3, 4}, {20, 9}, {7, 30}};
    Overlay expected;
    AppendPolygon(corners, {10, 20, 30, 255}, {0.25f, 0.75f}, expected);
    const Overlay triangle = Copied([](ImDrawList& list) {
        list.AddTriangleFilled({3, 4}, {20, 9}, {7, 30}, kInk);
    });
    EXPECT_EQ(triangle.vertices, expected.vertices);
    EXPECT_EQ(triangle.indices, expected.indices);
    const Overlay round = Copied([](ImDrawList& list) {
        list.AddRectFilled({3, 4}, {40, 30}, kInk, 5.0f);
    });
    EXPECT_GE(round.vertices.size(), 2u * 12);
    EXPECT_EQ(round.vertices[1].color, (Color{10, 20, 30, 0}));
}

TEST(ImGuiDrawData, DrawsStrokesBesideOtherThings)
{
    const std::vector<Vec2> points{{3, 4}, {20, 9}, {30, 50}};
    const Color color{10, 20, 30, 200};
    for (const std::size_t count : {std::size_t(2), points.size()})
    {
        const std::span<const Vec2> part(points.data(), count);
        Overlay expected;
        AppendLine(part, false, 2.5, color, {0.25f, 0.75f}, expected);
        AppendLine(part, true, 1.0, color, {0.25f, 0.75f}, expected);
        const Overlay overlay = Copied([&](ImDrawList& list) {
            AddStroke(list, part, false, 2.5, color);
            AddStroke(list, part, true, 1.0, color);
            AddStroke(list, part.first(1), true, 1.0, color); // nothing
        });
        EXPECT_EQ(overlay.vertices, expected.vertices);
        EXPECT_EQ(overlay.indices, expected.indices);
    }
}

TEST(ImGuiDrawData, DrawsABorderInsideItsRectangle)
{
    for (const float rounding : {0.0f, 6.0f})
    {
        const Overlay overlay = Copied([&](ImDrawList& list) {
            AddBorder(list, {{10, 12}, {50, 40}}, rounding, 2.0f, {255, 255, 255, 36});
        });
        Rect full;
        bool isWhite = true;
        for (const OverlayVertex& v : overlay.vertices)
        {
            isWhite = isWhite && v.uv == Vec2{0.25f, 0.75f};
            if (v.color.a > 0)
            {
                full.Include(v.position);
            }
        }
        EXPECT_EQ(full, (Rect{{10.5f, 12.5f}, {49.5f, 39.5f}})) << rounding;
        EXPECT_GE(overlay.vertices.size(), 4u * 4) << "a ring, not a rectangle";
        EXPECT_TRUE(isWhite);
    }
}

TEST(ImGuiDrawData, LeavesOutWhatIsTransparentAndWhatIsCutOff)
{
    const Overlay overlay = Copied([](ImDrawList& list) {
        const ImVec2 points[] = {{3, 4}, {20, 9}, {30, 50}};
        list.AddPolyline(points, 3, IM_COL32(1, 2, 3, 0), 0, 3.0f);
    });
    EXPECT_TRUE(overlay.IsEmpty());
    EXPECT_TRUE(overlay.vertices.empty());
}
