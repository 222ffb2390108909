// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Scalar.h>

/// @file
/// Vectors, matrices, rotations, transforms and sweeps in two dimensions. Small value types, all
/// inline. Scalar functions are in b2Scalar.h.

/// A column vector with two components.
struct b2Vec2
{
    constexpr b2Vec2() = default;
    /// Creates a vector from its components.
    constexpr b2Vec2(float32 x_, float32 y_) : x(x_), y(y_) {}

    /// Sets all components to 0.
    constexpr void SetZero() { *this = b2Vec2(); }
    /// Sets the components.
    constexpr void Set(float32 x_, float32 y_) { *this = b2Vec2(x_, y_); }

    /// Returns the opposite vector.
    constexpr b2Vec2 operator-() const { return {-x, -y}; }
    /// Returns component i, 0 or 1.
    constexpr float32 operator()(int32 i) const { return i == 0 ? x : y; }
    /// Returns component i, 0 or 1, as a reference.
    constexpr float32& operator()(int32 i) { return i == 0 ? x : y; }

    /// Adds a vector per component.
    constexpr void operator+=(const b2Vec2& v) { Set(x + v.x, y + v.y); }
    /// Subtracts a vector per component.
    constexpr void operator-=(const b2Vec2& v) { Set(x - v.x, y - v.y); }
    /// Multiplies each component.
    constexpr void operator*=(float32 a) { Set(a * x, a * y); }

    /// Returns the length.
    float32 Length() const { return b2Sqrt(LengthSquared()); }
    /// Returns the squared length; cheaper than Length.
    constexpr float32 LengthSquared() const { return x * x + y * y; }

    /// Makes this a unit vector and returns the former length. A vector shorter than b2_epsilon is
    /// unchanged, and the result is 0.
    float32 Normalize()
    {
        const float32 length = Length();
        if (length < b2_epsilon)
        {
            return 0.0f;
        }
        *this *= 1.0f / length;
        return length;
    }

    /// True if all components are finite.
    bool IsValid() const { return b2IsValid(x) && b2IsValid(y); }

    /// Returns the vector rotated by 90 degrees counter-clockwise: b2Dot(v.Skew(), w) == b2Cross(v,
    /// w).
    constexpr b2Vec2 Skew() const { return {-y, x}; }

    float32 x = 0.0f; ///< first component
    float32 y = 0.0f; ///< second component
};

/// A column vector with three components.
struct b2Vec3
{
    constexpr b2Vec3() = default;
    /// Creates a vector from its components.
    constexpr b2Vec3(float32 x_, float32 y_, float32 z_) : x(x_), y(y_), z(z_) {}

    /// Sets all components to 0.
    constexpr void SetZero() { *this = b2Vec3(); }
    /// Sets the components.
    constexpr void Set(float32 x_, float32 y_, float32 z_) { *this = b2Vec3(x_, y_, z_); }

    /// Returns the opposite vector.
    constexpr b2Vec3 operator-() const { return {-x, -y, -z}; }
    /// Adds a vector per component.
    constexpr void operator+=(const b2Vec3& v) { Set(x + v.x, y + v.y, z + v.z); }
    /// Subtracts a vector per component.
    constexpr void operator-=(const b2Vec3& v) { Set(x - v.x, y - v.y, z - v.z); }
    /// Multiplies each component.
    constexpr void operator*=(float32 a) { Set(a * x, a * y, a * z); }

    float32 x = 0.0f; ///< first component
    float32 y = 0.0f; ///< second component
    float32 z = 0.0f; ///< third component
};

/// The origin.
inline constexpr b2Vec2 b2Vec2_zero{};

/// Returns the sum.
constexpr b2Vec2 operator+(const b2Vec2& a, const b2Vec2& b)
{
    return {a.x + b.x, a.y + b.y};
}

/// Returns the difference.
constexpr b2Vec2 operator-(const b2Vec2& a, const b2Vec2& b)
{
    return {a.x - b.x, a.y - b.y};
}

/// Returns each component times s.
constexpr b2Vec2 operator*(float32 s, const b2Vec2& a)
{
    return {s * a.x, s * a.y};
}

/// True if both components are equal.
constexpr bool operator==(const b2Vec2& a, const b2Vec2& b)
{
    return a.x == b.x && a.y == b.y;
}

/// True if a component differs or is NaN.
constexpr bool operator!=(const b2Vec2& a, const b2Vec2& b)
{
    return !(a == b);
}

/// Returns the sum.
constexpr b2Vec3 operator+(const b2Vec3& a, const b2Vec3& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

/// Returns the difference.
constexpr b2Vec3 operator-(const b2Vec3& a, const b2Vec3& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// Returns each component times s.
constexpr b2Vec3 operator*(float32 s, const b2Vec3& a)
{
    return {s * a.x, s * a.y, s * a.z};
}

/// Returns the dot product.
constexpr float32 b2Dot(const b2Vec2& a, const b2Vec2& b)
{
    return a.x * b.x + a.y * b.y;
}

/// Returns the dot product.
constexpr float32 b2Dot(const b2Vec3& a, const b2Vec3& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Returns the z component of a x b: positive if b is to the left of a.
constexpr float32 b2Cross(const b2Vec2& a, const b2Vec2& b)
{
    return a.x * b.y - a.y * b.x;
}

/// Returns a x (0, 0, s).
constexpr b2Vec2 b2Cross(const b2Vec2& a, float32 s)
{
    return {s * a.y, -s * a.x};
}

/// Returns (0, 0, s) x a: the velocity of a point at a with the angular velocity s.
constexpr b2Vec2 b2Cross(float32 s, const b2Vec2& a)
{
    return {-s * a.y, s * a.x};
}

/// Returns the cross product.
constexpr b2Vec3 b2Cross(const b2Vec3& a, const b2Vec3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Returns the distance of two points [m].
inline float32 b2Distance(const b2Vec2& a, const b2Vec2& b)
{
    return (a - b).Length();
}

/// Returns the squared distance of two points [m^2], without a root.
constexpr float32 b2DistanceSquared(const b2Vec2& a, const b2Vec2& b)
{
    return (a - b).LengthSquared();
}

/// A 2-by-2 matrix, stored by columns.
struct b2Mat22
{
    constexpr b2Mat22() = default;
    /// Creates a matrix from its columns.
    constexpr b2Mat22(const b2Vec2& c1, const b2Vec2& c2) : ex(c1), ey(c2) {}
    /// Creates a matrix from its entries, by rows.
    constexpr b2Mat22(float32 a11, float32 a12, float32 a21, float32 a22)
        : ex(a11, a21), ey(a12, a22)
    {}

    /// Sets the columns.
    constexpr void Set(const b2Vec2& c1, const b2Vec2& c2) { *this = b2Mat22(c1, c2); }
    /// Sets the identity.
    constexpr void SetIdentity() { *this = b2Mat22(1.0f, 0.0f, 0.0f, 1.0f); }
    /// Sets all components to 0.
    constexpr void SetZero() { *this = b2Mat22(); }

    /// Returns the inverse; zero when the matrix is singular.
    constexpr b2Mat22 GetInverse() const
    {
        const float32 det = b2Cross(ex, ey);
        const float32 s = det != 0.0f ? 1.0f / det : 0.0f;
        return {s * ey.y, -s * ey.x, -s * ex.y, s * ex.x};
    }

    /// Returns x with A x = b, by Cramer's rule; zero when the matrix is singular.
    constexpr b2Vec2 Solve(const b2Vec2& b) const
    {
        const float32 det = b2Cross(ex, ey);
        const float32 s = det != 0.0f ? 1.0f / det : 0.0f;
        return {s * b2Cross(b, ey), s * b2Cross(ex, b)};
    }

    b2Vec2 ex; ///< first column
    b2Vec2 ey; ///< second column
};

/// A 3-by-3 matrix, stored by columns.
struct b2Mat33
{
    constexpr b2Mat33() = default;
    /// Creates a matrix from its columns.
    constexpr b2Mat33(const b2Vec3& c1, const b2Vec3& c2, const b2Vec3& c3) : ex(c1), ey(c2), ez(c3)
    {}

    /// Sets all components to 0.
    constexpr void SetZero() { *this = b2Mat33(); }

    /// Returns x with A x = b; zero when the matrix is singular.
    b2Vec3 Solve33(const b2Vec3& b) const;

    /// Returns x with A x = b for the upper left 2-by-2 block only; zero when that is singular.
    b2Vec2 Solve22(const b2Vec2& b) const;

    /// Sets M to the inverse of the upper left block, bordered with zeros; zero when singular.
    void GetInverse22(b2Mat33* M) const;

    /// Sets M to the inverse of this symmetric matrix; zero when singular.
    void GetSymInverse33(b2Mat33* M) const;

    b2Vec3 ex; ///< first column
    b2Vec3 ey; ///< second column
    b2Vec3 ez; ///< third column
};

/// A rotation, as the sine and cosine of its angle.
struct b2Rot
{
    /// Creates the identity.
    constexpr b2Rot() = default;
    /// Creates a rotation by an angle [rad], finite.
    explicit b2Rot(float32 angle) { Set(angle); }

    /// Sets the angle [rad], finite.
    void Set(float32 angle)
    {
        const auto [sine, cosine] = box2d::SinCos(angle);
        s = sine;
        c = cosine;
    }
    /// Sets the identity.
    constexpr void SetIdentity() { *this = b2Rot(); }
    /// Returns the angle, -pi to pi [rad].
    float32 GetAngle() const { return b2Atan2(s, c); }
    /// Returns the rotated x axis.
    constexpr b2Vec2 GetXAxis() const { return {c, s}; }
    /// Returns the rotated y axis.
    constexpr b2Vec2 GetYAxis() const { return {-s, c}; }

    float32 s = 0.0f; ///< sine of the angle
    float32 c = 1.0f; ///< cosine of the angle
};

/// Returns A v.
constexpr b2Vec2 b2Mul(const b2Mat22& A, const b2Vec2& v)
{
    return {A.ex.x * v.x + A.ey.x * v.y, A.ex.y * v.x + A.ey.y * v.y};
}

/// Returns transpose(A) v.
constexpr b2Vec2 b2MulT(const b2Mat22& A, const b2Vec2& v)
{
    return {b2Dot(v, A.ex), b2Dot(v, A.ey)};
}

/// Returns the sum.
constexpr b2Mat22 operator+(const b2Mat22& A, const b2Mat22& B)
{
    return {A.ex + B.ex, A.ey + B.ey};
}

/// Returns A B: B is applied first.
constexpr b2Mat22 b2Mul(const b2Mat22& A, const b2Mat22& B)
{
    return {b2Mul(A, B.ex), b2Mul(A, B.ey)};
}

/// Returns transpose(A) B.
constexpr b2Mat22 b2MulT(const b2Mat22& A, const b2Mat22& B)
{
    return {b2MulT(A, B.ex), b2MulT(A, B.ey)};
}

/// Returns A v.
constexpr b2Vec3 b2Mul(const b2Mat33& A, const b2Vec3& v)
{
    return v.x * A.ex + v.y * A.ey + v.z * A.ez;
}

/// Returns the upper left block of A times v.
constexpr b2Vec2 b2Mul22(const b2Mat33& A, const b2Vec2& v)
{
    return {A.ex.x * v.x + A.ey.x * v.y, A.ex.y * v.x + A.ey.y * v.y};
}

/// Returns q r: r is applied first.
constexpr b2Rot b2Mul(const b2Rot& q, const b2Rot& r)
{
    b2Rot qr;
    qr.s = q.s * r.c + q.c * r.s;
    qr.c = q.c * r.c - q.s * r.s;
    return qr;
}

/// Returns inverse(q) r: r relative to q.
constexpr b2Rot b2MulT(const b2Rot& q, const b2Rot& r)
{
    b2Rot qr;
    qr.s = q.c * r.s - q.s * r.c;
    qr.c = q.c * r.c + q.s * r.s;
    return qr;
}

/// Returns the rotated vector.
constexpr b2Vec2 b2Mul(const b2Rot& q, const b2Vec2& v)
{
    return {q.c * v.x - q.s * v.y, q.s * v.x + q.c * v.y};
}

/// Returns the vector rotated by the inverse of q.
constexpr b2Vec2 b2MulT(const b2Rot& q, const b2Vec2& v)
{
    return {q.c * v.x + q.s * v.y, q.c * v.y - q.s * v.x};
}

/// A rigid motion: rotation by q, then translation by p. The position and orientation of a frame.
struct b2Transform
{
    /// Creates the identity.
    constexpr b2Transform() = default;
    /// Creates a transform from a position [m] and a rotation.
    constexpr b2Transform(const b2Vec2& position, const b2Rot& rotation) : p(position), q(rotation)
    {}

    /// Sets the identity.
    constexpr void SetIdentity() { *this = b2Transform(); }
    /// Sets the position [m] and the angle [rad].
    void Set(const b2Vec2& position, float32 angle)
    {
        p = position;
        q.Set(angle);
    }

    b2Vec2 p; ///< origin of the frame [m]
    b2Rot q;  ///< the rotation
};

/// Transforms from the frame T to the world.
constexpr b2Vec2 b2Mul(const b2Transform& T, const b2Vec2& v)
{
    return b2Mul(T.q, v) + T.p;
}

/// Transforms from the world to the frame T.
constexpr b2Vec2 b2MulT(const b2Transform& T, const b2Vec2& v)
{
    return b2MulT(T.q, v - T.p);
}

/// Returns A B: B is applied first.
constexpr b2Transform b2Mul(const b2Transform& A, const b2Transform& B)
{
    return {b2Mul(A, B.p), b2Mul(A.q, B.q)};
}

/// Returns the frame B relative to A.
constexpr b2Transform b2MulT(const b2Transform& A, const b2Transform& B)
{
    return {b2MulT(A, B.p), b2MulT(A.q, B.q)};
}

/// Returns the absolute value per component.
inline b2Vec2 b2Abs(const b2Vec2& a)
{
    return {b2Abs(a.x), b2Abs(a.y)};
}

/// Returns the absolute value per entry.
inline b2Mat22 b2Abs(const b2Mat22& A)
{
    return {b2Abs(A.ex), b2Abs(A.ey)};
}

/// Returns the minimum per component.
constexpr b2Vec2 b2Min(const b2Vec2& a, const b2Vec2& b)
{
    return {b2Min(a.x, b.x), b2Min(a.y, b.y)};
}

/// Returns the maximum per component.
constexpr b2Vec2 b2Max(const b2Vec2& a, const b2Vec2& b)
{
    return {b2Max(a.x, b.x), b2Max(a.y, b.y)};
}

/// Clamps each component to [low, high].
constexpr b2Vec2 b2Clamp(const b2Vec2& a, const b2Vec2& low, const b2Vec2& high)
{
    return b2Max(low, b2Min(a, high));
}

/// The motion of a body during a step: its centre of mass moves on a straight line, and it rotates
/// at a constant rate.
struct b2Sweep
{
    /// Computes the body's transform at beta, 0 to 1, where 0 is alpha0 and 1 the end of the step.
    void GetTransform(b2Transform* xf, float32 beta) const;

    /// Advances the start of the sweep to the fraction alpha of the step, alpha0 <= alpha < 1.
    void Advance(float32 alpha);

    /// Removes whole turns from both angles, so that they stay precise.
    void Normalize();

    b2Vec2 localCenter;    ///< centre of mass in the body's frame [m]
    b2Vec2 c0;             ///< centre of mass at alpha0, in the world [m]
    b2Vec2 c;              ///< centre of mass at the end of the step, in the world [m]
    float32 a0 = 0.0f;     ///< angle at alpha0 [rad]
    float32 a = 0.0f;      ///< angle at the end of the step [rad]
    float32 alpha0 = 0.0f; ///< fraction of the step before the start of the sweep, 0 to 1
};

inline void b2Sweep::GetTransform(b2Transform* xf, float32 beta) const
{
    xf->q.Set((1.0f - beta) * a0 + beta * a);
    xf->p = (1.0f - beta) * c0 + beta * c - b2Mul(xf->q, localCenter);
}

inline void b2Sweep::Advance(float32 alpha)
{
    b2Assert(alpha0 < 1.0f);
    if (alpha0 < 1.0f)
    {
        const float32 beta = (alpha - alpha0) / (1.0f - alpha0);
        c0 += beta * (c - c0);
        a0 += beta * (a - a0);
        alpha0 = alpha;
    }
}

inline void b2Sweep::Normalize()
{
    constexpr float32 turn = 2.0f * b2_pi;
    const float32 whole = turn * std::floor(a0 / turn);
    a0 -= whole;
    a -= whole;
}
