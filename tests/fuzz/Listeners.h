// SPDX-License-Identifier: MIT
#pragma once

#include "Choices.h"

#include <Box2D/Box2D.h>

namespace fuzz
{

/// All callbacks of a world. They make calls that are allowed in callbacks. In a wild world they
/// also make forbidden ones: create and destroy.
class Listeners final : public b2ContactListener,
                        public b2ContactFilter,
                        public b2DestructionListener,
                        public b2QueryCallback,
                        public b2RayCastCallback
{
public:
    Listeners(b2World& world, Choices& choices) : m_world(world), m_choices(choices) {}

    void BeginContact(b2Contact* contact) override { Touch(contact); }
    void EndContact(b2Contact* contact) override { Touch(contact); }
    void PreSolve(b2Contact* contact, const b2Manifold* oldManifold) override;
    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override;
    bool ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB) override;
    void SayGoodbye(b2Joint* joint) override;
    void SayGoodbye(b2Fixture* fixture) override;
    bool ReportFixture(b2Fixture* fixture) override;
    float32 ReportFixture(b2Fixture* fixture, const b2Vec2& point, const b2Vec2& normal,
                          float32 fraction) override;

private:
    void Touch(b2Contact* contact);
    /// Performs calls that are forbidden while the world is locked.
    void Trespass(b2Body* body);

    b2World& m_world;
    Choices& m_choices;
};

} // namespace fuzz
