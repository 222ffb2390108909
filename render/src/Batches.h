// SPDX-License-Identifier: MIT
#pragma once

#include "Footprint.h"
#include "ProgramKind.h"

#include <render/Frame.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Collects instances in as few draw calls as painter's order allows. Written by Renderer, read by
/// Canvas. Independent of GL.
namespace boxreel
{

/// One draw call: instances of one kind, in painter's order.
struct Batch
{
    ProgramKind kind = ProgramKind::Box;
    Form form = Form::Quad;
    std::size_t instances = 0;
    std::vector<float> data; ///< the instances' parts and attributes, one after another
};

class Batches
{
public:
    /// Starts a picture of this size [px]; keeps the allocated memory.
    void Clear(int width, int height);

    /// The first vector of an instance: the rectangle of pixels to draw. An empty one draws the
    /// whole instance, by its tightest quad. As a square, the enclosing square around the
    /// rectangle's centre is drawn.
    using Part = std::array<float, 4>;

    /// Adds an instance that touches only pixels within `bounds` (not empty, inside the picture).
    /// It is drawn after all earlier instances whose Footprint shares a tile with its own. The
    /// order of other instances is free.
    void Add(ProgramKind kind, Form form, const PixelBounds& bounds, const Part& part,
             std::span<const float> attributes);

    /// Returns the number of instances added.
    std::size_t Instances() const { return m_instances; }

    std::span<const Batch> All() const { return {m_batches.data(), m_used}; }

private:
    /// A range of tiles in a row, index into m_latest.
    struct Run
    {
        std::size_t begin;
        std::size_t end;
    };
    /// The batch m_first + age - 1; 0: a batch before m_first, or none. One byte, so that more
    /// tiles fit in the cache.
    using Age = std::uint8_t;

    void StartOver(int first);
    void FindTiles(const Footprint& footprint, const PixelBounds& bounds);
    std::size_t Place(ProgramKind kind, Form form);

    std::size_t m_columns = 0;
    std::vector<Run> m_tiles;  // of the current instance
    std::vector<Age> m_latest; // per tile: the last batch that draws into it, relative to m_first
    int m_first = 0;           // first batch that still accepts instances
    std::vector<Batch> m_batches;
    std::size_t m_used = 0;
    std::size_t m_instances = 0;
    std::array<std::vector<int>, kProgramKinds * kForms> m_ofKind; // batches per kind and form,
                                                                   // ascending
};

} // namespace boxreel
