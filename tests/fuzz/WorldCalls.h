// SPDX-License-Identifier: MIT
#pragma once

#include "Choices.h"
#include "Listeners.h"

#include <Box2D/Box2D.h>

#include <string>
#include <vector>

namespace fuzz
{

/// Calls the public interface of a world in an order, and with arguments, that bytes decide. The
/// first byte says whether the world is wild (see Choices), which needs an engine with its asserts
/// off.
class WorldCalls
{
public:
    explicit WorldCalls(std::span<const std::uint8_t> bytes);
    ~WorldCalls();
    WorldCalls(const WorldCalls&) = delete;
    WorldCalls& operator=(const WorldCalls&) = delete;

    bool Done() const { return m_choices.Done(); }
    /// Makes one call and returns its name.
    const char* Call();
    /// Returns the broken invariant of the world as a sentence; empty if there is none.
    std::string WhyBroken();

private:
    const char* CreateBody();
    const char* DestroyBody();
    void AddFixture(b2Body* body);
    const char* CreateFixture();
    const char* DestroyFixture();
    const char* ChangeFixture();
    const char* CreateJointBetween();
    const char* DestroyJoint();
    const char* ChangeOneJoint();
    const char* ChangeBody();
    const char* Push();
    const char* ChangeWorld();
    const char* Listen();
    const char* Ask();
    const char* Step();

    b2Body* Body();
    b2Fixture* Fixture();
    b2Joint* Joint();

    Choices m_choices;
    b2World m_world;
    Listeners m_listeners;
    std::vector<b2Body*> m_bodies;
    bool m_stepped = false;
    bool m_subStepped = false;
};

} // namespace fuzz
