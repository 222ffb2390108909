// SPDX-License-Identifier: MIT
#include "SceneMotion.h"
#include "SceneLabels.h"

#include <base/ErrorMacros.h>
#include <debugdraw/Axes.h>
#include <debugdraw/Dimension.h>
#include <debugdraw/DrawCollector.h>
#include <debugdraw/Faded.h>
#include <debugdraw/Trail.h>
#include <debugdraw/WorldGlyphs.h>
#include <golden/StateHash.h>

#include <algorithm>

namespace boxreel
{
namespace
{

// Opacity of a stroboscope's poses. They must differ from the background and from the last pose.
constexpr double kStrobeOpacity = 0.45;
// Opacity of an onion skin's oldest and newest pose.
constexpr double kOldestOpacity = 0.15;
constexpr double kNewestOpacity = 0.6;

// A pose nearer than this [px] to the next one would only blur it.
constexpr double kSamePlace = 1.5;

// More would be a smear, and a file and a memory full of it.
constexpr std::size_t kMaxPoses = 2000;

bool IsMeant(const BodyChoice& choice, const b2Body& body)
{
    return choice.moving ? body.GetType() != b2_staticBody
                         : std::find(choice.bodies.begin(), choice.bodies.end(),
                                     BodyRef(body.GetNumber())) != choice.bodies.end();
}

/// `count` intervals, in steps.
std::int64_t StepsIn(const Interval& interval, std::int64_t count, const Rational& stepsPerSecond)
{
    return interval.steps > 0 ? count * interval.steps
                              : StepAt(Duration{count * interval.time.nanoseconds}, stepsPerSecond);
}

std::optional<Vec2> PlaceOf(const MeasuredEnd& end, const b2World& world)
{
    if (const BodyRef* const measured = std::get_if<BodyRef>(&end))
    {
        const b2Body* const body = FindBodies(world, {measured->number}).front();
        return body != nullptr
                   ? std::optional(Vec2{body->GetWorldCenter().x, body->GetWorldCenter().y})
                   : std::nullopt;
    }
    return std::get<Vec2>(end);
}

/// The bodies between which is measured.
std::vector<int> MeasuredBodies(const MotionLook& look)
{
    std::vector<int> bodies;
    for (const DimensionChoice& dimension : look.dimensions)
    {
        for (const MeasuredEnd& end : {dimension.from, dimension.to})
        {
            if (const BodyRef* const body = std::get_if<BodyRef>(&end))
            {
                bodies.push_back(body->number);
            }
        }
    }
    return bodies;
}

/// Checks that all bodies of the look are among the first `made` bodies.
Result<void> CheckAllBodies(const MotionLook& look, int made)
{
    const std::pair<const char*, std::vector<int>> named[] = {
        {"--trail", look.trail ? NumbersOf(look.trail->bodies) : std::vector<int>()},
        {"--strobe", look.strobe ? NumbersOf(look.strobe->of.bodies) : std::vector<int>()},
        {"--onion", look.onion ? NumbersOf(look.onion->of.bodies) : std::vector<int>()},
        {"--dimension", MeasuredBodies(look)}};
    for (const auto& [option, numbers] : named)
    {
        RETURN_IF_ERROR(CheckBodies(option, made, numbers));
    }
    return {};
}

std::vector<BodyRef*> Pointers(std::vector<BodyRef>& bodies)
{
    std::vector<BodyRef*> pointers;
    for (BodyRef& body : bodies)
    {
        pointers.push_back(&body);
    }
    return pointers;
}

/// The look with numbers instead of names.
Result<MotionLook> WithNumbers(MotionLook look, const BodyNames& names)
{
    std::vector<BodyRef> none;
    std::vector<BodyRef*> measured;
    for (DimensionChoice& dimension : look.dimensions)
    {
        for (MeasuredEnd* const end : {&dimension.from, &dimension.to})
        {
            if (BodyRef* const body = std::get_if<BodyRef>(end))
            {
                measured.push_back(body);
            }
        }
    }
    const std::pair<const char*, std::vector<BodyRef*>> named[] = {
        {"--trail", Pointers(look.trail ? look.trail->bodies : none)},
        {"--strobe", Pointers(look.strobe ? look.strobe->of.bodies : none)},
        {"--onion", Pointers(look.onion ? look.onion->of.bodies : none)},
        {"--dimension", measured}};
    for (const auto& [option, bodies] : named)
    {
        RETURN_IF_ERROR(FindNames(option, bodies, names));
    }
    return look;
}

} // namespace

Result<SceneMotion> SceneMotion::Create(const MotionLook& asked, SceneSession& session,
                                        const std::vector<std::int64_t>& moments)
{
    ASSIGN_OR_RETURN(const MotionLook numbered, WithNumbers(asked, session.Names()));
    const MotionLook& look = numbered;
    const int made = CountMade(session.World());
    if (const Result<void> found = CheckAllBodies(look, made);
        !found && !session.MakesBodiesLater())
    {
        return found.GetError();
    }
    SceneMotion motion(look);
    motion.m_made = made;
    for (const std::int64_t moment : moments)
    {
        for (const std::int64_t step : motion.PosesFor(moment, session.StepsPerSecond()))
        {
            motion.m_poses.try_emplace(step);
        }
        if (motion.m_poses.size() > kMaxPoses)
        {
            return Error{ErrorKind::Unusable, look.strobe ? "--strobe" : "--onion",
                         "makes more than " + std::to_string(kMaxPoses) + " poses",
                         "give a longer interval or fewer moments"};
        }
    }
    motion.Observe(session);
    return motion;
}

/// The steps of the earlier poses, the oldest first. One more than the maximum shows that it is
/// exceeded.
std::vector<std::int64_t> SceneMotion::PosesFor(std::int64_t moment,
                                                const Rational& stepsPerSecond) const
{
    std::set<std::int64_t> steps;
    if (m_look.strobe)
    {
        for (std::int64_t i = 0; steps.size() <= kMaxPoses; ++i)
        {
            const std::int64_t step = StepsIn(m_look.strobe->every, i, stepsPerSecond);
            if (step >= moment)
            {
                break;
            }
            steps.insert(step);
        }
    }
    for (std::int64_t i = 1; m_look.onion && i <= m_look.onion->count; ++i)
    {
        const std::int64_t step = moment - StepsIn(m_look.onion->every, i, stepsPerSecond);
        if (step >= 0 && step < moment)
        {
            steps.insert(step);
        }
    }
    return {steps.begin(), steps.end()};
}

void SceneMotion::AdvanceTo(SceneSession& session, std::int64_t step)
{
    const bool watches = m_look.trail.has_value();
    while (session.Step() < step)
    {
        const auto next = m_poses.upper_bound(session.Step());
        const std::int64_t goal = next != m_poses.end() ? std::min(step, next->first) : step;
        session.AdvanceTo(watches ? session.Step() + 1 : goal);
        Observe(session);
    }
}

void SceneMotion::Observe(SceneSession& session)
{
    m_made = std::max(m_made, CountMade(session.World()));
    const auto pose = m_poses.find(session.Step());
    if (pose == m_poses.end() && !m_look.trail)
    {
        return;
    }
    for (const b2Body* const body : OldestFirst(session.World()))
    {
        if (m_look.trail && IsMeant(*m_look.trail, *body))
        {
            Way& way = m_ways.try_emplace(body->GetNumber(), Way{session.Step(), {}}).first->second;
            const b2Vec2 center = body->GetWorldCenter();
            way.places.push_back({center.x, center.y});
        }
        if (pose != m_poses.end() &&
            IsMeant(m_look.strobe ? m_look.strobe->of : m_look.onion->of, *body))
        {
            pose->second.bodies.insert(static_cast<std::uint32_t>(body->GetNumber()));
        }
    }
    if (pose != m_poses.end())
    {
        pose->second.list = DrawListOf(session.World(), b2Draw::e_shapeBit);
    }
}

void SceneMotion::AddTrails(const SceneSession& session, DrawList& list) const
{
    std::int64_t start = 0;
    if (m_look.trailTime)
    {
        start = session.Step() - StepAt(*m_look.trailTime, session.StepsPerSecond());
    }
    std::size_t number = 0;
    for (const auto& [body, way] : m_ways)
    {
        const std::size_t skipped = static_cast<std::size_t>(
            std::clamp<std::int64_t>(start - way.firstStep, 0, std::ssize(way.places)));
        list.owner = static_cast<std::uint32_t>(body);
        AddTrail(list, session.CurrentCamera(), std::span(way.places).subspan(skipped),
                 {.color = TrailColor(number++)});
    }
    list.owner = kNoOwner;
}

void SceneMotion::AddPoses(SceneSession& session, DrawList& list) const
{
    const std::vector<std::int64_t> steps = PosesFor(session.Step(), session.StepsPerSecond());
    if (steps.empty())
    {
        return;
    }
    const double near = kSamePlace / session.CurrentCamera().pixelsPerMeter;
    const DrawList now = DrawListOf(session.World(), b2Draw::e_shapeBit);
    std::map<std::uint32_t, const DrawList*> later; // where a body was seen last, backwards
    std::map<std::int64_t, std::set<std::uint32_t>> shown;
    for (auto step = steps.rbegin(); step != steps.rend(); ++step)
    {
        const Pose& pose = m_poses.at(*step);
        for (const std::uint32_t body : pose.bodies)
        {
            const DrawList*& next = later.try_emplace(body, &now).first->second;
            if (!StandsStill(pose.list, *next, body, near) &&
                !StandsStill(pose.list, now, body, near))
            {
                shown[*step].insert(body);
                next = &pose.list;
            }
        }
    }
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
        const double age = double(i + 1) / double(steps.size());
        const double opacity = m_look.strobe
                                   ? kStrobeOpacity
                                   : kOldestOpacity + age * (kNewestOpacity - kOldestOpacity);
        const std::set<std::uint32_t>& bodies = shown[steps[i]];
        AddFaded(list, m_poses.at(steps[i]).list, opacity,
                 [&bodies](const DrawItem& item) { return bodies.contains(item.owner); });
    }
}

/// Adds the dimensions of the look whose ends exist.
void SceneMotion::AddDimensions(const SceneSession& session, DrawList& list) const
{
    for (const DimensionChoice& dimension : m_look.dimensions)
    {
        const std::optional<Vec2> from = PlaceOf(dimension.from, session.World());
        const std::optional<Vec2> to = PlaceOf(dimension.to, session.World());
        if (from && to)
        {
            AddDimension(list, session.CurrentCamera(), *from, *to);
        }
    }
}

/// With texts that keep clear of bodies where they are and where they are seen to have been, signs,
/// and lines of other dimensions, also of later ones.
DrawList SceneMotion::Dimensions(SceneSession& session) const
{
    DrawList inTheWay;
    AddDimensions(session, inTheWay);
    std::erase_if(inTheWay.items, [](const DrawItem& item) { return item.kind == DrawKind::Text; });
    DrawList picture = DrawListOf(session.World(), b2Draw::e_shapeBit);
    AddJointGlyphs(session.World(), ViewOfEverything(session.CurrentCamera()), picture);
    AddPoses(session, inTheWay);
    AddTrails(session, inTheWay);
    for (DrawItem& item : inTheWay.items)
    {
        // Restores the layer of a body or a sign.
        item.layer = item.layer == DrawLayer::Poses ? DrawLayer::Shapes : DrawLayer::JointGlyphs;
    }
    Append(picture, inTheWay);
    AddDimensions(session, picture);
    DrawList dimensions;
    Append(dimensions, picture,
           [](const DrawItem& item) { return item.layer == DrawLayer::Annotations; });
    return dimensions;
}

DrawList SceneMotion::Notes(SceneSession& session)
{
    DrawList list;
    if (m_look.axes)
    {
        AddOriginMark(list, session.CurrentCamera());
    }
    if (!m_look.dimensions.empty())
    {
        Append(list, Dimensions(session));
    }
    for (const int body : MeasuredBodies(m_look))
    {
        if (FindBodies(session.World(), {body}).front() != nullptr)
        {
            m_measured.insert(body);
        }
    }
    return list;
}

DrawList SceneMotion::Picture(SceneSession& session, const DrawList& scene) const
{
    DrawList list;
    AddPoses(session, list);
    AddTrails(session, list);
    Append(list, scene);
    return list;
}

Result<void> SceneMotion::CheckBodiesCame() const
{
    RETURN_IF_ERROR(CheckAllBodies(m_look, m_made));
    for (const int body : MeasuredBodies(m_look))
    {
        if (!m_measured.contains(body))
        {
            return Error{ErrorKind::Unusable, "--dimension",
                         "body " + std::to_string(body) + " no longer exists",
                         "give an earlier moment or another body"};
        }
    }
    return {};
}

} // namespace boxreel
