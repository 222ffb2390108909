// SPDX-License-Identifier: MIT
#include "Islands.h"

#include "Access.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

namespace box2d
{

int32 Islands::Create()
{
    if (m_free.empty())
    {
        m_islands.emplace_back();
        return int32(m_islands.size()) - 1;
    }
    const int32 island = m_free.back();
    m_free.pop_back();
    m_islands[std::size_t(island)] = Island();
    return island;
}

void Islands::Append(int32 island, b2Body& body)
{
    ++m_version;
    Island& to = m_islands[std::size_t(island)];
    BodyData& data = Data(body);
    data.island = island;
    data.islandPrev = to.last;
    data.islandNext = nullptr;
    (to.last ? Data(*to.last).islandNext : to.first) = &body;
    to.last = &body;
    ++to.count;
}

void Islands::Add(b2Body& body)
{
    Append(Create(), body);
}

void Islands::Remove(b2Body& body)
{
    BodyData& data = Data(body);
    if (data.island == -1)
    {
        return;
    }
    ++m_version;
    Island& island = m_islands[std::size_t(data.island)];
    (data.islandPrev ? Data(*data.islandPrev).islandNext : island.first) = data.islandNext;
    (data.islandNext ? Data(*data.islandNext).islandPrev : island.last) = data.islandPrev;
    ++island.lostLinks;
    if (--island.count == 0)
    {
        m_free.push_back(data.island);
    }
    data.island = -1;
    data.islandPrev = nullptr;
    data.islandNext = nullptr;
}

// The smaller island joins the larger, so that a body changes its island at most log2(n) times.
void Islands::Link(b2Body& a, b2Body& b)
{
    int32 to = Data(a).island;
    int32 from = Data(b).island;
    if (to == -1 || from == -1 || to == from)
    {
        return;
    }
    if (m_islands[std::size_t(to)].count < m_islands[std::size_t(from)].count)
    {
        b2Swap(to, from);
    }
    ++m_version;
    Island& larger = m_islands[std::size_t(to)];
    Island& smaller = m_islands[std::size_t(from)];
    for (b2Body* body = smaller.first; body; body = Data(*body).islandNext)
    {
        Data(*body).island = to;
    }
    Data(*larger.last).islandNext = smaller.first;
    // NOLINTNEXTLINE(clang-analyzer-core.NonNullParamChecker): an island has at least one body.
    Data(*smaller.first).islandPrev = larger.last;
    larger.last = smaller.last;
    larger.count += smaller.count;
    larger.lostLinks += smaller.lostLinks;
    smaller = Island();
    m_free.push_back(from);
}

void Islands::Unlink(b2Body& a, b2Body& b)
{
    const int32 island = Data(a).island;
    if (island != -1 && island == Data(b).island)
    {
        ++m_islands[std::size_t(island)].lostLinks;
    }
}

void Islands::ReportSleepTime(const BodyData& body)
{
    if (body.island == -1)
    {
        return;
    }
    Island& island = m_islands[std::size_t(body.island)];
    if (!island.seen)
    {
        island.seen = true;
        island.minSleepTime = body.sleepTime;
        island.maxSleepTime = body.sleepTime;
        m_seen.push_back(body.island);
    }
    island.minSleepTime = b2Min(island.minSleepTime, body.sleepTime);
    island.maxSleepTime = b2Max(island.maxSleepTime, body.sleepTime);
}

const Array<int32>& Islands::FindSleepy(float32 timeToSleep)
{
    m_sleepy.clear();
    for (const int32 index : m_seen)
    {
        Island& island = m_islands[std::size_t(index)];
        island.seen = false;
        if (island.first == nullptr || island.maxSleepTime < timeToSleep)
        {
            continue;
        }
        if (island.lostLinks > 0)
        {
            Split(index, timeToSleep); // an active part of it may separate
        }
        else if (island.minSleepTime >= timeToSleep)
        {
            m_sleepy.push_back(index);
        }
    }
    m_seen.clear();
    return m_sleepy;
}

namespace
{

bool IsSleepy(const Islands::Island& island, float32 timeToSleep)
{
    for (b2Body* body = island.first; body; body = Data(*body).islandNext)
    {
        if (Data(*body).IsAwake() && Data(*body).sleepTime < timeToSleep)
        {
            return false;
        }
    }
    return true;
}

} // namespace

void Islands::Split(int32 index, float32 timeToSleep)
{
    m_members.clear();
    for (b2Body* body = m_islands[std::size_t(index)].first; body; body = Data(*body).islandNext)
    {
        m_members.push_back(body);
    }
    for (b2Body* body : m_members)
    {
        Data(*body).island = -1;
    }
    m_islands[std::size_t(index)] = Island();
    m_free.push_back(index);
    for (b2Body* seed : m_members)
    {
        if (Data(*seed).island == -1)
        {
            const int32 part = Create();
            Gather(*seed, part);
            if (IsSleepy(m_islands[std::size_t(part)], timeToSleep))
            {
                m_sleepy.push_back(part);
            }
        }
    }
}

// Depth-first search from the seed, along links between dynamic bodies.
void Islands::Gather(b2Body& seed, int32 island)
{
    Append(island, seed);
    m_stack.assign(1, &seed);
    const auto visit = [&](b2Body* other) {
        if (Data(*other).IsDynamic() && Data(*other).IsActive() && Data(*other).island == -1)
        {
            Append(island, *other);
            m_stack.push_back(other);
        }
    };
    while (!m_stack.empty())
    {
        b2Body* body = m_stack.back();
        m_stack.pop_back();
        for (b2ContactEdge* edge = body->GetContactList(); edge; edge = edge->next)
        {
            if (Data(*edge->contact).flags & kContactLinked)
            {
                visit(edge->other);
            }
        }
        for (b2JointEdge* edge = body->GetJointList(); edge; edge = edge->next)
        {
            if (JointAccess::Linked(*edge->joint))
            {
                visit(edge->other);
            }
        }
    }
}

} // namespace box2d
