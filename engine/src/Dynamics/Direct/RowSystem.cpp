// SPDX-License-Identifier: MIT
#include "RowSystem.h"

#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>

namespace box2d
{

namespace
{

/// Factors a symmetric positive definite matrix in place: L below the diagonal, the inverse of D on
/// it. A full inverse would lose stiff directions among soft ones.
void FactorInPlace(Lower3& m)
{
    auto& [xx, yx, yy, wx, wy, ww] = m.at;
    xx = 1.0 / xx;
    const double y = yx;
    const double w = wx;
    yx = y * xx;
    wx = w * xx;
    yy = 1.0 / (yy - yx * y);
    const double u = wy - wx * y;
    wy = u * yy;
    ww = 1.0 / (ww - wx * w - wy * u);
}

/// m = m L^-T
void DivideByTransposed(Block3& m, const Lower3& factors)
{
    const auto& [xx, yx, yy, wx, wy, ww] = factors.at;
    for (auto& row : m.at)
    {
        row[1] -= row[0] * yx;
        row[2] -= row[0] * wx + row[1] * wy;
    }
}

/// v = L^-1 v
void DivideByLower(Vector3& v, const Lower3& factors)
{
    const auto& [xx, yx, yy, wx, wy, ww] = factors.at;
    v.at[1] -= yx * v.at[0];
    v.at[2] -= wx * v.at[0] + wy * v.at[1];
}

/// v = L^-T v
void DivideByUpper(Vector3& v, const Lower3& factors)
{
    const auto& [xx, yx, yy, wx, wy, ww] = factors.at;
    v.at[1] -= wy * v.at[2];
    v.at[0] -= yx * v.at[1] + wx * v.at[2];
}

Vector3 DividedByDiagonal(const Vector3& v, const Lower3& factors)
{
    return Vector3{{v.at[0] * factors.at[0], v.at[1] * factors.at[2], v.at[2] * factors.at[5]}};
}

/// Returns a D^-1.
Block3 DividedByDiagonal(const Block3& a, const Lower3& factors)
{
    Block3 scaled;
    for (int32 i = 0; i < 3; ++i)
    {
        scaled.at[i][0] = a.at[i][0] * factors.at[0];
        scaled.at[i][1] = a.at[i][1] * factors.at[2];
        scaled.at[i][2] = a.at[i][2] * factors.at[5];
    }
    return scaled;
}

double Dot(const double (&a)[3], const double (&b)[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// m -= a b^T
void SubtractProduct(Block3& m, const Block3& a, const Block3& b)
{
    for (int32 i = 0; i < 3; ++i)
    {
        for (int32 k = 0; k < 3; ++k)
        {
            m.at[i][k] -= Dot(a.at[i], b.at[k]);
        }
    }
}

/// The same for a symmetric product.
void SubtractSquare(Lower3& m, const Block3& a, const Block3& b)
{
    double* at = m.at;
    for (int32 i = 0; i < 3; ++i)
    {
        for (int32 k = 0; k <= i; ++k)
        {
            *at++ -= Dot(a.at[i], b.at[k]);
        }
    }
}

/// r -= m v
void SubtractProduct(Vector3& r, const Block3& m, const Vector3& v)
{
    for (int32 i = 0; i < 3; ++i)
    {
        r.at[i] -= m.at[i][0] * v.at[0] + m.at[i][1] * v.at[1] + m.at[i][2] * v.at[2];
    }
}

/// r -= m^T v
void SubtractTransposed(Vector3& r, const Block3& m, const Vector3& v)
{
    for (int32 i = 0; i < 3; ++i)
    {
        r.at[i] -= m.at[0][i] * v.at[0] + m.at[1][i] * v.at[1] + m.at[2][i] * v.at[2];
    }
}

/// v += u^T push
void AddAlong(double (&v)[3], const double (&u)[3][3], const double (&push)[3])
{
    for (int32 i = 0; i < 3; ++i)
    {
        v[i] = v[i] + push[0] * u[0][i] + push[1] * u[1][i] + push[2] * u[2][i];
    }
}

/// Returns u^T w v.
Block3 Product(const double (&u)[3], double weight, const double (&v)[3])
{
    Block3 m;
    for (int32 i = 0; i < 3; ++i)
    {
        const double wu = weight * u[i];
        for (int32 k = 0; k < 3; ++k)
        {
            m.at[i][k] = wu * v[k];
        }
    }
    return m;
}

/// Returns u^T w u.
Lower3 Square(const double (&u)[3], double weight)
{
    const double x = weight * u[0];
    const double y = weight * u[1];
    const double w = weight * u[2];
    return Lower3{{x * u[0], y * u[0], y * u[1], w * u[0], w * u[1], w * u[2]}};
}

/// Adds those of three matrices of `count` elements whose bits are set.
template <std::size_t count>
void AddActive(double* sum, const double* of, uint32 active)
{
    // All read before any is written, so that the compiler may add several at once.
    double result[count];
    for (std::size_t i = 0; i < count; ++i)
    {
        result[i] = sum[i];
    }
    for (int32 row = 0; row < JointRows::kMaxRows; ++row, of += count)
    {
        if ((active >> row & 1u) != 0)
        {
            for (std::size_t i = 0; i < count; ++i)
            {
                result[i] += of[i];
            }
        }
    }
    for (std::size_t i = 0; i < count; ++i)
    {
        sum[i] = result[i];
    }
}

/// Returns the inverse of a mass or moment of inertia after something was added to it.
float32 Lessened(float32 inverse, double added)
{
    return float32(double(inverse) / (1.0 + double(inverse) * added));
}

/// Returns J M^-1 J^T of a single row.
double OwnOf(const JointRows& rows, int32 row)
{
    double sum = 0.0;
    for (int32 side = 0; side < rows.bodies; ++side)
    {
        const JointRows::Column& c = rows.columns[side];
        const double x = c.x[row];
        const double y = c.y[row];
        const double w = c.w[row];
        sum += double(c.invMass) * (x * x + y * y) + double(c.invInertia) * w * w;
    }
    return sum;
}

} // namespace

void RowSystem::Build(const Array<RowSides>& sides, int32 maxUpdates, Elimination& elimination)
{
    elimination.Run(sides, maxUpdates, m_pattern);
    const auto resize = [](auto& array, std::size_t count) {
        MakeRoom(array, count);
        array.resize(count);
    };
    const auto assign = [](auto& array, std::size_t count, const auto& value) {
        MakeRoom(array, count);
        array.assign(count, value);
    };
    resize(m_rows, sides.size());
    assign(m_active, sides.size(), uint8(7));
    resize(m_stiff, sides.size());
    assign(m_weights, sides.size(), Vector3{});
    resize(m_residuals, sides.size());
    assign(m_found, sides.size(), Vector3{});
    assign(m_places, sides.size(), int32(-1));
    for (std::size_t i = 0; i + 1 < m_pattern.items.size(); ++i)
    {
        m_places[std::size_t(m_pattern.items[i].item)] = int32(i);
    }
    resize(m_responses, sides.size());
    assign(m_sides, m_pattern.sides.size(), Side{});
    resize(m_squares, 3 * m_pattern.sides.size());
    resize(m_products, 3 * m_pattern.meetings.size());
    resize(m_diagonal, m_pattern.columns.size() - 1);
    resize(m_x, m_diagonal.size());
    assign(m_addedMass, m_diagonal.size(), AddedMass());
    resize(m_stiffness, m_diagonal.size());
    resize(m_entries, m_pattern.rows.size());
}

double RowSystem::SquaredFrequency(int32 component) const
{
    double highest = 0.0;
    const RowPattern::Component* c = m_pattern.components.data() + component;
    ForBodies(component,
              [&](const BodyData&, std::size_t place) { m_stiffness[place] = Stiffness(); });
    for (int32 i = c[0].firstItem; i < c[1].firstItem; ++i)
    {
        const RowPattern::Item* item = m_pattern.items.data() + i;
        const JointRows& rows = m_rows[std::size_t(item->item)];
        if (!rows.point && rows.length == 0.0f)
        {
            continue;
        }
        for (int32 k = item[0].firstSide; k < item[1].firstSide; ++k)
        {
            const RowPattern::Side& side = m_pattern.sides[std::size_t(k)];
            const JointRows::Column& column = rows.columns[side.side];
            Stiffness& stiffness = m_stiffness[std::size_t(side.place)];
            rows.point ? stiffness.AddPoint(rows, column) : stiffness.AddLine(rows, column);
            // Its own masses, because those of the rows are less where a component was torn.
            const BodyData& body = *m_pattern.columns[std::size_t(side.place)].body;
            highest = std::max(highest, stiffness.turning * double(body.SolverInvInertia()) +
                                            stiffness.swaying * double(body.SolverInvMass()));
        }
    }
    return highest;
}

/// A force F at an arm r gives the torque -F.r per radian.
void RowSystem::Stiffness::AddPoint(const JointRows& rows, const JointRows::Column& column)
{
    turning += double(rows.impulse[0]) * double(column.w[1]) -
               double(rows.impulse[1]) * double(column.w[0]);
}

/// Tension T along a line of length L gives the restoring force T / L per metre of lateral
/// displacement, also at the body's arm. It is twice as large if the other end moves in the
/// opposite direction.
void RowSystem::Stiffness::AddLine(const JointRows& rows, const JointRows::Column& column)
{
    const double pull = -double(rows.impulse[0]);
    const double reach = double(column.reach);
    const double across = 2.0 * pull / double(rows.length);
    swaying += across;
    turning += pull * reach + across * reach * reach;
}

void RowSystem::Factor(int32 component)
{
    const RowPattern::Component* c = m_pattern.components.data() + component;
    FillDiagonal(c);
    for (int32 i = c[0].firstItem; i < c[1].firstItem; ++i)
    {
        Fill(std::size_t(i));
    }
    for (int32 i = c[0].firstColumn; i < c[1].firstColumn; ++i)
    {
        Eliminate(std::size_t(i));
    }
}

/// Sets the diagonal to the masses, and the other entries to zero.
void RowSystem::FillDiagonal(const RowPattern::Component* component)
{
    for (int32 i = component[0].firstColumn; i < component[1].firstColumn; ++i)
    {
        const BodyData& body = *m_pattern.columns[std::size_t(i)].body;
        Lower3& m = m_diagonal[std::size_t(i)];
        m = Lower3{};
        const AddedMass& addedMass = m_addedMass[std::size_t(i)];
        const double inertia =
            body.SolverInvInertia() > 0.0f ? 1.0 / double(body.SolverInvInertia()) : 1.0;
        m.at[0] = m.at[2] = 1.0 / double(body.SolverInvMass()) + addedMass.mass;
        m.at[5] = inertia + addedMass.inertia;
    }
    const int32 first = m_pattern.columns[std::size_t(component[0].firstColumn)].firstEntry;
    const int32 last = m_pattern.columns[std::size_t(component[1].firstColumn)].firstEntry;
    std::fill(m_entries.begin() + first, m_entries.begin() + last, Block3{});
}

void RowSystem::TakeAddedMass(std::size_t item)
{
    const auto [first, last] = SidesOf(item);
    for (int32 k = first; k < last; ++k)
    {
        const RowPattern::Side& side = m_pattern.sides[std::size_t(k)];
        const AddedMass& added = m_addedMass[std::size_t(side.place)];
        JointRows::Column& column = m_rows[item].columns[side.side];
        column.invMass = Lessened(column.invMass, added.mass);
        column.invInertia = Lessened(column.invInertia, added.inertia);
    }
}

std::pair<int32, int32> RowSystem::SidesOf(std::size_t item) const
{
    const RowPattern::Item* at = m_pattern.items.data() + m_places[item];
    return {at[0].firstSide, at[1].firstSide};
}

void RowSystem::Read(int32 component, double compliance)
{
    const RowPattern::Component* c = m_pattern.components.data() + component;
    for (int32 i = c[0].firstItem; i < c[1].firstItem; ++i)
    {
        ReadItem(std::size_t(i), compliance);
    }
}

/// Reads an item, given by its index in the pattern.
void RowSystem::ReadItem(std::size_t place, double compliance)
{
    constexpr int32 kRows = JointRows::kMaxRows;
    const RowPattern::Item* item = m_pattern.items.data() + place;
    const JointRows& rows = m_rows[std::size_t(item->item)];
    Vector3& responses = m_responses[std::size_t(item->item)];
    Vector3& stiff = m_stiff[std::size_t(item->item)];
    for (int32 row = 0; row < kRows; ++row)
    {
        responses.at[row] = OwnOf(rows, row);
        stiff.at[row] =
            row < rows.rows && responses.at[row] > 0.0
                ? 1.0 / (compliance * responses.at[row] + double(rows.laws[row].softness))
                : 0.0;
    }
    for (int32 i = item[0].firstSide; i < item[1].firstSide; ++i)
    {
        const JointRows::Column& column = rows.columns[m_pattern.sides[std::size_t(i)].side];
        Side& to = m_sides[std::size_t(i)];
        to.invMass = double(column.invMass);
        to.invInertia = double(column.invInertia);
        to.body = column.body;
        for (int32 row = 0; row < kRows; ++row)
        {
            to.rows[row][0] = double(column.x[row]);
            to.rows[row][1] = double(column.y[row]);
            to.rows[row][2] = column.invInertia > 0.0f ? double(column.w[row]) : 0.0;
            m_squares[std::size_t(kRows * i + row)] = Square(to.rows[row], stiff.at[row]);
        }
    }
    for (int32 i = item[0].firstMeeting; i < item[1].firstMeeting; ++i)
    {
        const RowPattern::Meeting& meeting = m_pattern.meetings[std::size_t(i)];
        const Side& a = m_sides[std::size_t(meeting.side1)];
        const Side& b = m_sides[std::size_t(meeting.side2)];
        for (int32 row = 0; row < kRows; ++row)
        {
            m_products[std::size_t(kRows * i + row)] =
                Product(a.rows[row], stiff.at[row], b.rows[row]);
        }
    }
}

/// Adds the active rows of an item, given by its index in the pattern.
void RowSystem::Fill(std::size_t place)
{
    constexpr int32 kRows = JointRows::kMaxRows;
    const RowPattern::Item* item = m_pattern.items.data() + place;
    const auto index = std::size_t(item->item);
    uint32 active = 0;
    for (int32 row = 0; row < kRows; ++row)
    {
        const bool holds = (m_active[index] >> row & 1) != 0 && m_stiff[index].at[row] > 0.0;
        m_weights[index].at[row] = holds ? m_stiff[index].at[row] : 0.0;
        active |= uint32(holds) << row;
    }
    if (active == 0)
    {
        return;
    }
    for (int32 i = item[0].firstSide; i < item[1].firstSide; ++i)
    {
        AddActive<6>(m_diagonal[std::size_t(m_pattern.sides[std::size_t(i)].place)].at,
                     m_squares[std::size_t(kRows * i)].at, active);
    }
    for (int32 i = item[0].firstMeeting; i < item[1].firstMeeting; ++i)
    {
        AddActive<9>(m_entries[std::size_t(m_pattern.meetings[std::size_t(i)].entry)].at[0],
                     m_products[std::size_t(kRows * i)].at[0], active);
    }
}

void RowSystem::Eliminate(std::size_t place)
{
    const RowPattern::Column& column = m_pattern.columns[place];
    const int32 end = m_pattern.columns[place + 1].firstEntry;
    FactorInPlace(m_diagonal[place]);
    const int32* target = m_pattern.targets.data() + column.firstTarget;
    for (int32 i = column.firstEntry; i < end; ++i)
    {
        DivideByTransposed(m_entries[std::size_t(i)], m_diagonal[place]);
        const Block3 scaled = DividedByDiagonal(m_entries[std::size_t(i)], m_diagonal[place]);
        for (int32 k = column.firstEntry; k < i; ++k, ++target)
        {
            SubtractProduct(m_entries[std::size_t(*target)], scaled, m_entries[std::size_t(k)]);
        }
        SubtractSquare(m_diagonal[std::size_t(-1 - *target)], scaled, m_entries[std::size_t(i)]);
        ++target;
    }
}

void RowSystem::Substitute(const RowPattern::Component* component)
{
    const auto first = std::size_t(component[0].firstColumn);
    const auto last = std::size_t(component[1].firstColumn);
    for (std::size_t place = first; place < last; ++place)
    {
        const int32 end = m_pattern.columns[place + 1].firstEntry;
        DivideByLower(m_x[place], m_diagonal[place]);
        const Vector3 v = DividedByDiagonal(m_x[place], m_diagonal[place]);
        for (int32 i = m_pattern.columns[place].firstEntry; i < end; ++i)
        {
            SubtractProduct(m_x[std::size_t(m_pattern.rows[std::size_t(i)])],
                            m_entries[std::size_t(i)], v);
        }
    }
    for (std::size_t place = last; place-- > first;)
    {
        // D^-1 (x - Y^T of the rows below), then L^-T.
        const int32 end = m_pattern.columns[place + 1].firstEntry;
        Vector3& x = m_x[place];
        for (int32 i = m_pattern.columns[place].firstEntry; i < end; ++i)
        {
            SubtractTransposed(x, m_entries[std::size_t(i)],
                               m_x[std::size_t(m_pattern.rows[std::size_t(i)])]);
        }
        x = DividedByDiagonal(x, m_diagonal[place]);
        DivideByUpper(x, m_diagonal[place]);
    }
}

void RowSystem::Solve(int32 component)
{
    const RowPattern::Component* c = m_pattern.components.data() + component;
    std::fill(m_x.begin() + c[0].firstColumn, m_x.begin() + c[1].firstColumn, Vector3{});
    for (int32 i = c[0].firstItem; i < c[1].firstItem; ++i)
    {
        const RowPattern::Item* item = m_pattern.items.data() + i;
        const Vector3& weights = m_weights[std::size_t(item->item)];
        const Vector3& residual = m_residuals[std::size_t(item->item)];
        const double push[3] = {weights.at[0] * residual.at[0], weights.at[1] * residual.at[1],
                                weights.at[2] * residual.at[2]};
        for (int32 k = item[0].firstSide; k < item[1].firstSide; ++k)
        {
            AddAlong(m_x[std::size_t(m_pattern.sides[std::size_t(k)].place)].at,
                     m_sides[std::size_t(k)].rows, push);
        }
    }
    Substitute(c);
    for (int32 i = c[0].firstItem; i < c[1].firstItem; ++i)
    {
        const RowPattern::Item* item = m_pattern.items.data() + i;
        const Vector3& weights = m_weights[std::size_t(item->item)];
        Vector3 left = m_residuals[std::size_t(item->item)];
        for (int32 k = item[0].firstSide; k < item[1].firstSide; ++k)
        {
            const Side& side = m_sides[std::size_t(k)];
            const Vector3& x = m_x[std::size_t(m_pattern.sides[std::size_t(k)].place)];
            for (int32 row = 0; row < 3; ++row)
            {
                left.at[row] -= Dot(side.rows[row], x.at);
            }
        }
        for (int32 row = 0; row < 3; ++row)
        {
            m_found[std::size_t(item->item)].at[row] = weights.at[row] * left.at[row];
        }
    }
}

void RowSystem::Apply(int32 component, const SolverContext& context)
{
    const RowPattern::Component* c = m_pattern.components.data() + component;
    for (int32 i = c[0].firstColumn; i < c[1].firstColumn; ++i)
    {
        const BodyData& data = *m_pattern.columns[std::size_t(i)].body;
        const Vector3& x = m_x[std::size_t(i)];
        SolverBody& body = context.bodies[data.SolverIndex()];
        body.v.x = float32(double(body.v.x) + x.at[0]);
        body.v.y = float32(double(body.v.y) + x.at[1]);
        body.w = data.SolverInvInertia() > 0.0f ? float32(double(body.w) + x.at[2]) : body.w;
    }
    ForItems(component, [this](std::size_t item) {
        for (int32 row = 0; row < JointRows::kMaxRows; ++row)
        {
            m_rows[item].impulse[row] += float32(m_found[item].at[row]);
        }
    });
}

void RowSystem::Apply(int32 component, const SolverContext& context, float32 timeStep, bool keep)
{
    ForBodies(component, [&](const BodyData& data, std::size_t place) {
        SolverBody& body = context.bodies[data.SolverIndex()];
        const Vector3& x = m_x[place];
        body.d += timeStep * b2Vec2(float32(x.at[0]), float32(x.at[1]));
        if (data.SolverInvInertia() > 0.0f)
        {
            const float32 turn = timeStep * float32(x.at[2]);
            body.angle += turn;
            body.q = b2Mul(body.q, b2Rot(turn));
        }
    });
    if (keep)
    {
        Apply(component, context);
    }
}

Vector3 RowSystem::SpeedOf(const SolverContext& context, std::size_t item,
                           const Vector3& given) const
{
    Vector3 speed = given;
    const auto [first, last] = SidesOf(item);
    for (int32 k = first; k < last; ++k)
    {
        const Side& side = m_sides[std::size_t(k)];
        const SolverBody& body = context.bodies[side.body];
        const double velocity[3] = {double(body.v.x), double(body.v.y), double(body.w)};
        for (int32 row = 0; row < JointRows::kMaxRows; ++row)
        {
            speed.at[row] += Dot(side.rows[row], velocity);
        }
    }
    return speed;
}

void RowSystem::Push(const SolverContext& context, std::size_t item, const Vector3& impulse) const
{
    const auto [first, last] = SidesOf(item);
    for (int32 k = first; k < last; ++k)
    {
        const Side& side = m_sides[std::size_t(k)];
        double sum[3] = {};
        for (int32 row = 0; row < JointRows::kMaxRows; ++row)
        {
            for (int32 i = 0; i < 3; ++i)
            {
                sum[i] += side.rows[row][i] * impulse.at[row];
            }
        }
        SolverBody& body = context.bodies[side.body];
        body.v.x = float32(double(body.v.x) + side.invMass * sum[0]);
        body.v.y = float32(double(body.v.y) + side.invMass * sum[1]);
        body.w = float32(double(body.w) + side.invInertia * sum[2]);
    }
}

Vector3 SpeedOf(const SolverContext& context, const JointRows& rows)
{
    Vector3 speed{};
    for (int32 side = 0; side < rows.bodies; ++side)
    {
        const JointRows::Column& column = rows.columns[side];
        const SolverBody& body = context.bodies[column.body];
        for (int32 i = 0; i < rows.rows; ++i)
        {
            speed.at[i] += SpeedFrom(column, i, body);
        }
    }
    return speed;
}

void Push(const SolverContext& context, JointRows& rows, const Vector3& impulse)
{
    for (int32 i = 0; i < rows.rows; ++i)
    {
        rows.impulse[i] += float32(impulse.at[i]);
    }
    for (int32 side = 0; side < rows.bodies; ++side)
    {
        const JointRows::Column& column = rows.columns[side];
        if (!Moves(column.invMass, column.invInertia))
        {
            continue;
        }
        double x = 0.0;
        double y = 0.0;
        double w = 0.0;
        for (int32 i = 0; i < rows.rows; ++i)
        {
            x += double(column.x[i]) * impulse.at[i];
            y += double(column.y[i]) * impulse.at[i];
            w += double(column.w[i]) * impulse.at[i];
        }
        SolverBody& body = context.bodies[column.body];
        body.v.x = float32(double(body.v.x) + double(column.invMass) * x);
        body.v.y = float32(double(body.v.y) + double(column.invMass) * y);
        body.w = float32(double(body.w) + double(column.invInertia) * w);
    }
}

} // namespace box2d
