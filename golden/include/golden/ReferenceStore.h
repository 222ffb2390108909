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
/// The folder of references, at three depths: the state (state/NAME.txt, and the steps before it,
/// trace/NAME.txt), the draw list (drawlist/NAME.txt) and the picture (frames/NAME.png). A renderer
/// may have its own picture, `frames/NAME@RENDERER.png`; for a film, sheet/NAME.txt lists the
/// moments. Long texts are compressed (.txt.gz). Verify compares in that order, so that a failure
/// states whether the motion, the geometry or only the pixels changed.
namespace boxreel
{

/// One moment of a scene. `name` is a relative path such as "pyramid/2s"; it cannot leave the
/// folder.
struct GoldenCandidate
{
    std::string name;      ///< name of the reference
    std::string stateHash; ///< 16 hex digits; empty: depth not used
    DrawList list;         ///< empty: depth not used
    Frame frame;           ///< empty: depth not used
    WorldState state = {}; ///< only with a hash: for the size of differences; no bodies: not stored
    StateTrace trace = {}; ///< the steps since the previous moment; empty: not stored
    std::string renderer = {};             ///< Renderer::Description(); empty: one picture for all
                                           ///< renderers
    std::string fingerprint = {};          ///< Renderer::Fingerprint(); empty: unknown
    std::optional<Camera> camera = {};     ///< camera of the picture; required to ignore bodies
    std::optional<SheetLayout> sheet = {}; ///< of a film's contact sheet; stored to detect other
                                           ///< moments of the film
};

/// Checks that a reference may have the name: parts separated by slashes, none empty or starting
/// with a dot. An Error (Unusable) states the reason.
Result<void> CheckReferenceName(const std::string& name);

/// Returns the candidate of a film.
GoldenCandidate CandidateOf(ContactSheet sheet, std::string name);

/// The picture to replace.
enum class AcceptAs
{
    TheOneCompared,  ///< the renderer's own picture if it exists, otherwise the common one
    ForThisRenderer, ///< a picture for candidates of the same `renderer` only
};

/// The result of a comparison.
enum class GoldenStatus
{
    Same,
    Missing,     ///< no reference: fails, and the candidate is written to the output folder
    State,       ///< the states differ
    DrawList,    ///< equal states, different draw lists
    Pixels,      ///< equal draw lists, different pixels
    NotCompared, ///< fails: the reference is damaged, or bodies cannot be ignored
};

/// The reason for the limits of a comparison.
enum class LimitsChoice
{
    AsGiven,       ///< the settings do not adapt, or a renderer is unknown
    SameRenderer,  ///< both pictures have the same fingerprint: limits as given
    OtherRenderer, ///< the fingerprints differ: limits of CompareSettings::CrossMachine
};

/// The first difference of two texts, line by line. If neither line is set, the texts differ only
/// in the newline at their end.
struct LineDifference
{
    std::size_t line = 0;                ///< counted from 1
    std::optional<std::string> expected; ///< none: the expected text ends before this line
    std::optional<std::string> actual;   ///< none: the actual text ends before this line
    std::size_t expectedLines = 0;       ///< in the whole text
    std::size_t actualLines = 0;         ///< in the whole text
};

/// The difference of two worlds at one moment.
struct WorldDifference
{
    std::string expected;                   ///< hash of the state, 16 hex digits
    std::string actual;                     ///< hash of the state, 16 hex digits
    std::optional<TraceDifference> inTrace; ///< the first step that differs, where steps are kept
    std::optional<StateDifference> now;     ///< at the moment, where the bodies are kept
};

/// A comparison of two films by their contact sheets.
struct FilmComparison
{
    std::string expectedMoments;           ///< first line of the sheet's text
    std::string actualMoments;             ///< first line of the sheet's text
    SheetLayout expected;                  ///< of the reference
    SheetLayout actual;                    ///< of the candidate
    std::optional<std::int64_t> firstStep; ///< of the first picture that differs by itself

    /// True if the two sheets show different moments. Their pictures are then not compared one by
    /// one.
    bool HasOtherMoments() const { return expectedMoments != actualMoments; }
};

/// The missing part of a reference, for GoldenStatus::Missing.
enum class GoldenAbsence
{
    Nothing,    ///< nothing is missing
    All,        ///< the whole reference
    Part,       ///< some of its files; the others are equal
    OwnPicture, ///< the picture of this renderer
};

/// The depths of a moment.
struct GoldenDepths
{
    bool state = false; ///< of the world
    bool list = false;  ///< the draw list
    bool frame = false; ///< the picture
};

/// The result of comparing one candidate.
struct GoldenVerdict
{
    std::string name;                               ///< of the reference
    GoldenStatus status = GoldenStatus::Missing;    ///< result
    GoldenDepths compared = {};                     ///< depths that were compared
    std::optional<WorldDifference> world = {};      ///< none: the worlds do not differ
    std::optional<LineDifference> list = {};        ///< none: the draw lists do not differ
    std::optional<FilmComparison> film = {};        ///< none: not of a film
    std::string references = {};                    ///< the approved folder
    std::vector<std::string> missing = {};          ///< files that are not there
    GoldenAbsence absence = GoldenAbsence::Nothing; ///< the missing part
    Error problem = {};                             ///< reason of GoldenStatus::NotCompared
    std::vector<std::string> look = {};             ///< files to look at first after a failure
    std::string accept = {}; ///< command that accepts the candidate if there is no reference;
                             ///< empty: there is one, or accepting would not help
    Comparison pixels;       ///< result of comparing the pictures
    LimitsChoice limits = LimitsChoice::AsGiven; ///< origin of the limits for the pictures
    std::optional<Error> warning = {}; ///< passed, but the result file was not written: reason

    /// Returns the differences, or what was compared, the largest first, for people.
    std::vector<std::string> Findings() const;
    /// Returns name, findings, files, and the remedy if the change is intended, for people.
    /// `remedy` replaces the command to accept; lower case, no full stop.
    std::string Text(const std::string& remedy = "") const;
    /// Returns what was accepted, for people: the differences, if there was a reference.
    std::string AcceptedText() const;
};

/// A folder of references.
class ReferenceStore
{
public:
    /// `references`: folder of the references. `output`: folder for NAME.expected.png,
    /// NAME.actual.png, NAME.difference.png, NAME.side-by-side.png, draw lists and states of
    /// failures. Every comparison writes NAME.verdict.json there, for `boxreel golden report`.
    ReferenceStore(std::filesystem::path references, std::filesystem::path output);

    /// Compares the candidate with its reference and writes files of the differences. An Error only
    /// when the name is invalid or a file cannot be written. A difference is a verdict, and so is
    /// an unreadable reference.
    Result<GoldenVerdict> Verify(const GoldenCandidate& candidate,
                                 const CompareSettings& settings = {}) const;

    /// Compares as Verify does, without writing files. An Error only when the name is invalid.
    Result<GoldenVerdict> Judge(const GoldenCandidate& candidate,
                                const CompareSettings& settings = {}) const;

    /// Makes the candidate the reference, replacing an existing one. Files are written completely
    /// or not at all. Unusable for ForThisRenderer when the candidate has no renderer.
    Result<void> Accept(const GoldenCandidate& candidate,
                        AcceptAs as = AcceptAs::TheOneCompared) const;

    /// True if this renderer (a Description()) has its own picture of that name.
    bool HasOwnPicture(const std::string& name, const std::string& renderer) const;

    /// Returns the names of all references, sorted.
    std::vector<std::string> Names() const;

private:
    std::filesystem::path m_references;
    std::filesystem::path m_output;
};

} // namespace boxreel
