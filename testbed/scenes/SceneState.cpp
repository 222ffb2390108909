// SPDX-License-Identifier: MIT
#include <scenes/SceneState.h>

#include <algorithm>

namespace boxreel
{

namespace
{

template <class Thing>
std::vector<Thing*> OldestFirst(Thing* newest)
{
    std::vector<Thing*> things;
    for (Thing* thing = newest; thing != nullptr; thing = thing->GetNext())
    {
        things.push_back(thing);
    }
    std::reverse(things.begin(), things.end());
    return things;
}

/// Of a pointer that may be null: a name for none.
constexpr std::uint64_t kNone = ~std::uint64_t(0);

} // namespace

SceneState::SceneState(b2World& world)
    : m_restores(false), m_bodies(OldestFirst(world.GetBodyList())),
      m_joints(OldestFirst(world.GetJointList()))
{}

SceneState::SceneState(b2World& world, std::span<const uint8> bytes) : SceneState(world)
{
    m_restores = true;
    m_left = bytes;
}

// Eight bytes, the lowest first: whatever it is, a scene keeps few of them. A float's four bytes
// lie lowest on every machine that this is built for.
void SceneState::VisitBits(std::uint64_t& bits)
{
    if (!m_restores)
    {
        for (int shift = 0; shift < 64; shift += 8)
        {
            m_saved.push_back(uint8(bits >> shift));
        }
        return;
    }
    m_sound = m_sound && m_left.size() >= sizeof(bits);
    bits = 0;
    for (int i = 0; i < 8 && m_sound; ++i)
    {
        bits |= std::uint64_t(m_left[std::size_t(i)]) << (8 * i);
    }
    m_left = m_sound ? m_left.subspan(sizeof(bits)) : std::span<const uint8>();
}

void SceneState::Visit(bool& flag)
{
    std::uint64_t bits = flag ? 1 : 0;
    VisitBits(bits);
    flag = bits != 0;
}

void SceneState::Visit(b2Body*& body)
{
    std::uint64_t number = body && !m_restores ? std::uint64_t(body->GetNumber()) : kNone;
    VisitBits(number);
    if (m_restores)
    {
        const auto found = std::find_if(m_bodies.begin(), m_bodies.end(), [&](b2Body* b) {
            return std::uint64_t(b->GetNumber()) == number;
        });
        m_sound = m_sound && (found != m_bodies.end() || number == kNone);
        body = found != m_bodies.end() ? *found : nullptr;
    }
}

void SceneState::Visit(b2Joint*& joint)
{
    const auto known = std::find(m_joints.begin(), m_joints.end(), joint);
    std::uint64_t place = joint && !m_restores ? std::uint64_t(known - m_joints.begin()) : kNone;
    VisitBits(place);
    if (m_restores)
    {
        m_sound = m_sound && (place < m_joints.size() || place == kNone);
        joint = place < m_joints.size() ? m_joints[std::size_t(place)] : nullptr;
    }
}

} // namespace boxreel
