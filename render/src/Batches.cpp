// SPDX-License-Identifier: MIT
#include "Batches.h"

#include <algorithm>
#include <limits>

namespace boxreel
{
namespace
{

// Smaller tiles separate more neighbours, larger ones are fewer to check. A draw call costs as much
// as a few thousand tiles.
constexpr int kTileShift = 1;

// Limit of Age: batches later than this after m_first are indistinguishable.
constexpr int kMaxAge = std::numeric_limits<std::uint8_t>::max();

} // namespace

void Batches::Clear(int width, int height)
{
    m_columns = std::size_t((width - 1) >> kTileShift) + 1;
    m_latest.resize(m_columns * (std::size_t((height - 1) >> kTileShift) + 1));
    for (std::vector<int>& batches : m_ofKind)
    {
        batches.clear();
    }
    m_used = 0;
    m_instances = 0;
}

void Batches::StartOver(int first)
{
    m_first = first;
    std::fill(m_latest.begin(), m_latest.end(), Age(0));
}

void Batches::FindTiles(const Footprint& footprint, const PixelBounds& bounds)
{
    m_tiles.clear();
    for (int row = bounds.y0 >> kTileShift; row <= (bounds.y1 - 1) >> kTileShift; ++row)
    {
        const Footprint::Span span = footprint.Between(row << kTileShift, (row + 1) << kTileShift);
        if (span.x0 < span.x1)
        {
            const std::size_t first = std::size_t(row) * m_columns;
            m_tiles.push_back({first + std::size_t(span.x0 >> kTileShift),
                               first + std::size_t((span.x1 - 1) >> kTileShift) + 1});
        }
    }
}

std::size_t Batches::Place(ProgramKind kind, Form form)
{
    Age latest = 0;
    for (const Run& run : m_tiles)
    {
        for (std::size_t tile = run.begin; tile < run.end; ++tile)
        {
            latest = std::max(latest, m_latest[tile]);
        }
    }
    // The first batch of this kind and form that is drawn after everything below this instance.
    const int minimum = m_first + std::max(int(latest) - 1, 0);
    std::vector<int>& ofKind = m_ofKind[std::size_t(kind) * kForms + std::size_t(form)];
    const auto found = std::lower_bound(ofKind.begin(), ofKind.end(), minimum);
    int batch = found == ofKind.end() ? int(m_used) : *found;
    if (found == ofKind.end())
    {
        ofKind.push_back(batch);
        m_batches.resize(std::max(m_batches.size(), ++m_used));
        m_batches[std::size_t(batch)].kind = kind;
        m_batches[std::size_t(batch)].form = form;
        m_batches[std::size_t(batch)].instances = 0;
        m_batches[std::size_t(batch)].data.clear();
    }
    if (batch - m_first >= kMaxAge)
    {
        StartOver(batch);
    }
    for (const Run& run : m_tiles)
    {
        std::fill(m_latest.data() + run.begin, m_latest.data() + run.end, Age(batch - m_first + 1));
    }
    return std::size_t(batch);
}

void Batches::Add(ProgramKind kind, Form form, const PixelBounds& bounds, const Part& part,
                  std::span<const float> attributes)
{
    if (m_instances == 0)
    {
        StartOver(0);
    }
    FindTiles(Footprint(kind, bounds, attributes), bounds);
    Batch& batch = m_batches[Place(kind, form)];
    batch.data.insert(batch.data.end(), part.begin(), part.end());
    batch.data.insert(batch.data.end(), attributes.begin(), attributes.end());
    ++batch.instances;
    ++m_instances;
}

} // namespace boxreel
