// SPDX-License-Identifier: MIT
#include "GoldenScenes.h"

#include <base/ErrorMacros.h>
#include <base/Quoting.h>
#include <base/Words.h>
#include <golden/StateHash.h>
#include <options/Values.h>

#include <algorithm>
#include <functional>
#include <iterator>

namespace boxreel
{
namespace
{

struct Moment
{
    const char* name;
    Duration time;
};

// At the start, during the main action, and after most scenes have shown their effect.
constexpr Moment kMoments[] = {
    {"0.5s", Duration{500'000'000}},
    {"2s", Duration{2'000'000'000}},
    {"5s", Duration{5'000'000'000}},
};

std::int64_t LastStep(const GoldenSelection& selection, const Rational& stepsPerSecond)
{
    const auto named =
        std::find_if(std::begin(kMoments), std::end(kMoments),
                     [&](const Moment& moment) { return selection.moment == moment.name; });
    return StepAt((named != std::end(kMoments) ? *named : *std::rbegin(kMoments)).time,
                  stepsPerSecond);
}

// Simulates up to `step`, one step at a time.
StateTrace Advance(SceneSession& session, std::int64_t step)
{
    StateTrace trace;
    while (session.Step() < step)
    {
        session.AdvanceTo(session.Step() + 1);
        trace.steps.push_back(ReadTraceStep(session.World(), session.Step()));
    }
    return trace;
}

// `trace`: the steps since the previous moment.
Result<GoldenCandidate> CandidateAt(const std::string& name, SceneSession& session,
                                    StateTrace trace, Renderer& renderer)
{
    FrameContent content;
    session.Fill(content);
    GoldenCandidate candidate;
    candidate.name = name;
    candidate.stateHash = StateHashText(session.World());
    candidate.state = ReadWorldState(session.World());
    candidate.trace = std::move(trace);
    candidate.renderer = renderer.Description();
    ASSIGN_OR_RETURN(const std::string fingerprint, renderer.Fingerprint());
    candidate.fingerprint = fingerprint;
    candidate.camera = content.camera;
    RETURN_IF_ERROR(renderer.Draw(content.list, content.camera, candidate.frame));
    candidate.list = std::move(content.list);
    return candidate;
}

/// A film does not say who drew it; it is taken for one that was recorded here.
Result<void> VisitFilm(const GoldenFilm& film, const Renderer& renderer,
                       const std::function<Result<void>(const GoldenCandidate&)>& visit)
{
    ASSIGN_OR_RETURN(ContactSheet sheet, ContactSheetOf(film.path, film.sheet));
    ASSIGN_OR_RETURN(const std::string fingerprint, renderer.Fingerprint());
    GoldenCandidate candidate = CandidateOf(std::move(sheet), film.name);
    candidate.fingerprint = fingerprint;
    return visit(candidate);
}

} // namespace

Result<Renderer> CreateGoldenRenderer(Backend backend)
{
    return Renderer::Create({.width = kGoldenWidth, .height = kGoldenHeight, .backend = backend});
}

Result<SceneSession> OpenGolden(const GoldenSelection& selection, int width, int height)
{
    SceneLook look;
    look.width = width;
    look.height = height;
    look.collectEverything = true;
    SceneSource source;
    source.entry = selection.scene;
    source.title = selection.scene->name;
    return SceneSession::Open(std::move(source), look);
}

Result<GoldenSelection> SelectGolden(const std::string& name)
{
    // The name of a scene may have a slash of its own.
    if (const Result<const SceneEntry*> scene = FindScene(name))
    {
        return GoldenSelection{.scene = *scene};
    }
    const std::size_t slash = name.rfind('/');
    ASSIGN_OR_RETURN(const SceneEntry* const scene, FindScene(name.substr(0, slash)));
    GoldenSelection selection{.scene = scene, .moment = name.substr(slash + 1)};
    if (std::ranges::count(kMoments, selection.moment, &Moment::name) > 0)
    {
        return selection;
    }
    return Error{ErrorKind::Unusable, Quoted(name), "unknown moment",
                 "use one of " + JoinedBy(", ", kMoments, std::mem_fn(&Moment::name))};
}

Result<void> VisitGoldenMoments(const GoldenSelection& selection, Renderer& renderer,
                                const std::function<Result<void>(const GoldenCandidate&)>& visit)
{
    if (selection.film)
    {
        return VisitFilm(*selection.film, renderer, visit);
    }
    ASSIGN_OR_RETURN(SceneSession session, OpenGolden(selection));
    for (const Moment& moment : kMoments)
    {
        StateTrace trace = Advance(session, StepAt(moment.time, session.StepsPerSecond()));
        if (!selection.moment.empty() && selection.moment != moment.name)
        {
            continue;
        }
        ASSIGN_OR_RETURN(const GoldenCandidate candidate,
                         CandidateAt(SceneSlug(selection.scene->name) + "/" + moment.name, session,
                                     std::move(trace), renderer));
        Result<void> visited = visit(candidate);
        if (!visited)
        {
            return visited;
        }
    }
    return {};
}

Result<std::vector<GoldenVerdict>> VerifyGolden(const GoldenSelection& selection,
                                                const ReferenceStore& store, Renderer& renderer,
                                                const CompareSettings& settings)
{
    std::vector<GoldenVerdict> verdicts;
    const auto verify = [&](const GoldenCandidate& candidate) -> Result<void> {
        ASSIGN_OR_RETURN(GoldenVerdict verdict, store.Verify(candidate, settings));
        verdicts.push_back(std::move(verdict));
        return {};
    };
    RETURN_IF_ERROR(VisitGoldenMoments(selection, renderer, verify));
    return verdicts;
}

Result<std::vector<GoldenVerdict>> AcceptGolden(const GoldenSelection& selection,
                                                const ReferenceStore& store, Renderer& renderer,
                                                const GoldenAcceptance& acceptance)
{
    std::vector<GoldenVerdict> accepted;
    const auto accept = [&](const GoldenCandidate& candidate) -> Result<void> {
        ASSIGN_OR_RETURN(GoldenVerdict verdict, store.Judge(candidate));
        if (acceptance.forThisRenderer && verdict.status == GoldenStatus::Same &&
            !store.HasOwnPicture(candidate.name, candidate.renderer))
        {
            verdict.status = GoldenStatus::Missing;
            verdict.absence = GoldenAbsence::OwnPicture;
        }
        const bool isMissing = verdict.status == GoldenStatus::Missing;
        const bool isSame = verdict.status == GoldenStatus::Same;
        const GoldenFilter only = acceptance.only;
        if ((only == GoldenFilter::Missing && !isMissing) ||
            (only == GoldenFilter::Changed && (isMissing || isSame)))
        {
            return {};
        }
        accepted.push_back(std::move(verdict));
        return store.Accept(candidate, acceptance.forThisRenderer ? AcceptAs::ForThisRenderer
                                                                  : AcceptAs::TheOneCompared);
    };
    RETURN_IF_ERROR(VisitGoldenMoments(selection, renderer, accept));
    return accepted;
}

Result<std::int64_t> LastStepOf(const GoldenSelection& selection)
{
    ASSIGN_OR_RETURN(const SceneSession session, OpenGolden(selection));
    return LastStep(selection, session.StepsPerSecond());
}

Result<GoldenRun> SimulateGolden(const GoldenSelection& selection,
                                 std::optional<std::int64_t> lastStep)
{
    ASSIGN_OR_RETURN(SceneSession session, OpenGolden(selection));
    GoldenRun run;
    run.trace =
        Advance(session, lastStep ? *lastStep : LastStep(selection, session.StepsPerSecond()));
    run.stateHash = StateHashText(session.World());
    run.state = ReadWorldState(session.World());
    return run;
}

} // namespace boxreel
