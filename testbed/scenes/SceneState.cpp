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

/// The number of a null pointer.
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

// Eight bytes, lowest first, for every type, because scenes save few values. The four bytes of a
// float are the lowest on every supported machine.
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

// Eight letters a number.
void SceneState::Visit(std::string& text)
{
    std::uint64_t length = text.size();
    VisitBits(length);
    m_sound = m_sound && (!m_restores || length <= m_left.size());
    text.resize(m_sound ? std::size_t(length) : 0);
    for (std::size_t i = 0; i < text.size(); i += sizeof(std::uint64_t))
    {
        const std::size_t count = std::min(sizeof(std::uint64_t), text.size() - i);
        std::uint64_t letters = 0;
        for (std::size_t k = 0; k < count; ++k)
        {
            letters |= std::uint64_t(static_cast<unsigned char>(text[i + k])) << (8 * k);
        }
        VisitBits(letters);
        for (std::size_t k = 0; k < count; ++k)
        {
            text[i + k] = static_cast<char>(letters >> (8 * k));
        }
    }
}

void SceneState::Visit(std::map<std::uint32_t, std::string>& names)
{
    std::vector<std::pair<std::uint32_t, std::string>> all(names.begin(), names.end());
    std::uint64_t count = all.size();
    VisitBits(count);
    names.clear();
    for (std::uint64_t i = 0; i < count && m_sound; ++i)
    {
        auto [number, name] = m_restores ? std::pair(std::uint32_t(0), std::string()) : all[i];
        Visit(number);
        Visit(name);
        names.emplace(number, name);
    }
}

// By places, for addresses are others in every run.
void SceneState::Visit(std::map<const b2Joint*, std::string>& names)
{
    std::map<std::uint32_t, std::string> byPlace;
    for (std::size_t i = 0; i < m_joints.size(); ++i)
    {
        if (const auto named = names.find(m_joints[i]); named != names.end() && !m_restores)
        {
            byPlace.emplace(std::uint32_t(i), named->second);
        }
    }
    Visit(byPlace);
    names.clear();
    for (const auto& [place, name] : byPlace)
    {
        m_sound = m_sound && place < m_joints.size();
        names.emplace(m_sound ? m_joints[place] : nullptr, name);
    }
}

} // namespace boxreel
