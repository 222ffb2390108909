// SPDX-License-Identifier: MIT
#include "PageEncoder.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

// A group begins with all tracks as they are, which costs as much as some frames in motion. More
// frames make it slower to jump into the middle of a group.
constexpr std::int64_t kGroupFrames = 240;
constexpr std::size_t kGroupBytes = 8u << 20; // for worlds of very many bodies

// Rounding of place, angle and form add up to 1.1 quanta at most, and floats have some of their
// own.
constexpr double kQuantaInError = 1.25;

// A quantum of the view: a picture is off by far less than kPagePixelError.
constexpr double kViewSteps = 16.0;

constexpr double kNearPixels = 6.0;

// Velocities are rounded to kPageVelocityError.
constexpr double kVelocityUnit = 2.0 * kPageVelocityError;

// A body whose shapes place it this well needs no place of its own: half of the last digit that the
// page shows of it.
constexpr double kSamePlace = 0.0005; // [m, rad]
constexpr double kAngleUnit = 0.0001; // of a place of its own [rad]

// Of larger places, differences of predictions would not be whole numbers in a double, which is
// what JavaScript has.
constexpr double kMaxQuanta = 1e14;

/// Returns the pixel at which renderers and draw.js begin a text. The operations and their order
/// are theirs, because results within rounding of half a pixel depend on them.
PagePoint TextPixel(PagePoint world, const Camera& camera)
{
    return {
        std::floor(0.5 * camera.width + (world.x - camera.centerX) * camera.pixelsPerMeter + 0.5),
        std::floor(0.5 * camera.height - (world.y - camera.centerY) * camera.pixelsPerMeter + 0.5)};
}

} // namespace

PageEncoder::PageEncoder(const Camera& first, double rate)
    : m_fullScale(kPageZoom * first.pixelsPerMeter),
      m_quantum(kPagePixelError / (kQuantaInError * m_fullScale)),
      m_tolerance(kPagePixelError / m_fullScale), m_rate(rate),
      m_near(kNearPixels / first.pixelsPerMeter), m_forms(m_quantum)
{}

bool PageEncoder::CanHold(const Camera& camera) const
{
    const double farthest = kMaxQuanta * m_quantum / kViewSteps;
    return std::abs(camera.centerX) <= farthest && std::abs(camera.centerY) <= farthest &&
           camera.height / camera.pixelsPerMeter <= farthest;
}

bool PageEncoder::IsGroupFull() const
{
    std::size_t bytes = m_sequence.size();
    for (const Column& column : m_columns)
    {
        bytes += column.small.size() + column.large.size();
    }
    return m_frames >= kGroupFrames || bytes >= kGroupBytes;
}

std::string PageEncoder::TakeGroup()
{
    std::string bytes;
    const auto put = [&bytes](std::string& part) {
        PutVarint(bytes, part.size());
        bytes += part;
        part.clear();
    };
    PutVarint(bytes, std::uint64_t(m_frames));
    put(m_sequence);
    for (Column& column : m_columns)
    {
        put(column.small);
        put(column.large);
    }
    m_frames = 0;
    m_view = {};
    m_neighbour = {};
    return bytes;
}

void PageEncoder::Put(ColumnOf column, Predictor& predictor, std::int64_t number)
{
    const std::int64_t guess = predictor.IsEmpty() ? m_neighbour[column] : predictor.Guess();
    m_columns[column].Put(number - guess);
    predictor.Add(number);
    m_neighbour[column] = number;
}

/// Returns the view as it is stored: x, y and height.
std::array<std::int64_t, 3> PageEncoder::ViewNumbers(const Camera& camera) const
{
    const double unit = m_quantum / kViewSteps;
    return {std::llround(camera.centerX / unit), std::llround(camera.centerY / unit),
            std::llround(camera.height / camera.pixelsPerMeter / unit)};
}

/// Returns the view as the page will read it.
Camera PageEncoder::StoredView(const Camera& camera) const
{
    const double unit = m_quantum / kViewSteps;
    const auto [x, y, height] = ViewNumbers(camera);
    Camera stored = camera;
    stored.centerX = double(x) * unit;
    stored.centerY = double(y) * unit;
    stored.pixelsPerMeter = camera.height / (double(height) * unit);
    return stored;
}

void PageEncoder::PutView(const Camera& camera)
{
    const std::array<std::int64_t, 3> numbers = ViewNumbers(camera);
    for (std::size_t k = 0; k < numbers.size(); ++k)
    {
        Put(View, m_view[k], numbers[k]);
    }
}

Track PageEncoder::BeginLoose(const Run& run)
{
    Track track;
    track.run = run;
    track.form = m_forms.AddLoose(run.signature);
    return track;
}

/// Expects the points of the run in m_points.
Track PageEncoder::Begin(const Run& run, const PageBody* body)
{
    if (m_points.size() < 2 || !InfoOf(run.layer).isRigid)
    {
        return BeginLoose(run);
    }
    const bool isKnown = body != nullptr && run.layer == DrawLayer::Shapes;
    std::optional<PagePoint> origin;
    if (isKnown)
    {
        origin = PagePoint{body->position.x, body->position.y};
    }
    const double angle = isKnown ? double(body->angle) : 0.0;
    Track track;
    track.run = run;
    track.isRigid = true;
    track.form = m_forms.AddRigid(run.signature, m_points, angle, origin);
    const double angleUnit = m_forms.Rigid(track.form).angleUnit;
    track.numbers = {0, 0, std::llround(angle / angleUnit)};
    return track;
}

/// Expects the points of the run in m_points. False if they no longer move as one.
bool PageEncoder::Place(Track& track)
{
    if (track.isRigid)
    {
        const auto place =
            FitPlace(m_forms.Rigid(track.form), m_points, m_quantum, track.numbers[2], m_tolerance);
        if (place)
        {
            track.numbers = {place->x, place->y, place->angle};
        }
        return place.has_value();
    }
    track.numbers.clear();
    for (const PagePoint p : m_points)
    {
        track.numbers.push_back(std::llround(p.x / m_quantum));
        track.numbers.push_back(std::llround(p.y / m_quantum));
    }
    return true;
}

/// Moves a text by a quantum where its stored place, or the stored view, begins it at another pixel
/// than renderers do: within about a quantum of half a pixel. Expects the points of the run in
/// m_points and their numbers in the track.
void PageEncoder::PlaceTexts(const DrawList& list, const Camera& camera, Track& track) const
{
    if (track.isRigid)
    {
        return;
    }
    const auto move = [this](std::int64_t& number, double pixels, double place) {
        const std::int64_t moved = number + (pixels > 0.0 ? 1 : pixels < 0.0 ? -1 : 0);
        number = std::abs(double(moved) * m_quantum - place) <= m_tolerance ? moved : number;
    };
    const ItemRun& items = track.run.items;
    std::size_t at = 0; // of the item's first point
    for (const DrawItem& item : std::span(list.items).subspan(items.first, items.count))
    {
        if (item.kind == DrawKind::Text)
        {
            std::int64_t* const numbers = &track.numbers[2 * at];
            const PagePoint place = m_points[at];
            const PagePoint stored{double(numbers[0]) * m_quantum, double(numbers[1]) * m_quantum};
            const PagePoint wanted = TextPixel(place, camera);
            const PagePoint shown = TextPixel(stored, StoredView(camera));
            move(numbers[0], wanted.x - shown.x, place.x);
            move(numbers[1], shown.y - wanted.y, place.y); // pixels have y down
        }
        at += item.count;
    }
}

void PageEncoder::Follow(const DrawList& list, const Camera& camera,
                         std::span<const PageBody> bodies)
{
    std::unordered_map<std::uint32_t, const PageBody*> known; // for lookups only
    for (const PageBody& body : bodies)
    {
        known.emplace(body.number, &body);
    }
    std::vector<Run> runs = SplitRuns(list, kMaxQuanta * m_quantum, m_styles, m_forms);
    m_from = MatchRuns(m_tracks, runs, m_near);
    std::vector<Track> tracks;
    tracks.reserve(runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i)
    {
        ReadPoints(list, runs[i].items, m_points);
        if (m_from[i] >= 0)
        {
            tracks.push_back(std::move(m_tracks[std::size_t(m_from[i])]));
            tracks.back().run = std::move(runs[i]);
        }
        else
        {
            const auto body = known.find(runs[i].owner);
            tracks.push_back(Begin(runs[i], body != known.end() ? body->second : nullptr));
        }
        if (!Place(tracks.back()))
        {
            tracks.back() = BeginLoose(tracks.back().run);
            Place(tracks.back());
            m_from[i] = -1;
        }
        PlaceTexts(list, camera, tracks.back());
    }
    m_tracks = std::move(tracks);
}

/// Returns where a rigid shape places the body, if that is the body's place.
std::optional<BodyPlace> PageEncoder::PlaceOfShape(const Track* shape, const PageBody& body) const
{
    if (shape == nullptr || !shape->isRigid || !m_forms.Rigid(shape->form).origin)
    {
        return std::nullopt;
    }
    const RigidPlace placed{shape->numbers[0], shape->numbers[1], shape->numbers[2]};
    const BodyPlace place = BodyPlaceOf(m_forms.Rigid(shape->form), placed, m_quantum);
    const auto isSame = [](double a, double b) { return std::abs(a - b) <= kSamePlace; };
    return isSame(place.x, body.position.x) && isSame(place.y, body.position.y) &&
                   isSame(place.angle, body.angle)
               ? std::optional(place)
               : std::nullopt;
}

/// `place`: as its shape has it, or none.
void PageEncoder::PlaceBody(BodyTrack& track, const PageBody& body,
                            const std::optional<BodyPlace>& place, const BodyTrack* before)
{
    if (place)
    {
        track.place = *place;
    }
    else
    {
        track.numbers = {std::llround(body.position.x / m_quantum),
                         std::llround(body.position.y / m_quantum),
                         std::llround(body.angle / kAngleUnit)};
        track.place = {double(track.numbers[0]) * m_quantum, double(track.numbers[1]) * m_quantum,
                       double(track.numbers[2]) * kAngleUnit};
    }
    const BodyPlace from = before != nullptr ? before->place : track.place;
    const auto rest = [this](double velocity, double now, double then) {
        const double limit = kMaxQuanta * kVelocityUnit;
        return std::llround(std::clamp(velocity - (now - then) * m_rate, -limit, limit) /
                            kVelocityUnit);
    };
    track.velocities = {rest(body.velocity.x, track.place.x, from.x),
                        rest(body.velocity.y, track.place.y, from.y),
                        rest(body.spin, track.place.angle, from.angle)};
}

/// Bodies come behind the tracks of the list, so that those go on as without them.
void PageEncoder::FollowBodies(std::span<const PageBody> bodies, std::size_t tracksBefore)
{
    std::unordered_map<std::uint32_t, const Track*> shapes; // for lookups only
    for (const Track& track : m_tracks)
    {
        if (track.run.layer == DrawLayer::Shapes)
        {
            shapes.emplace(track.run.owner, &track);
        }
    }
    std::vector<const PageBody*> sorted;
    for (const PageBody& body : bodies)
    {
        const double limit = kMaxQuanta * m_quantum;
        const bool isUsable = std::abs(body.position.x) <= limit &&
                              std::abs(body.position.y) <= limit && std::isfinite(body.angle) &&
                              std::isfinite(body.velocity.x) && std::isfinite(body.velocity.y) &&
                              std::isfinite(body.spin);
        if (isUsable)
        {
            sorted.push_back(&body);
        }
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const PageBody* a, const PageBody* b) { return a->number < b->number; });
    sorted.erase(
        std::unique(sorted.begin(), sorted.end(),
                    [](const PageBody* a, const PageBody* b) { return a->number == b->number; }),
        sorted.end());
    std::vector<BodyTrack> tracks;
    std::size_t old = 0;
    for (const PageBody* body : sorted)
    {
        for (; old < m_bodies.size() && m_bodies[old].owner < body->number; ++old)
        {}
        const auto shape = shapes.find(body->number);
        const auto place = PlaceOfShape(shape != shapes.end() ? shape->second : nullptr, *body);
        const bool isKept = m_frames > 0 && old < m_bodies.size() &&
                            m_bodies[old].owner == body->number && m_bodies[old].hasPlace == !place;
        BodyTrack track = isKept ? m_bodies[old] : BodyTrack();
        track.owner = body->number;
        track.hasPlace = !place;
        track.form = m_forms.AddBody(track.hasPlace);
        PlaceBody(track, *body, place, isKept ? &m_bodies[old] : nullptr);
        m_from.push_back(isKept ? std::ptrdiff_t(tracksBefore + old) : -1);
        tracks.push_back(std::move(track));
    }
    m_bodies = std::move(tracks);
}

/// Returns what a track is, with those of bodies behind those of the list.
PageEncoder::NewTrack PageEncoder::TrackAt(std::size_t index) const
{
    if (index >= m_tracks.size())
    {
        const BodyTrack& body = m_bodies[index - m_tracks.size()];
        return {body.form, 0, body.owner};
    }
    const Track& track = m_tracks[index];
    return {track.form, track.run.style, track.run.owner};
}

/// How the tracks of the frame before become those of this one: "keep, end, begin" by turns.
void PageEncoder::PutSequence(std::size_t before)
{
    std::string turns;
    std::uint64_t count = 0;
    std::size_t old = 0;
    for (std::size_t i = 0; i < m_from.size() || old < before;)
    {
        std::size_t kept = 0;
        for (; i < m_from.size() && m_from[i] == std::ptrdiff_t(old); ++i, ++old, ++kept)
        {}
        std::size_t end = i;
        for (; end < m_from.size() && m_from[end] < 0; ++end)
        {}
        const std::size_t next = end < m_from.size() ? std::size_t(m_from[end]) : before;
        if (next == old && end == i)
        {
            break; // all that follow are kept
        }
        PutVarint(turns, kept);
        PutVarint(turns, next - old);
        PutVarint(turns, end - i);
        for (; i < end; ++i)
        {
            const NewTrack track = TrackAt(i);
            PutVarint(turns, track.form);
            PutVarint(turns, track.style);
            PutVarint(turns, track.owner == kNoOwner ? 0 : std::uint64_t(track.owner) + 1);
        }
        old = next;
        ++count;
    }
    PutVarint(m_sequence, count);
    m_sequence += turns;
}

/// Those that have another style than in the frame before, `before` by index there.
void PageEncoder::PutStyles(std::span<const std::uint32_t> before)
{
    std::string changes;
    std::uint64_t count = 0;
    std::size_t last = 0;
    for (std::size_t i = 0; i < m_tracks.size(); ++i)
    {
        const std::uint32_t style = m_tracks[i].run.style;
        if (m_from[i] >= 0 && before[std::size_t(m_from[i])] != style)
        {
            PutVarint(changes, i - last);
            PutVarint(changes, style);
            last = i;
            ++count;
        }
    }
    PutVarint(m_sequence, count);
    m_sequence += changes;
}

void PageEncoder::Add(const DrawList& list, const Camera& camera, std::span<const PageBody> bodies)
{
    std::vector<std::uint32_t> styles;
    for (const Track& track : m_tracks)
    {
        styles.push_back(track.run.style);
    }
    const std::size_t before = styles.size() + m_bodies.size();
    const std::size_t tracksBefore = styles.size();
    Follow(list, camera, bodies);
    FollowBodies(bodies, tracksBefore);
    if (m_frames == 0) // a group can be read without those before it
    {
        styles.clear();
        m_from.assign(m_from.size(), -1);
    }
    PutSequence(m_frames == 0 ? 0 : before);
    PutStyles(styles);
    PutView(camera);
    for (std::size_t i = 0; i < m_tracks.size(); ++i)
    {
        Track& track = m_tracks[i];
        if (m_from[i] < 0)
        {
            track.predictors.assign(track.numbers.size(), Predictor{});
        }
        for (std::size_t k = 0; k < track.numbers.size(); ++k)
        {
            const auto column = track.isRigid ? ColumnOf(RigidX + k) : ColumnOf(LooseX + k % 2);
            Put(column, track.predictors[k], track.numbers[k]);
        }
    }
    for (std::size_t i = 0; i < m_bodies.size(); ++i)
    {
        PutBody(m_bodies[i]);
    }
    ++m_frames;
}

void PageEncoder::PutBody(BodyTrack& track)
{
    for (std::size_t k = 0; track.hasPlace && k < track.numbers.size(); ++k)
    {
        Put(ColumnOf(RigidX + k), track.predictors[k], track.numbers[k]);
    }
    for (std::size_t k = 0; k < track.velocities.size(); ++k)
    {
        m_columns[VelocityX + k].Put(track.velocities[k]);
    }
}

} // namespace boxreel
