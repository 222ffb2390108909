// SPDX-License-Identifier: MIT
#pragma once

#include "Batches.h"

#include <cstdint>
#include <span>
#include <vector>

/// What the items of a draw list are to the shaders, kept from one frame to the next so that an
/// item that has not changed is copied instead of built. Written by ShapeBuilder and Renderer.
namespace boxreel
{

/// One quad for the shaders.
struct Instance
{
    PixelBounds bounds; ///< holds every pixel that it touches; not empty, inside the picture
    ProgramKind kind = ProgramKind::Box;
    std::uint32_t first = 0; ///< of its attributes
    std::uint32_t count = 0;
};

class Instances
{
public:
    /// Keeps the memory.
    void Clear();

    /// Adds to the item in hand.
    void Add(ProgramKind kind, const PixelBounds& bounds, std::span<const float> attributes);

    /// The item in hand is complete, with as many instances as have been added, or none.
    void EndItem() { m_ends.push_back(std::uint32_t(m_instances.size())); }

    /// A whole item, equal to one of another list's.
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
