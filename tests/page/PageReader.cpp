// SPDX-License-Identifier: MIT
#include "PageReader.h"
#include "Base64.h"

#include <base/Gzip.h>
#include <base/ReadWhole.h>
#include <page/PageWriter.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace boxreel::test
{
namespace
{

std::string Unpacked(std::string_view base64)
{
    const Result<std::string> bytes = Gunzip("page", FromBase64(base64), std::size_t(1) << 30);
    EXPECT_TRUE(bytes);
    return bytes ? *bytes : "";
}

std::int64_t FromZigzag(std::uint64_t number)
{
    return std::int64_t(number >> 1) ^ -std::int64_t(number & 1);
}

struct Bytes
{
    std::string text;
    std::size_t at = 0;

    std::uint8_t Byte() { return std::uint8_t(text.at(at++)); }
    std::uint64_t Varint()
    {
        std::uint64_t number = 0;
        for (int shift = 0;; shift += 7)
        {
            const std::uint8_t byte = Byte();
            number |= std::uint64_t(byte & 127) << shift;
            if (byte < 128)
            {
                return number;
            }
        }
    }
    std::int64_t Signed() { return FromZigzag(Varint()); }
    float Float()
    {
        std::uint32_t bits = 0;
        for (int shift = 0; shift < 32; shift += 8)
        {
            bits |= std::uint32_t(Byte()) << shift;
        }
        return std::bit_cast<float>(bits);
    }
    std::string Part()
    {
        const std::size_t length = Varint();
        at += length;
        return text.substr(at - length, length);
    }
};

struct History
{
    std::int64_t last[3] = {}; // the latest first
    int count = 0;
    std::int64_t errors[3] = {};

    std::int64_t Rule(int rule) const
    {
        const auto& [a, b, c] = last;
        return rule == 0 ? a : rule == 1 ? 2 * a - b : 3 * a - 3 * b + c;
    }
    std::int64_t Guess() const
    {
        int best = 0;
        for (int rule = 1; rule < count; ++rule)
        {
            best = errors[rule] < errors[best] ? rule : best;
        }
        return Rule(best);
    }
    void Add(std::int64_t number)
    {
        for (int rule = 0; rule < count; ++rule)
        {
            errors[rule] += std::abs(number - Rule(rule)) - errors[rule] / 4;
        }
        last[2] = last[1];
        last[1] = last[0];
        last[0] = number;
        count = std::min(count + 1, 3);
    }
};

struct Column
{
    Bytes small;
    Bytes large;
    std::int64_t last = 0;

    std::int64_t Next(History& history)
    {
        last = (history.count == 0 ? last : history.Guess()) + Difference();
        history.Add(last);
        return last;
    }
    std::int64_t Difference()
    {
        std::uint64_t number = small.Byte();
        if (number >= 0xf8)
        {
            const int count = int(number) - 0xf8 + 1;
            number = 0;
            for (int i = 0; i < count; ++i)
            {
                number |= std::uint64_t(large.Byte()) << 8 * i;
            }
        }
        return FromZigzag(number);
    }
};

struct Form
{
    bool isBody = false;
    bool hasPlace = false;
    bool isRigid = false;
    bool hasOrigin = false;
    std::vector<PageItem> items;     // their points are the form's
    std::vector<std::size_t> counts; // of points
    std::vector<double> points;
    double originX = 0.0;
    double originY = 0.0;
    double angleUnit = 1.0;
    std::size_t numbers = 0;
};

struct Track
{
    std::size_t form = 0;
    std::size_t style = 0;
    std::uint32_t owner = kNoOwner;
    std::vector<History> histories;
    std::optional<PageOrigin> before; // place of the body in the frame before of the group
};

class Reader
{
public:
    explicit Reader(const nlohmann::json& head) : m_head(head), m_quantum(head["quantum"])
    {
        Bytes bytes{Unpacked(head["forms"].get<std::string>())};
        while (bytes.at < bytes.text.size())
        {
            m_forms.push_back(ReadForm(bytes));
        }
    }
    std::size_t FormCount() const { return m_forms.size(); }
    void ReadGroup(const std::string& bytes, std::vector<PageFrame>& frames);

private:
    Form ReadForm(Bytes& bytes) const;
    void ReadSequence(Bytes& sequence);
    void Place(const Track& track, const std::vector<std::int64_t>& numbers,
               PageFrame& frame) const;
    void ReadState(Track& track, const std::vector<std::int64_t>& numbers, Column* velocities,
                   PageFrame& frame) const;

    const nlohmann::json& m_head;
    double m_quantum;
    std::vector<Form> m_forms;
    std::vector<Track> m_tracks;
};

Form Reader::ReadForm(Bytes& bytes) const
{
    Form form;
    const std::uint64_t type = bytes.Varint();
    form.isRigid = type == 1 || type == 2;
    form.isBody = type > 2;
    form.hasPlace = type == 4;
    form.hasOrigin = type == 2;
    std::size_t points = 0;
    for (std::uint64_t left = bytes.Varint(); left > 0; --left)
    {
        PageItem item;
        item.kind = DrawKind(bytes.Varint());
        form.counts.push_back(bytes.Varint());
        item.size = bytes.Float();
        item.text = item.kind == DrawKind::Text ? m_head["texts"][bytes.Varint()] : "";
        form.items.push_back(item);
        points += form.counts.back();
    }
    form.numbers = form.isBody ? (form.hasPlace ? 3 : 0) : form.isRigid ? 3 : 2 * points;
    if (!form.isRigid)
    {
        return form;
    }
    const double unit = m_quantum / 16;
    double farthest = 0.0;
    for (std::size_t i = 0; i < points; ++i)
    {
        const double x = double(bytes.Signed()) * unit;
        const double y = double(bytes.Signed()) * unit;
        form.points.insert(form.points.end(), {x, y});
        farthest = std::max(farthest, x * x + y * y);
    }
    if (form.hasOrigin)
    {
        form.originX = double(bytes.Signed()) * unit;
        form.originY = double(bytes.Signed()) * unit;
    }
    form.angleUnit = farthest > 0.0 ? m_quantum / std::sqrt(farthest) : 1.0;
    return form;
}

void Reader::ReadSequence(Bytes& sequence)
{
    std::vector<Track> tracks;
    std::size_t old = 0;
    for (std::uint64_t turns = sequence.Varint(); turns > 0; --turns)
    {
        for (std::uint64_t kept = sequence.Varint(); kept > 0; --kept)
        {
            tracks.push_back(std::move(m_tracks.at(old++)));
        }
        old += sequence.Varint();
        for (std::uint64_t begun = sequence.Varint(); begun > 0; --begun)
        {
            Track track;
            track.form = sequence.Varint();
            track.style = sequence.Varint();
            track.owner = std::uint32_t(sequence.Varint() - 1);
            track.histories.resize(m_forms.at(track.form).numbers);
            tracks.push_back(std::move(track));
        }
    }
    std::move(m_tracks.begin() + std::ptrdiff_t(old), m_tracks.end(), std::back_inserter(tracks));
    m_tracks = std::move(tracks);
    std::size_t at = 0;
    for (std::uint64_t changes = sequence.Varint(); changes > 0; --changes)
    {
        at += sequence.Varint();
        m_tracks.at(at).style = sequence.Varint();
    }
}

void Reader::Place(const Track& track, const std::vector<std::int64_t>& numbers,
                   PageFrame& frame) const
{
    const Form& form = m_forms[track.form];
    const double x = double(numbers[0]) * m_quantum;
    const double y = double(numbers[1]) * m_quantum;
    const double angle = form.isRigid ? double(numbers[2]) * form.angleUnit : 0.0;
    const auto placed = [&](double localX, double localY) {
        return std::pair(x + std::cos(angle) * localX - std::sin(angle) * localY,
                         y + std::sin(angle) * localX + std::cos(angle) * localY);
    };
    if (form.hasOrigin)
    {
        const auto [originX, originY] = placed(form.originX, form.originY);
        frame.origins.push_back({track.owner, originX, originY, angle});
    }
    std::size_t at = 0;
    for (std::size_t i = 0; i < form.items.size(); ++i)
    {
        PageItem item = form.items[i];
        item.layer = m_head["styles"][track.style];
        item.stroke = m_head["themes"][0]["strokes"][track.style];
        item.owner = track.owner;
        for (std::size_t k = 0; k < form.counts[i]; ++k, at += 2)
        {
            const auto [px, py] = form.isRigid ? placed(form.points[at], form.points[at + 1])
                                               : std::pair(double(numbers[at]) * m_quantum,
                                                           double(numbers[at + 1]) * m_quantum);
            item.points.insert(item.points.end(), {px, py});
        }
        const bool hasAnchors = item.layer == int(DrawLayer::JointGlyphs) &&
                                item.kind != DrawKind::Circle && item.kind != DrawKind::Point;
        if (hasAnchors)
        {
            const auto half = item.points.begin() + std::ptrdiff_t(item.points.size() / 2);
            item.anchors.assign(half, item.points.end());
            item.points.erase(half, item.points.end());
        }
        frame.items.push_back(std::move(item));
    }
}

void Reader::ReadState(Track& track, const std::vector<std::int64_t>& numbers, Column* velocities,
                       PageFrame& frame) const
{
    PageOrigin place{track.owner};
    if (m_forms[track.form].hasPlace)
    {
        place = {track.owner, double(numbers[0]) * m_quantum, double(numbers[1]) * m_quantum,
                 double(numbers[2]) * 0.0001};
    }
    else
    {
        const auto origin =
            std::find_if(frame.origins.begin(), frame.origins.end(),
                         [&](const PageOrigin& known) { return known.owner == track.owner; });
        ASSERT_NE(origin, frame.origins.end()) << "body " << track.owner << " has no place";
        place = *origin;
    }
    const PageOrigin before = track.before.value_or(place);
    const double rate = m_head["framesPerSecond"].get<double>() / m_head["speed"].get<double>();
    const auto velocity = [&](Column& column, double now, double then) {
        return double(column.Difference()) * 0.02 + (now - then) * rate;
    };
    const double x = velocity(velocities[0], place.x, before.x);
    const double y = velocity(velocities[1], place.y, before.y);
    const double spin = velocity(velocities[2], place.angle, before.angle);
    frame.states.push_back({place, x, y, spin});
    track.before = place;
}

void Reader::ReadGroup(const std::string& text, std::vector<PageFrame>& frames)
{
    Bytes bytes{text};
    const std::uint64_t count = bytes.Varint();
    Bytes sequence{bytes.Part()};
    Column columns[9];
    for (Column& column : columns)
    {
        column.small.text = bytes.Part();
        column.large.text = bytes.Part();
    }
    EXPECT_EQ(bytes.at, text.size());
    History view[3];
    m_tracks.clear();
    for (std::uint64_t i = 0; i < count; ++i)
    {
        PageFrame& frame = frames.emplace_back();
        ReadSequence(sequence);
        for (int k = 0; k < 3; ++k)
        {
            (k == 0   ? frame.viewX
             : k == 1 ? frame.viewY
                      : frame.viewHeight) = double(columns[5].Next(view[k])) * m_quantum / 16;
        }
        for (Track& track : m_tracks)
        {
            const bool isRigid = m_forms[track.form].isRigid || m_forms[track.form].isBody;
            std::vector<std::int64_t> numbers;
            for (std::size_t k = 0; k < track.histories.size(); ++k)
            {
                numbers.push_back(columns[isRigid ? k : 3 + k % 2].Next(track.histories[k]));
            }
            if (m_forms[track.form].isBody)
            {
                ReadState(track, numbers, &columns[6], frame);
                continue;
            }
            Place(track, numbers, frame);
        }
    }
}

/// What stands between two texts, from `at` on, which moves behind it.
std::string_view Between(std::string_view text, std::string_view begin, std::string_view end,
                         std::size_t& at)
{
    const std::size_t first = text.find(begin, at);
    if (first == std::string_view::npos)
    {
        return {};
    }
    const std::size_t last = text.find(end, first + begin.size());
    at = last;
    return text.substr(first + begin.size(), last - first - begin.size());
}

} // namespace

ReadPage ReadPageFile(const std::filesystem::path& path)
{
    ReadPage page;
    const Result<std::string> html = ReadWhole(path, std::uintmax_t(1) << 30);
    EXPECT_TRUE(html);
    if (!html)
    {
        return page;
    }
    page.html = *html;
    std::size_t at = 0;
    const std::string_view headText =
        Between(page.html, "<script type=\"application/json\" id=\"head\">", "</script>", at);
    const nlohmann::json head = nlohmann::json::parse(headText, nullptr, false);
    if (head.is_discarded())
    {
        ADD_FAILURE() << "the head is not JSON";
        return page;
    }
    page.fullScale = head["fullScale"];
    page.firstTime = head["firstTime"];
    Reader reader(head);
    page.forms = reader.FormCount();
    for (at = 0;;)
    {
        const std::string_view group =
            Between(page.html, "class=\"frames\" data-frames=\"", "<", at);
        if (group.empty())
        {
            break;
        }
        const std::size_t before = page.frames.size();
        reader.ReadGroup(Unpacked(group.substr(group.find('>') + 1)), page.frames);
        EXPECT_EQ(std::to_string(page.frames.size() - before), group.substr(0, group.find('"')));
    }
    EXPECT_EQ(page.frames.size(), head["frames"].get<std::size_t>());
    return page;
}

std::vector<PageItem> ItemsOf(const DrawList& list)
{
    std::vector<PageItem> items;
    for (const DrawItem& given : list.items)
    {
        PageItem item{given.kind, int(given.layer), given.owner, given.size};
        item.text = given.kind == DrawKind::Text ? list.texts[given.text] : "";
        for (std::size_t i = 0; i < given.count; ++i)
        {
            const Vec2 p = list.points[given.first + i];
            item.points.insert(item.points.end(), {double(p.x), double(p.y)});
        }
        if (given.kind == DrawKind::SolidCircle || given.kind == DrawKind::Transform)
        {
            item.points[2] = item.points[0] + double(given.size) * item.points[2];
            item.points[3] = item.points[1] + double(given.size) * item.points[3];
        }
        items.push_back(std::move(item));
    }
    return items;
}

void ExpectSameItems(const PageFrame& frame, const DrawList& list, double fullScale)
{
    const std::vector<PageItem> expected = ItemsOf(list);
    ASSERT_EQ(frame.items.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
        const PageItem& a = frame.items[i];
        const PageItem& b = expected[i];
        ASSERT_EQ(std::tie(a.kind, a.layer, a.owner, a.size, a.text),
                  std::tie(b.kind, b.layer, b.owner, b.size, b.text))
            << "item " << i;
        ASSERT_EQ(a.points.size(), b.points.size());
        for (std::size_t k = 0; k < b.points.size(); ++k)
        {
            ASSERT_LE(std::abs(a.points[k] - b.points[k]) * fullScale, kPagePixelError)
                << "item " << i << ", number " << k << ", at " << b.points[k];
        }
    }
}

} // namespace boxreel::test
