// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

#include <compare>

class b2Joint;

/// Where the system of RowSystem is not zero, and in which order its bodies are eliminated: it
/// follows from which constraints share which bodies alone.
namespace box2d
{

/// Whether joints and contacts can move it now.
inline bool IsMoved(const BodyData& body)
{
    return body.IsDynamic() && body.awakeIndex != -1;
}

/// The bodies of a constraint that the solver moves, each once, nullptr where the others are: by
/// side, as in ConstraintRows.
struct RowSides
{
    const BodyData* sides[4] = {};
    int32 count = 0;

    void Add(const BodyData& body);
    bool operator==(const RowSides&) const = default;
};

RowSides SidesOf(b2Joint& joint);

/// A body's column of the system's lower triangle; place in the order of elimination.
struct RowPattern
{
    struct Column
    {
        const BodyData* body;
        int32 firstEntry, firstTarget; ///< of this column; the next one's end them
    };
    /// A side of a constraint whose body is moved.
    struct Side
    {
        int32 side;
        int32 place; ///< of its body
    };
    /// Two of these sides: the entry in which their bodies meet.
    struct Meeting
    {
        int32 side1, side2; ///< row and column of the entry: places in `sides`
        int32 entry;
    };
    /// A constraint of the system.
    struct Item
    {
        int32 item;                    ///< which of the list
        int32 firstSide, firstMeeting; ///< the next one's end them
    };
    /// A connected component.
    struct Component
    {
        int32 firstColumn, firstItem; ///< the next one's end them
        bool hasLoops;                ///< bodies are held in more than one way
    };

    void Clear();                                 ///< and keeps the memory
    int32 EntryAt(int32 row, int32 column) const; ///< places; -1 when there is none

    Array<Column> columns; ///< in the order of elimination, and one more for the end
    Array<int32> rows;     ///< of each entry below the diagonal: its place, rising in a column
    /// What each pair of a column's entries is subtracted from: an entry, or -1 - a place on the
    /// diagonal.
    Array<int32> targets;
    Array<Component> components; ///< and one more for the end, like the following two
    Array<Item> items;
    Array<Side> sides;
    Array<Meeting> meetings;
    Array<int32> swept;            ///< constraints of systems that would cost too much
    Array<const BodyData*> bodies; ///< all that are moved, swept ones too
};

/// Makes patterns, and keeps the memory that it works in from one to the next.
class Elimination
{
public:
    /// Bodies are eliminated by minimum degree (Davis, "Direct Methods for Sparse Linear Systems",
    /// 2006, 7.1), so that chains and trees fill in nothing. A component that costs more
    /// than `mostUpdates` a body is left out. Uses BodyData::jointLevel for itself.
    void Run(const Array<RowSides>& constraints, int32 mostUpdates, RowPattern& pattern);

private:
    struct Candidate // the first to be eliminated is on top of a heap
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
        // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 means the operator.
        auto operator<=>(const Member&) const = default;
    };

    void NumberBodies(const Array<RowSides>& constraints);
    void ConnectBodies(const Array<RowSides>& constraints);
    void Connect(int32 body1, int32 body2);
    void Offer(int32 body);
    void Gather(int32 seed);
    bool Eliminate(int32 mostUpdates);
    void Take(int32 body);
    void NumberRows();
    void ListTargets();
    int32 PlaceOf(const RowSides& constraint) const;
    void NumberComponents();
    void ListItems(const Array<RowSides>& constraints);
    void ListItem(const RowSides& constraint, int32 index);

    RowPattern* m_pattern = nullptr; ///< that is being made
    /// Of each body those not yet eliminated, rising; of one that has been, its column, in the end
    /// by places. As many as the largest system had.
    Array<Array<int32>> m_neighbours;
    Array<int32> m_placeOf; ///< of each body, -1: not yet, or left out
    Array<uint8> m_seen;
    Array<int32> m_component; ///< bodies that hang together
    Array<Candidate> m_candidates;
    Array<int32> m_order;       ///< bodies, as they are eliminated
    Array<int32> m_componentOf; ///< by place
    Array<Member> m_members;
};

} // namespace box2d
