// SPDX-License-Identifier: MIT
#pragma once

#include "RigidFit.h"
#include "Tracks.h"

#include <page/PageWriter.h>

#include <array>
#include <optional>
#include <unordered_map>

/// Frames as bytes. Frames are packed in groups that can be read without each other; forms and
/// styles are those of the whole page. docs/notes/page-format.md describes the bytes, decode.js
/// reads them. Touches no files.
namespace boxreel
{

class PageEncoder
{
public:
    /// `first`: the camera of the first frame, whose scale sets the quantum. `rate`: frames for
    /// each simulated second.
    PageEncoder(const Camera& first, double rate);

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
        VelocityX,
        VelocityY,
        Spin,
        Columns
    };

    /// The state of a body as it goes on from frame to frame.
    struct BodyTrack
    {
        std::uint32_t owner = kNoOwner;
        std::uint32_t form = 0;
        bool hasPlace = false;
        BodyPlace place;
        std::array<std::int64_t, 3> numbers{};    ///< of the place, if it has one
        std::array<Predictor, 3> predictors;      ///< of these
        std::array<std::int64_t, 3> velocities{}; ///< less what the change of place says
    };
    struct NewTrack
    {
        std::uint32_t form = 0;
        std::uint32_t style = 0;
        std::uint32_t owner = kNoOwner;
    };

    void Follow(const DrawList& list, const Camera& camera, std::span<const PageBody> bodies);
    void FollowBodies(std::span<const PageBody> bodies, std::size_t tracksBefore);
    std::optional<BodyPlace> PlaceOfShape(const Track* shape, const PageBody& body) const;
    void PlaceBody(BodyTrack& track, const PageBody& body, const std::optional<BodyPlace>& place,
                   const BodyTrack* before);
    void PutBody(BodyTrack& track);
    NewTrack TrackAt(std::size_t index) const;
    Track Begin(const Run& run, const PageBody* body);
    Track BeginLoose(const Run& run);
    bool Place(Track& track);
    void PlaceTexts(const DrawList& list, const Camera& camera, Track& track) const;
    void PutSequence(std::size_t before);
    void PutStyles(std::span<const std::uint32_t> before);
    std::array<std::int64_t, 3> ViewNumbers(const Camera& camera) const;
    Camera StoredView(const Camera& camera) const;
    void PutView(const Camera& camera);
    void Put(ColumnOf column, Predictor& predictor, std::int64_t number);

    double m_fullScale;
    double m_quantum;
    double m_tolerance;
    double m_rate;
    double m_near; // what moves less in a frame is the same [m]
    FormTable m_forms;
    StyleTable m_styles;
    std::vector<Track> m_tracks;        // of the latest list, in its order
    std::vector<BodyTrack> m_bodies;    // behind them, by number of the body
    std::vector<std::ptrdiff_t> m_from; // of each its index in the frame before; -1: it is new
    std::array<Predictor, 3> m_view;
    std::int64_t m_frames = 0;
    std::string m_sequence; // tracks that begin and end, and their styles
    std::array<Column, Columns> m_columns;
    std::array<std::int64_t, Columns> m_neighbour{}; // the last number of each column
    std::vector<PagePoint> m_points;                 // of a run, scratch
};

} // namespace boxreel
