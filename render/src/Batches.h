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

/// Gathers what is to be drawn into as few draw calls as painter's order allows. Written by
/// Renderer, read by Canvas. Knows no GL.
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
    /// Starts a picture of this size [px]; keeps the memory of the last one.
    void Clear(int width, int height);

    /// The first vector of an instance: the rectangle of pixels to draw of it. An empty one means
    /// all of it, by the quad that lies closest around it. As a square, the one around its middle
    /// is drawn that holds it.
    using Part = std::array<float, 4>;

    /// Adds an instance that touches only pixels within `bounds` (not empty, inside the picture).
    /// It is drawn after everything added before whose Footprint shares a tile with its own; among
    /// strangers the order is free.
    void Add(ProgramKind kind, Form form, const PixelBounds& bounds, const Part& part,
             std::span<const float> attributes);

    /// All that was added.
    std::size_t Instances() const { return m_instances; }

    std::span<const Batch> All() const { return {m_batches.data(), m_used}; }

private:
    /// Tiles of a row, in m_latest.
    struct Run
    {
        std::size_t begin;
        std::size_t end;
    };
    /// The batch m_first + age - 1; 0: one before m_first, or none. Small, so that many tiles fit
    /// into the caches.
    using Age = std::uint8_t;

    void StartOver(int first);
    void FindTiles(const Footprint& footprint, const PixelBounds& bounds);
    std::size_t Place(ProgramKind kind, Form form);

    std::size_t m_columns = 0;
    std::vector<Run> m_tiles;  // of the instance in hand
    std::vector<Age> m_latest; // per tile: the last batch that draws into it, from m_first on
    int m_first = 0;           // nothing more is added to the batches before it
    std::vector<Batch> m_batches;
    std::size_t m_used = 0;
    std::size_t m_instances = 0;
    std::array<std::vector<int>, kProgramKinds * kForms> m_ofKind; // batches of each, ascending
};

} // namespace boxreel
