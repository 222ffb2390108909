// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"
#include "RowPattern.h"

#include "../Joints/JointRows.h"

#include <utility>

/// Solves a system of equality constraints directly. The velocity change u gives the rows their
/// target speeds, J (v + u) = s, with the minimum energy. As e goes to 0, it minimizes
///   u^T M u / 2 + |J u - r|^2 / (2 e),   r = s - J v.
/// With a small e it follows from
///   (M + J^T J / e) u = J^T r / e,   and the impulses are  lambda = (r - J u) / e.
/// This matrix has a block per body and one per pair of joined bodies. It is positive definite for
/// any constraints, including redundant ones. Its factors L D L^T take linear time for chains and
/// trees (as in Baraff, "Linear-Time Dynamics using Lagrange Multipliers", SIGGRAPH 1996); loops
/// add fill-in. Components above a cost limit are left out.
namespace box2d
{

struct SnapshotAccess;

/// In double precision, because e is small: a chain of twenty links with a ball of a thousand times
/// their mass costs six digits.
struct Block3
{
    double at[3][3];
};

/// A symmetric matrix by its diagonal and what is below it, row by row.
struct Lower3
{
    double at[6];
};

struct Vector3
{
    double at[3];
};

/// Returns a body's part of the speed of a row.
inline double SpeedFrom(const JointRows::Column& c, int32 row, const SolverBody& s)
{
    return double(c.x[row]) * double(s.v.x) + double(c.y[row]) * double(s.v.y) +
           double(c.w[row]) * double(s.w);
}
/// Returns the speed of each row.
Vector3 SpeedOf(const SolverContext& context, const JointRows& rows);
/// Applies an impulse along the rows and adds it to theirs.
void Push(const SolverContext& context, JointRows& rows, const Vector3& impulse);

class RowSystem
{
public:
    void Build(const Array<RowSides>& sides, int32 maxUpdates, Elimination& elimination);

    std::size_t Count() const { return m_rows.size(); }
    JointRows& Rows(std::size_t item) { return m_rows[item]; }
    const JointRows& Rows(std::size_t item) const { return m_rows[item]; }
    bool IsExact() const { return m_pattern.iterative.empty(); }
    /// Returns all moving bodies.
    const Array<const BodyData*>& Bodies() const { return m_pattern.bodies; }
    /// A connected component, which can be solved by itself, from any thread.
    int32 Components() const { return int32(m_pattern.components.size()) - 1; }
    template <class Function>
    void ForItems(int32 component, Function&& function) const
    {
        const RowPattern::Component* c = m_pattern.components.data() + component;
        for (int32 i = c[0].firstItem; i < c[1].firstItem; ++i)
        {
            function(std::size_t(m_pattern.items[std::size_t(i)].item));
        }
    }

    bool HasLoops(int32 component) const
    {
        return m_pattern.components[std::size_t(component)].hasLoops;
    }
    template <class Function>
    void ForBodies(int32 component, Function&& function) const
    {
        const RowPattern::Component* c = m_pattern.components.data() + component;
        for (int32 i = c[0].firstColumn; i < c[1].firstColumn; ++i)
        {
            function(*m_pattern.columns[std::size_t(i)].body, std::size_t(i));
        }
    }
    /// Sets the active rows of an item, one bit per row. Default: all, after Build.
    void SetActive(std::size_t item, uint8 rows) { m_active[item] = rows; }

    /// Returns the maximum squared frequency [1/s] times the duration of the impulses. Considered
    /// are rotations of a body, and its lateral motion between the lines that hold it.
    double SquaredFrequency(int32 component) const;

    /// Reads the rows. Call after they are filled, and again after each change of them. The
    /// compliance is e relative to the row's own J M^-1 J^T: the fraction of its error that
    /// remains.
    void Read(int32 component, double compliance = kCompliance);
    /// Returns the speed of each of an item's rows; `given` is that of the bodies that do not move.
    Vector3 SpeedOf(const SolverContext& context, std::size_t item, const Vector3& given) const;
    /// Applies impulses along an item's rows.
    void Push(const SolverContext& context, std::size_t item, const Vector3& impulse) const;
    /// Returns J M^-1 J^T of each of an item's rows.
    const Vector3& Response(std::size_t item) const { return m_responses[item]; }

    /// Call after Read, and again after a change of the active rows.
    void Factor(int32 component);
    /// Small enough for exact joints. Of the 16 digits of a double, 7 remain for a row's error. If
    /// it is much smaller, rounding pushes a jointed pair, and a large sudden load fails. If it is
    /// much larger, chains of large mass ratios gain energy (docs/notes/tuned-constants.md).
    static constexpr double kCompliance = 1e-9;
    /// Adds mass and moment of inertia to the body at an index in later factorizations.
    void SetAddedMass(std::size_t place, double mass, double inertia)
    {
        m_addedMass[place] = {mass, inertia};
    }
    /// Makes the columns of an item's rows those of bodies with the added masses. Call it after the
    /// rows are filled; without it only factorizations see them.
    void TakeAddedMass(std::size_t item);
    /// Returns the residual of each row: its target speed minus its speed.
    Vector3& Residual(std::size_t item) { return m_residuals[item]; }
    /// Computes the impulses that remove the residuals.
    void Solve(int32 component);
    const Vector3& Found(std::size_t item) const { return m_found[item]; }
    /// Applies the impulses and adds them to those of the rows.
    void Apply(int32 component, const SolverContext& context);
    /// Applies the impulses as if the bodies had moved with them for `timeStep`. Without `keep`,
    /// impulses and velocities are not stored.
    void Apply(int32 component, const SolverContext& context, float32 timeStep, bool keep);

    /// Returns the constraints of components above the cost limit, which are left out.
    const Array<int32>& Iterative() const { return m_pattern.iterative; }

private:
    struct Side // side of an item, see RowPattern
    {
        double rows[3][3]; // by x, y, and rotation
        double invMass, invInertia;
        int32 body; // solver index
    };

    /// Resistance of a body to rotation [Nm s] and lateral motion [Ns/m], times the duration of the
    /// forces.
    struct Stiffness
    {
        double turning = 0.0, swaying = 0.0;
        void AddPoint(const JointRows& rows, const JointRows::Column& column);
        void AddLine(const JointRows& rows, const JointRows::Column& column);
    };

    struct AddedMass
    {
        double mass = 0.0, inertia = 0.0;
    };

    std::pair<int32, int32> SidesOf(std::size_t item) const; // indices in the pattern
    void ReadItem(std::size_t place, double compliance);
    void Fill(std::size_t place);
    void FillDiagonal(const RowPattern::Component* component);
    void Eliminate(std::size_t place);
    void Substitute(const RowPattern::Component* component);

    RowPattern m_pattern;
    Array<int32> m_places;   // per item: its index in the pattern; -1: left out
    Array<JointRows> m_rows; // per item
    Array<Vector3> m_responses;
    Array<uint8> m_active;
    Array<Vector3> m_stiff;   // 1 / e of its rows
    Array<Vector3> m_weights; // the same, 0 if inactive
    Array<Vector3> m_residuals, m_found;
    Array<Side> m_sides;
    Array<Lower3> m_squares;              // what each row of a side adds to the diagonal if active
    Array<Block3> m_products;             // what each row of a meeting adds to its entry
    mutable Array<Stiffness> m_stiffness; // by index
    Array<Vector3> m_x;                   // by index: right-hand side, then change of velocity
    Array<Lower3> m_diagonal;             // by index; factors after elimination
    Array<Block3> m_entries;
    Array<AddedMass> m_addedMass; // by index
};

} // namespace box2d
