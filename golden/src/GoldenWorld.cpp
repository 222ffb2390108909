// SPDX-License-Identifier: MIT
#include <golden/GoldenWorld.h>

#include <Box2D/Box2D.h>
#include <base/ErrorMacros.h>
#include <debugdraw/DrawCollector.h>
#include <debugdraw/WorldBounds.h>
#include <golden/StateHash.h>
#include <render/Renderer.h>

#include <utility>

namespace boxreel
{

static_assert(GoldenWorldLook{}.layers == (b2Draw::e_shapeBit | b2Draw::e_jointBit));

Result<GoldenCandidate> CandidateOf(b2World& world, const std::string& name,
                                    const GoldenWorldLook& look)
{
    // A new renderer each time: the second takes two milliseconds, and none exists at program exit.
    // It also rejects invalid sizes.
    ASSIGN_OR_RETURN(Renderer renderer,
                     Renderer::Create({.width = look.camera ? look.camera->width : look.width,
                                       .height = look.camera ? look.camera->height : look.height}));
    const Camera camera =
        look.camera ? *look.camera : FitTo(BoundsAtStart(world), look.width, look.height);
    GoldenCandidate candidate;
    candidate.name = name;
    candidate.stateHash = StateHashText(world);
    candidate.state = ReadWorldState(world);
    candidate.trace = look.trace;
    candidate.list = DrawListOf(world, look.layers);
    candidate.camera = camera;
    candidate.renderer = renderer.Description();
    ASSIGN_OR_RETURN(candidate.fingerprint, renderer.Fingerprint());
    RETURN_IF_ERROR(renderer.Draw(candidate.list, camera, candidate.frame));
    return candidate;
}

} // namespace boxreel
