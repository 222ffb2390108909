// SPDX-License-Identifier: MIT
#include "GoldenScenes.h"

#include "SceneSession.h"
#include "Values.h"

#include <golden/StateHash.h>

namespace boxreel
{
namespace
{

struct Moment
{
    const char* name;
    Duration time;
};

// While it starts, while it is busy, and when most scenes have shown what they are known for.
constexpr Moment kMoments[] = {
    {"0.5s", Duration{500'000'000}},
    {"2s", Duration{2'000'000'000}},
    {"5s", Duration{5'000'000'000}},
};

Result<GoldenCandidate> CandidateOf(const std::string& name, SceneSession& session,
                                    Renderer& renderer)
{
    FrameContent content;
    session.Fill(content);
    GoldenCandidate candidate;
    candidate.name = name;
    candidate.stateHash = StateHashText(session.World());
    const Result<void> drawn = renderer.Draw(content.list, content.camera, candidate.frame);
    if (!drawn)
    {
        return drawn.GetError();
    }
    candidate.list = std::move(content.list);
    return candidate;
}

} // namespace

Result<Renderer> CreateGoldenRenderer(Backend backend)
{
    return Renderer::Create({.width = kGoldenWidth, .height = kGoldenHeight, .backend = backend});
}

Result<GoldenSelection> SelectGolden(const std::string& name)
{
    // The name of a scene may have a slash of its own.
    if (const Result<const SceneEntry*> scene = FindScene(name))
    {
        return GoldenSelection{*scene, ""};
    }
    const std::size_t slash = name.rfind('/');
    const Result<const SceneEntry*> scene = FindScene(name.substr(0, slash));
    if (!scene)
    {
        return scene.GetError();
    }
    GoldenSelection selection{*scene, name.substr(slash + 1)};
    std::string moments;
    for (const Moment& moment : kMoments)
    {
        if (selection.moment == moment.name)
        {
            return selection;
        }
        moments += (moments.empty() ? "" : ", ") + std::string(moment.name);
    }
    return Error{ErrorKind::Unusable, "There is no moment '" + selection.moment + "' of '" +
                                          name.substr(0, slash) + "'; give one of " + moments +
                                          "."};
}

Result<void> VisitGoldenMoments(const GoldenSelection& selection, Renderer& renderer,
                                const std::function<Result<void>(const GoldenCandidate&)>& visit)
{
    SceneLook look;
    look.width = kGoldenWidth;
    look.height = kGoldenHeight;
    look.collectEverything = true;
    SceneSource source;
    source.entry = selection.scene;
    source.title = selection.scene->name;
    Result<SceneSession> session = SceneSession::Open(std::move(source), look);
    if (!session)
    {
        return session.GetError();
    }
    for (const Moment& moment : kMoments)
    {
        if (!selection.moment.empty() && selection.moment != moment.name)
        {
            continue;
        }
        session->AdvanceTo(StepAt(moment.time, session->StepsPerSecond()));
        const Result<GoldenCandidate> candidate =
            CandidateOf(SceneSlug(selection.scene->name) + "/" + moment.name, *session, renderer);
        if (!candidate)
        {
            return candidate.GetError();
        }
        Result<void> visited = visit(*candidate);
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
        Result<GoldenVerdict> verdict = store.Verify(candidate, settings);
        if (!verdict)
        {
            return verdict.GetError();
        }
        verdicts.push_back(std::move(*verdict));
        return {};
    };
    const Result<void> visited = VisitGoldenMoments(selection, renderer, verify);
    if (!visited)
    {
        return visited.GetError();
    }
    return verdicts;
}

Result<int> AcceptGolden(const GoldenSelection& selection, const ReferenceStore& store,
                         Renderer& renderer)
{
    int accepted = 0;
    const auto accept = [&](const GoldenCandidate& candidate) -> Result<void> {
        ++accepted;
        return store.Accept(candidate);
    };
    const Result<void> visited = VisitGoldenMoments(selection, renderer, accept);
    if (!visited)
    {
        return visited.GetError();
    }
    return accepted;
}

} // namespace boxreel
