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
void FactorInPlace(Block3& m)
{
    auto& a = m.at;
    a[0][0] = 1.0 / a[0][0];
    const double u10 = a[1][0];
    const double u20 = a[2][0];
    a[1][0] = u10 * a[0][0];
    a[2][0] = u20 * a[0][0];
    a[1][1] = 1.0 / (a[1][1] - a[1][0] * u10);
    const double u21 = a[2][1] - a[2][0] * u10;
    a[2][1] = u21 * a[1][1];
    a[2][2] = 1.0 / (a[2][2] - a[2][0] * u20 - a[2][1] * u21);
}

/// m = m L^-T
void DivideByTransposed(Block3& m, const Block3& factors)
{
    const auto& l = factors.at;
    for (auto& row : m.at)
    {
        row[1] -= row[0] * l[1][0];
        row[2] -= row[0] * l[2][0] + row[1] * l[2][1];
    }
}

/// v = L^-1 v
void DivideByLower(Vector3& v, const Block3& factors)
{
    const auto& l = factors.at;
    v.at[1] -= l[1][0] * v.at[0];
    v.at[2] -= l[2][0] * v.at[0] + l[2][1] * v.at[1];
}

/// v = L^-T v
void DivideByUpper(Vector3& v, const Block3& factors)
{
    const auto& l = factors.at;
    v.at[1] -= l[2][1] * v.at[2];
    v.at[0] -= l[1][0] * v.at[1] + l[2][0] * v.at[2];
}

Vector3 DividedByDiagonal(const Vector3& v, const Block3& factors)
{
    return Vector3{
        {v.at[0] * factors.at[0][0], v.at[1] * factors.at[1][1], v.at[2] * factors.at[2][2]}};
}

/// m -= a D^-1 b^T
void SubtractProduct(Block3& m, const Block3& a, const Block3& factors, const Block3& b)
{
    for (int32 i = 0; i < 3; ++i)
    {
        const double r0 = a.at[i][0] * factors.at[0][0];
        const double r1 = a.at[i][1] * factors.at[1][1];
        const double r2 = a.at[i][2] * factors.at[2][2];
        for (int32 k = 0; k < 3; ++k)
        {
            m.at[i][k] -= r0 * b.at[k][0] + r1 * b.at[k][1] + r2 * b.at[k][2];
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

/// m += u^T W v
void AddProduct(Block3& m, const double (&u)[3][3], const Vector3& weights, const double (&v)[3][3],
                int32 rows)
{
    for (int32 row = 0; row < rows; ++row)
    {
        for (int32 i = 0; i < 3; ++i)
        {
            const double wu = weights.at[row] * u[row][i];
            for (int32 k = 0; k < 3; ++k)
            {
                m.at[i][k] += wu * v[row][k];
            }
        }
    }
}

/// m += u^T W u, on the diagonal and below it, where the factors are made from.
void AddSquare(Block3& m, const double (&u)[3][3], const Vector3& weights, int32 rows)
{
    for (int32 row = 0; row < rows; ++row)
    {
        const double x = weights.at[row] * u[row][0];
        const double y = weights.at[row] * u[row][1];
        const double w = weights.at[row] * u[row][2];
        m.at[0][0] += x * u[row][0];
        m.at[1][0] += y * u[row][0];
        m.at[1][1] += y * u[row][1];
        m.at[2][0] += w * u[row][0];
        m.at[2][1] += w * u[row][1];
        m.at[2][2] += w * u[row][2];
    }
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

void RowSystem::Build(const Array<RowSides>& sides, int32 mostUpdates, Elimination& elimination)
{
    elimination.Run(sides, mostUpdates, m_pattern);
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
    assign(m_weights, sides.size(), Vector3{});
    resize(m_residuals, sides.size());
    assign(m_found, sides.size(), Vector3{});
    assign(m_sides, m_pattern.sides.size(), Side{});
    resize(m_diagonal, m_pattern.columns.size() - 1);
    resize(m_x, m_diagonal.size());
    assign(m_addedMass, m_diagonal.size(), AddedMass());
    resize(m_stiffness, m_diagonal.size());
    resize(m_entries, m_pattern.rows.size());
}

void RowSystem::Factor()
{
    for (int32 i = 0; i < Components(); ++i)
    {
        Factor(i);
    }
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
            const BodyData& body = *m_pattern.columns[std::size_t(side.place)].body;
            highest = std::max(highest, stiffness.turning * double(column.invInertia) +
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

void RowSystem::Factor(int32 component, double compliance)
{
    const RowPattern::Component* c = m_pattern.components.data() + component;
    FillDiagonal(c);
    for (int32 i = c[0].firstItem; i < c[1].firstItem; ++i)
    {
        Fill(std::size_t(i), compliance);
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
        Block3& m = m_diagonal[std::size_t(i)];
        m = Block3{};
        const AddedMass& addedMass = m_addedMass[std::size_t(i)];
        const double inertia =
            body.SolverInvInertia() > 0.0f ? 1.0 / double(body.SolverInvInertia()) : 1.0;
        m.at[0][0] = m.at[1][1] = 1.0 / double(body.SolverInvMass()) + addedMass.mass;
        m.at[2][2] = inertia + addedMass.inertia;
    }
    const int32 first = m_pattern.columns[std::size_t(component[0].firstColumn)].firstEntry;
    const int32 last = m_pattern.columns[std::size_t(component[1].firstColumn)].firstEntry;
    std::fill(m_entries.begin() + first, m_entries.begin() + last, Block3{});
}

/// Adds an item, given by its index.
void RowSystem::Fill(std::size_t place, double compliance)
{
    const RowPattern::Item* item = m_pattern.items.data() + place;
    const auto index = std::size_t(item->item);
    const JointRows& rows = m_rows[index];
    Vector3& weights = m_weights[index];
    weights = Vector3{};
    for (int32 row = 0; row < rows.rows; ++row)
    {
        const double own = OwnOf(rows, row);
        const bool holds = own > 0.0 && (m_active[index] >> row & 1) != 0;
        weights.at[row] = holds ? 1.0 / (compliance * own + double(rows.laws[row].softness)) : 0.0;
    }
    for (int32 i = item[0].firstSide; i < item[1].firstSide; ++i)
    {
        const RowPattern::Side& side = m_pattern.sides[std::size_t(i)];
        const JointRows::Column& column = rows.columns[side.side];
        Side& to = m_sides[std::size_t(i)];
        for (int32 row = 0; row < rows.rows; ++row)
        {
            to.rows[row][0] = double(column.x[row]);
            to.rows[row][1] = double(column.y[row]);
            to.rows[row][2] = column.invInertia > 0.0f ? double(column.w[row]) : 0.0;
        }
        AddSquare(m_diagonal[std::size_t(side.place)], to.rows, weights, rows.rows);
    }
    for (int32 i = item[0].firstMeeting; i < item[1].firstMeeting; ++i)
    {
        const RowPattern::Meeting& meeting = m_pattern.meetings[std::size_t(i)];
        AddProduct(m_entries[std::size_t(meeting.entry)], m_sides[std::size_t(meeting.side1)].rows,
                   weights, m_sides[std::size_t(meeting.side2)].rows, rows.rows);
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
        for (int32 k = column.firstEntry; k <= i; ++k, ++target)
        {
            Block3& m = *target >= 0 ? m_entries[std::size_t(*target)]
                                     : m_diagonal[std::size_t(-1 - *target)];
            SubtractProduct(m, m_entries[std::size_t(i)], m_diagonal[place],
                            m_entries[std::size_t(k)]);
        }
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

void RowSystem::Solve()
{
    for (int32 i = 0; i < Components(); ++i)
    {
        Solve(i);
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
        const int32 rows = m_rows[std::size_t(item->item)].rows;
        for (int32 k = item[0].firstSide; k < item[1].firstSide; ++k)
        {
            const Side& side = m_sides[std::size_t(k)];
            Vector3& x = m_x[std::size_t(m_pattern.sides[std::size_t(k)].place)];
            for (int32 row = 0; row < rows; ++row)
            {
                const double push = weights.at[row] * residual.at[row];
                x.at[0] += push * side.rows[row][0];
                x.at[1] += push * side.rows[row][1];
                x.at[2] += push * side.rows[row][2];
            }
        }
    }
    Substitute(c);
    for (int32 i = c[0].firstItem; i < c[1].firstItem; ++i)
    {
        const RowPattern::Item* item = m_pattern.items.data() + i;
        Vector3 left = m_residuals[std::size_t(item->item)];
        const int32 rows = m_rows[std::size_t(item->item)].rows;
        for (int32 k = item[0].firstSide; k < item[1].firstSide; ++k)
        {
            const Side& side = m_sides[std::size_t(k)];
            const Vector3& x = m_x[std::size_t(m_pattern.sides[std::size_t(k)].place)];
            for (int32 row = 0; row < rows; ++row)
            {
                left.at[row] -= side.rows[row][0] * x.at[0] + side.rows[row][1] * x.at[1] +
                                side.rows[row][2] * x.at[2];
            }
        }
        const Vector3& weights = m_weights[std::size_t(item->item)];
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

Vector3 SpeedOf(const SolverContext& context, const JointRows& rows)
{
    Vector3 speed{};
    for (int32 side = 0; side < rows.bodies; ++side)
    {
        const JointRows::Column& column = rows.columns[side];
        const SolverBody& body = context.bodies[column.body];
        for (int32 i = 0; i < rows.rows; ++i)
        {
            speed.at[i] += double(column.x[i]) * double(body.v.x) +
                           double(column.y[i]) * double(body.v.y) +
                           double(column.w[i]) * double(body.w);
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
