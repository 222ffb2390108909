// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"
#include "RowPattern.h"

#include "../Joints/JointRows.h"

/// Constraints that are all to hold at once, solved exactly. Which changes u of velocity with the
/// least energy bring the rows to the speeds that are wanted, J (v + u) = s ? Those that make
///   u^T M u / 2 + |J u - r|^2 / (2 e),   r = s - J v,
/// least as e goes to 0; with a small e they follow from
///   (M + J^T J / e) u = J^T r / e,   and the impulses are  lambda = (r - J u) / e.
/// This matrix has a block for each body and one for each two that a constraint joins. It is
/// positive definite whatever the constraints are, and be it that many hold the same; its factors
/// L D L^T take a time linear in the size of a chain or a tree (as in Baraff, "Linear-Time Dynamics
/// using Lagrange Multipliers", SIGGRAPH 1996), and for loops what they fill in. Where that would
/// be too much, constraints are swept over (Gauss-Seidel).
namespace box2d
{

struct SnapshotAccess;

/// In double precision: e is small, and a ball of a thousand on a chain of twenty costs six digits.
struct Block3
{
    double at[3][3];
};

struct Vector3
{
    double at[3];
};

/// The speed of each row.
Vector3 SpeedOf(const SolverContext& context, const JointRows& rows);
/// Gives an impulse along the rows, and adds it to theirs.
void Push(const SolverContext& context, JointRows& rows, const Vector3& impulse);

class RowSystem
{
public:
    void Build(const Array<RowSides>& sides, int32 mostUpdates, Elimination& elimination);

    std::size_t Count() const { return m_rows.size(); }
    JointRows& Rows(std::size_t item) { return m_rows[item]; }
    const JointRows& Rows(std::size_t item) const { return m_rows[item]; }
    bool IsExact() const { return m_pattern.swept.empty(); }
    /// All that are moved.
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
    /// Whether an item is solved exactly, and not swept over.
    bool IsExact(std::size_t item) const { return m_exact[item] != 0; }

    /// Which rows of an item are to hold, a bit each [all, after Build].
    void SetActive(std::size_t item, uint8 rows) { m_active[item] = rows; }

    /// The largest, of a body that turns back and forth, or sways between the lines that hold it,
    /// under the impulses that rows give to its points, times the time in which they were given
    /// [1/s].
    double SquaredFrequency(int32 component) const;

    /// After the rows have been filled. The compliance is e, as a share of what a row feels of its
    /// own impulse: the share of its error that is left.
    void Factor(int32 component, double compliance = kCompliance);
    void Factor();
    static constexpr double kCompliance = 1e-9;
    /// Makes the body at a place harder to move in what is factored from now on, by so much mass
    /// and moment of inertia.
    void SetBallast(std::size_t place, double mass, double inertia)
    {
        m_ballast[place] = {mass, inertia};
    }
    /// What is missing of the speed that each row should have.
    Vector3& Lack(std::size_t item) { return m_lack[item]; }
    /// Finds the impulses that give it.
    void Solve(int32 component);
    void Solve();
    const Vector3& Found(std::size_t item) const { return m_found[item]; }
    /// Gives them, and adds them to those of the rows.
    void Apply(int32 component, const SolverContext& context);
    /// Gives them as if they had been given before the bodies moved for `timeStep`; without keeping
    /// them and the velocities, if so wanted.
    void Apply(int32 component, const SolverContext& context, float32 timeStep, bool keep);

    /// Constraints that are not solved exactly, to be swept over one by one: after Factor, what
    /// each of them is to give.
    const Array<int32>& Swept() const { return m_pattern.swept; }
    void FactorSwept(std::size_t item);
    void SolveSwept(std::size_t item);

private:
    friend struct SnapshotAccess;
    struct Side // of an item, see RowPattern
    {
        double rows[3][3]; // by x, y, and turning
    };

    /// Of what pulls at a body against its turning [Nm s] and its swaying to and fro [Ns/m], times
    /// the time in which it pulls.
    struct Stiffness
    {
        double turning = 0.0, swaying = 0.0;
        void AddPoint(const JointRows& rows, const JointRows::Column& column);
        void AddLine(const JointRows& rows, const JointRows::Column& column);
    };

    struct Ballast
    {
        double mass = 0.0, inertia = 0.0;
    };

    void Fill(std::size_t place, double compliance);
    void FillDiagonal(const RowPattern::Component* component);
    void Eliminate(std::size_t place);
    void Substitute(const RowPattern::Component* component);

    RowPattern m_pattern;
    Array<JointRows> m_rows; // of each item
    Array<uint8> m_active;
    Array<Vector3> m_weights; // 1 / e of its rows, 0 where not active
    Array<Vector3> m_lack, m_found;
    Array<Side> m_sides;
    Array<uint8> m_exact;                 // of each item
    mutable Array<Stiffness> m_stiffness; // by place
    Array<Vector3> m_x;                   // by place: right side, then change of velocity
    Array<Block3> m_diagonal;             // by place; factors once eliminated
    Array<Block3> m_entries;
    Array<Ballast> m_ballast; // by place
    Array<Block3> m_own;      // of each swept item: the factors of J M^-1 J^T
};

} // namespace box2d
