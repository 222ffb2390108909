// SPDX-License-Identifier: MIT
#include "../testbed/cli/Subprocess.h"
#include "PageReader.h"

#include <base/AtomicFile.h>
#include <page/PageWriter.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>

namespace boxreel
{
namespace
{

using testing::HasSubstr;
using testing::Not;

constexpr Camera kCamera{
    .width = 640, .height = 360, .centerX = 1.0, .centerY = 2.0, .pixelsPerMeter = 20.0};
/// Two bodies that move, a joint, contacts that come and go, a text and an axis.
DrawList ListAt(int frame)
{
    DrawList list;
    const float angle = 0.05f * float(frame);
    const Vec2 centre{0.1f * float(frame), 5.0f - 0.001f * float(frame * frame)};
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    const auto place = [&](float x, float y) {
        return Vec2{centre.x + c * x - s * y, centre.y + s * x + c * y};
    };
    list.owner = 0;
    list.AddSegment({-20, 0}, {20, 0}, ColorRole::StaticBody);
    list.owner = 1;
    const Vec2 box[] = {place(-1, -0.5f), place(1, -0.5f), place(1, 0.5f), place(-1, 0.5f)};
    list.AddSolidPolygon(box, 4, frame < 20 ? ColorRole::AwakeBody : ColorRole::AsleepBody);
    list.AddSolidCircle(place(2, 0), 0.5f, {c, s},
                        frame < 20 ? ColorRole::AwakeBody : ColorRole::AsleepBody);
    if (frame > 5)
    {
        list.owner = 2;
        list.AddCircle({3, 3}, 0.1f * float(frame), ColorRole::KinematicBody);
    }
    list.owner = kNoOwner;
    list.layer = DrawLayer::Joints;
    list.AddSegment({0, 9}, centre, ColorRole::Joint);
    list.layer = DrawLayer::Contacts;
    for (int i = frame % 7; i < 12; i += 1 + frame % 3)
    {
        list.AddPoint({float(i), 0.01f * float(frame)}, 4.0f, ColorRole::OldContact);
    }
    list.layer = DrawLayer::CentersOfMass;
    list.owner = 1;
    list.AddTransform(centre, {c, s}, 0.4f);
    list.layer = DrawLayer::Labels;
    list.AddText(centre, "</script> \"" + std::to_string(frame / 10), ColorRole::Ink);
    return list;
}

class PageWriterTest : public testing::Test
{
protected:
    std::filesystem::path Path() const { return folder / "page.html"; }
    PageSettings Settings() const
    {
        PageSettings settings;
        settings.width = kCamera.width;
        settings.height = kCamera.height;
        return settings;
    }
    PageWriter Open(const PageSettings& settings) const
    {
        Result<PageWriter> writer = PageWriter::Open(Path(), settings);
        EXPECT_TRUE(writer);
        return std::move(*writer);
    }
    test::ReadPage Written(int frames) const
    {
        PageWriter writer = Open(Settings());
        for (int frame = 0; frame < frames; ++frame)
        {
            EXPECT_TRUE(writer.Append(ListAt(frame), kCamera));
        }
        EXPECT_TRUE(writer.Close());
        return test::ReadPageFile(Path());
    }

    TemporaryFolder folder;
};

TEST_F(PageWriterTest, WritesItemsOfEveryListAtTheirPlaces)
{
    constexpr int kFrames = 500; // more than two groups
    const test::ReadPage page = Written(kFrames);
    ASSERT_EQ(page.frames.size(), std::size_t(kFrames));
    for (int frame = 0; frame < kFrames && !HasFailure(); ++frame)
    {
        test::ExpectSameItems(page.frames[std::size_t(frame)], ListAt(frame), page.fullScale);
    }
    EXPECT_EQ(page.fullScale, kPageZoom * kCamera.pixelsPerMeter);
}

TEST_F(PageWriterTest, WritesTheSameBytesAgain)
{
    const std::string first = Written(30).html;
    std::filesystem::remove(Path());
    EXPECT_EQ(Written(30).html, first);
}

TEST_F(PageWriterTest, FollowsTheCamera)
{
    PageWriter writer = Open(Settings());
    Camera camera = kCamera;
    for (int frame = 0; frame < 10; ++frame)
    {
        camera.centerX += 0.3;
        camera.pixelsPerMeter *= 1.1;
        ASSERT_TRUE(writer.Append(ListAt(frame), camera));
    }
    ASSERT_TRUE(writer.Close());
    const test::PageFrame last = test::ReadPageFile(Path()).frames.back();
    constexpr double kViewError = 1e-6; // [m], far less than a hundredth of a pixel
    EXPECT_NEAR(last.viewX, camera.centerX, kViewError);
    EXPECT_NEAR(last.viewY, camera.centerY, kViewError);
    EXPECT_NEAR(last.viewHeight, camera.height / camera.pixelsPerMeter, kViewError);
}

TEST_F(PageWriterTest, WritesOriginsAndAnglesOfBodies)
{
    PageWriter writer = Open(Settings());
    for (int frame = 0; frame < 10; ++frame)
    {
        const float angle = 0.05f * float(frame);
        const PageBody body{
            1, {0.1f * float(frame), 5.0f - 0.001f * float(frame * frame)}, angle, "\"b\" <1>"};
        ASSERT_TRUE(writer.Append(ListAt(frame), kCamera, {&body, 1}));
    }
    ASSERT_TRUE(writer.Close());
    const test::ReadPage page = test::ReadPageFile(Path());
    const std::vector<test::PageOrigin>& origins = page.frames.back().origins;
    ASSERT_EQ(origins.size(), 1u);
    EXPECT_EQ(origins[0].owner, 1u);
    constexpr double kRounding = 2e-5; // of forms, places and floats [m]
    EXPECT_NEAR(origins[0].x, 0.9, kRounding);
    EXPECT_NEAR(origins[0].y, 5.0 - 0.081, kRounding);
    EXPECT_NEAR(origins[0].angle, 0.45, kRounding);
    EXPECT_THAT(page.html, HasSubstr(R"("names":{"1":"\u0022b\u0022 \u003c1>"})"));
}

TEST_F(PageWriterTest, StoresABodyAtRestOnce)
{
    const auto bytes = [this](int frames) {
        PageSettings settings = Settings();
        settings.overwrite = true;
        PageWriter writer = Open(settings);
        for (int frame = 0; frame < frames; ++frame)
        {
            EXPECT_TRUE(writer.Append(ListAt(3), kCamera));
        }
        EXPECT_TRUE(writer.Close());
        return std::filesystem::file_size(Path());
    };
    EXPECT_LT(bytes(200), bytes(2) + 400);
}

TEST_F(PageWriterTest, SharesTheFormOfEqualShapes)
{
    PageWriter writer = Open(Settings());
    DrawList list;
    for (std::uint32_t owner = 0; owner < 100; ++owner)
    {
        const float x = float(owner);
        const Vec2 box[] = {{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}};
        list.owner = owner;
        list.AddSolidPolygon(box, 4, ColorRole::AwakeBody);
    }
    ASSERT_TRUE(writer.Append(list, kCamera));
    ASSERT_TRUE(writer.Close());
    EXPECT_EQ(test::ReadPageFile(Path()).forms, 1u);
}

TEST_F(PageWriterTest, LeavesOutItemsThatAreNotFinite)
{
    PageWriter writer = Open(Settings());
    DrawList list = ListAt(0);
    DrawList broken = list;
    broken.AddCircle({std::numeric_limits<float>::infinity(), 0}, 1.0f, ColorRole::Pair);
    broken.AddPoint({std::numeric_limits<float>::quiet_NaN(), 0}, 1.0f, ColorRole::Pair);
    ASSERT_TRUE(writer.Append(broken, kCamera));
    ASSERT_TRUE(writer.Close());
    const test::ReadPage page = test::ReadPageFile(Path());
    test::ExpectSameItems(page.frames.at(0), list, page.fullScale);
}

TEST_F(PageWriterTest, UsesTheColoursOfTheTheme)
{
    PageSettings settings = Settings();
    settings.theme = Theme::OkabeIto();
    PageWriter writer = Open(settings);
    ASSERT_TRUE(writer.Append(ListAt(0), kCamera));
    ASSERT_TRUE(writer.Close());
    EXPECT_EQ(test::ReadPageFile(Path()).frames.at(0).items.at(1).stroke, "rgb(230,159,0)");
}

TEST_F(PageWriterTest, EscapesMarkupInTexts)
{
    PageSettings settings = Settings();
    settings.title = "<b>\"{{frames}}";
    PageWriter writer = Open(settings);
    ASSERT_TRUE(writer.Append(ListAt(0), kCamera));
    ASSERT_TRUE(writer.Close());
    const std::string page = test::ReadPageFile(Path()).html;
    EXPECT_THAT(page, HasSubstr("<title>&lt;b&gt;&quot;{{frames}}</title>"));
    EXPECT_THAT(page, HasSubstr("\\u003c/script> \\u0022"));
    EXPECT_THAT(page, Not(HasSubstr("://"))) << "a page needs no network";
}

TEST_F(PageWriterTest, KeepsAnchorsOfJointSigns)
{
    DrawList list = ListAt(0);
    list.layer = DrawLayer::JointGlyphs;
    list.owner = kNoOwner;
    list.AddCircle({1, 1}, 0.3f, ColorRole::Joint);
    list.AddSegment({1, 1}, {3, 1.5f}, ColorRole::Joint);
    const std::vector<Vec2> anchors = {{1, 1}, {1, 1}, {2.9f, 1.5f}};
    PageWriter writer = Open(Settings());
    ASSERT_TRUE(writer.Append(list, kCamera, {}, anchors));
    ASSERT_TRUE(writer.Append(list, kCamera)); // without them, signs grow
    ASSERT_TRUE(writer.Close());
    const test::ReadPage page = test::ReadPageFile(Path());
    const std::vector<double> wanted[] = {{1, 1, 2.9, 1.5}, {1, 1, 3, 1.5}};
    for (std::size_t frame = 0; frame < 2; ++frame)
    {
        test::ExpectSameItems(page.frames.at(frame), list, page.fullScale);
        const test::PageItem& line = page.frames[frame].items.back();
        ASSERT_EQ(line.anchors.size(), 4u);
        for (std::size_t i = 0; i < 4; ++i)
        {
            EXPECT_NEAR(line.anchors[i], wanted[frame][i], 1e-5) << i;
        }
    }
}

/// The pixel at which a renderer begins a text.
std::array<double, 2> TextPixel(double x, double y, const Camera& camera)
{
    return {std::floor(0.5 * camera.width + (x - camera.centerX) * camera.pixelsPerMeter + 0.5),
            std::floor(0.5 * camera.height - (y - camera.centerY) * camera.pixelsPerMeter + 0.5)};
}

TEST_F(PageWriterTest, BeginsTextsAtHalvesAtTheSamePixel)
{
    Camera camera = kCamera;
    camera.centerX = 0.7; // neither it nor the scale is a whole number of quanta
    camera.pixelsPerMeter = 23.7;
    DrawList list;
    list.layer = DrawLayer::Labels;
    for (int i = 0; i < 300; ++i)
    {
        list.AddText({float(camera.centerX + (i - 149.5) / camera.pixelsPerMeter),
                      float(camera.centerY + (0.5 * i - 74.5) / camera.pixelsPerMeter)},
                     "1", ColorRole::Ink);
    }
    PageWriter writer = Open(Settings());
    ASSERT_TRUE(writer.Append(list, camera));
    ASSERT_TRUE(writer.Close());
    const test::ReadPage page = test::ReadPageFile(Path());
    const test::PageFrame& frame = page.frames.at(0);
    test::ExpectSameItems(frame, list, page.fullScale);
    Camera stored = camera;
    stored.centerX = frame.viewX;
    stored.centerY = frame.viewY;
    stored.pixelsPerMeter = camera.height / frame.viewHeight;
    for (std::size_t i = 0; i < list.points.size(); ++i)
    {
        const std::vector<double>& points = frame.items.at(i).points;
        EXPECT_EQ(TextPixel(points[0], points[1], stored),
                  TextPixel(list.points[i].x, list.points[i].y, camera))
            << i;
    }
}

TEST_F(PageWriterTest, RefusesSettingsOutOfRange)
{
    const auto refuses = [this](auto&& change, const std::string& culprit) {
        PageSettings settings = Settings();
        change(settings);
        const Result<PageWriter> writer = PageWriter::Open(Path(), settings);
        ASSERT_FALSE(writer);
        EXPECT_EQ(writer.GetError().kind, ErrorKind::Unusable);
        EXPECT_THAT(writer.GetError().culprit, HasSubstr(culprit));
    };
    refuses([](PageSettings& s) { s.width = 0; }, "0x360");
    refuses([](PageSettings& s) { s.height = 8193; }, "640x8193");
    refuses([](PageSettings& s) { s.framesPerSecond = 0.0; }, "framesPerSecond");
    refuses([](PageSettings& s) { s.speed = std::nan(""); }, "time");
    EXPECT_TRUE(folder.Names().empty());
}

TEST_F(PageWriterTest, RefusesPathsThatCannotBeWritten)
{
    std::ofstream(Path()) << "mine";
    const auto kindOf = [this](const std::filesystem::path& path) {
        const Result<PageWriter> writer = PageWriter::Open(path, Settings());
        return writer ? ErrorKind::Failed : writer.GetError().kind;
    };
    EXPECT_EQ(kindOf(Path()), ErrorKind::Unusable);
    EXPECT_EQ(kindOf(folder / "missing/page.html"), ErrorKind::Unusable);
    EXPECT_EQ(ReadBytes(Path()), "mine");
}

TEST_F(PageWriterTest, RefusesCamerasThatCannotBeDrawn)
{
    PageWriter writer = Open(Settings());
    Camera other = kCamera;
    other.width = 320;
    EXPECT_FALSE(writer.Append(ListAt(0), other));
    other = kCamera;
    other.pixelsPerMeter = 0.0;
    EXPECT_FALSE(writer.Append(ListAt(0), other));
    other = kCamera;
    other.centerX = 1e13;
    EXPECT_FALSE(writer.Append(ListAt(0), other));
    EXPECT_TRUE(writer.Append(ListAt(0), kCamera));
    other = kCamera;
    other.pixelsPerMeter = 1.01 * kPageZoom * kCamera.pixelsPerMeter;
    EXPECT_FALSE(writer.Append(ListAt(1), other)) << "places would be less exact than promised";
    other.pixelsPerMeter = kPageZoom * kCamera.pixelsPerMeter;
    EXPECT_TRUE(writer.Append(ListAt(1), other));
}

TEST_F(PageWriterTest, LeavesThePageSoFarWhenSuspended)
{
    const auto write = [this](bool closes) {
        PageWriter writer = Open(Settings());
        EXPECT_TRUE(writer.Append(ListAt(0), kCamera));
        EXPECT_TRUE(closes ? writer.Close() : writer.Suspend());
    };
    write(true);
    const std::string closed = ReadBytes(Path());
    std::filesystem::remove(Path());
    write(false);
    const std::filesystem::path part = PartPath(Path());
    EXPECT_THAT(folder.Names(), testing::ElementsAre(part.filename().string()));
    EXPECT_EQ(ReadBytes(part), closed);
}

TEST_F(PageWriterTest, KeepsAFileOfItsTemporaryName)
{
    const std::filesystem::path part = PartPath(Path());
    std::ofstream(part) << "mine";
    const Result<PageWriter> refused = PageWriter::Open(Path(), Settings());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.GetError().kind, ErrorKind::Unusable);
    EXPECT_EQ(ReadBytes(part), "mine");
    PageSettings settings = Settings();
    settings.overwrite = true;
    EXPECT_TRUE(PageWriter::Open(Path(), settings));
}

TEST_F(PageWriterTest, LeavesNothingWithoutAFrameOrClose)
{
    {
        PageWriter writer = Open(Settings());
        EXPECT_FALSE(writer.Close());
    }
    {
        PageWriter writer = Open(Settings());
        ASSERT_TRUE(writer.Append(ListAt(0), kCamera));
    }
    EXPECT_TRUE(folder.Names().empty());
}

} // namespace
} // namespace boxreel
