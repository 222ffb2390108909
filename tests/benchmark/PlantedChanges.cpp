// SPDX-License-Identifier: MIT
#include "PlantedChanges.h"

#include <session/SceneSession.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <random>
#include <utility>

namespace bench
{
namespace
{

using namespace boxreel;

constexpr int kWidth = 1280;         // [px]
constexpr int kHeight = 720;         // [px]
constexpr std::int64_t kStep = 60;   // a second in: things move and touch
constexpr float kCentimetre = 0.01f; // [m]

/// One scene's moment, drawn as often as is needed.
class Planter
{
public:
    Planter(FrameContent content, Renderer& renderer)
        : m_content(std::move(content)), m_renderer(renderer)
    {}

    Result<std::vector<PlantedPicture>> All()
    {
        m_expected = Draw(m_content.list, m_content.camera);
        const std::optional<std::size_t> body = Find(DrawLayer::Shapes, DrawKind::SolidPolygon);
        const std::optional<std::size_t> label = Find(DrawLayer::Labels, DrawKind::Text);
        if (!body || !label)
        {
            return Error{ErrorKind::Unusable, "it shows no polygon, or no label, as a whole"};
        }
        AddSame();
        AddMovedBody(*body);
        AddMissingLine();
        AddFill();
        AddMisspelt(*label);
        AddOutline(*body);
        AddOrder(*body);
        AddStray();
        AddShifted();
        AddNoise();
        return m_failure.empty() ? Result<std::vector<PlantedPicture>>(std::move(m_all))
                                 : Error{ErrorKind::Failed, m_failure};
    }

private:
    Frame Draw(const DrawList& list, const Camera& camera)
    {
        Frame frame;
        const Result<void> drawn = m_renderer.Draw(list, camera, frame);
        m_failure = drawn ? m_failure : drawn.GetError().Text();
        return frame;
    }

    Frame Draw(const DrawList& list) { return Draw(list, m_content.camera); }

    void Add(const char* change, Frame expected, Frame actual)
    {
        m_all.push_back({change, std::move(expected), std::move(actual)});
    }

    /// Returns the last item of this kind that is inside the picture with room for a label.
    std::optional<std::size_t> Find(DrawLayer layer, DrawKind kind) const
    {
        const DrawList& list = m_content.list;
        for (std::size_t i = list.items.size(); i-- > 0;)
        {
            const DrawItem& item = list.items[i];
            bool isInside = item.layer == layer && item.kind == kind && item.count > 0;
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
        return {};
    }

    std::vector<Vec2> PointsOf(std::size_t item, float right, float up) const
    {
        const DrawItem& body = m_content.list.items[item];
        std::vector<Vec2> points(m_content.list.points.begin() + body.first,
                                 m_content.list.points.begin() + body.first + body.count);
        for (Vec2& point : points)
        {
            point = {point.x + right, point.y + up};
        }
        return points;
    }

    float Pixel() const { return float(1.0 / m_content.camera.pixelsPerMeter); } // [m]

    void AddSame() { Add("equal", m_expected, Draw(m_content.list)); }

    void AddMovedBody(std::size_t body)
    {
        DrawList moved = m_content.list;
        const std::vector<Vec2> points = PointsOf(body, kCentimetre, 0.0f);
        std::copy(points.begin(), points.end(), moved.points.begin() + moved.items[body].first);
        Add("body", m_expected, Draw(moved));
    }

    void AddMissingLine()
    {
        DrawList joined = m_content.list;
        joined.layer = DrawLayer::Joints;
        joined.AddSegment(m_content.camera.ToWorld({100.3f, 80.2f}),
                          m_content.camera.ToWorld({160.8f, 110.6f}), {128, 204, 204});
        Add("line", Draw(joined), m_expected);
    }

    static std::uint32_t Word(const Frame& frame, int x, int y)
    {
        std::uint32_t word;
        std::memcpy(&word, frame.Pixel(x, y), 4);
        return word;
    }

    /// The colour of most pixels that have it all around them, and are not the ground.
    std::uint32_t MostOfAFill() const
    {
        std::map<std::uint32_t, int> inFills;
        for (int y = 1; y < kHeight - 1; ++y)
        {
            for (int x = 1; x < kWidth - 1; ++x)
            {
                bool isFlat = true;
                for (int i = 0; i < 9 && isFlat; ++i)
                {
                    isFlat =
                        Word(m_expected, x - 1 + i % 3, y - 1 + i / 3) == Word(m_expected, x, y);
                }
                inFills[Word(m_expected, x, y)] += isFlat;
            }
        }
        inFills.erase(Word(m_expected, 1, 1));
        const auto maximum =
            std::max_element(inFills.begin(), inFills.end(),
                             [](const auto& a, const auto& b) { return a.second < b.second; });
        return maximum == inFills.end() ? 0 : maximum->first;
    }

    /// Off by four in each channel, as with a theme that was changed by mistake.
    void AddFill()
    {
        const std::uint32_t fill = MostOfAFill();
        Frame actual = m_expected;
        for (std::size_t i = 0; i < actual.rgba.size(); i += 4)
        {
            if (std::memcmp(&fill, m_expected.rgba.data() + i, 4) == 0)
            {
                for (std::size_t channel = 0; channel < 3; ++channel)
                {
                    std::uint8_t& value = actual.rgba[i + channel];
                    value = std::uint8_t(value < 128 ? value + 4 : value - 4);
                }
            }
        }
        Add("fill", m_expected, std::move(actual));
    }

    void AddMisspelt(std::size_t label)
    {
        DrawList changed = m_content.list;
        std::string& text = changed.texts[changed.items[label].text];
        text.back() = text.back() == '7' ? '1' : '7';
        Add("label", m_expected, Draw(changed));
    }

    void AddOutline(std::size_t body)
    {
        DrawList changed = m_content.list;
        const std::vector<Vec2> points = PointsOf(body, Pixel(), 0.0f);
        changed.layer = DrawLayer::Shapes;
        changed.AddPolygon(points.data(), points.size(), m_content.list.items[body].color);
        Add("outline", m_expected, Draw(changed));
    }

    void AddOrder(std::size_t body)
    {
        const std::vector<Vec2> one = PointsOf(body, 0.0f, 0.0f);
        const std::vector<Vec2> two = PointsOf(body, 0.3f, 0.3f);
        const Color color = m_content.list.items[body].color;
        const Color other{86, 180, 233};
        DrawList first = m_content.list;
        DrawList second = m_content.list;
        first.layer = second.layer = DrawLayer::Shapes;
        first.AddSolidPolygon(one.data(), one.size(), color);
        first.AddSolidPolygon(two.data(), two.size(), other);
        second.AddSolidPolygon(two.data(), two.size(), other);
        second.AddSolidPolygon(one.data(), one.size(), color);
        Add("order", Draw(first), Draw(second));
    }

    /// One pixel of another colour, where nothing is.
    void AddStray()
    {
        Frame actual = m_expected;
        const std::uint8_t red[4] = {230, 40, 60, 255};
        std::copy(red, red + 4, actual.Pixel(kWidth - 60, 40));
        Add("stray", m_expected, std::move(actual));
    }

    /// Adds a shift as another driver may round corners. Without labels, because they snap to whole
    /// pixels.
    void AddShifted()
    {
        DrawList list = m_content.list;
        std::erase_if(list.items, [](const DrawItem& item) { return item.kind == DrawKind::Text; });
        Camera camera = m_content.camera;
        camera.centerX += 0.1 / camera.pixelsPerMeter;
        Add("shift", Draw(list), Draw(list, camera));
    }

    /// Every channel up to one off, as of a lossy film.
    void AddNoise()
    {
        Frame actual = m_expected;
        std::mt19937 random(1);
        for (std::size_t i = 0; i < actual.rgba.size(); ++i)
        {
            const int value = int(actual.rgba[i]) + int(random() % 3) - 1;
            actual.rgba[i] = i % 4 == 3 ? actual.rgba[i] : std::uint8_t(std::clamp(value, 0, 255));
        }
        Add("noise", m_expected, std::move(actual));
    }

    FrameContent m_content;
    Renderer& m_renderer;
    Frame m_expected;
    std::vector<PlantedPicture> m_all;
    std::string m_failure;
};

} // namespace

const std::vector<PlantedKind>& PlantedKinds()
{
    static const std::vector<PlantedKind> kinds{
        {"body", "a body moved by 1 cm", "different"},
        {"line", "a joint's line is missing", "different"},
        {"fill", "a fill off by 4 of 255", "different"},
        {"label", "a label misspelt", "different"},
        {"outline", "an outline one pixel thicker", "different"},
        {"order", "two bodies drawn the other way round", "different"},
        {"equal", "the same drawn again", "equal"},
        {"stray", "a single stray pixel", "equal"},
        {"shift", "all edges 0.1 px elsewhere", "equal"},
        {"noise", "every channel up to 1 off, for the time", "either"}};
    return kinds;
}

Result<Renderer> CreatePlantingRenderer()
{
    return Renderer::Create({.width = kWidth, .height = kHeight});
}

Result<std::vector<PlantedPicture>> PlantChanges(const std::string& scene, Renderer& renderer)
{
    Result<SceneSource> source = OpenScene(scene);
    if (!source)
    {
        return source.GetError();
    }
    SceneLook look;
    look.width = kWidth;
    look.height = kHeight;
    look.labels = true;
    Result<SceneSession> session = SceneSession::Open(std::move(*source), look);
    if (!session)
    {
        return session.GetError();
    }
    session->AdvanceTo(kStep);
    FrameContent content;
    session->Fill(content);
    Result<std::vector<PlantedPicture>> all = Planter(std::move(content), renderer).All();
    if (!all && all.GetError().kind == ErrorKind::Unusable)
    {
        return Error{ErrorKind::Unusable, "Nothing can be changed in '" + scene + "': " +
                                              all.GetError().Text() + "; name another scene."};
    }
    return all;
}

} // namespace bench
