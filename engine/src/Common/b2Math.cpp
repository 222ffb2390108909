// SPDX-License-Identifier: MIT
#include <Box2D/Common/b2Math.h>

// Cramer's rule, with the columns' cross products as the cofactors.
b2Vec3 b2Mat33::Solve33(const b2Vec3& b) const
{
    const b2Vec3 yz = b2Cross(ey, ez);
    const float32 det = b2Dot(ex, yz);
    const float32 s = det != 0.0f ? 1.0f / det : 0.0f;
    return {s * b2Dot(b, yz), s * b2Dot(ex, b2Cross(b, ez)), s * b2Dot(ex, b2Cross(ey, b))};
}

b2Vec2 b2Mat33::Solve22(const b2Vec2& b) const
{
    return b2Mat22(ex.x, ey.x, ex.y, ey.y).Solve(b);
}

void b2Mat33::GetInverse22(b2Mat33* M) const
{
    const b2Mat22 inverse = b2Mat22(ex.x, ey.x, ex.y, ey.y).GetInverse();
    M->ex.Set(inverse.ex.x, inverse.ex.y, 0.0f);
    M->ey.Set(inverse.ey.x, inverse.ey.y, 0.0f);
    M->ez.SetZero();
}

// The rows of the inverse are the cross products of the columns divided by the determinant; for a
// symmetric matrix rows equal columns.
void b2Mat33::GetSymInverse33(b2Mat33* M) const
{
    const b2Vec3 yz = b2Cross(ey, ez);
    const float32 det = b2Dot(ex, yz);
    const float32 s = det != 0.0f ? 1.0f / det : 0.0f;
    const b2Vec3 zx = b2Cross(ez, ex);
    const b2Vec3 xy = b2Cross(ex, ey);
    *M = b2Mat33(s * yz, s * zx, s * xy);
    // The two halves come from different products; this makes them identical.
    M->ex.y = M->ey.x;
    M->ex.z = M->ez.x;
    M->ey.z = M->ez.y;
}
