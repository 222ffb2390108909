// SPDX-License-Identifier: MIT
// Changes planted into real scenes, drawn by the renderer, and the presets that find them.
#include <golden/Compare.h>
#include <session/GoldenScenes.h>
#include <session/SceneSession.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace boxreel;

namespace
{

constexpr int kWidth = 1280;
constexpr int kHeight = 720;

class RenderedChange : public testing::TestWithParam<std::string>
{
protected:
    void SetUp() override
    {
        Result<Renderer> renderer = Renderer::Create({.width = kWidth, .height = kHeight});
        ASSERT_TRUE(renderer) << renderer.GetError().Text();
        m_renderer.emplace(std::move(*renderer));
        const Result<GoldenSelection> selection = SelectGolden(GetParam());
        ASSERT_TRUE(selection) << selection.GetError().Text();
        SceneLook look;
        look.width = kWidth;
        look.height = kHeight;
        look.labels = true;
        SceneSource source;
        source.entry = selection->scene;
        source.title = selection->scene->name;
        Result<SceneSession> session = SceneSession::Open(std::move(source), look);
        ASSERT_TRUE(session) << session.GetError().Text();
        session->AdvanceTo(60);
        session->Fill(m_content);
        m_expected = Draw(m_content.list);
    }

    Frame Draw(const DrawList& list, const Camera* camera = nullptr)
    {
        Frame frame;
        EXPECT_TRUE(m_renderer->Draw(list, camera ? *camera : m_content.camera, frame));
        return frame;
    }

    // Returns the last item that is completely inside the picture.
    std::size_t Find(DrawLayer layer, DrawKind kind) const
    {
        const DrawList& list = m_content.list;
        for (std::size_t i = list.items.size(); i-- > 0;)
        {
            const DrawItem& item = list.items[i];
            bool isInside = item.layer == layer && item.kind == kind;
            for (std::size_t k = 0; isInside && k < item.count; ++k)
            {
                const Vec2 p = m_content.camera.ToPixel(list.points[item.first + k]);
                isInside = p.x > 10 && p.y > 10 && p.x < kWidth - 40 && p.y < kHeight - 20;
            }
            if (isInside)
            {
                return i;
            }
        }
        ADD_FAILURE() << "the scene has no such item in its picture";
        return 0;
    }

    bool Finds(const CompareSettings& settings, const Frame& actual) const
    {
        return !Compare(m_expected, actual, settings).equal;
    }

    // Expects all three presets to find it.
    void ExpectFound(const Frame& actual) const
    {
        EXPECT_TRUE(Finds(CompareSettings::Exact(), actual));
        EXPECT_TRUE(Finds(CompareSettings::SameMachine(), actual));
        EXPECT_TRUE(Finds(CompareSettings::CrossMachine(), actual))
            << Compare(m_expected, actual, CompareSettings::CrossMachine()).Text();
    }

    std::optional<Renderer> m_renderer;
    FrameContent m_content;
    Frame m_expected;
};

} // namespace

TEST_P(RenderedChange, IsNotFoundInUnchangedPicture)
{
    const Frame again = Draw(m_content.list);
    EXPECT_FALSE(Finds(CompareSettings::Exact(), again));
    EXPECT_FALSE(Finds(CompareSettings::CrossMachine(), again));
}

// A centimetre is a fraction of a pixel here, which another driver may make of an
// edge: cross-machine leaves that to the draw lists.
TEST_P(RenderedChange, IsFoundOnSameMachineWhenBodyMovesByCentimetre)
{
    DrawList changed = m_content.list;
    const DrawItem& body = changed.items[Find(DrawLayer::Shapes, DrawKind::SolidPolygon)];
    for (std::size_t i = 0; i < body.count; ++i)
    {
        changed.points[body.first + i].x += 0.01f;
    }
    const Frame actual = Draw(changed);
    EXPECT_TRUE(Finds(CompareSettings::Exact(), actual));
    EXPECT_TRUE(Finds(CompareSettings::SameMachine(), actual));
}

TEST_P(RenderedChange, IsFoundByAllWhenBodyMovesByOnePixel)
{
    DrawList changed = m_content.list;
    const DrawItem& body = changed.items[Find(DrawLayer::Shapes, DrawKind::SolidPolygon)];
    for (std::size_t i = 0; i < body.count; ++i)
    {
        changed.points[body.first + i].x += float(1.0 / m_content.camera.pixelsPerMeter);
    }
    ExpectFound(Draw(changed));
}

TEST_P(RenderedChange, IsFoundByAllWhenLineIsMissing)
{
    DrawList withLine = m_content.list;
    withLine.layer = DrawLayer::Joints;
    withLine.AddSegment(m_content.camera.ToWorld({100.3f, 80.2f}),
                        m_content.camera.ToWorld({160.8f, 110.6f}), {128, 204, 204});
    m_expected = Draw(withLine);
    ExpectFound(Draw(m_content.list));
}

// Off by four in each channel, like a theme changed by mistake. Only fills at least three pixels
// wide, because a narrower one consists of edges.
TEST_P(RenderedChange, IsFoundByAllWhenFillIsOffByFour)
{
    std::map<std::uint32_t, int> inFills; // pixels with eight neighbours of the same colour
    const auto word = [&](int x, int y) {
        std::uint32_t value;
        std::memcpy(&value, m_expected.Pixel(x, y), 4);
        return value;
    };
    for (int y = 1; y < kHeight - 1; ++y)
    {
        for (int x = 1; x < kWidth - 1; ++x)
        {
            bool isFlat = true;
            for (int i = 0; i < 9 && isFlat; ++i)
            {
                isFlat = word(x - 1 + i % 3, y - 1 + i / 3) == word(x, y);
            }
            inFills[word(x, y)] += isFlat;
        }
    }
    inFills.erase(word(1, 1)); // the ground
    const auto maximum =
        std::max_element(inFills.begin(), inFills.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    ASSERT_GT(maximum->second, 16);
    Frame actual = m_expected;
    for (std::size_t i = 0; i < actual.rgba.size(); i += 4)
    {
        if (std::memcmp(&maximum->first, m_expected.rgba.data() + i, 4) == 0)
        {
            for (std::size_t channel = 0; channel < 3; ++channel)
            {
                std::uint8_t& value = actual.rgba[i + channel];
                value = std::uint8_t(value < 128 ? value + 4 : value - 4);
            }
        }
    }
    ExpectFound(actual);
}

TEST_P(RenderedChange, IsFoundByAllWhenLabelIsMisspelt)
{
    DrawList changed = m_content.list;
    std::string& label = changed.texts[changed.items[Find(DrawLayer::Labels, DrawKind::Text)].text];
    ASSERT_FALSE(label.empty());
    label.back() = label.back() == '7' ? '1' : '7';
    ExpectFound(Draw(changed));
}

TEST_P(RenderedChange, IsFoundByAllWhenOutlineIsOnePixelThicker)
{
    DrawList changed = m_content.list;
    const std::size_t index = Find(DrawLayer::Shapes, DrawKind::SolidPolygon);
    const DrawItem body = changed.items[index];
    const std::vector<Vec2> points(changed.points.begin() + body.first,
                                   changed.points.begin() + body.first + body.count);
    const float pixel = float(1.0 / m_content.camera.pixelsPerMeter);
    changed.layer = body.layer;
    std::vector<Vec2> shifted;
    for (const Vec2& point : points)
    {
        shifted.push_back({point.x + pixel, point.y});
    }
    changed.AddPolygon(shifted.data(), shifted.size(), body.color);
    ExpectFound(Draw(changed));
}

TEST_P(RenderedChange, IsFoundByAllWhenDrawOrderIsSwapped)
{
    const std::size_t index = Find(DrawLayer::Shapes, DrawKind::SolidPolygon);
    DrawList first = m_content.list;
    const DrawItem body = first.items[index];
    const std::vector<Vec2> points(first.points.begin() + body.first,
                                   first.points.begin() + body.first + body.count);
    std::vector<Vec2> over;
    for (const Vec2& point : points)
    {
        over.push_back({point.x + 0.3f, point.y + 0.3f});
    }
    DrawList second = first;
    const Color other{86, 180, 233};
    first.AddSolidPolygon(points.data(), points.size(), body.color);
    first.AddSolidPolygon(over.data(), over.size(), other);
    second.AddSolidPolygon(over.data(), over.size(), other);
    second.AddSolidPolygon(points.data(), points.size(), body.color);
    m_expected = Draw(first);
    ExpectFound(Draw(second));
}

// Vertices shifted as another driver may do. Without labels, because they snap to whole pixels.
TEST_P(RenderedChange, IsNotFoundAcrossMachinesForTenthOfPixel)
{
    DrawList list = m_content.list;
    std::erase_if(list.items, [](const DrawItem& item) { return item.kind == DrawKind::Text; });
    m_expected = Draw(list);
    Camera camera = m_content.camera;
    camera.centerX += 0.1 / camera.pixelsPerMeter;
    const Frame slightly = Draw(list, &camera);
    EXPECT_TRUE(Finds(CompareSettings::SameMachine(), slightly));
    EXPECT_FALSE(Finds(CompareSettings::CrossMachine(), slightly))
        << Compare(m_expected, slightly, CompareSettings::CrossMachine()).Text();
    camera.centerX += 0.9 / camera.pixelsPerMeter;
    ExpectFound(Draw(list, &camera));
}

INSTANTIATE_TEST_SUITE_P(Of, RenderedChange, testing::Values("pyramid", "bridge", "tumbler"),
                         [](const auto& which) { return which.param; });
