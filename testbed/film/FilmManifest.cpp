// SPDX-License-Identifier: MIT
#include "FilmManifest.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <golden/StateHash.h>

#include <utility>

namespace boxreel
{

FilmManifest::FilmManifest(const RecordOptions& options, const FilmPlan& plan)
    : m_options(options), m_plan(plan), m_first(FileOfFrame(options.output, plan.frames.First())),
      m_isKept(HasManifest(options, plan)), m_manifest{.version = BOXREEL_VERSION,
                                                       .command = CommandOfFilm(options.arguments),
                                                       .framesPerSecond = plan.film.framesPerSecond,
                                                       .groupFrames = plan.groupFrames,
                                                       .plays = plan.film.plays,
                                                       .frameCount = plan.frameCount,
                                                       .first = plan.frames.First(),
                                                       .end = plan.frames.Last() + 1,
                                                       .checksum = {},
                                                       .states = {}}
{}

Result<bool> FilmManifest::FindLeft()
{
    const std::filesystem::path part = PartPath(m_first);
    std::error_code ignored;
    const bool isLeft = std::filesystem::exists(ManifestPath(part), ignored) ||
                        std::filesystem::exists(part, ignored);
    if (m_options.film.resume && !isLeft && std::filesystem::exists(m_first, ignored))
    {
        return Error{ErrorKind::Unusable, m_first.string(),
                     "already exists, and no stopped film is left to continue",
                     "choose another name, or start again with --force"};
    }
    if (!m_options.film.resume || !isLeft)
    {
        return false;
    }
    if (IsBeingWritten(part))
    {
        return Error{ErrorKind::Failed, part.string(), "another program is writing it",
                     "wait for it"};
    }
    ASSIGN_OR_RETURN(Manifest left, ReadManifest(part, "start again with --force"));
    const std::string difference = DifferenceFromAsked(left, m_options, m_plan);
    if (!difference.empty())
    {
        return Error{ErrorKind::Unusable, part.string(),
                     "belongs to another film (" + difference + ")",
                     "use the same command, or start again with --force"};
    }
    m_left = std::move(left);
    m_manifest.states = m_left.states; // merge asks for the first one
    return true;
}

Result<void> FilmManifest::Note(std::int64_t number, const b2World& world)
{
    if (!m_isKept || (number % m_plan.groupFrames != 0 && number != m_manifest.first))
    {
        return {};
    }
    const std::filesystem::path part = PartPath(m_first);
    const std::string state = StateHashText(world);
    const auto left = m_left.states.find(number);
    if (left != m_left.states.end() && left->second != state)
    {
        return Error{ErrorKind::Unusable, part.string(),
                     "was made by another build of boxreel: frame " + std::to_string(number) +
                         " differs",
                     "start again with --force"};
    }
    m_manifest.states[number] = state;
    return WriteManifest(part, m_manifest);
}

Result<void> FilmManifest::Complete(std::int64_t end, const b2World& world)
{
    m_manifest.end = end;
    m_manifest.states[end] = StateHashText(world);
    m_manifest.checksum = ChecksumOfFrames(m_options.output, m_manifest.first, end);
    return WriteManifest(m_first, m_manifest);
}

void FilmManifest::Remove() const
{
    std::error_code ignored;
    if (m_isKept)
    {
        std::filesystem::remove(ManifestPath(PartPath(m_first)), ignored);
    }
}

} // namespace boxreel
