// SPDX-License-Identifier: MIT
#pragma once

#include "JointFrame.h"

/// The effect of a joint on its bodies in sub-steps, as rows of a linear system. Each row has its
/// derivative J by the velocities of the bodies. Rigid rows come first, with an error C at the
/// present pose whose rate is J v. Motors, limits, springs and friction follow as bounded rows,
/// each with its own law. The impulses change the velocities by M^-1 J^T lambda.
namespace box2d
{

struct JointRows
{
    static constexpr int32 kMaxRows = 3;
    static constexpr int32 kMaxBodies = 4; ///< a gear has four

    /// Derivatives of each row by one body's velocity and angular velocity.
    struct Column
    {
        const BodyData* data = nullptr;
        int32 body = 0; ///< solver index
        float32 invMass = 0.0f, invInertia = 0.0f;
        float32 x[kMaxRows] = {}, y[kMaxRows] = {}, w[kMaxRows] = {};
        float32 reach = 0.0f; ///< for a line: from the centre of mass to its end, along it [m]

        /// Returns the part of the response of a row's speed to an impulse along it.
        float32 InverseMassOf(int32 row) const
        {
            return invMass * (x[row] * x[row] + y[row] * y[row]) + invInertia * w[row] * w[row];
        }
        void AddTo(int32 row, const b2Vec2& direction, float32 lever)
        {
            x[row] += direction.x;
            y[row] += direction.y;
            w[row] += lever;
        }
    };

    /// Returns the column of a body; a body that is used twice has one.
    Column& Of(const BodyData& body)
    {
        for (int32 i = 0; i < bodies; ++i)
        {
            if (columns[i].data == &body)
            {
                return columns[i];
            }
        }
        Column& column = columns[bodies++];
        column = Column();
        column.data = &body;
        column.body = body.SolverIndex();
        column.invMass = body.SolverInvMass();
        column.invInertia = body.SolverInvInertia();
        return column;
    }

    /// The law of a bounded row. Its target speed is `wanted` - softness * impulse, with an impulse
    /// of at most `maximum`. Independent of the impulse, the speed is between `slowest` and
    /// `fastest`.
    struct Law
    {
        float32 wanted = 0.0f;   ///< [m/s] or [rad/s]
        float32 softness = 0.0f; ///< [1/kg] or [1/(kg m^2)]
        float32 maximum = b2_maxFloat;
        float32 slowest = -b2_maxFloat, fastest = b2_maxFloat;

        bool IsLimited() const { return slowest > -b2_maxFloat || fastest < b2_maxFloat; }
        /// True beyond a limit, or where the speed towards it is bounded by `speed` at most.
        bool IsNear(float32 speed) const { return slowest >= -speed || fastest <= speed; }
        /// True if a motor pushes against its limit with its maximum force.
        bool DrivesBelow() const { return wanted < slowest - kSameSpeed; }
        bool DrivesAbove() const { return wanted > fastest + kSameSpeed; }
        /// Returns the motor's part of an impulse, which also contains the limit's.
        float32 Within(float32 all) const
        {
            return DrivesBelow()   ? -maximum
                   : DrivesAbove() ? maximum
                                   : b2Clamp(all, -maximum, maximum);
        }
    };
    /// Tolerance of speeds [m/s], [rad/s]: rounding must not release a limit. Speeds of 100 m/s are
    /// rounded by as much. With 1e-3 a body at a limit keeps 1 mrad/s, with 1e-7 no test fails.
    static constexpr float32 kSameSpeed = 1e-5f;

    int32 Rigid() const { return rows - boundedRows; }
    /// True if the row has a motor, a spring, or friction in addition to a limit.
    bool IsDriven() const
    {
        return std::any_of(laws + Rigid(), laws + rows,
                           [](const Law& law) { return law.maximum > 0.0f; });
    }

    /// Resets the rows at low cost: columns are cleared when they are added.
    void Clear()
    {
        std::fill_n(laws, kMaxRows, Law()); // contacts and rigid rows may be soft, too
        rows = boundedRows = bodies = 0;
        point = disc = false;
        length = 0.0f;
        std::fill_n(error, kMaxRows, 0.0f);
        std::fill_n(impulse, kMaxRows, 0.0f);
    }
    /// Returns the largest error of a rigid row [m], [rad].
    float32 WidestGap() const
    {
        float32 widest = 0.0f;
        for (int32 k = 0; k < Rigid(); ++k)
        {
            widest = b2Max(widest, b2Abs(error[k]));
        }
        return widest;
    }
    void SetImpulse(const float32 (&value)[kMaxRows]) { std::copy_n(value, kMaxRows, impulse); }

    int32 rows = 0;        ///< 0 to 3; the remaining array elements are zero
    int32 boundedRows = 0; ///< number of bounded rows, the last ones
    bool point = false;    ///< the first two rows hold a point
    /// The first two rows are bounded together: `maximum` limits the length of both impulses.
    bool disc = false;
    float32 length = 0.0f; ///< length of the line for the first row
    int32 bodies = 0;      ///< number of columns
    Column columns[kMaxBodies];
    Law laws[kMaxRows];
    float32 error[kMaxRows] = {};   ///< [m] or [rad], of rigid rows and beyond limits, or zero
    float32 impulse[kMaxRows] = {}; ///< [Ns] or [Nms]
};

/// A joint's frame with its rows.
struct RowFiller
{
    RowFiller(const b2Body& bodyA, const b2Body& bodyB, const SolverContext& stepContext,
              JointRows& into)
        : f(bodyA, bodyB, stepContext), context(stepContext), rows(into), a(rows.Of(f.dataA)),
          b(rows.Of(f.dataB))
    {}

    /// Adds a row that holds the points together perpendicular to the axis.
    JointPair::Slide AddSlide(const b2Vec2& localAnchorA, const b2Vec2& localAnchorB,
                              const b2Vec2& localAxisA)
    {
        const JointPair::Slide slide = f.Along(localAxisA, localAnchorA, localAnchorB);
        const b2Vec2 across = b2Cross(1.0f, slide.axis);
        AddAlong(across, slide.reachA, slide.armB, b2Dot(across, slide.reachA - slide.armA));
        return slide;
    }

    /// Adds a row that holds two points along a unit vector. `reachA` goes from the centre of mass
    /// A to B's point if the direction rotates with A, otherwise to A's own point.
    void AddAlong(const b2Vec2& direction, const b2Vec2& reachA, const b2Vec2& armB, float32 error)
    {
        a.AddTo(rows.rows, -direction, -b2Cross(reachA, direction));
        b.AddTo(rows.rows, direction, b2Cross(armB, direction));
        rows.error[rows.rows++] = error;
    }
    /// Adds the first row, along a line between two points.
    void AddLine(const JointFrame::Line& line, float32 error)
    {
        AddAlong(line.axis, line.armA, line.armB, error);
        rows.length = line.length;
        a.reach = b2Dot(line.armA, line.axis);
        b.reach = -b2Dot(line.armB, line.axis);
    }
    /// Adds the first two rows, which hold two points together.
    void AddPoint(const b2Vec2& localAnchorA, const b2Vec2& localAnchorB)
    {
        const b2Vec2 armA = f.ArmA(localAnchorA);
        const b2Vec2 armB = f.ArmB(localAnchorB);
        const b2Vec2 error = f.Offset() + armB - armA;
        rows.point = true;
        AddAlong(b2Vec2(1.0f, 0.0f), armA, armB, error.x);
        AddAlong(b2Vec2(0.0f, 1.0f), armA, armB, error.y);
    }
    /// Adds a row that holds the relative angle.
    void AddAngle(float32 error)
    {
        a.AddTo(rows.rows, b2Vec2(0.0f, 0.0f), -1.0f);
        b.AddTo(rows.rows, b2Vec2(0.0f, 0.0f), 1.0f);
        rows.error[rows.rows++] = error;
    }

    // The following make the last row a bounded one.

    JointRows::Law& Give()
    {
        ++rows.boundedRows;
        return rows.laws[rows.rows - 1];
    }
    void GiveToMotor(float32 speed, float32 maxForce)
    {
        JointRows::Law& law = Give();
        law.wanted = speed;
        law.maximum = context.timeStep * maxForce;
    }
    /// Call after a motor, which may have no force. The largest number means no limit on that side.
    void GiveToLimit(float32 place, float32 lower, float32 upper)
    {
        JointRows::Law& law = rows.laws[rows.rows - 1];
        law.slowest = lower > -b2_maxFloat ? -SpeedTowards(place - lower) : -b2_maxFloat;
        law.fastest = upper < b2_maxFloat ? SpeedTowards(upper - place) : b2_maxFloat;
        rows.error[rows.rows - 1] = place - b2Clamp(place, lower, upper);
    }
    /// Adds a row for the angle to the two for the point.
    void GiveToFriction(float32 maxForce, float32 maxTorque)
    {
        AddAngle(0.0f);
        rows.boundedRows = rows.rows;
        rows.disc = true;
        rows.error[0] = rows.error[1] = 0.0f; // only speeds matter
        rows.laws[0].maximum = rows.laws[1].maximum = context.timeStep * maxForce;
        rows.laws[2].maximum = context.timeStep * maxTorque;
    }
    /// Uses the oscillator with the mass 1 / `inverseMass`, or with the effective mass of the row.
    void GiveToSpring(float32 error, float32 frequencyHz, float32 dampingRatio)
    {
        GiveToSpring(error, frequencyHz, dampingRatio, InverseMassOf(rows.rows - 1));
    }
    void GiveToSpring(float32 error, float32 frequencyHz, float32 dampingRatio,
                      float32 inverseMass);
    /// Returns the maximum approach speed for a limit at a distance: it is reached in the drift.
    /// Beyond the limit (negative) the body stops. JointSystem moves it back by its pose: it would
    /// keep the speed of its return.
    float32 SpeedTowards(float32 distance) const
    {
        return b2Max(distance, 0.0f) * context.inverseStep;
    }

    /// Returns the response of a row's speed to an impulse along it.
    float32 InverseMassOf(int32 row) const { return a.InverseMassOf(row) + b.InverseMassOf(row); }
    float32 SpeedOf(int32 row) const
    {
        const auto of = [row](const JointRows::Column& c, const SolverBody& body) {
            return c.x[row] * body.v.x + c.y[row] * body.v.y + c.w[row] * body.w;
        };
        return of(a, f.a) + of(b, f.b);
    }

    JointFrame f;
    const SolverContext& context;
    JointRows& rows;
    JointRows::Column& a;
    JointRows::Column& b;
};

/// A spring k and a damper c act in the kick of duration t before a drift of h. At either end of a
/// step t is h / 2. With the speeds u before and v after the kick:
///   impulse = -t k C - h^2 k / 4 (v - u) - t c (p v + (1 - p) u)
/// The first two terms are Newmark's method with beta = 1/4 (1959; Hairer, Lubich, Wanner,
/// "Geometric Numerical Integration", 2006, XIII.8). It is of second order and conserves a spring's
/// energy. It is stable for any frequency f, which is too low by the fraction (2 pi f h)^2 / 12.
/// Let z = t c / m and p = (1 + z) / (2 + z). A damper alone then reduces the speed by
/// 1 / (1 + z + z^2 / 2), the Pade approximant (0, 2) of exp(-z).
/// If h does not resolve the spring, c is multiplied by sqrt(1 + (h omega / 4)^2), because stiff
/// springs would ring. Periods below two drifts count as two drifts.
inline void RowFiller::GiveToSpring(float32 error, float32 frequencyHz, float32 dampingRatio,
                                    float32 inverseMass)
{
    JointRows::Law& law = Give();
    rows.error[rows.rows - 1] = 0.0f;
    if (inverseMass <= 0.0f || frequencyHz <= 0.0f)
    {
        law.maximum = 0.0f;
        return;
    }
    const float32 t = context.timeStep;
    const float32 omega = b2_pi * b2Min(2.0f * frequencyHz, context.inverseStep);
    const float32 turn = omega / context.inverseStep;
    const float32 mass = 1.0f / inverseMass;
    const float32 z = 2.0f * dampingRatio * omega * t * b2Sqrt(1.0f + turn * turn / 16.0f);
    const float32 p = (1.0f + z) / (2.0f + z);
    const float32 inertia = 0.25f * turn * turn * mass; // h^2 k / 4
    const float32 sum = inertia + p * z * mass;
    const float32 before = SpeedOf(rows.rows - 1);
    law.softness = 1.0f / sum;
    law.wanted =
        ((inertia - (1.0f - p) * z * mass) * before - t * mass * omega * omega * error) / sum;
}

} // namespace box2d
