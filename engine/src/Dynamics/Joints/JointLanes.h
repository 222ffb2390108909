// SPDX-License-Identifier: MIT
#pragma once

#include "../State/BodyLanes.h"
#include "JointBlocks.h"

#include <type_traits>
#include <utility>

/// Common parts of the lanes of all joint types. These are the two bodies of each lane, with
/// velocities or poses, and the matrices of a point and of a direction. For numbers F of 1, 4 or 8
/// lanes. It has no external linkage, because sources of every instruction set include it.
namespace box2d
{
namespace
{

/// Inverse masses and inertias of a lane's bodies, the first numbers of a block [1/kg], [1/(kg
/// m^2)].
template <class F>
struct PairMasses
{
    F mA, iA, mB, iB;

    /// False for unused lanes.
    auto CanMove() const { return Not(AtLeast(F::Set(0.0f), mA + iA + mB + iB)); }

    /// K with  d(vB - vA at the point) = K impulse:  (mA + mB) E - iA [rA][rA] - iB [rB][rB],  [r]
    /// the cross-product matrix of r.
    struct Matrix
    {
        F k11, k12, k22;

        BOX2D_INLINE Vector<F> operator*(const Vector<F>& v) const
        {
            return {k11 * v.x + k12 * v.y, k12 * v.x + k22 * v.y};
        }
        /// Zero where it is singular.
        BOX2D_INLINE Vector<F> Solve(const Vector<F>& b) const
        {
            const F scale = InverseUnlessZero(Determinant());
            return {scale * (b.x * k22 - b.y * k12), scale * (k11 * b.y - k12 * b.x)};
        }
        F Determinant() const { return k11 * k22 - k12 * k12; }
        /// Zero where it is singular.
        BOX2D_INLINE Matrix Inverse() const
        {
            const F scale = InverseUnlessZero(Determinant());
            return {scale * k22, -(scale * k12), scale * k11};
        }
    };
    BOX2D_INLINE Matrix PointMatrix(const Vector<F>& armA, const Vector<F>& armB) const
    {
        const F mass = mA + mB;
        return {mass + iA * armA.y * armA.y + iB * armB.y * armB.y,
                -iA * armA.x * armA.y - iB * armB.x * armB.y,
                mass + iA * armA.x * armA.x + iB * armB.x * armB.x};
    }
    /// Along a direction with these moments about the centres.
    BOX2D_INLINE F AxisMatrix(F leverA, F leverB) const
    {
        return mA + mB + iA * leverA * leverA + iB * leverB * leverB;
    }
    BOX2D_INLINE F AxisMatrix(const Vector<F>& axis, const Vector<F>& armA,
                              const Vector<F>& armB) const
    {
        return AxisMatrix(Cross(armA, axis), Cross(armB, axis));
    }
};

/// A row that may be inactive, a motor or a limit, combined with two rows that are always active
/// (their Schur complement). An impulse along this row is applied with the impulses of the two that
/// keep them satisfied.
template <class F>
struct HeldRow
{
    F mass;             ///< effective mass while the two are held
    Vector<F> reaction; ///< impulses of the two for an impulse of 1

    /// The relative angle of two bodies with a common point. With K of the three rows and the
    /// masses a = iA / (mA + mB), b = iB / (mA + mB)
    ///   |K point| / (mA + mB)^2 = 1 + a rA^2 + b rB^2 + a b (rA x rB)^2
    ///   |K|       / (mA + mB)^3 = a + b + a b (rA - rB)^2
    /// All terms are >= 0, so long arms cause no cancellation.
    static HeldRow AngleOfPoint(const PairMasses<F>& pair, const Vector<F>& rA, const Vector<F>& rB)
    {
        const F reduced = InverseOrZero(pair.mA + pair.mB);
        const F a = pair.iA * reduced;
        const F b = pair.iB * reduced;
        const F area = Cross(rA, rB);
        const Vector<F> apart = rB - rA;
        const F point = F::Set(1.0f) + a * Dot(rA, rA) + b * Dot(rB, rB) + a * b * area * area;
        const F all = a + b + a * b * Dot(apart, apart);
        const Vector<F> pull = Skew(a * rA + b * rB) + (a * b * area) * apart;
        return {point * reduced * InverseOrZero(all), (F::Set(-1.0f) / point) * pull};
    }
};

/// Bodies of lanes with their velocities, loaded from a block and stored back.
template <class F>
struct MovingPair : PairMasses<F>
{
    Vector<F> vA;
    F wA, angleA; // the angle is kept as it is
    Vector<F> vB;
    F wB, angleB;

    /// Returns the velocity of B's point relative to A's.
    BOX2D_INLINE Vector<F> PointSpeed(const Vector<F>& armA, const Vector<F>& armB) const
    {
        return vB + Cross(wB, armB) - vA - Cross(wA, armA);
    }
    BOX2D_INLINE void Apply(const Vector<F>& impulse, const Vector<F>& armA, const Vector<F>& armB)
    {
        vA = vA - this->mA * impulse;
        wA = wA - this->iA * Cross(armA, impulse);
        vB = vB + this->mB * impulse;
        wB = wB + this->iB * Cross(armB, impulse);
    }
    BOX2D_INLINE void ApplyAngular(F impulse)
    {
        wA = wA - this->iA * impulse;
        wB = wB + this->iB * impulse;
    }
    /// Along a direction with these moments about the centres.
    BOX2D_INLINE void ApplyAlong(const Vector<F>& direction, F leverA, F leverB, F impulse)
    {
        vA = vA - (this->mA * impulse) * direction;
        wA = wA - this->iA * leverA * impulse;
        vB = vB + (this->mB * impulse) * direction;
        wB = wB + this->iB * leverB * impulse;
    }
    BOX2D_INLINE F SpeedAlong(const Vector<F>& direction, F leverA, F leverB) const
    {
        return Dot(direction, vB - vA) + leverB * wB - leverA * wA;
    }
    /// Replaces the state by `solved` where `active`.
    template <class M>
    BOX2D_INLINE void Take(M active, const MovingPair& solved)
    {
        vA = Select(active, solved.vA, vA);
        wA = Select(active, solved.wA, wA);
        vB = Select(active, solved.vB, vB);
        wB = Select(active, solved.wB, wB);
    }
};

/// Larger corrections count by their arc tangent [rad]. With 0.25 random world 5 gains 2 % with one
/// step; with 0.5 the plate of world 15 of MixedWorld does not come to rest.
constexpr float32 kLargeTurn = 1.0f;

/// Returns the arc tangent of what is larger than kLargeTurn, to 0.005 rad, and other numbers
/// unchanged. (Rajan et al., "Efficient Approximations for the Arctangent Function", 2006.)
template <class F>
F ArcTangentIfLarge(F tangent)
{
    const F size = Abs(tangent);
    const F angle = F::Set(0.5f * b2_pi) - size / (size * size + F::Set(0.28125f));
    const F turn = Select(AtLeast(tangent, F::Set(0.0f)), angle, -angle);
    return Select(AtLeast(F::Set(kLargeTurn), size), tangent, turn);
}

/// Bodies of lanes with their poses: displacement and rotation since the start of the step.
template <class F>
struct PlacedPair : PairMasses<F>
{
    struct Place
    {
        F speed[3]; // kept as they are
        F angle;
        Vector<F> d;
        F s, c;

        BOX2D_INLINE Vector<F> Turn(const Vector<F>& v) const
        {
            return {c * v.x - s * v.y, s * v.x + c * v.y};
        }
        /// Rotates to first order, then normalized; `seen` is by how much. A body that cannot
        /// rotate keeps its bits with any number of joints.
        template <class M>
        BOX2D_INLINE void Rotate(M turns, F delta, F seen)
        {
            const F sine = s + delta * c;
            const F cosine = c - delta * s;
            const F inverseLength = F::Set(1.0f) / Sqrt(sine * sine + cosine * cosine);
            s = Select(turns, sine * inverseLength, s);
            c = Select(turns, cosine * inverseLength, c);
            angle = Select(turns, angle + seen, angle);
        }
    };
    Place a, b;

    /// Returns the vector from the centre of mass of A to that of B; `offset` is its value at the
    /// start of the step.
    BOX2D_INLINE Vector<F> Offset(const Vector<F>& offset) const { return offset + b.d - a.d; }

    BOX2D_INLINE void Move(const Vector<F>& impulse, const Vector<F>& armA, const Vector<F>& armB)
    {
        a.d = a.d - this->mA * impulse;
        b.d = b.d + this->mB * impulse;
        Rotate(Cross(armA, impulse), Cross(armB, impulse));
    }
    BOX2D_INLINE void MoveAlong(const Vector<F>& direction, F leverA, F leverB, F impulse)
    {
        a.d = a.d - (this->mA * impulse) * direction;
        b.d = b.d + (this->mB * impulse) * direction;
        Turn(-this->iA * leverA * impulse, this->iB * leverB * impulse);
    }
    /// Applies these angular impulses.
    BOX2D_INLINE void Rotate(F onA, F onB) { Turn(-this->iA * onA, this->iB * onB); }
    /// Rotates to first order. Far out on a lever corrections are large, and joints that count them
    /// in full throw their bodies away.
    BOX2D_INLINE void Turn(F angleA, F angleB)
    {
        const F zero = F::Set(0.0f);
        F seenA = angleA;
        F seenB = angleB;
        if (Any(Less(F::Set(kLargeTurn), Max(Abs(angleA), Abs(angleB)))))
        {
            seenA = ArcTangentIfLarge(angleA);
            seenB = ArcTangentIfLarge(angleB);
        }
        a.Rotate(Not(AtLeast(zero, this->iA)), angleA, seenA);
        b.Rotate(Not(AtLeast(zero, this->iB)), angleB, seenB);
    }
    template <class M>
    BOX2D_INLINE void Take(M active, const PlacedPair& solved)
    {
        for (Place PlacedPair::*side : {&PlacedPair::a, &PlacedPair::b})
        {
            Place& to = this->*side;
            const Place& from = solved.*side;
            to.d = Select(active, from.d, to.d);
            to.s = Select(active, from.s, to.s);
            to.c = Select(active, from.c, to.c);
            to.angle = Select(active, from.angle, to.angle);
        }
    }
};

/// The lanes of a kind of joint, as `type`.
template <class Joint, class F>
struct LanesOf;

/// Returns the mask of lanes in which the number is 1, not 0.
template <class F>
auto IsSet(F flag)
{
    return AtLeast(flag, F::Set(1.0f));
}

/// Returns the total impulse of a pair of limits, positive at the lower one. It keeps a speed
/// between -lowerSpeed and upperSpeed, which are >= 0. At most one of the two terms is not zero,
/// because only one limit can push.
template <class F>
F LimitImpulse(F impulse, F mass, F speed, F lowerSpeed, F upperSpeed)
{
    const F zero = F::Set(0.0f);
    return Max(impulse - mass * (speed + lowerSpeed), zero) +
           Min(impulse - mass * (speed - upperSpeed), zero);
}

/// Returns the correction of a violated limit. Not complete, because within the slop contacts would
/// push back, and the body would tremble.
template <class F>
F BackTowards(F lower, F upper, F value, F slop, F maximum)
{
    return Clamp(Clamp(value, lower - slop, upper + slop) - value, -maximum, maximum);
}

/// Limits a vector to the maximum impulse of a force in a step.
template <class F>
Vector<F> ClampLength(const Vector<F>& v, F limit)
{
    const F squared = Dot(v, v);
    const auto within = AtLeast(limit * limit, squared);
    const F length = Sqrt(Select(within, F::Set(1.0f), squared));
    return Select(within, v, (limit / length) * v);
}

/// Loads a block's numbers into registers: T consists of numbers F only.
template <class T, class F>
BOX2D_INLINE T LoadNumbers(const float32* numbers)
{
    constexpr int width = F::kLanes == 1 ? 1 : kJointLanes;
    T loaded;
    F* const to = reinterpret_cast<F*>(&loaded);
    [&]<std::size_t... I>(std::index_sequence<I...>)
    {
        ((to[I] = F::Load(numbers + int(I) * width)), ...);
    }
    (std::make_index_sequence<sizeof(T) / sizeof(F)>());
    return loaded;
}

/// Stores the first of them, the impulses.
template <int Count, class T, class F>
BOX2D_INLINE void StoreNumbers(float32* numbers, const T& from)
{
    constexpr int width = F::kLanes == 1 ? 1 : kJointLanes;
    const F* const numbersOf = reinterpret_cast<const F*>(&from);
    for (int i = 0; i < Count; ++i)
    {
        numbersOf[i].Store(numbers + i * width);
    }
}

template <class F>
BOX2D_INLINE MovingPair<F> LoadMoving(const int32* a, const int32* b, const float32* masses,
                                      const float32* bodies)
{
    F rows[4]; // vx, vy, w; the angle is kept as it is
    MovingPair<F> pair;
    static_cast<PairMasses<F>&>(pair) = LoadNumbers<PairMasses<F>, F>(masses);
    LoadRows(bodies, kBodyStride, a, rows);
    pair.vA = {rows[0], rows[1]};
    pair.wA = rows[2];
    pair.angleA = rows[3];
    LoadRows(bodies, kBodyStride, b, rows);
    pair.vB = {rows[0], rows[1]};
    pair.wB = rows[2];
    pair.angleB = rows[3];
    return pair;
}

template <class F, int Count>
BOX2D_INLINE void StoreNumbersOf(float32* numbers, int32 body, uint32 moves, const F (&from)[Count])
{
    if ((moves & 1u) != 0)
    {
        for (int i = 0; i < Count; ++i)
        {
            from[i].Store(numbers + kBodyStride * body + i);
        }
    }
}

template <class F>
BOX2D_INLINE void StoreMoving(const MovingPair<F>& pair, const int32* a, const int32* b,
                              uint32 movesA, uint32 movesB, float32* bodies)
{
    if constexpr (F::kLanes == 1) // unchanged numbers are not written
    {
        StoreNumbersOf(bodies, *a, movesA, {pair.vA.x, pair.vA.y, pair.wA});
        StoreNumbersOf(bodies, *b, movesB, {pair.vB.x, pair.vB.y, pair.wB});
        return;
    }
    const F rowsA[4] = {pair.vA.x, pair.vA.y, pair.wA, pair.angleA};
    const F rowsB[4] = {pair.vB.x, pair.vB.y, pair.wB, pair.angleB};
    StoreMoved(bodies, a, movesA, rowsA);
    StoreMoved(bodies, b, movesB, rowsB);
}

template <class F>
BOX2D_INLINE void LoadPlace(const float32* bodies, const int32* of,
                            typename PlacedPair<F>::Place& place)
{
    F rows[4];
    LoadRows(bodies, kBodyStride, of, rows);
    place.speed[0] = rows[0];
    place.speed[1] = rows[1];
    place.speed[2] = rows[2];
    place.angle = rows[3];
    LoadRows(bodies + 4, kBodyStride, of, rows);
    place.d = {rows[0], rows[1]};
    place.s = rows[2];
    place.c = rows[3];
}

template <class F>
BOX2D_INLINE void StorePlace(float32* bodies, const int32* of, uint32 moves,
                             const typename PlacedPair<F>::Place& place)
{
    if constexpr (F::kLanes == 1)
    {
        StoreNumbersOf(bodies + 3, *of, moves,
                       {place.angle, place.d.x, place.d.y, place.s, place.c});
        return;
    }
    const F first[4] = {place.speed[0], place.speed[1], place.speed[2], place.angle};
    const F second[4] = {place.d.x, place.d.y, place.s, place.c};
    StoreMoved(bodies, of, moves, first);
    StoreMoved(bodies + 4, of, moves, second);
}

template <class F>
BOX2D_INLINE PlacedPair<F> LoadPlaced(const int32* a, const int32* b, const float32* masses,
                                      const float32* bodies)
{
    PlacedPair<F> pair;
    static_cast<PairMasses<F>&>(pair) = LoadNumbers<PairMasses<F>, F>(masses);
    LoadPlace<F>(bodies, a, pair.a);
    LoadPlace<F>(bodies, b, pair.b);
    return pair;
}

template <class F>
BOX2D_INLINE void StorePlaced(const PlacedPair<F>& pair, const int32* a, const int32* b,
                              uint32 movesA, uint32 movesB, float32* bodies)
{
    StorePlace<F>(bodies, a, movesA, pair.a);
    StorePlace<F>(bodies, b, movesB, pair.b);
}

} // namespace
} // namespace box2d
