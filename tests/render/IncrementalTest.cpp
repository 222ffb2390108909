// SPDX-License-Identifier: MIT
#include "Pictures.h"

#include <algorithm>
#include <cstring>
#include <limits>

// After any change between frames, the incremental renderer shows the same bits as one that draws
// everything.
using namespace boxreel;

namespace
{

class Random
{
public:
    explicit Random(unsigned seed) : m_generator(seed) {}
    int Below(int count) { return int(m_generator() % unsigned(count)); }
    bool OneIn(int count) { return Below(count) == 0; }
    float Between(float a, float b)
    {
        return a + (b - a) * float(m_generator() % 100000u) / 100000.0f;
    }
    template <class T>
    T OneOf(std::initializer_list<T> values)
    {
        return *(values.begin() + Below(int(values.size())));
    }

private:
    std::mt19937 m_generator;
};

/// An item by itself, so that lists can be edited.
struct Thing
{
    DrawKind kind = DrawKind::Point;
    DrawLayer layer = DrawLayer::Shapes;
    std::uint32_t owner = kNoOwner;
    std::vector<Vec2> points;
    float size = 0.0f;
    Color color;
    std::string text;
};

DrawList ListOf(const std::vector<Thing>& things)
{
    DrawList list;
    for (const Thing& thing : things)
    {
        list.layer = thing.layer;
        list.owner = thing.owner;
        const Vec2* const p = thing.points.data();
        switch (thing.kind)
        {
        case DrawKind::Polygon:
            list.AddPolygon(p, thing.points.size(), thing.color);
            break;
        case DrawKind::SolidPolygon:
            list.AddSolidPolygon(p, thing.points.size(), thing.color);
            break;
        case DrawKind::Circle:
            list.AddCircle(p[0], thing.size, thing.color);
            break;
        case DrawKind::SolidCircle:
            list.AddSolidCircle(p[0], thing.size, p[1], thing.color);
            break;
        case DrawKind::Segment:
            list.AddSegment(p[0], p[1], thing.color);
            break;
        case DrawKind::Transform:
            list.AddTransform(p[0], p[1], thing.size);
            break;
        case DrawKind::Point:
            list.AddPoint(p[0], thing.size, thing.color);
            break;
        case DrawKind::Text:
            list.AddText(p[0], thing.text, thing.color);
            break;
        }
    }
    return list;
}

/// A world of scenes in a picture of this size, with its camera and its panel.
class Show
{
public:
    Show(unsigned seed, int width, int height)
        : m_random(seed), m_width(width), m_height(height),
          m_hud(std::move(*Hud::Create(width, height)))
    {
        SetCamera();
        for (int i = m_random.Below(120); i >= 0; --i)
        {
            m_things.push_back(Anything());
        }
        m_overlay = m_hud.Build({"frame", {{"number", "0"}}});
    }

    const Camera& View() const { return m_camera; }
    DrawList List() const { return ListOf(m_things); }
    const Overlay* Panel() const { return m_hasPanel ? &m_overlay : nullptr; }

    /// Some changes; which, the return value says.
    std::string Edit()
    {
        std::string done;
        for (int i = m_random.OneOf({0, 1, 1, 2, 5, 30}); i > 0; --i)
        {
            done += EditOnce() + ", ";
        }
        return done;
    }

private:
    Vec2 Somewhere()
    {
        // In the view, beside it, or far away.
        const float reach = float(0.5 * m_width / m_camera.pixelsPerMeter) *
                            m_random.OneOf({0.9f, 0.9f, 0.9f, 1.3f, 40.0f});
        return {float(m_camera.centerX) + m_random.Between(-reach, reach),
                float(m_camera.centerY) + m_random.Between(-reach, reach)};
    }

    /// Returns the extent of a body [m], in most cases a few pixels.
    float Extent()
    {
        const float pixels = m_random.OneIn(40)
                                 ? m_random.OneOf({0.0f, 1e-3f, 1e3f, 1e5f, 1e8f, 1e20f})
                                 : m_random.OneOf({m_random.Between(0, 4), m_random.Between(2, 20),
                                                   m_random.Between(5, 90)});
        return pixels / float(m_camera.pixelsPerMeter);
    }

    Thing Anything()
    {
        Thing thing;
        thing.kind = DrawKind(m_random.Below(8));
        thing.layer = DrawLayer(m_random.Below(7));
        thing.owner = m_random.OneIn(2) ? kNoOwner : std::uint32_t(m_random.Below(20));
        thing.color = {std::uint8_t(m_random.Below(256)), std::uint8_t(m_random.Below(256)),
                       std::uint8_t(m_random.Below(256)),
                       std::uint8_t(m_random.OneIn(3) ? m_random.Below(256) : 255)};
        thing.text = m_random.OneOf({"", "a", "label 12", "two\nlines", "\xff"});
        Place(thing);
        return thing;
    }

    void Place(Thing& thing)
    {
        const Vec2 at = Somewhere();
        const float angle = m_random.Between(0, 6.2831853f);
        const Vec2 axis{std::cos(angle), std::sin(angle)};
        thing.size = thing.kind == DrawKind::Point ? m_random.Between(0, 30) : Extent();
        thing.points = {at, axis};
        if (thing.kind == DrawKind::Segment)
        {
            thing.points[1] = m_random.OneIn(2) ? Somewhere() : Vec2{at.x + Extent(), at.y};
        }
        if (thing.kind == DrawKind::Polygon || thing.kind == DrawKind::SolidPolygon)
        {
            DrawList list;
            m_random.OneIn(2)
                ? AddTurnedBox(list, at, Extent(), Extent(), m_random.OneIn(3) ? 0 : angle, {})
                : AddRegular(list, at, Extent(), Extent(), 3 + m_random.Below(6), angle, {});
            thing.points = list.points;
        }
        if (m_random.OneIn(60))
        {
            const float bad = m_random.OneOf({std::numeric_limits<float>::quiet_NaN(),
                                              std::numeric_limits<float>::infinity(),
                                              std::numeric_limits<float>::max(), -0.0f});
            (m_random.OneIn(2) ? thing.points[0].x : thing.size) = bad;
        }
    }

    std::size_t Any() { return std::size_t(m_random.Below(int(m_things.size()))); }
    auto AtAny() { return m_things.begin() + std::ptrdiff_t(Any()); }

    std::string EditOnce()
    {
        if (m_things.empty())
        {
            m_things.push_back(Anything());
            return "begin";
        }
        switch (m_random.Below(14))
        {
        case 0:
            m_things.insert(AtAny(), Anything());
            return "insert";
        case 1:
            m_things.push_back(Anything());
            return "append";
        case 2:
            m_things.erase(AtAny());
            return "remove";
        case 3:
            std::swap(m_things[Any()], m_things[Any()]);
            return "swap";
        case 4:
            m_things[Any()].color.g = std::uint8_t(m_random.Below(256));
            return "recolour";
        case 5:
            m_things[Any()].text += m_random.OneOf({"x", "1", "\n"});
            return "write";
        case 6:
            m_hasPanel = !m_hasPanel;
            return "panel";
        case 7:
            m_overlay = m_hud.Build({"frame", {{"number", std::to_string(m_random.Below(2000))}}});
            return "count";
        case 8:
            return EditMuch();
        case 9:
            return Nudge();
        default:
            Place(m_things[Any()]);
            return "move";
        }
    }

    /// By less than a pixel, as most of what moves.
    std::string Nudge()
    {
        const float step = 0.3f / float(m_camera.pixelsPerMeter);
        for (Vec2& point : m_things[Any()].points)
        {
            point = {point.x + step, point.y + 0.5f * step};
        }
        return "nudge";
    }

    std::string EditMuch()
    {
        switch (m_random.Below(4))
        {
        case 0:
            SetCamera();
            return "camera";
        case 1:
            std::rotate(m_things.begin(), AtAny(), m_things.end());
            return "rotate";
        case 2:
            m_things.erase(m_things.begin(), AtAny());
            return "remove many";
        default:
            for (Thing& thing : m_things)
            {
                if (m_random.OneIn(3))
                {
                    Place(thing);
                }
            }
            return "move many";
        }
    }

    void SetCamera()
    {
        m_camera.width = m_width;
        m_camera.height = m_height;
        m_camera.centerX = m_random.Between(-3, 3);
        m_camera.centerY = m_random.Between(-3, 3);
        m_camera.pixelsPerMeter = m_random.OneOf({0.37f, 1.0f, 14.4f, 211.0f});
    }

    Random m_random;
    int m_width;
    int m_height;
    Hud m_hud;
    Overlay m_overlay;
    bool m_hasPanel = true;
    Camera m_camera;
    std::vector<Thing> m_things;
};

RendererSettings SettingsOf(int width, int height, unsigned seed, Backend backend)
{
    RendererSettings settings;
    settings.width = width;
    settings.height = height;
    settings.backend = backend;
    settings.theme.outlineWidth = seed % 3 == 1 ? 4.5f : settings.theme.outlineWidth;
    if (seed % 4 == 2)
    {
        settings.theme.background = {200, 31, 77, 129}; // no step of 1 / 255 when premultiplied
    }
    settings.scale = seed % 5 == 3 ? 0.7 : 1.0;
    return settings;
}

/// Returns the difference of two frames in words; empty if they are equal.
std::string Difference(const Frame& a, const Frame& b)
{
    if (a == b)
    {
        return "";
    }
    for (int y = 0; y < a.height; ++y)
    {
        for (int x = 0; x < a.width; ++x)
        {
            if (At(a, x, y) != At(b, x, y))
            {
                return "at " + std::to_string(x) + ", " + std::to_string(y) + ": " +
                       testing::PrintToString(At(a, x, y)) + " and " +
                       testing::PrintToString(At(b, x, y));
            }
        }
    }
    return "in size";
}

/// The pixels of `next` outside the rectangles are those of `last`, and no two rectangles overlap.
void ExpectChangesWithin(std::span<const PixelBounds> changes, const Frame& last, const Frame& next)
{
    Frame kept = next; // with last's pixels where it may have changed
    for (const PixelBounds& r : changes)
    {
        ASSERT_FALSE(r.IsEmpty());
        ASSERT_EQ(Intersection(r, {0, 0, next.width, next.height}), r);
        for (int y = r.y0; y < r.y1; ++y)
        {
            const auto bytes = std::size_t(r.x1 - r.x0) * 4;
            std::memcpy(kept.Pixel(r.x0, y), last.Pixel(r.x0, y), bytes);
        }
    }
    EXPECT_TRUE(kept == last);
    for (std::size_t i = 0; i < changes.size(); ++i)
    {
        for (std::size_t k = 0; k < i; ++k)
        {
            EXPECT_TRUE(Intersection(changes[i], changes[k]).IsEmpty());
        }
    }
}

struct Size
{
    int width;
    int height;
};

/// The statistics of a run, which show that the test is effective.
RenderTotals Film(unsigned seed, Size size, int frames, Backend backend = Backend::Auto)
{
    const RendererSettings settings = SettingsOf(size.width, size.height, seed, backend);
    RendererSettings whole = settings;
    whole.redrawsWhole = true;
    Result<Renderer> renderer = Renderer::Create(settings);
    Result<Renderer> reference = Renderer::Create(whole);
    EXPECT_TRUE(renderer && reference);
    Show show(seed, size.width, size.height);
    Random random(seed + 1000);
    Frame last(size.width, size.height);
    std::string edits;
    for (int i = 0; i < frames; ++i)
    {
        edits += show.Edit();
        EXPECT_TRUE(renderer->Submit(show.List(), show.View(), show.Panel()));
        if (i > 0 && random.OneIn(3))
        {
            continue; // the next one, without reading this
        }
        Frame expected;
        EXPECT_TRUE(reference->Draw(show.List(), show.View(), expected, show.Panel()));
        const Result<const Frame*> read = renderer->ReadChanges();
        EXPECT_TRUE(read);
        EXPECT_EQ(Difference(**read, expected), "")
            << "seed " << seed << ", frame " << i << ": " << edits;
        ExpectChangesWithin(renderer->Changes(), last, expected);
        last = expected;
        if (random.OneIn(4))
        {
            Frame other(random.Below(9), random.Below(9));
            EXPECT_TRUE(renderer->Read(other));
            EXPECT_EQ(Difference(other, expected), "");
        }
        if (testing::Test::HasFailure())
        {
            break;
        }
        edits.clear();
    }
    return renderer->Totals();
}

} // namespace

TEST(IncrementalDrawing, EqualsCompleteDrawingAfterAnyChange)
{
    RenderTotals sum;
    unsigned seed = 1;
    for (const Size size : {Size{320, 240}, {101, 333}, {641, 359}, {7, 5}, {64, 64}, {1280, 31}})
    {
        for (int run = 0; run < 12; ++run)
        {
            const RenderTotals totals = Film(seed++, size, 30);
            sum.frames += totals.frames;
            sum.framesInPart += totals.framesInPart;
            sum.framesUnchanged += totals.framesUnchanged;
            if (HasFailure())
            {
                return;
            }
        }
    }
    EXPECT_GT(sum.framesInPart, sum.frames / 4);
    EXPECT_GT(sum.framesUnchanged, sum.frames / 20);
    EXPECT_GT(sum.frames - sum.framesInPart - sum.framesUnchanged, sum.frames / 20);
}

TEST(IncrementalDrawing, EqualsCompleteDrawingWithEitherBackEnd)
{
    for (const Backend backend : {Backend::OSMesa, Backend::Egl})
    {
        if (Renderer::Create({.width = 8, .height = 8, .backend = backend}))
        {
            for (unsigned seed = 500; seed < 506; ++seed)
            {
                Film(seed, {333, 222}, 25, backend);
            }
        }
    }
}

TEST(IncrementalDrawing, RedrawsOldAndNewPlaceOfMovedItem)
{
    Renderer renderer = MakeRenderer(320, 240);
    const Camera camera = PixelCamera(320, 240);
    DrawList list;
    AddRectangle(list, 0, 0, 320, 20, kStatic);
    AddRectangle(list, 50, 50, 70, 70, kAwake);
    (void)DrawWith(renderer, list, camera);
    DrawList moved;
    AddRectangle(moved, 0, 0, 320, 20, kStatic);
    AddRectangle(moved, 150, 150, 170, 170, kAwake);
    const Frame frame = DrawWith(renderer, moved, camera);
    EXPECT_TRUE(frame == Picture(moved, 320, 240));

    const RenderStatistics& now = renderer.Statistics();
    EXPECT_EQ(now.items, 2u);
    EXPECT_EQ(now.itemsDrawn, 1u) << "the ground is not touched";
    EXPECT_EQ(now.itemsReused, 1u);
    EXPECT_EQ(now.rectangles, 2u);
    EXPECT_GE(now.pixels, 2 * 22 * 22);
    EXPECT_LE(now.pixels, 2 * 40 * 40);
}

TEST(IncrementalDrawing, DrawsNoPixelOfUnchangedFrame)
{
    Renderer renderer = MakeRenderer(320, 240);
    const Camera camera = PixelCamera(320, 240);
    const DrawList list = Everything();
    (void)DrawWith(renderer, list, camera);
    ASSERT_TRUE(renderer.ReadChanges());
    ASSERT_TRUE(renderer.Submit(list, camera));
    EXPECT_TRUE(renderer.Statistics().unchanged);
    EXPECT_EQ(renderer.Statistics().pixels, 0);
    EXPECT_EQ(renderer.Statistics().drawCalls, 0u);
    ASSERT_TRUE(renderer.ReadChanges());
    EXPECT_TRUE(renderer.Changes().empty());

    DrawList more = list;
    AddRectangle(more, 400, 400, 420, 420, kAwake);
    ASSERT_TRUE(renderer.Submit(more, camera));
    EXPECT_TRUE(renderer.Statistics().unchanged) << "what was added is not in the picture";
    EXPECT_EQ(renderer.Totals().frames, 3);
    EXPECT_EQ(renderer.Totals().framesUnchanged, 2);
}

TEST(IncrementalDrawing, RedrawsOnlyInsertedOrRemovedItems)
{
    Renderer renderer = MakeRenderer(320, 240);
    const Camera camera = PixelCamera(320, 240);
    DrawList list;
    for (int i = 0; i < 60; ++i)
    {
        list.AddPoint({5.0f + 5.0f * float(i), 100}, 4, kAwake);
    }
    (void)DrawWith(renderer, list, camera);
    DrawList shifted;
    for (int i = 0; i < 60; ++i)
    {
        if (i == 30)
        {
            shifted.AddPoint({100, 200}, 4, kStatic);
        }
        if (i != 10 && i != 11)
        {
            shifted.AddPoint({5.0f + 5.0f * float(i), 100}, 4, kAwake);
        }
    }
    EXPECT_TRUE(DrawWith(renderer, shifted, camera) == Picture(shifted, 320, 240));
    EXPECT_EQ(renderer.Statistics().itemsReused, 58u);
    EXPECT_LE(renderer.Statistics().pixels, 3 * 16 * 16);
}

TEST(IncrementalDrawing, LeavesNothingBehindAMovedPanel)
{
    // The same triangles elsewhere, and then other ones.
    Result<Hud> hud = Hud::Create(320, 240);
    ASSERT_TRUE(hud);
    Overlay overlay = hud->Build({"title", {{"name", "value"}}});
    Renderer renderer = MakeRenderer(320, 240);
    const Camera camera = PixelCamera(320, 240);
    const DrawList list = Everything();
    (void)DrawWith(renderer, list, camera, &overlay);
    for (OverlayVertex& vertex : overlay.vertices)
    {
        vertex.position.y += 100.0f;
    }
    for (OverlayCommand& command : overlay.commands)
    {
        command.clipX0 = command.clipY0 = 0;
        command.clipX1 = 320;
        command.clipY1 = 240;
    }
    (void)DrawWith(renderer, list, camera, &overlay);
    for (OverlayVertex& vertex : overlay.vertices)
    {
        vertex.position.y -= 90.0f;
    }
    const Frame moved = DrawWith(renderer, list, camera, &overlay);
    EXPECT_FALSE(renderer.Statistics().unchanged);
    Renderer fresh = MakeRenderer(320, 240);
    EXPECT_EQ(Difference(moved, DrawWith(fresh, list, camera, &overlay)), "");
    EXPECT_EQ(Difference(DrawWith(renderer, list, camera), Picture(list, 320, 240)), "");
}

TEST(IncrementalDrawing, RestoresFrameChangedByTheCaller)
{
    Renderer renderer = MakeRenderer(320, 240);
    const Camera camera = PixelCamera(320, 240);
    DrawList list = Everything();
    Frame frame = DrawWith(renderer, list, camera);
    list.points[3].x += 2.0f;
    std::fill(frame.rgba.begin(), frame.rgba.end(), std::uint8_t(7));
    ASSERT_TRUE(renderer.Draw(list, camera, frame));
    EXPECT_TRUE(frame == Picture(list, 320, 240));
}
