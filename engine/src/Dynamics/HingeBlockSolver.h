// SPDX-License-Identifier: MIT
#pragma once

#include "HingeBlocks.h"

#include "BodyLanes.h"

/// The revolute joint on blocks, for numbers F of 4 or 8 lanes: b2RevoluteJoint.cpp line by line,
/// in the same order of operations. Included by one source for each instruction set; nothing in it
/// has external linkage.
namespace box2d
{
namespace
{

/// What the velocity and the position side have in common.
template <class F>
struct HingeLanes
{
    const HingeBlock& block;
    int lane; // the first
    F invMassA, invInertiaA, invMassB, invInertiaB;

    HingeLanes(const HingeBlock& from, int first) : block(from), lane(first)
    {
        invMassA = At(block.invMassA);
        invInertiaA = At(block.invInertiaA);
        invMassB = At(block.invMassB);
        invInertiaB = At(block.invInertiaB);
    }

    F At(const float32* field) const { return F::Load(field + lane); }
    Vector<F> At(const float32* x, const float32* y) const { return {At(x), At(y)}; }
    auto IsSet(const float32* field) const { return AtLeast(At(field), F::Set(1.0f)); }
    static F Clamp(F value, F low, F high) { return Max(low, Min(value, high)); }

    struct Matrix
    {
        F k11, k12, k22;
    };
    /// See PointMatrix.
    Matrix PointMatrix(const Vector<F>& armA, const Vector<F>& armB) const
    {
        const F mass = invMassA + invMassB;
        return {mass + invInertiaA * armA.y * armA.y + invInertiaB * armB.y * armB.y,
                -invInertiaA * armA.x * armA.y - invInertiaB * armB.x * armB.y,
                mass + invInertiaA * armA.x * armA.x + invInertiaB * armB.x * armB.x};
    }
    static F InverseDeterminant(const Matrix& m)
    {
        const F zero = F::Set(0.0f);
        const F one = F::Set(1.0f);
        const F determinant = m.k11 * m.k22 - m.k12 * m.k12;
        const auto singular = And(AtLeast(determinant, zero), AtLeast(zero, determinant));
        return Select(singular, zero, one / Select(singular, one, determinant));
    }
    static Vector<F> Solve(const Matrix& m, F inverse, const Vector<F>& b)
    {
        return {inverse * (b.x * m.k22 - b.y * m.k12), inverse * (m.k11 * b.y - m.k12 * b.x)};
    }
};

template <class F>
struct HingeVelocities : HingeLanes<F>
{
    using Base = HingeLanes<F>;
    using Base::At;
    using Base::block;
    using Base::lane;
    HingeBlock& to;
    F a[4], b[4]; // vx, vy, w; the angle is along for the ride

    HingeVelocities(HingeBlock& from, int first, const float32* bodies)
        : Base(from, first), to(from)
    {
        LoadRows(bodies, kBodyStride, block.bodyA + lane, a);
        LoadRows(bodies, kBodyStride, block.bodyB + lane, b);
    }
    void Store(float32* bodies) const
    {
        StoreMoved(bodies, block.bodyA + lane, uint32(block.movesA) >> lane, a);
        StoreMoved(bodies, block.bodyB + lane, uint32(block.movesB) >> lane, b);
    }

    void Apply(const Vector<F>& impulse, const Vector<F>& armA, const Vector<F>& armB)
    {
        a[0] = a[0] - this->invMassA * impulse.x;
        a[1] = a[1] - this->invMassA * impulse.y;
        a[2] = a[2] - this->invInertiaA * Cross(armA, impulse);
        b[0] = b[0] + this->invMassB * impulse.x;
        b[1] = b[1] + this->invMassB * impulse.y;
        b[2] = b[2] + this->invInertiaB * Cross(armB, impulse);
    }
    template <class M>
    void ApplyAngular(M active, F impulse)
    {
        a[2] = Select(active, a[2] - this->invInertiaA * impulse, a[2]);
        b[2] = Select(active, b[2] + this->invInertiaB * impulse, b[2]);
    }

    void WarmStart()
    {
        Apply(At(block.impulseX, block.impulseY), At(block.armAX, block.armAY),
              At(block.armBX, block.armBY));
        F axial = F::Set(0.0f);
        if (block.axial)
        {
            axial = At(block.motorImpulse) + At(block.lowerImpulse) - At(block.upperImpulse);
        }
        a[2] = a[2] - this->invInertiaA * axial;
        b[2] = b[2] + this->invInertiaB * axial;
    }

    void SolveMotor()
    {
        const auto active = this->IsSet(block.hasMotor);
        const F limit = At(block.motorLimit);
        const F old = At(block.motorImpulse);
        const F speed = b[2] - a[2] - At(block.motorSpeed);
        const F total = Base::Clamp(old - At(block.axialMass) * speed, -limit, limit);
        ApplyAngular(active, total - old);
        Select(active, total, old).Store(to.motorImpulse + lane);
    }

    void SolveLimits()
    {
        const auto active = this->IsSet(block.hasLimits);
        const F zero = F::Set(0.0f);
        const F mass = At(block.axialMass);
        const F oldLower = At(block.lowerImpulse);
        const F lower = Max(oldLower - mass * (b[2] - a[2] + At(block.lowerSpeed)), zero);
        ApplyAngular(active, lower - oldLower);
        Select(active, lower, oldLower).Store(to.lowerImpulse + lane);
        const F oldUpper = At(block.upperImpulse);
        const F upper = Max(oldUpper - mass * (a[2] - b[2] + At(block.upperSpeed)), zero);
        ApplyAngular(active, oldUpper - upper);
        Select(active, upper, oldUpper).Store(to.upperImpulse + lane);
    }

    void SolvePoint()
    {
        const Vector<F> armA = At(block.armAX, block.armAY);
        const Vector<F> armB = At(block.armBX, block.armBY);
        const Vector<F> speed = {b[0] - b[2] * armB.y - a[0] + a[2] * armA.y,
                                 b[1] + b[2] * armB.x - a[1] - a[2] * armA.x};
        const typename Base::Matrix matrix = {At(block.k11), At(block.k12), At(block.k22)};
        const Vector<F> impulse = Base::Solve(matrix, At(block.inverse), {-speed.x, -speed.y});
        (At(block.impulseX) + impulse.x).Store(to.impulseX + lane);
        (At(block.impulseY) + impulse.y).Store(to.impulseY + lane);
        Apply(impulse, armA, armB);
    }
};

template <class F>
struct HingePositions : HingeLanes<F>
{
    using Base = HingeLanes<F>;
    using Base::At;
    using Base::block;
    using Base::lane;
    F a[4], b[4];           // moved by (0, 1), turned by sine 2 and cosine 3
    F speedA[4], speedB[4]; // whose last is the angle

    HingePositions(const HingeBlock& from, int first, const float32* bodies) : Base(from, first)
    {
        LoadRows(bodies, kBodyStride, block.bodyA + lane, speedA);
        LoadRows(bodies, kBodyStride, block.bodyB + lane, speedB);
        LoadRows(bodies + 4, kBodyStride, block.bodyA + lane, a);
        LoadRows(bodies + 4, kBodyStride, block.bodyB + lane, b);
    }
    void Store(float32* bodies) const
    {
        StoreMoved(bodies, block.bodyA + lane, uint32(block.movesA) >> lane, speedA);
        StoreMoved(bodies, block.bodyB + lane, uint32(block.movesB) >> lane, speedB);
        StoreMoved(bodies + 4, block.bodyA + lane, uint32(block.movesA) >> lane, a);
        StoreMoved(bodies + 4, block.bodyB + lane, uint32(block.movesB) >> lane, b);
    }

    static Vector<F> Turn(const F (&body)[4], const Vector<F>& v)
    {
        return {body[3] * v.x - body[2] * v.y, body[2] * v.x + body[3] * v.y};
    }

    /// A body that cannot be turned, or a lane that is not active, keeps its bits.
    template <class M>
    static void Rotate(F (&body)[4], F& angle, F invInertia, M active, F delta)
    {
        const auto turns = And(active, Not(AtLeast(F::Set(0.0f), invInertia)));
        const F s = body[2] + delta * body[3];
        const F c = body[3] - delta * body[2];
        const F inverseLength = F::Set(1.0f) / Sqrt(s * s + c * c);
        body[2] = Select(turns, s * inverseLength, body[2]);
        body[3] = Select(turns, c * inverseLength, body[3]);
        angle = Select(turns, angle + delta, angle);
    }

    /// Returns the error [rad].
    F SolveLimits()
    {
        const auto active = this->IsSet(block.hasLimits);
        const F most = F::Set(b2_maxAngularCorrection);
        const F angle = At(block.angle) + speedB[3] - speedA[3];
        const F inside = Base::Clamp(angle, At(block.lower), At(block.upper));
        const F error = Max(angle - inside, inside - angle);
        const F impulse = At(block.axialMass) * Base::Clamp(inside - angle, -most, most);
        Rotate(a, speedA[3], this->invInertiaA, active, -this->invInertiaA * impulse);
        Rotate(b, speedB[3], this->invInertiaB, active, this->invInertiaB * impulse);
        return Select(active, error, F::Set(0.0f));
    }

    /// Returns the error [m].
    F SolvePoint()
    {
        const F zero = F::Set(0.0f);
        const auto all = AtLeast(zero, zero);
        const Vector<F> armA = Turn(a, At(block.armAX, block.armAY));
        const Vector<F> armB = Turn(b, At(block.armBX, block.armBY));
        const Vector<F> error = {At(block.offsetX) + b[0] - a[0] + armB.x - armA.x,
                                 At(block.offsetY) + b[1] - a[1] + armB.y - armA.y};
        const typename Base::Matrix matrix = this->PointMatrix(armA, armB);
        const Vector<F> impulse =
            Base::Solve(matrix, Base::InverseDeterminant(matrix), {-error.x, -error.y});
        a[0] = a[0] - this->invMassA * impulse.x;
        a[1] = a[1] - this->invMassA * impulse.y;
        Rotate(a, speedA[3], this->invInertiaA, all, -this->invInertiaA * Cross(armA, impulse));
        b[0] = b[0] + this->invMassB * impulse.x;
        b[1] = b[1] + this->invMassB * impulse.y;
        Rotate(b, speedB[3], this->invInertiaB, all, this->invInertiaB * Cross(armB, impulse));
        return Sqrt(error.x * error.x + error.y * error.y);
    }
};

template <class F>
void PrepareHingeMatrix(HingeBlock& block)
{
    for (int lane = 0; lane < block.count; lane += F::kLanes)
    {
        const HingeLanes<F> lanes(block, lane);
        const auto m = lanes.PointMatrix(lanes.At(block.armAX, block.armAY),
                                         lanes.At(block.armBX, block.armBY));
        m.k11.Store(block.k11 + lane);
        m.k12.Store(block.k12 + lane);
        m.k22.Store(block.k22 + lane);
        HingeLanes<F>::InverseDeterminant(m).Store(block.inverse + lane);
    }
}

template <class F>
void WarmStartHingeBlock(HingeBlock& block, float32* bodies)
{
    for (int lane = 0; lane < block.count; lane += F::kLanes)
    {
        HingeVelocities<F> solver(block, lane, bodies);
        solver.WarmStart();
        solver.Store(bodies);
    }
}

template <class F>
void SolveHingeBlockVelocities(HingeBlock& block, float32* bodies)
{
    for (int lane = 0; lane < block.count; lane += F::kLanes)
    {
        HingeVelocities<F> solver(block, lane, bodies);
        if (block.axial)
        {
            solver.SolveMotor();
            solver.SolveLimits();
        }
        solver.SolvePoint();
        solver.Store(bodies);
    }
}

template <class F>
bool SolveHingeBlockPositions(const HingeBlock& block, float32* bodies)
{
    bool joined = true;
    for (int lane = 0; lane < block.count; lane += F::kLanes)
    {
        HingePositions<F> solver(block, lane, bodies);
        F angularError = F::Set(0.0f);
        if (block.axial)
        {
            angularError = solver.SolveLimits();
        }
        const F error = solver.SolvePoint();
        solver.Store(bodies);
        joined = joined && !Any(Not(And(AtLeast(F::Set(b2_linearSlop), error),
                                        AtLeast(F::Set(b2_angularSlop), angularError))));
    }
    return joined;
}

} // namespace
} // namespace box2d
