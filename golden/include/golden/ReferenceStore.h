// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>
#include <golden/Compare.h>
#include <golden/ContactSheet.h>
#include <golden/WorldState.h>
#include <render/Frame.h>

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

/// The result of comparing one candidate.
struct GoldenVerdict
{
    std::string name;                            ///< name of the reference
    GoldenStatus status = GoldenStatus::Missing; ///< result
    std::vector<std::string> findings = {};      ///< differences, or what was compared, the worst
                                                 ///< first
    std::vector<std::string> look = {};          ///< the files to open first after a failure
    std::string accept = {}; ///< command that accepts the candidate if there is no reference;
                             ///< empty: there is one, or accepting does not help
    Comparison pixels;       ///< result of comparing the pictures
    LimitsChoice limits = LimitsChoice::AsGiven; ///< reason for the pictures' limits
    std::string warning = {}; ///< on success: why no verdict file was written; usually empty

    /// Returns the text: name, findings, files, and how to accept an intended change. `remedy`
    /// replaces the command to accept; lower case, no full stop.
    std::string Text(const std::string& remedy = "") const;
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
