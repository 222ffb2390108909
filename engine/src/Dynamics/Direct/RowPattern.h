// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

#include <compare>

class b2Joint;

/// The sparsity pattern of the system in RowSystem, and the elimination order of its bodies. Both
/// follow from which constraints share which bodies.
namespace box2d
{

/// True if joints and contacts can currently move it.
inline bool IsMoved(const BodyData& body)
{
    return body.IsDynamic() && body.awakeIndex != -1;
}

/// The bodies of a constraint that the solver moves, each once; nullptr for the others. By side, as
/// in JointRows.
struct RowSides
{
    const BodyData* sides[4] = {};
    int32 count = 0;

    void Add(const BodyData& body);
    bool operator==(const RowSides&) const = default;
};

RowSides SidesOf(b2Joint& joint);

/// A body's column of the system's lower triangle; index is the elimination order.
struct RowPattern
{
    struct Column
    {
        const BodyData* body;
        int32 firstEntry, firstTarget; ///< of this column; those of the next one are the ends
    };
    /// A side of a constraint with a moving body.
    struct Side
    {
        int32 side;
        int32 place; ///< index of its body
    };
    /// Two of these sides: the entry of the two bodies.
    struct Meeting
    {
        int32 side1, side2; ///< row and column of the entry: indices into `sides`
        int32 entry;
    };
    /// A constraint of the system.
    struct Item
    {
        int32 item;                    ///< index in the list
        int32 firstSide, firstMeeting; ///< those of the next one are the ends
    };
    /// A connected component.
    struct Component
    {
        int32 firstColumn, firstItem; ///< those of the next one are the ends
        bool hasLoops;                ///< contains cycles of constraints
    };

    void Clear();                                 ///< keeps the memory
    int32 EntryAt(int32 row, int32 column) const; ///< index of one that there is

    Array<Column> columns; ///< in elimination order, with one more for the end
    Array<int32> rows;     ///< row index of each entry below the diagonal, ascending in a column
    /// The target of each pair of a column's entries: an entry, or -1 - index on the diagonal.
    Array<int32> targets;
    Array<Component> components; ///< with one more for the end, as in the following two
    Array<Item> items;
    Array<Side> sides;
    Array<Meeting> meetings;
    Array<int32> iterative;        ///< constraints of systems above the cost limit
    Array<const BodyData*> bodies; ///< all moving bodies, including those solved iteratively
};

/// Computes patterns, and reuses its memory.
class Elimination
{
public:
    /// Bodies are eliminated by minimum degree (Davis, "Direct Methods for Sparse Linear Systems",
    /// 2006, 7.1), so that chains and trees fill in nothing. A component that costs more
    /// than `maxUpdates` a body is left out. Uses BodyData::jointLevel for itself.
    void Run(const Array<RowSides>& constraints, int32 maxUpdates, RowPattern& pattern);

private:
    struct Candidate // heap element; the next to eliminate is on top
    {
        std::size_t degree;
        int32 body;
        bool operator<(const Candidate& other) const
        {
            return degree != other.degree ? degree > other.degree : body > other.body;
        }
    };
    struct Member
    {
        int32 component;
        int32 item;
        // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 misinterprets the operator.
        auto operator<=>(const Member&) const = default;
    };

    void NumberBodies(const Array<RowSides>& constraints);
    void ConnectBodies(const Array<RowSides>& constraints);
    void Connect(int32 body1, int32 body2);
    void Offer(int32 body);
    void Gather(int32 seed);
    bool Eliminate(int32 maxUpdates);
    void Take(int32 body);
    void NumberRows();
    void ListTargets();
    int32 PlaceOf(const RowSides& constraint) const;
    void NumberComponents();
    void ListItems(const Array<RowSides>& constraints);
    void ListItem(const RowSides& constraint, int32 index);

    RowPattern* m_pattern = nullptr; ///< under construction
    /// Per body: neighbours not yet eliminated, ascending. For an eliminated body: its column,
    /// finally by index. The size is that of the largest system.
    Array<Array<int32>> m_neighbours;
    Array<int32> m_placeOf; ///< per body; -1: not yet, or skipped
    Array<uint8> m_seen;
    Array<int32> m_component; ///< bodies of the current component
    Array<Candidate> m_candidates;
    Array<int32> m_order;       ///< bodies in elimination order
    Array<int32> m_componentOf; ///< by index
    Array<Member> m_members;
};

} // namespace box2d
