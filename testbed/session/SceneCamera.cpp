// SPDX-License-Identifier: MIT
#include "SceneCamera.h"

#include <debugdraw/WorldBounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace boxreel
{
namespace
{

// The view of a followed body, if no height is given. It is high enough to show the place of a body
// of one metre. Around larger bodies it has as much space again on either side.
constexpr double kMinFollowHeight = 10.0; // [m]
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

Rect RectOf(const b2AABB& box)
{
    return Rect{{box.lowerBound.x, box.lowerBound.y}, {box.upperBound.x, box.upperBound.y}};
}

double HeightForFollowing(const Rect& bodies, int width, int height)
{
    const Camera fitting = FitTo(bodies, width, height, 0.5 * (1.0 - kFollowedShare));
    return std::max(kMinFollowHeight, height / fitting.pixelsPerMeter);
}

std::vector<int> NumbersOf(ViewChoice choice)
{
    std::vector<int> numbers;
    for (const BodyRef* const body : BodiesOf(choice))
    {
        numbers.push_back(body->number);
    }
    return numbers;
}

} // namespace

SceneCamera::SceneCamera(const ViewChoice& choice, b2World& world, int width, int height,
                         const std::vector<b2AABB>& framed)
    : m_bodies(NumbersOf(choice)), m_made(CountMade(world))
{
    m_view.width = width;
    m_view.height = height;
    if (const auto* fixed = std::get_if<FixedView>(&choice))
    {
        m_view = FixedCamera(*fixed, width, height);
    }
    else if (const auto* path = std::get_if<PathView>(&choice))
    {
        m_view = m_mover.emplace<CameraPath>(width, height, path->keys).At(0.0);
    }
    else if (const auto* fit = std::get_if<FitView>(&choice))
    {
        LookAtAll(world, fit->wholeWorld, framed);
    }
    else if (std::holds_alternative<SceneView>(choice))
    {
        LookAtAll(world, false, framed);
    }
    else
    {
        const auto* follow = std::get_if<FollowView>(&choice);
        m_seesCentersOnly = follow != nullptr;
        m_followHeight = follow != nullptr ? follow->height : std::nullopt;
        m_waits = BoundsOfBodies(FindBodies(world, m_bodies)).IsEmpty();
        m_waits ? LookAtAll(world, false, framed) : LookAtBodies(world);
    }
}

void SceneCamera::LookAtAll(b2World& world, bool whole, const std::vector<b2AABB>& framed)
{
    Rect extra;
    for (const b2AABB& box : framed)
    {
        extra.Include(RectOf(box));
    }
    const Rect bounds = whole ? BoundsOfEverything(world, extra) : BoundsAtStart(world, extra);
    m_view = m_mover.emplace<FitCamera>(m_view.width, m_view.height, bounds).View();
}

void SceneCamera::LookAtBodies(b2World& world)
{
    std::optional<double> height = m_followHeight;
    if (m_seesCentersOnly && !height)
    {
        height = HeightForFollowing(BoundsOfBodies(FindBodies(world, m_bodies)), m_view.width,
                                    m_view.height);
    }
    m_view =
        m_mover.emplace<FollowCamera>(m_view.width, m_view.height, Subject(world), height).View();
}

Result<SceneCamera> SceneCamera::Create(const ViewChoice& choice, b2World& world, int width,
                                        int height, bool bodiesMayCome,
                                        const std::vector<b2AABB>& framed)
{
    const SceneCamera camera(choice, world, width, height, framed);
    const Result<void> came = bodiesMayCome ? Result<void>() : camera.CheckBodiesCame();
    return came ? Result<SceneCamera>(camera) : came.GetError();
}

Rect SceneCamera::Subject(b2World& world) const
{
    const std::vector<const b2Body*> bodies = FindBodies(world, m_bodies);
    return m_seesCentersOnly ? BoundsOfCenters(bodies) : BoundsOfBodies(bodies);
}

void SceneCamera::Update(b2World& world, double time, double dt, const std::vector<b2AABB>& framed)
{
    m_made = std::max(m_made, CountMade(world));
    if (m_waits && !Subject(world).IsEmpty())
    {
        m_waits = false;
        LookAtBodies(world);
    }
    else if (auto* fit = std::get_if<FitCamera>(&m_mover))
    {
        std::vector<Rect> seen = BoundsOfMovers(world);
        for (const b2AABB& box : framed)
        {
            seen.push_back(RectOf(box));
        }
        fit->Update(seen, dt);
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

void SceneCamera::VisitState(const NumberVisitor& visit)
{
    const bool waited = m_waits;
    double waits = m_waits ? 1.0 : 0.0;
    double made = m_made;
    visit(waits);
    visit(made);
    m_waits = waits != 0.0;
    m_made = static_cast<int>(std::clamp(made, 0.0, double(std::numeric_limits<int>::max())));
    if (waited && !m_waits) // what it waited for has come
    {
        m_mover.emplace<FollowCamera>(m_view.width, m_view.height, Rect(),
                                      m_seesCentersOnly
                                          ? std::optional(m_followHeight.value_or(kMinFollowHeight))
                                          : std::nullopt);
    }
    if (auto* fit = std::get_if<FitCamera>(&m_mover))
    {
        fit->VisitState(visit);
    }
    else if (auto* follow = std::get_if<FollowCamera>(&m_mover))
    {
        follow->VisitState(visit);
    }
    visit(m_view.centerX);
    visit(m_view.centerY);
    visit(m_view.pixelsPerMeter);
}

std::vector<double> SceneCamera::State() const
{
    std::vector<double> state;
    SceneCamera copy = *this;
    copy.VisitState([&state](double& number) { state.push_back(number); });
    return state;
}

bool SceneCamera::Restore(std::span<const double> state)
{
    SceneCamera restored = *this;
    std::size_t read = 0;
    bool isSound = true;
    restored.VisitState([&](double& number) {
        isSound = isSound && read < state.size() && std::isfinite(state[read]);
        number = isSound ? state[read] : 0.0;
        ++read;
    });
    if (isSound && read == state.size())
    {
        *this = restored;
        return true;
    }
    return false;
}

} // namespace boxreel
