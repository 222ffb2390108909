// SPDX-License-Identifier: MIT
#pragma once

#include "Batches.h"

#include <cstdint>
#include <span>
#include <vector>

/// The shader instances of a draw list's items. Kept from one frame to the next, so that unchanged
/// items are copied instead of built. Written by ShapeBuilder and Renderer.
namespace boxreel
{

/// One quad for the shaders.
struct Instance
{
    PixelBounds bounds; ///< contains every touched pixel; not empty, inside the picture
    ProgramKind kind = ProgramKind::Box;
    std::uint32_t first = 0; ///< index of its first attribute
    std::uint32_t count = 0;
};

class Instances
{
public:
    /// Clears all items; keeps the memory.
    void Clear();

    /// Adds an instance to the current item.
    void Add(ProgramKind kind, const PixelBounds& bounds, std::span<const float> attributes);

    /// Ends the current item, which may have no instances.
    void EndItem() { m_ends.push_back(std::uint32_t(m_instances.size())); }

    /// Copies all instances of an item of another list.
    void CopyItem(const Instances& from, std::size_t item);

    std::size_t Items() const { return m_ends.size(); }
    std::span<const Instance> All() const { return m_instances; }
    std::span<const Instance> OfItem(std::size_t item) const;
    std::span<const float> AttributesOf(const Instance& instance) const
    {
        return {m_attributes.data() + instance.first, instance.count};
    }

private:
    std::vector<Instance> m_instances;
    std::vector<float> m_attributes;
    std::vector<std::uint32_t> m_ends; // per item
};

} // namespace boxreel
