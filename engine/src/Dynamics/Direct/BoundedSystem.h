// SPDX-License-Identifier: MIT
#pragma once

#include "RowSystem.h"

/// Constraints with bounded impulses: contacts do not pull, and friction is limited. The impulses
/// minimize an energy, and each impulse is either free or at a bound (Moreau, 1966; Lotstedt,
/// "Mechanical Systems of Rigid Bodies Subject to Unilateral Constraints", 1982). The start comes
/// from iterations. The rows inside their bounds are solved as if they had none. Rows that then
/// reach a bound stay there, and the rest is solved again. This is subspace minimisation after
/// projected Gauss-Seidel (Silcowitz, Niebe, Erleben, "A Nonsmooth Newton Method and Subspace
/// Minimization for Interactive Rigid Body Dynamics", 2010). The energy never rises, so a result
/// that is broken off early is still better than the start.
namespace box2d
{

/// Returns the speed that bodies with infinite mass give to a row, and those that turn with an
/// infinite moment of inertia.
double GivenSpeed(const JointRows& rows, int32 row, const SolverContext& context);

class BoundedSystem
{
public:
    /// A bound of this size means that a row is unbounded [Ns]. Exact impulses are far smaller, and
    /// its square is finite.
    static constexpr double kUnbounded = 1e30;

    struct Item
    {
        Vector3 speeds{};  ///< target speed of each row
        Vector3 impulse{}; ///< applied impulse
        Vector3 start{};   ///< impulse at which a row's softness has no effect
        Vector3 minimum{}, maximum{};
        uint8 active = 0; ///< rows that are not at a bound
    };

    /// Returns by how much rows miss their target speeds, beyond rounding [m/s]; a row at a bound
    /// may move away from it.
    static float32 ErrorOf(const SolverContext& context, const JointRows& rows, const Item& item);

    void Build(const Array<RowSides>& sides, int32 maxUpdates, Elimination& elimination);
    bool IsExact() const { return m_system.IsExact(); }
    std::size_t Count() const { return m_items.size(); }
    JointRows& Rows(std::size_t item) { return m_system.Rows(item); }
    Item& At(std::size_t item) { return m_items[item]; }
    const Array<const BodyData*>& Bodies() const { return m_system.Bodies(); }
    int32 Components() const { return m_system.Components(); }

    /// Reads the rows and the speeds that platforms give them. Call after the rows are filled.
    void Begin(const SolverContext& context);
    /// Call after Begin and when the items are filled, and again after a change of bounds. Changes
    /// velocities, impulses and the active set. An inactive row may violate its condition by
    /// `tolerance` [m/s].
    void Minimize(const SolverContext& context, double tolerance);
    /// True if bounds of -maximum and maximum require another solution.
    bool HasOtherLimit(std::size_t item, int32 row, double maximum) const;
    /// Sets these bounds. An impulse at a bound follows it, and one beyond is clamped. Call
    /// Minimize afterwards, because the velocities change.
    void Limit(const SolverContext& context, std::size_t item, int32 row, double maximum);
    /// True if an item whose first two impulses are bounded as a vector requires another solution.
    bool HasOtherDisc(const SolverContext& context, std::size_t item) const;
    /// If it slips, holds both impulses where they belong. Call Minimize afterwards.
    void LimitDisc(const SolverContext& context, std::size_t item);
    /// Mark stores velocities and impulses; KeepIfBetter returns to them if the energy is higher or
    /// has no minimum.
    void Mark(const SolverContext& context);
    void KeepIfBetter(const SolverContext& context);
    /// True if speeds are far above all marked or target speeds, or target speeds do far more work
    /// than the bodies could take. Rows then contradict each other, and the energy decreases
    /// without bound.
    bool HasBurst(const SolverContext& context) const;
    void GoBack(const SolverContext& context);
    /// True if there is more kinetic energy than marked, beyond rounding, and no body of infinite
    /// mass moves, which might have supplied it.
    bool HasGained(const SolverContext& context) const;
    /// True if rows of the first `items` that may only push have reached their target speeds, but
    /// for this tolerance.
    bool Separates(const SolverContext& context, std::size_t items, double tolerance) const;
    /// Returns the maximum speed at which bodies with infinite mass, such as a platform and the
    /// ground, move against each other at a row [m/s]. One alone, or all together, squeeze nothing.
    double FastestDriven(const SolverContext& context) const;

private:
    /// Returns the maximum speed that a body with infinite mass gives to a row [m/s], if it moves
    /// like `motion` of it.
    template <class Motion>
    double FastestGiven(Motion&& motion) const;
    bool IsDisc(std::size_t item) const;
    b2Vec2 DiscImpulse(const SolverContext& context, std::size_t item) const;
    bool Improve(const SolverContext& context);
    bool Release(const SolverContext& context, double tolerance);
    bool Move(const SolverContext& context, double share);
    bool MoveItem(std::size_t index, double share, Vector3& change);
    double ShareWithin() const;
    double KineticEnergyOfAll(const SolverContext& context) const;
    double Energy(const SolverContext& context) const;
    bool HasEndlessWork() const;
    double Fastest(const SolverContext& context) const;
    struct Mass
    {
        int32 body; // solver index
        double mass, inertia;
    };
    struct Impulse
    {
        Vector3 impulse;
        uint8 active;
    };
    struct Velocity
    {
        b2Vec2 v;
        float32 w;
    };
    struct Solution
    {
        Array<Impulse> impulses; // per item
        Array<Velocity> velocities;
        double energy = 0.0;
    };
    void Save(const SolverContext& context, Solution& solution) const;
    void Restore(const SolverContext& context, const Solution& solution);

    RowSystem m_system;
    Array<Item> m_items;
    Array<Vector3> m_given; // speeds of the rows from bodies of infinite mass
    Array<Mass> m_masses;   // per body
    Solution m_before, m_marked;
    double m_energy = 0.0;
    double m_markedFastest = 0.0, m_markedKinetic = 0.0;
};

} // namespace box2d
