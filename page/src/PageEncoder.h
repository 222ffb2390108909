// SPDX-License-Identifier: MIT
#pragma once

#include "RigidFit.h"
#include "Tracks.h"

#include <page/PageWriter.h>

#include <array>
#include <unordered_map>

/// Frames as bytes. Frames are packed in groups that can be read without each other; forms and
/// styles are those of the whole page. docs/notes/page-format.md describes the bytes, decode.js
/// reads them. Touches no files.
namespace boxreel
{

class PageEncoder
{
public:
    /// `first`: the camera of the first frame, whose scale sets the quantum.
    explicit PageEncoder(const Camera& first);

    /// Whether the view is near enough to the origin, at its scale, to be stored.
    bool CanHold(const Camera& camera) const;

    /// Only for a camera that it can hold.
    void Add(const DrawList& list, const Camera& camera, std::span<const PageBody> bodies);

    /// The group has as many frames or bytes as it should.
    bool IsGroupFull() const;
    /// Returns the bytes of the group and begins the next one.
    std::string TakeGroup();
    std::int64_t FramesInGroup() const { return m_frames; }

    const FormTable& Forms() const { return m_forms; }
    const StyleTable& Styles() const { return m_styles; }
    double Quantum() const { return m_quantum; }     ///< [m]
    double FullScale() const { return m_fullScale; } ///< largest zoom [px/m]

private:
    enum ColumnOf
    {
        RigidX,
        RigidY,
        RigidAngle,
        LooseX,
        LooseY,
        View,
        Columns
    };

    void Follow(const DrawList& list, std::span<const PageBody> bodies);
    Track Begin(const Run& run, const PageBody* body);
    Track BeginLoose(const Run& run);
    bool Place(Track& track);
    void PutSequence(std::size_t before);
    void PutStyles(std::span<const std::uint32_t> before);
    void PutView(const Camera& camera);
    void Put(ColumnOf column, Predictor& predictor, std::int64_t number);

    double m_fullScale;
    double m_quantum;
    double m_tolerance;
    double m_near; // what moves less in a frame is the same [m]
    FormTable m_forms;
    StyleTable m_styles;
    std::vector<Track> m_tracks;        // of the latest list, in its order
    std::vector<std::ptrdiff_t> m_from; // of each its index in the list before; -1: it is new
    std::array<Predictor, 3> m_view;
    std::int64_t m_frames = 0;
    std::string m_sequence; // tracks that begin and end, and their styles
    std::array<Column, Columns> m_columns;
    std::array<std::int64_t, Columns> m_neighbour{}; // the last number of each column
    std::vector<PagePoint> m_points;                 // of a run, scratch
};

} // namespace boxreel
