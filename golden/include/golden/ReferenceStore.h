// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>
#include <golden/Compare.h>
#include <golden/ContactSheet.h>
#include <golden/WorldState.h>
#include <render/Frame.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// @file
/// The folder of what was approved, at three depths: the state (state/NAME.txt, and the steps on
/// the way to it, trace/NAME.txt), what was drawn (drawlist/NAME.txt) and the picture
/// (frames/NAME.png, or `frames/NAME@RENDERER.png` where a renderer has one of its own; for a film
/// sheet/NAME.txt says which moments it shows). Long texts are packed (.txt.gz). Verify compares in
/// that order, so that a failure says whether the motion, the geometry or only the pixels changed.
namespace boxreel
{

/// One moment of a scene. `name` is a relative path such as "pyramid/2s"; it cannot leave the
/// folder.
struct GoldenCandidate
{
    std::string name;      ///< of the reference
    std::string stateHash; ///< 16 hex digits; empty: depth not used
    DrawList list;         ///< what is drawn; empty: depth not used
    Frame frame;           ///< the picture; empty: depth not used
    WorldState state = {}; ///< with a hash only: what differs, and by how much; no bodies: not kept
    StateTrace trace = {}; ///< the steps since the moment before; none: not kept
    std::string renderer = {};             ///< Renderer::Description(); empty: one picture for all
    std::string fingerprint = {};          ///< Renderer::Fingerprint(); empty: not known
    std::optional<Camera> camera = {};     ///< with which it is drawn; needed to leave out bodies
    std::optional<SheetLayout> sheet = {}; ///< of a film's contact sheet; kept, so that other
                                           ///< moments of the film are told as such
};

/// Whether a reference may have the name: parts of letters between slashes, none empty or beginning
/// with a dot. An Error (Unusable) says what is wrong.
Result<void> CheckReferenceName(const std::string& name);

/// Of a film.
GoldenCandidate CandidateOf(ContactSheet sheet, std::string name);

/// Which picture becomes the reference.
enum class AcceptAs
{
    TheOneCompared,  ///< this renderer's own where it has one, else the one for all
    ForThisRenderer, ///< one that only candidates of the same `renderer` are compared with
};

/// How a comparison ended.
enum class GoldenStatus
{
    Same,
    Missing,     ///< no reference: fails, the candidate is written to the output folder
    State,       ///< the worlds differ
    DrawList,    ///< same world, other geometry
    Pixels,      ///< same geometry, other pixels
    NotCompared, ///< fails: the reference is damaged, or bodies that are to be left out cannot be
};

/// Why the limits of a comparison hold.
enum class LimitsChoice
{
    AsGiven,       ///< the settings do not adapt, or nobody knows which renderer drew a picture
    SameRenderer,  ///< both pictures have the same fingerprint: as given, too
    OtherRenderer, ///< the fingerprints differ: those of CompareSettings::CrossMachine
};

/// Where two texts part, line by line. Without either line, the texts differ by the newline at
/// their end alone.
struct LineDifference
{
    std::size_t line = 0;                ///< counted from 1
    std::optional<std::string> expected; ///< none: the expected text ends before this line
    std::optional<std::string> actual;   ///< none: the actual text ends before this line
    std::size_t expectedLines = 0;       ///< in the whole text
    std::size_t actualLines = 0;
};

/// How the worlds of two moments differ.
struct WorldDifference
{
    std::string expected;                    ///< hash of the state, 16 hex digits
    std::string actual;                      ///< hash of the state, 16 hex digits
    std::optional<TraceDifference> onTheWay; ///< the first step that differs, where steps are kept
    std::optional<StateDifference> now;      ///< at the moment, where the bodies are kept
};

/// How two films are compared, by their contact sheets.
struct FilmComparison
{
    std::string expectedMoments;           ///< first line of the sheet's text
    std::string actualMoments;             ///< first line of the sheet's text
    SheetLayout expected;                  ///< of the reference
    SheetLayout actual;                    ///< of the candidate
    std::optional<std::int64_t> firstStep; ///< of the first picture that differs by itself

    /// Whether the pictures show other moments, and are not compared one by one.
    bool HasOtherMoments() const { return expectedMoments != actualMoments; }
};

/// What is not there of GoldenStatus::Missing.
enum class GoldenAbsence
{
    Nothing,    ///< all is there
    All,        ///< there is no reference
    Part,       ///< some of its files; the others are the same
    OwnPicture, ///< a picture of this renderer alone
};

/// The depths of a moment.
struct GoldenDepths
{
    bool state = false; ///< of the world
    bool list = false;  ///< the draw list
    bool frame = false; ///< the picture
};

/// What comparing one candidate has found.
struct GoldenVerdict
{
    std::string name;                               ///< of the reference
    GoldenStatus status = GoldenStatus::Missing;    ///< how it ended
    GoldenDepths compared = {};                     ///< what there was to compare with
    std::optional<WorldDifference> world = {};      ///< none: the worlds do not differ
    std::optional<LineDifference> list = {};        ///< none: the draw lists do not differ
    std::optional<FilmComparison> film = {};        ///< none: not of a film
    std::string references = {};                    ///< the approved folder
    std::vector<std::string> missing = {};          ///< files that are not there
    GoldenAbsence absence = GoldenAbsence::Nothing; ///< what there is not
    Error problem = {};                             ///< of GoldenStatus::NotCompared: why
    std::vector<std::string> look = {};             ///< the files of a failure to look at first
    std::string accept = {}; ///< what a person runs where there is nothing to compare with; empty:
                             ///< there is, or accepting would not help
    Comparison pixels;       ///< what comparing the pictures has found
    LimitsChoice limits = LimitsChoice::AsGiven; ///< why those of the pictures hold
    std::optional<Error> warning = {};           ///< of what passed: why no file says so

    /// For a person: what differs, or was compared, the worst first.
    std::vector<std::string> Findings() const;
    /// For a person: name, findings, files, and what to do if the change is right. `remedy`
    /// replaces the command to accept; lower case, no full stop.
    std::string Text(const std::string& remedy = "") const;
};

/// A folder of what was approved.
class ReferenceStore
{
public:
    /// `references`: the approved folder; `output`: where failures leave NAME.expected.png,
    /// NAME.actual.png, NAME.difference.png, NAME.side-by-side.png, the two draw lists and states,
    /// and every comparison NAME.verdict.json, of which `boxreel golden report` makes a page.
    ReferenceStore(std::filesystem::path references, std::filesystem::path output);

    /// Compares the candidate with its reference, and leaves files of what differs. An Error only
    /// when the name is not usable or a file of a failure cannot be written; a difference is a
    /// verdict, and so is a reference that cannot be read.
    Result<GoldenVerdict> Verify(const GoldenCandidate& candidate,
                                 const CompareSettings& settings = {}) const;

    /// Compares as Verify does, and leaves no file. An Error only when the name is not usable.
    Result<GoldenVerdict> Judge(const GoldenCandidate& candidate,
                                const CompareSettings& settings = {}) const;

    /// Makes the candidate the reference, whatever there was. Files are written whole or not at
    /// all. Unusable for a renderer alone when the candidate does not say which.
    Result<void> Accept(const GoldenCandidate& candidate,
                        AcceptAs as = AcceptAs::TheOneCompared) const;

    /// Whether this renderer (a Description()) has a picture of its own under the name.
    bool HasOwnPicture(const std::string& name, const std::string& renderer) const;

    /// Names that have a reference, sorted.
    std::vector<std::string> Names() const;

private:
    std::filesystem::path m_references;
    std::filesystem::path m_output;
};

} // namespace boxreel
