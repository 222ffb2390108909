// SPDX-License-Identifier: MIT
#include "RowPattern.h"

#include <Box2D/Dynamics/Joints/b2GearJoint.h>
#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>
#include <queue>

namespace box2d
{

namespace
{

std::size_t At(int32 index)
{
    return std::size_t(index);
}

class Elimination
{
public:
    Elimination(const Array<RowSides>& constraints, int32 mostUpdates, RowPattern& pattern);
    void Run();

private:
    void NumberBodies();
    void Connect(int32 body1, int32 body2);
    Array<int32> Gather(int32 seed);
    bool Eliminate(const Array<int32>& component);
    void Take(int32 body);
    void NumberRows();
    void ListTargets();
    int32 PlaceOf(const RowSides& constraint) const;
    void ListItems();
    void ListItem(int32 index);

    struct Candidate // the first to be eliminated is on top of a heap
    {
        std::size_t degree;
        int32 body;
        bool operator<(const Candidate& other) const
        {
            return degree != other.degree ? degree > other.degree : body > other.body;
        }
    };

    const Array<RowSides>& m_constraints;
    RowPattern& m_pattern;
    std::size_t m_mostUpdates;
    Array<Array<int32>> m_neighbours; // of each body: those not yet eliminated, rising
    Array<int32> m_placeOf;           // of each body, -1: not yet, or left out
    Array<uint8> m_seen;
    std::priority_queue<Candidate> m_candidates;
    Array<Array<int32>> m_structure; // of each column: bodies, in the end places
};

Elimination::Elimination(const Array<RowSides>& constraints, int32 mostUpdates, RowPattern& pattern)
    : m_constraints(constraints), m_pattern(pattern), m_mostUpdates(At(mostUpdates))
{
    NumberBodies();
    m_neighbours.resize(m_pattern.bodies.size());
    m_placeOf.assign(m_pattern.bodies.size(), -1);
    m_seen.resize(m_pattern.bodies.size());
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

void Elimination::NumberBodies()
{
    for (const RowSides& constraint : m_constraints)
    {
        for (const BodyData* body : constraint.sides)
        {
            if (body != nullptr)
            {
                body->jointLevel = -1;
            }
        }
    }
    for (const RowSides& constraint : m_constraints)
    {
        for (const BodyData* body : constraint.sides)
        {
            if (body != nullptr && body->jointLevel == -1)
            {
                body->jointLevel = int32(m_pattern.bodies.size());
                m_pattern.bodies.push_back(body);
            }
        }
    }
}

/// One way.
void Elimination::Connect(int32 body1, int32 body2)
{
    Array<int32>& list = m_neighbours[At(body1)];
    const auto place = std::lower_bound(list.begin(), list.end(), body2);
    if (place == list.end() || *place != body2)
    {
        list.insert(place, body2);
    }
}

/// All that hangs together with it.
Array<int32> Elimination::Gather(int32 seed)
{
    Array<int32> component{seed};
    m_seen[At(seed)] = 1;
    for (std::size_t i = 0; i < component.size(); ++i)
    {
        for (const int32 other : m_neighbours[At(component[i])])
        {
            if (m_seen[At(other)] == 0)
            {
                m_seen[At(other)] = 1;
                component.push_back(other);
            }
        }
    }
    return component;
}

void Elimination::Run()
{
    for (std::size_t i = 0; i < m_seen.size(); ++i)
    {
        if (m_seen[i] != 0)
        {
            continue;
        }
        const std::size_t before = m_pattern.columns.size();
        const Array<int32> component = Gather(int32(i));
        if (Eliminate(component))
        {
            m_pattern.components.push_back({int32(before), 0, false});
            continue;
        }
        m_pattern.columns.resize(before);
        m_structure.resize(before);
        for (const int32 body : component)
        {
            m_placeOf[At(body)] = -1;
        }
    }
    m_pattern.components.push_back({int32(m_pattern.columns.size()), 0, false});
    NumberRows();
    ListTargets();
    ListItems();
}

/// False when it costs too much.
bool Elimination::Eliminate(const Array<int32>& component)
{
    m_candidates = {};
    const std::size_t end = m_pattern.columns.size() + component.size();
    std::size_t updates = 0;
    for (const int32 body : component)
    {
        m_candidates.push({m_neighbours[At(body)].size(), body});
    }
    while (m_pattern.columns.size() < end)
    {
        const Candidate next = m_candidates.top();
        m_candidates.pop();
        const std::size_t degree = m_neighbours[At(next.body)].size();
        if (m_placeOf[At(next.body)] != -1 || next.degree != degree)
        {
            continue; // it has been offered again since
        }
        updates += degree * (degree + 1) / 2;
        if (updates > m_mostUpdates * component.size())
        {
            return false;
        }
        Take(next.body);
    }
    return true;
}

void Elimination::Take(int32 body)
{
    m_placeOf[At(body)] = int32(m_pattern.columns.size());
    m_pattern.columns.push_back({m_pattern.bodies[At(body)], 0, 0});
    m_structure.push_back(std::move(m_neighbours[At(body)]));
    const Array<int32>& others = m_structure.back();
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
        m_candidates.push({m_neighbours[At(other)].size(), other});
    }
}

/// From bodies to places in the order.
void Elimination::NumberRows()
{
    for (std::size_t place = 0; place < m_structure.size(); ++place)
    {
        Array<int32>& list = m_structure[place];
        for (int32& body : list)
        {
            body = m_placeOf[At(body)];
        }
        std::sort(list.begin(), list.end());
        m_pattern.columns[place].firstEntry = int32(m_pattern.rows.size());
        m_pattern.rows.insert(m_pattern.rows.end(), list.begin(), list.end());
    }
    m_pattern.columns.push_back({nullptr, int32(m_pattern.rows.size()), 0});
}

void Elimination::ListTargets()
{
    for (std::size_t place = 0; place < m_structure.size(); ++place)
    {
        m_pattern.columns[place].firstTarget = int32(m_pattern.targets.size());
        const Array<int32>& list = m_structure[place];
        for (std::size_t i = 0; i < list.size(); ++i)
        {
            for (std::size_t k = 0; k < i; ++k)
            {
                m_pattern.targets.push_back(m_pattern.EntryAt(list[i], list[k]));
            }
            m_pattern.targets.push_back(-1 - list[i]);
        }
    }
    m_pattern.columns.back().firstTarget = int32(m_pattern.targets.size());
}

/// The place of one of its bodies, -1 if none is moved, -2 if it is not in the system.
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

/// Component by component, in each in the order of the list.
void Elimination::ListItems()
{
    Array<int32> componentOf(m_structure.size());
    for (std::size_t i = 0; i + 1 < m_pattern.components.size(); ++i)
    {
        for (int32 k = m_pattern.components[i].firstColumn;
             k < m_pattern.components[i + 1].firstColumn; ++k)
        {
            componentOf[At(k)] = int32(i);
        }
    }
    Array<Array<int32>> members(m_pattern.components.size());
    for (std::size_t i = 0; i < m_constraints.size(); ++i)
    {
        const int32 place = PlaceOf(m_constraints[i]);
        if (place >= 0)
        {
            members[At(componentOf[At(place)])].push_back(int32(i));
        }
        else if (place == -2)
        {
            m_pattern.swept.push_back(int32(i));
        }
    }
    for (std::size_t i = 0; i + 1 < members.size(); ++i)
    {
        RowPattern::Component* c = m_pattern.components.data() + i;
        int32 ties = 0; // a tree that may be tied down once has one to each body
        for (const int32 item : members[i])
        {
            ties += m_constraints[At(item)].count - 1;
        }
        c->hasLoops = ties > c[1].firstColumn - c[0].firstColumn;
    }
    for (std::size_t i = 0; i < members.size(); ++i)
    {
        m_pattern.components[i].firstItem = int32(m_pattern.items.size());
        for (const int32 item : members[i])
        {
            ListItem(item);
        }
    }
    m_pattern.items.push_back(
        {-1, int32(m_pattern.sides.size()), int32(m_pattern.meetings.size())});
}

void Elimination::ListItem(int32 index)
{
    const RowSides& constraint = m_constraints[At(index)];
    const auto first = int32(m_pattern.sides.size());
    m_pattern.items.push_back({index, first, int32(m_pattern.meetings.size())});
    for (int32 side = 0; side < constraint.count; ++side)
    {
        if (constraint.sides[side] == nullptr)
        {
            continue;
        }
        const int32 place = m_placeOf[At(constraint.sides[side]->jointLevel)];
        const auto last = int32(m_pattern.sides.size());
        for (int32 other = first; other < last; ++other)
        {
            const int32 second = m_pattern.sides[At(other)].place;
            const int32 entry = m_pattern.EntryAt(b2Max(place, second), b2Min(place, second));
            m_pattern.meetings.push_back(place > second ? RowPattern::Meeting{last, other, entry}
                                                        : RowPattern::Meeting{other, last, entry});
        }
        m_pattern.sides.push_back({side, place});
    }
}

} // namespace

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
    if (joint.GetType() == e_gearJoint)
    {
        auto& gear = static_cast<b2GearJoint&>(joint);
        add(*gear.GetJoint1());
        add(*gear.GetJoint2());
    }
    else
    {
        add(joint);
    }
    return result;
}

int32 RowPattern::EntryAt(int32 row, int32 column) const
{
    const auto first = rows.begin() + columns[std::size_t(column)].firstEntry;
    const auto last = rows.begin() + columns[std::size_t(column) + 1].firstEntry;
    const auto place = std::lower_bound(first, last, row);
    return place != last && *place == row ? int32(place - rows.begin()) : -1;
}

void RowPattern::Build(const Array<RowSides>& constraints, int32 mostUpdates)
{
    *this = RowPattern();
    Elimination(constraints, mostUpdates, *this).Run();
}

} // namespace box2d
