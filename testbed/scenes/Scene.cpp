// SPDX-License-Identifier: MIT
#include <scenes/Scene.h>

#include <scenes/Parts.h>
#include <scenes/SceneState.h>

namespace boxreel
{

namespace
{

// Heavy for its size, so it breaks through the bodies it hits.
constexpr float32 kBombRadius = 0.3f; // [m]
constexpr Material kBomb{.density = 20.0f};

// Thrown from above, at the origin: five times as fast as it is far.
constexpr float32 kBombHeight = 30.0f;            // [m]
constexpr float32 kBombReach = 15.0f;             // to either side [m]
constexpr float32 kBombHurry = 5.0f;              // [1/s]
constexpr std::uint64_t kBombSeed = 0xb0bb0bb0bu; // apart from the scene's own numbers

} // namespace

Scene::Scene(const SceneSettings& settings)
    : m_settings(settings), m_world(b2Vec2(0.0f, -10.0f)), m_bombs(settings.seed ^ kBombSeed)
{
    m_world.SetDestructionListener(this);
}

void Scene::MouseUp(const b2Vec2& point)
{
    m_grip.MoveTo(point);
    m_grip.LetGo(m_world);
}

void Scene::ThrowBomb(const b2Vec2& place, const b2Vec2& velocity)
{
    if (m_bomb != nullptr)
    {
        m_world.DestroyBody(m_bomb);
    }
    m_bomb = AddBall(m_world, place, kBombRadius, kBomb);
    m_bomb->SetBullet(true);
    m_bomb->SetLinearVelocity(velocity);
}

void Scene::ThrowBomb()
{
    const b2Vec2 place(m_bombs.Between(-kBombReach, kBombReach), kBombHeight);
    ThrowBomb(place, -kBombHurry * place);
}

void Scene::VisitCommonState(SceneState& state)
{
    state(m_names, m_jointNames, m_bomb, m_bombs);
    m_grip.VisitState(state);
}

void Scene::SayGoodbye(b2Joint* joint)
{
    m_jointNames.erase(joint);
    m_grip.Forget(joint);
    JointGone(joint);
}

} // namespace boxreel
