// SPDX-License-Identifier: MIT
#include "Forms.h"

#include "Predictor.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace boxreel
{
namespace
{

// The points of a form are stored this much finer than places, so that rounding does not add up.
constexpr double kFormSteps = 16.0;

void PutSigned(std::string& bytes, std::int64_t number)
{
    PutVarint(bytes, (std::uint64_t(number) << 1) ^ std::uint64_t(number >> 63));
}

void PutFloat(std::string& bytes, float number)
{
    const auto bits = std::bit_cast<std::uint32_t>(number);
    for (int shift = 0; shift < 32; shift += 8)
    {
        bytes += char(bits >> shift);
    }
}

PagePoint Turned(PagePoint p, double angle)
{
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * p.x - s * p.y, s * p.x + c * p.y};
}

} // namespace

void ReadPoints(const DrawList& list, const ItemRun& run, std::vector<PagePoint>& points)
{
    points.clear();
    for (const DrawItem& item : std::span(list.items).subspan(run.first, run.count))
    {
        const Vec2* const given = list.points.data() + item.first;
        const bool hasAxis = item.kind == DrawKind::SolidCircle || item.kind == DrawKind::Transform;
        for (std::size_t i = 0; i < item.count; ++i)
        {
            points.push_back({given[i].x, given[i].y});
        }
        if (hasAxis && item.count == 2)
        {
            const double size = item.size;
            points.back() = {double(given[0].x) + size * double(given[1].x),
                             double(given[0].y) + size * double(given[1].y)};
        }
    }
}

std::string FormTable::Signature(const DrawList& list, const ItemRun& run)
{
    std::string bytes;
    PutVarint(bytes, run.count);
    for (const DrawItem& item : std::span(list.items).subspan(run.first, run.count))
    {
        PutVarint(bytes, std::uint64_t(item.kind));
        PutVarint(bytes, item.count);
        PutFloat(bytes, item.size);
        if (item.kind == DrawKind::Text)
        {
            const std::string& text = list.texts[item.text];
            const auto [known, isNew] =
                m_textNumbers.try_emplace(text, std::uint32_t(m_texts.size()));
            if (isNew)
            {
                m_texts.push_back(text);
            }
            PutVarint(bytes, known->second);
        }
    }
    return bytes;
}

std::uint32_t FormTable::Add(const std::string& bytes)
{
    const auto [known, isNew] = m_known.try_emplace(bytes, m_count);
    if (isNew)
    {
        m_bytes += bytes;
        ++m_count;
    }
    return known->second;
}

std::uint32_t FormTable::AddLoose(const std::string& signature)
{
    return Add('\0' + signature);
}

/// Appends the point and returns it as it will be read.
PagePoint FormTable::PutPoint(PagePoint point, std::string& bytes) const
{
    const double unit = m_quantum / kFormSteps;
    const auto x = std::llround(point.x / unit);
    const auto y = std::llround(point.y / unit);
    PutSigned(bytes, x);
    PutSigned(bytes, y);
    return {double(x) * unit, double(y) * unit};
}

std::uint32_t FormTable::AddBody(bool hasPlace)
{
    std::string bytes(1, hasPlace ? '\4' : '\3');
    PutVarint(bytes, 0); // items
    return Add(bytes);
}

std::uint32_t FormTable::AddRigid(const std::string& signature, std::span<const PagePoint> points,
                                  double angle, const std::optional<PagePoint>& origin)
{
    PagePoint centre;
    for (const PagePoint p : points)
    {
        centre.x += p.x / double(points.size());
        centre.y += p.y / double(points.size());
    }
    const auto local = [&](PagePoint p) {
        return Turned({p.x - centre.x, p.y - centre.y}, -angle);
    };
    std::string bytes(1, origin ? '\2' : '\1');
    bytes += signature;
    RigidForm rigid;
    double farthest = 0.0; // squared [m^2]
    for (const PagePoint p : points)
    {
        rigid.points.push_back(PutPoint(local(p), bytes));
        const PagePoint& stored = rigid.points.back();
        farthest = std::max(farthest, stored.x * stored.x + stored.y * stored.y);
    }
    if (origin)
    {
        rigid.origin = PutPoint(local(*origin), bytes);
    }
    rigid.angleUnit = farthest > 0.0 ? m_quantum / std::sqrt(farthest) : 1.0;
    const std::uint32_t form = Add(bytes);
    m_rigid.try_emplace(form, std::move(rigid));
    return form;
}

} // namespace boxreel
