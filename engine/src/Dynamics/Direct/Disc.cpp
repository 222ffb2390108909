// SPDX-License-Identifier: MIT
#include "Disc.h"

#include <cmath>

namespace box2d
{

namespace
{

/// Relative excess of length at which Newton's method ends, well below kSameImpulse. The impulse is
/// then scaled to its final length, so only its direction is less exact.
constexpr double kSameLength = 1e-6;
/// A bound; five are usual. Newton's method converges from below, and the impulse is scaled to its
/// final length. With 3 and 100 no test changes.
constexpr int32 kMaxNewtonSteps = 20;
/// Ratio of the responses in two directions, because their quotient is infinite at a determinant
/// of zero. The determinant is a difference that is rounded by about 1e-16 of its terms.
constexpr double kMinResponse = 1e-12;

/// A symmetric 2 x 2 matrix.
struct Pair
{
    double xx, xy, yy;
};

/// Returns the response of the first two rows' speeds to their impulses.
Pair ResponseOf(const JointRows& rows)
{
    Pair k{double(rows.laws[0].softness), 0.0, double(rows.laws[1].softness)};
    for (int32 side = 0; side < rows.bodies; ++side)
    {
        const JointRows::Column& c = rows.columns[side];
        const double m = c.invMass;
        const double i = c.invInertia;
        k.xx += m * double(c.x[0] * c.x[0] + c.y[0] * c.y[0]) + i * double(c.w[0] * c.w[0]);
        k.xy += m * double(c.x[0] * c.x[1] + c.y[0] * c.y[1]) + i * double(c.w[0] * c.w[1]);
        k.yy += m * double(c.x[1] * c.x[1] + c.y[1] * c.y[1]) + i * double(c.w[1] * c.w[1]);
    }
    return k;
}

} // namespace

/// The impulse x is parallel to its residual g - K x, with g = residual + K now. The condition is
/// (K + s) x = g, s >= 0. Newton's method for 1 / |x(s)| = 1 / maximum, in the axes of K, converges
/// from below (More and Sorensen, "Computing a Trust Region Step", 1983).
b2Vec2 SlippingImpulse(const JointRows& rows, const b2Vec2& now, const b2Vec2& residual,
                       float32 maximum)
{
    const Pair k = ResponseOf(rows);
    const double half = 0.5 * (k.xx - k.yy);
    const double root = std::sqrt(half * half + k.xy * k.xy);
    const double large = 0.5 * (k.xx + k.yy) + root;
    if (!(large > 0.0) || maximum == 0.0f)
    {
        return now;
    }
    const double small = b2Max((k.xx * k.yy - k.xy * k.xy) / large, 0.0);
    // The eigenvector of the larger eigenvalue, from the column that is not near zero.
    double c = half >= 0.0 ? root + half : k.xy;
    double s = half >= 0.0 ? k.xy : root - half;
    const double length = std::sqrt(c * c + s * s);
    c = length > 0.0 ? c / length : 1.0;
    s = length > 0.0 ? s / length : 0.0;
    const double gx = double(residual.x) + k.xx * double(now.x) + k.xy * double(now.y);
    const double gy = double(residual.y) + k.xy * double(now.x) + k.yy * double(now.y);
    const double g1 = c * gx + s * gy;
    const double g2 = c * gy - s * gx;
    const double bound = double(maximum);
    double shift = b2Max(std::sqrt(g1 * g1 + g2 * g2) / bound - large, 0.0);
    double x1 = 0.0, x2 = 0.0;
    for (int32 i = 0; i < kMaxNewtonSteps; ++i)
    {
        const double d1 = large + shift;
        const double d2 = b2Max(small + shift, kMinResponse * large);
        x1 = g1 / d1;
        x2 = g2 / d2;
        const double square = x1 * x1 + x2 * x2;
        const double size = std::sqrt(square);
        if (size <= bound * (1.0 + kSameLength))
        {
            break;
        }
        shift += square / (x1 * x1 / d1 + x2 * x2 / d2) * (size - bound) / bound;
    }
    const double size = std::sqrt(x1 * x1 + x2 * x2);
    const double scale =
        shift > 0.0 && size > 0.0 ? (1.0 + double(kSameImpulse)) * bound / size : 1.0;
    return b2Vec2(float32(scale * (c * x1 - s * x2)), float32(scale * (s * x1 + c * x2)));
}

} // namespace box2d
