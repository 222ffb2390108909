// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

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
    /// What hangs together.
    struct Component
    {
        int32 firstColumn, firstItem; ///< the next one's end them
        bool hasLoops;                ///< bodies are held in more than one way
    };

    /// Bodies are eliminated by minimum degree (Davis, "Direct Methods for Sparse Linear Systems",
    /// 2006, 7.1), so that chains and trees fill in nothing. What hangs together and costs more
    /// than `mostUpdates` a body is left out. Uses BodyData::jointLevel for itself.
    void Build(const Array<RowSides>& constraints, int32 mostUpdates);
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

} // namespace box2d
