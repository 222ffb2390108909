// SPDX-License-Identifier: MIT
#include "SceneCamera.h"

#include "SceneBounds.h"
#include "SceneLabels.h"

#include <algorithm>

namespace boxreel
{
namespace
{

// Of the view of what is followed without a height: enough to see where a body of a metre is, and
// around larger ones as much again on either side.
constexpr double kLeastFollowHeight = 10.0; // [m]
constexpr double kFollowedShare = 1.0 / 3.0;

Camera FixedCamera(const FixedView& view, int width, int height)
{
    Camera camera;
    camera.width = width;
    camera.height = height;
    camera.centerX = view.centerX;
    camera.centerY = view.centerY;
    camera.pixelsPerMeter = height / view.height;
    return camera;
}

double HeightForFollowing(const Rect& bodies, int width, int height)
{
    const Camera fitting = FitTo(bodies, width, height, 0.5 * (1.0 - kFollowedShare));
    return std::max(kLeastFollowHeight, height / fitting.pixelsPerMeter);
}

std::vector<int> BodiesOf(const ViewChoice& choice)
{
    if (const auto* fit = std::get_if<FitBodiesView>(&choice))
    {
        return fit->bodies;
    }
    const auto* follow = std::get_if<FollowView>(&choice);
    return follow != nullptr ? follow->bodies : std::vector<int>();
}

} // namespace

SceneCamera::SceneCamera(const ViewChoice& choice, b2World& world, int width, int height)
    : m_bodies(BodiesOf(choice))
{
    if (const auto* fixed = std::get_if<FixedView>(&choice))
    {
        m_view = FixedCamera(*fixed, width, height);
    }
    else if (const auto* path = std::get_if<PathView>(&choice))
    {
        m_view = m_mover.emplace<CameraPath>(width, height, path->keys).At(0.0);
    }
    else if (const auto* follow = std::get_if<FollowView>(&choice))
    {
        const double viewHeight =
            follow->height.value_or(HeightForFollowing(Subject(world), width, height));
        m_seesCentersOnly = true;
        m_view = m_mover.emplace<FollowCamera>(width, height, Subject(world), viewHeight).View();
    }
    else if (std::holds_alternative<FitBodiesView>(choice))
    {
        m_view = m_mover.emplace<FollowCamera>(width, height, Subject(world)).View();
    }
    else
    {
        const bool whole = std::get<FitView>(choice).wholeWorld;
        const Rect bounds = whole ? BoundsOfEverything(world) : BoundsAtStart(world);
        m_view = m_mover.emplace<FitCamera>(width, height, bounds).View();
    }
}

Result<SceneCamera> SceneCamera::Create(const ViewChoice& choice, b2World& world, int width,
                                        int height)
{
    if (const Result<void> found = CheckBodies("--camera", world, BodiesOf(choice)); !found)
    {
        return found.GetError();
    }
    return SceneCamera(choice, world, width, height);
}

Rect SceneCamera::Subject(b2World& world) const
{
    const std::vector<const b2Body*> bodies = FindBodies(world, m_bodies);
    return m_seesCentersOnly ? BoundsOfCenters(bodies) : BoundsOfBodies(bodies);
}

void SceneCamera::Update(b2World& world, double time, double dt)
{
    if (auto* fit = std::get_if<FitCamera>(&m_mover))
    {
        fit->Update(BoundsOfMovers(world), dt);
        m_view = fit->View();
    }
    else if (auto* follow = std::get_if<FollowCamera>(&m_mover))
    {
        follow->Update(Subject(world), dt);
        m_view = follow->View();
    }
    else if (const auto* path = std::get_if<CameraPath>(&m_mover))
    {
        m_view = path->At(time);
    }
}

} // namespace boxreel
