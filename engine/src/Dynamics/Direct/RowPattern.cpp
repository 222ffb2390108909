// SPDX-License-Identifier: MIT
#include "RowPattern.h"

#include "../Joints/JointKinds.h"

#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>

namespace box2d
{

namespace
{

/// Initial capacity of each neighbour list, to avoid repeated growth. It affects allocations only:
/// packed circles have six neighbours.
constexpr std::size_t kFewNeighbours = 8;

std::size_t At(int32 index)
{
    return std::size_t(index);
}

} // namespace

void Elimination::Run(const Array<RowSides>& constraints, int32 maxUpdates, RowPattern& pattern)
{
    m_pattern = &pattern;
    pattern.Clear();
    m_order.clear();
    NumberBodies(constraints);
    ConnectBodies(constraints);
    for (std::size_t i = 0; i < m_seen.size(); ++i)
    {
        if (m_seen[i] != 0)
        {
            continue;
        }
        const std::size_t before = m_order.size();
        Gather(int32(i));
        if (Eliminate(maxUpdates))
        {
            pattern.components.push_back({int32(before), 0, false});
            continue;
        }
        m_order.resize(before);
        for (const int32 body : m_component)
        {
            m_placeOf[At(body)] = -1;
        }
    }
    pattern.components.push_back({int32(m_order.size()), 0, false});
    NumberRows();
    ListTargets();
    NumberComponents();
    ListItems(constraints);
}

void Elimination::NumberBodies(const Array<RowSides>& constraints)
{
    for (const RowSides& constraint : constraints)
    {
        for (const BodyData* body : constraint.sides)
        {
            if (body != nullptr)
            {
                body->jointLevel = -1;
            }
        }
    }
    for (const RowSides& constraint : constraints)
    {
        for (const BodyData* body : constraint.sides)
        {
            if (body != nullptr && body->jointLevel == -1)
            {
                body->jointLevel = int32(m_pattern->bodies.size());
                m_pattern->bodies.push_back(body);
            }
        }
    }
}

void Elimination::ConnectBodies(const Array<RowSides>& constraints)
{
    const std::size_t count = m_pattern->bodies.size();
    m_placeOf.assign(count, -1);
    m_seen.assign(count, 0);
    m_neighbours.resize(b2Max(m_neighbours.size(), count));
    for (std::size_t i = 0; i < count; ++i)
    {
        m_neighbours[i].clear();
        m_neighbours[i].reserve(kFewNeighbours);
    }
    for (const RowSides& constraint : constraints)
    {
        for (int32 i = 1; i < constraint.count; ++i)
        {
            for (int32 k = 0; k < i; ++k)
            {
                const BodyData* first = constraint.sides[i];
                const BodyData* second = constraint.sides[k];
                if (first != nullptr && second != nullptr)
                {
                    Connect(first->jointLevel, second->jointLevel);
                    Connect(second->jointLevel, first->jointLevel);
                }
            }
        }
    }
}

/// Adds one direction of the connection.
void Elimination::Connect(int32 body1, int32 body2)
{
    Array<int32>& list = m_neighbours[At(body1)];
    const auto place = std::lower_bound(list.begin(), list.end(), body2);
    if (place == list.end() || *place != body2)
    {
        list.insert(place, body2);
    }
}

/// Its connected component.
void Elimination::Gather(int32 seed)
{
    m_component.assign(1, seed);
    m_seen[At(seed)] = 1;
    for (std::size_t i = 0; i < m_component.size(); ++i)
    {
        for (const int32 other : m_neighbours[At(m_component[i])])
        {
            if (m_seen[At(other)] == 0)
            {
                m_seen[At(other)] = 1;
                m_component.push_back(other);
            }
        }
    }
}

void Elimination::Offer(int32 body)
{
    m_candidates.push_back({m_neighbours[At(body)].size(), body});
    std::push_heap(m_candidates.begin(), m_candidates.end());
}

/// False if it exceeds the cost limit.
bool Elimination::Eliminate(int32 maxUpdates)
{
    m_candidates.clear();
    const std::size_t end = m_order.size() + m_component.size();
    std::size_t updates = 0;
    for (const int32 body : m_component)
    {
        Offer(body);
    }
    while (m_order.size() < end)
    {
        const Candidate next = m_candidates.front();
        std::pop_heap(m_candidates.begin(), m_candidates.end());
        m_candidates.pop_back();
        const std::size_t degree = m_neighbours[At(next.body)].size();
        if (m_placeOf[At(next.body)] != -1 || next.degree != degree)
        {
            continue; // outdated entry: it was added again since
        }
        updates += degree * (degree + 1) / 2;
        if (updates > At(maxUpdates) * m_component.size())
        {
            return false;
        }
        Take(next.body);
    }
    return true;
}

void Elimination::Take(int32 body)
{
    m_placeOf[At(body)] = int32(m_order.size());
    m_order.push_back(body);
    const Array<int32>& others = m_neighbours[At(body)];
    for (const int32 other : others)
    {
        Array<int32>& list = m_neighbours[At(other)];
        list.erase(std::lower_bound(list.begin(), list.end(), body));
        for (const int32 second : others)
        {
            if (second != other)
            {
                Connect(other, second);
            }
        }
    }
    for (const int32 other : others)
    {
        Offer(other);
    }
}

/// Replaces bodies by indices in the elimination order.
void Elimination::NumberRows()
{
    for (const int32 eliminated : m_order)
    {
        Array<int32>& list = m_neighbours[At(eliminated)];
        for (int32& body : list)
        {
            body = m_placeOf[At(body)];
        }
        std::sort(list.begin(), list.end());
        m_pattern->columns.push_back(
            {m_pattern->bodies[At(eliminated)], int32(m_pattern->rows.size()), 0});
        m_pattern->rows.insert(m_pattern->rows.end(), list.begin(), list.end());
    }
    m_pattern->columns.push_back({nullptr, int32(m_pattern->rows.size()), 0});
}

void Elimination::ListTargets()
{
    for (std::size_t place = 0; place < m_order.size(); ++place)
    {
        m_pattern->columns[place].firstTarget = int32(m_pattern->targets.size());
        const Array<int32>& list = m_neighbours[At(m_order[place])];
        for (std::size_t i = 0; i < list.size(); ++i)
        {
            for (std::size_t k = 0; k < i; ++k)
            {
                m_pattern->targets.push_back(m_pattern->EntryAt(list[i], list[k]));
            }
            m_pattern->targets.push_back(-1 - list[i]);
        }
    }
    m_pattern->columns.back().firstTarget = int32(m_pattern->targets.size());
}

/// Returns the index of one of its bodies; -1 if none moves, -2 if it is not in the system.
int32 Elimination::PlaceOf(const RowSides& constraint) const
{
    for (const BodyData* body : constraint.sides)
    {
        if (body != nullptr)
        {
            const int32 place = m_placeOf[At(body->jointLevel)];
            return place == -1 ? -2 : place;
        }
    }
    return -1;
}

void Elimination::NumberComponents()
{
    m_componentOf.resize(m_order.size());
    for (std::size_t i = 0; i + 1 < m_pattern->components.size(); ++i)
    {
        for (int32 k = m_pattern->components[i].firstColumn;
             k < m_pattern->components[i + 1].firstColumn; ++k)
        {
            m_componentOf[At(k)] = int32(i);
        }
    }
}

/// Lists the items by component, each in the order of the list.
void Elimination::ListItems(const Array<RowSides>& constraints)
{
    m_members.clear();
    for (std::size_t i = 0; i < constraints.size(); ++i)
    {
        const int32 place = PlaceOf(constraints[i]);
        if (place >= 0)
        {
            m_members.push_back({m_componentOf[At(place)], int32(i)});
        }
        else if (place == -2)
        {
            m_pattern->iterative.push_back(int32(i));
        }
    }
    std::sort(m_members.begin(), m_members.end());
    auto member = m_members.begin();
    for (std::size_t i = 0; i < m_pattern->components.size(); ++i)
    {
        RowPattern::Component* c = m_pattern->components.data() + i;
        c->firstItem = int32(m_pattern->items.size());
        int32 ties = 0; // a tree, possibly attached once to the world, has one tie per body
        for (; member != m_members.end() && member->component == int32(i); ++member)
        {
            const RowSides& constraint = constraints[At(member->item)];
            ties += constraint.count - 1;
            ListItem(constraint, member->item);
        }
        const bool isEnd = i + 1 == m_pattern->components.size();
        c->hasLoops = !isEnd && ties > c[1].firstColumn - c[0].firstColumn;
    }
    m_pattern->items.push_back(
        {-1, int32(m_pattern->sides.size()), int32(m_pattern->meetings.size())});
}

void Elimination::ListItem(const RowSides& constraint, int32 index)
{
    const auto first = int32(m_pattern->sides.size());
    m_pattern->items.push_back({index, first, int32(m_pattern->meetings.size())});
    for (int32 side = 0; side < constraint.count; ++side)
    {
        if (constraint.sides[side] == nullptr)
        {
            continue;
        }
        const int32 place = m_placeOf[At(constraint.sides[side]->jointLevel)];
        const auto last = int32(m_pattern->sides.size());
        for (int32 other = first; other < last; ++other)
        {
            const int32 second = m_pattern->sides[At(other)].place;
            const int32 entry = m_pattern->EntryAt(b2Max(place, second), b2Min(place, second));
            m_pattern->meetings.push_back(place > second ? RowPattern::Meeting{last, other, entry}
                                                         : RowPattern::Meeting{other, last, entry});
        }
        m_pattern->sides.push_back({side, place});
    }
}

void RowSides::Add(const BodyData& body)
{
    sides[count++] = IsMoved(body) ? &body : nullptr;
}

RowSides SidesOf(b2Joint& joint)
{
    RowSides result;
    const BodyData* known[4];
    const auto add = [&](const b2Joint& part) {
        for (const b2Body* body : {part.GetBodyA(), part.GetBodyB()})
        {
            const BodyData* data = &Data(*body);
            if (std::find(known, known + result.count, data) == known + result.count)
            {
                known[result.count] = data;
                result.Add(*data);
            }
        }
    };
    ForParts(joint, add);
    return result;
}

int32 RowPattern::EntryAt(int32 row, int32 column) const
{
    const auto first = rows.begin() + columns[std::size_t(column)].firstEntry;
    const auto last = rows.begin() + columns[std::size_t(column) + 1].firstEntry;
    return int32(std::lower_bound(first, last, row) - rows.begin());
}

void RowPattern::Clear()
{
    columns.clear();
    rows.clear();
    targets.clear();
    components.clear();
    items.clear();
    sides.clear();
    meetings.clear();
    iterative.clear();
    bodies.clear();
}

} // namespace box2d
