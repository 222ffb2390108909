// SPDX-License-Identifier: MIT
#include <Box2D/Common/b2Draw.h>
#include <Box2D/Rope/b2Rope.h>

namespace
{

/// Shorter steps do nothing, longer ones are clamped [s]: their inverses and squares would exceed
/// single precision.
constexpr float32 kShortestStep = 1e-9f;
constexpr float32 kLongestStep = 1e6f;

/// Returns the angle from one direction to the next, counter-clockwise [rad].
float32 BendAngle(const b2Vec2& d1, const b2Vec2& d2)
{
    return b2Atan2(b2Cross(d1, d2), b2Dot(d1, d2));
}

bool IsUsable(const b2RopeDef& def)
{
    bool isUsable =
        B2_REQUIRE(def.count >= 3, "A rope needs at least 3 vertices.") &&
        B2_REQUIRE(def.vertices != nullptr, "A rope's definition needs vertices.") &&
        B2_REQUIRE(def.masses != nullptr, "A rope's definition needs a mass for every vertex.") &&
        B2_REQUIRE(def.gravity.IsValid(), "A rope's gravity must be finite.") &&
        B2_REQUIRE(def.damping >= 0.0f && b2IsValid(def.damping),
                   "A rope's damping must be finite and not negative.") &&
        B2_REQUIRE(0.0f <= def.k2 && def.k2 <= 1.0f && 0.0f <= def.k3 && def.k3 <= 1.0f,
                   "A rope's stiffnesses k2 and k3 must be from 0 to 1.");
    for (int32 i = 0; isUsable && i < def.count; ++i)
    {
        isUsable = B2_REQUIRE(def.vertices[i].IsValid(), "A rope's vertices must be finite.") &&
                   B2_REQUIRE(def.masses[i] >= 0.0f && b2IsValid(def.masses[i]),
                              "A rope's masses must be finite and not negative.");
    }
    return isUsable;
}

} // namespace

void b2Rope::Initialize(const b2RopeDef* def)
{
    m_points.clear();
    m_positions.clear();
    m_lengths.clear();
    m_angles.clear();
    if (!B2_REQUIRE(def != nullptr, "A rope needs a definition.") || !IsUsable(*def))
    {
        return;
    }
    m_positions.assign(def->vertices, def->vertices + def->count);
    for (int32 i = 0; i < def->count; ++i)
    {
        const float32 mass = def->masses[i];
        m_points.push_back({m_positions[i], b2Vec2(), mass > 0.0f ? 1.0f / mass : 0.0f});
    }
    for (int32 i = 0; i + 1 < def->count; ++i)
    {
        m_lengths.push_back(b2Distance(m_positions[i], m_positions[i + 1]));
    }
    for (int32 i = 0; i + 2 < def->count; ++i)
    {
        m_angles.push_back(BendAngle(m_positions[i + 1] - m_positions[i],
                                     m_positions[i + 2] - m_positions[i + 1]));
    }
    m_gravity = def->gravity;
    m_damping = def->damping;
    m_stretchStiffness = def->k2;
    m_bendStiffness = def->k3;
}

void b2Rope::Step(float32 timeStep, int32 iterations)
{
    if (!B2_REQUIRE(timeStep >= 0.0f && b2IsValid(timeStep),
                    "A rope's time step must be finite and not negative.") ||
        timeStep < kShortestStep)
    {
        return;
    }
    timeStep = b2Min(timeStep, kLongestStep);
    // Implicit, so that any damping is stable.
    const float32 kept = 1.0f / (1.0f + timeStep * m_damping);
    for (std::size_t i = 0; i < m_points.size(); ++i)
    {
        Point& point = m_points[i];
        point.before = m_positions[i];
        if (point.inverseMass > 0.0f)
        {
            point.velocity = kept * (point.velocity + timeStep * m_gravity);
        }
        m_positions[i] += timeStep * point.velocity;
    }
    for (int32 i = 0; i < iterations; ++i)
    {
        SolveStretch();
        SolveBends();
        SolveStretch(); // last, because a stretch is more visible than a bend
    }
    for (std::size_t i = 0; i < m_points.size(); ++i)
    {
        m_points[i].velocity = (1.0f / timeStep) * (m_positions[i] - m_points[i].before);
        // Points that became non-finite stop.
        if (!m_positions[i].IsValid() || !m_points[i].velocity.IsValid())
        {
            m_positions[i] = m_points[i].before;
            m_points[i].velocity.SetZero();
        }
    }
}

void b2Rope::SolveStretch()
{
    for (std::size_t i = 0; i < m_lengths.size(); ++i)
    {
        const float32 mass1 = m_points[i].inverseMass;
        const float32 mass2 = m_points[i + 1].inverseMass;
        b2Vec2 direction = m_positions[i + 1] - m_positions[i];
        const float32 length = direction.Normalize();
        if (mass1 + mass2 > 0.0f)
        {
            const float32 share = m_stretchStiffness * (length - m_lengths[i]) / (mass1 + mass2);
            m_positions[i] += mass1 * share * direction;
            m_positions[i + 1] -= mass2 * share * direction;
        }
    }
}

// The gradient of the angle at each point follows from that of a direction's angle: the direction
// rotated left, divided by its squared length.
void b2Rope::SolveBends()
{
    for (std::size_t i = 0; i < m_angles.size(); ++i)
    {
        const b2Vec2 d1 = m_positions[i + 1] - m_positions[i];
        const b2Vec2 d2 = m_positions[i + 2] - m_positions[i + 1];
        const float32 squared1 = d1.LengthSquared();
        const float32 squared2 = d2.LengthSquared();
        if (squared1 * squared2 == 0.0f)
        {
            continue; // no direction, no angle
        }
        const b2Vec2 gradient1 = (1.0f / squared1) * d1.Skew();
        const b2Vec2 gradient3 = (1.0f / squared2) * d2.Skew();
        const b2Vec2 gradient2 = -(gradient1 + gradient3);
        const float32 mass1 = m_points[i].inverseMass;
        const float32 mass2 = m_points[i + 1].inverseMass;
        const float32 mass3 = m_points[i + 2].inverseMass;
        const float32 sum = mass1 * gradient1.LengthSquared() + mass2 * gradient2.LengthSquared() +
                            mass3 * gradient3.LengthSquared();
        if (sum == 0.0f)
        {
            continue;
        }
        float32 error = BendAngle(d1, d2) - m_angles[i];
        error -= error > b2_pi ? 2.0f * b2_pi : 0.0f; // the shorter rotation
        error += error < -b2_pi ? 2.0f * b2_pi : 0.0f;
        const float32 share = -m_bendStiffness * error / sum;
        m_positions[i] += mass1 * share * gradient1;
        m_positions[i + 1] += mass2 * share * gradient2;
        m_positions[i + 2] += mass3 * share * gradient3;
    }
}

void b2Rope::Draw(b2Draw* draw) const
{
    const b2Color color(0.4f, 0.5f, 0.7f);
    for (std::size_t i = 0; i + 1 < m_positions.size(); ++i)
    {
        draw->DrawSegment(m_positions[i], m_positions[i + 1], color);
    }
}

void b2Rope::SetAngle(float32 angle)
{
    if (B2_REQUIRE(b2IsValid(angle), "A rope's angle must be finite."))
    {
        m_angles.assign(m_angles.size(), angle);
    }
}
