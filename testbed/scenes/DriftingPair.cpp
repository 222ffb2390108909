// SPDX-License-Identifier: MIT
#include <scenes/DriftingPair.h>

#include <scenes/Parts.h>
#include <scenes/SceneState.h>

namespace boxreel
{

namespace
{

constexpr float32 kReachX = 4.5f;        ///< of the drift, left and right [m]
constexpr float32 kReachY = 3.2f;        ///< of the drift, up and down [m]
const b2Vec2 kDrift(1.3f, 1.1f);         ///< [m/s]
constexpr float32 kSpin = 0.5f;          ///< [rad/s]
constexpr float32 kNudge = 0.1f;         ///< of a key [m]
constexpr float32 kTurn = b2_pi / 36.0f; ///< of a key: 5 degrees [rad]

constexpr KeyBinding kKeys[] = {{'a', "moves it to the left"}, {'d', "moves it to the right"},
                                {'w', "moves it up"},          {'s', "moves it down"},
                                {'q', "turns it left"},        {'e', "turns it right"}};

/// Back when it goes away beyond its reach.
float32 TurnedBack(float32 speed, float32 offset, float32 reach)
{
    const bool leaves = (offset > reach && speed > 0.0f) || (offset < -reach && speed < 0.0f);
    return leaves ? -speed : speed;
}

} // namespace

DriftingPair::DriftingPair(const SceneSettings& settings) : Scene(settings)
{
    m_world.SetGravity(b2Vec2(0.0f, 0.0f));
    m_still = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, 0.0f));
    m_drifter = AddBody(m_world, b2_dynamicBody, b2Vec2(-kReachX, -1.0f));
    m_drifter->SetSleepingAllowed(false);
    m_drifter->SetLinearVelocity(kDrift);
    m_drifter->SetAngularVelocity(kSpin);
}

void DriftingPair::Detach(b2Fixture& fixture)
{
    fixture.SetFilterData({.maskBits = 0});
}

void DriftingPair::Step(const StepSettings& settings)
{
    const b2Vec2 offset = m_drifter->GetPosition() - m_still->GetPosition();
    const b2Vec2 velocity = m_drifter->GetLinearVelocity();
    m_drifter->SetLinearVelocity(b2Vec2(TurnedBack(velocity.x, offset.x, kReachX),
                                        TurnedBack(velocity.y, offset.y, kReachY)));
    Scene::Step(settings);
}

std::span<const KeyBinding> DriftingPair::Keys() const
{
    return kKeys;
}

void DriftingPair::VisitState(SceneState& state)
{
    state(m_still, m_drifter);
}

std::optional<SceneArea> DriftingPair::PreferredView() const
{
    return SceneArea{.center = b2Vec2(0.0f, 0.0f), .halfSize = b2Vec2(7.0f, 5.2f)};
}

// Once moved by hand it no longer drifts.
void DriftingPair::KeyDown(char key)
{
    const b2Vec2 way(key == 'a'   ? -kNudge
                     : key == 'd' ? kNudge
                                  : 0.0f,
                     key == 's'   ? -kNudge
                     : key == 'w' ? kNudge
                                  : 0.0f);
    const float32 turn = key == 'q' ? kTurn : key == 'e' ? -kTurn : 0.0f;
    if (way.x != 0.0f || way.y != 0.0f || turn != 0.0f)
    {
        m_drifter->SetLinearVelocity(b2Vec2(0.0f, 0.0f));
        m_drifter->SetAngularVelocity(0.0f);
        m_drifter->SetTransform(m_drifter->GetPosition() + way, m_drifter->GetAngle() + turn);
    }
}

} // namespace boxreel
