// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/Random.h>

#include <Box2D/Box2D.h>

#include <cstring>
#include <map>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace boxreel
{

/// The state of a scene beside its world: pointers into it, counters, times, random numbers. A
/// scene lists them in Scene::VisitState, which both saves and restores:
///   void VisitState(SceneState& state) override { state(m_ball, m_thrown, m_time, m_random); }
/// Bodies are stored by their number and joints by their index, so the world is restored first.
class SceneState
{
public:
    /// To save.
    explicit SceneState(b2World& world);
    /// To restore from what Take returned. After a mistake all that is read is zero.
    SceneState(b2World& world, std::span<const uint8> bytes);

    template <class... Values>
    void operator()(Values&... values)
    {
        (Visit(values), ...);
    }

    /// Returns the saved bytes.
    std::vector<uint8> Take() { return std::move(m_saved); }
    /// True if the restored data was valid and has been read completely.
    bool IsWhole() const { return m_sound && m_left.empty(); }

private:
    template <class Number>
    void Visit(Number& number)
    {
        static_assert(std::is_arithmetic_v<Number>, "Numbers, bodies, joints, Random.");
        std::uint64_t bits = 0;
        if (!m_restores)
        {
            std::memcpy(&bits, &number, sizeof(number));
        }
        VisitBits(bits);
        if (m_restores)
        {
            std::memcpy(&number, &bits, sizeof(number));
        }
    }
    void Visit(bool& flag);
    void Visit(b2Body*& body);   ///< may be null
    void Visit(b2Joint*& joint); ///< may be null
    void Visit(Random& random) { VisitBits(random.Counter()); }
    void Visit(std::string& text);
    void Visit(std::map<std::uint32_t, std::string>& names);  ///< by numbers of bodies
    void Visit(std::map<const b2Joint*, std::string>& names); ///< without joints that are gone
    void VisitBits(std::uint64_t& bits);

    bool m_restores;
    bool m_sound = true;
    std::vector<b2Body*> m_bodies; ///< oldest first
    std::vector<b2Joint*> m_joints;
    std::vector<uint8> m_saved;
    std::span<const uint8> m_left;
};

} // namespace boxreel
