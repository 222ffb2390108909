// SPDX-License-Identifier: MIT
#include "Batches.h"

#include <algorithm>

namespace boxreel
{
namespace
{

// Smaller tiles tell more neighbours apart, larger ones are fewer to look at; a shape of usual size
// touches one to four of these.
constexpr int kTileShift = 5;

} // namespace

void Batches::Clear(int width, int height)
{
    m_columns = ((width - 1) >> kTileShift) + 1;
    const int rows = ((height - 1) >> kTileShift) + 1;
    m_latest.assign(std::size_t(m_columns) * std::size_t(rows), -1);
    for (std::vector<int>& batches : m_ofKind)
    {
        batches.clear();
    }
    m_used = 0;
    m_instances = 0;
}

std::size_t Batches::Place(ProgramKind kind, const PixelBounds& bounds)
{
    const int column0 = bounds.x0 >> kTileShift;
    const int column1 = (bounds.x1 - 1) >> kTileShift;
    const int row0 = bounds.y0 >> kTileShift;
    const int row1 = (bounds.y1 - 1) >> kTileShift;

    // The batches that are executed after all that this instance covers, and the first such of its
    // kind.
    int latest = -1;
    for (int row = row0; row <= row1; ++row)
    {
        const int* const tiles = m_latest.data() + row * m_columns;
        latest = std::max(latest, *std::max_element(tiles + column0, tiles + column1 + 1));
    }
    std::vector<int>& ofKind = m_ofKind[std::size_t(kind)];
    const auto found = std::lower_bound(ofKind.begin(), ofKind.end(), latest);
    int batch = found == ofKind.end() ? int(m_used) : *found;
    if (found == ofKind.end())
    {
        ofKind.push_back(batch);
        m_batches.resize(std::max(m_batches.size(), ++m_used));
        m_batches[std::size_t(batch)].kind = kind;
        m_batches[std::size_t(batch)].instances = 0;
        m_batches[std::size_t(batch)].data.clear();
    }
    for (int row = row0; row <= row1; ++row)
    {
        int* const tiles = m_latest.data() + row * m_columns;
        std::fill(tiles + column0, tiles + column1 + 1, batch);
    }
    return std::size_t(batch);
}

void Batches::Add(ProgramKind kind, const PixelBounds& bounds, const Part& part,
                  std::span<const float> attributes)
{
    Batch& batch = m_batches[Place(kind, bounds)];
    batch.data.insert(batch.data.end(), part.begin(), part.end());
    batch.data.insert(batch.data.end(), attributes.begin(), attributes.end());
    ++batch.instances;
    ++m_instances;
}

} // namespace boxreel
