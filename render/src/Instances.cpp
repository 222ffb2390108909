// SPDX-License-Identifier: MIT
#include "Instances.h"

namespace boxreel
{

void Instances::Clear()
{
    m_instances.clear();
    m_attributes.clear();
    m_ends.clear();
}

void Instances::Add(ProgramKind kind, const PixelBounds& bounds, std::span<const float> attributes)
{
    m_instances.push_back(
        {bounds, kind, std::uint32_t(m_attributes.size()), std::uint32_t(attributes.size())});
    m_attributes.insert(m_attributes.end(), attributes.begin(), attributes.end());
}

void Instances::CopyItem(const Instances& from, std::size_t item)
{
    for (const Instance& instance : from.OfItem(item))
    {
        Add(instance.kind, instance.bounds, from.AttributesOf(instance));
    }
    EndItem();
}

std::span<const Instance> Instances::OfItem(std::size_t item) const
{
    const std::size_t begin = item == 0 ? 0 : m_ends[item - 1];
    return {m_instances.data() + begin, m_ends[item] - begin};
}

} // namespace boxreel
