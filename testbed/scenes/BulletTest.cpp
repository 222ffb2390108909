// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kSpeed = 200.0f;         ///< of a shot: 3.3 m a step [m/s]
constexpr float32 kRadius = 0.25f;         ///< of a shot [m]
constexpr float32 kShotEvery = 2.5f;       ///< [s]
constexpr float32 kMuzzle = -14.0f;        ///< where shots start [m]
constexpr float32 kLanes[] = {8.0f, 0.0f}; ///< heights [m]: of the bullet and of the plain shot

constexpr float32 kPlateHalfThickness = 0.05f; ///< [m]
constexpr float32 kPlateHalfHeight = 2.0f;     ///< [m]

/// Twice the same: a fast shot at three thin plates that hang in its way. Above, the shot is a
/// bullet, which is looked for between steps; below it is not, and jumps over the plates.
class BulletTest : public Scene
{
public:
    explicit BulletTest(const SceneSettings& settings) : Scene(settings)
    {
        for (const float32 height : kLanes)
        {
            AddLane(height);
        }
        m_bullet = AddShot(kLanes[0]);
        m_bullet->SetBullet(true);
        m_plain = AddShot(kLanes[1]);
    }

    void Step(const StepSettings& settings) override
    {
        if (m_time >= kShotEvery * static_cast<float32>(m_shots) + 0.5f)
        {
            Fire(*m_bullet);
            Fire(*m_plain);
            ++m_shots;
        }
        Scene::Step(settings);
        m_time += settings.timeStep;
    }

    void ShiftOrigin(const b2Vec2& newOrigin) override
    {
        Scene::ShiftOrigin(newOrigin);
        m_origin -= newOrigin;
    }

    void VisitState(SceneState& state) override
    {
        state(m_bullet, m_plain, m_time, m_shots, m_origin.x, m_origin.y);
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 4.5f), .halfSize = b2Vec2(15.5f, 8.5f)};
    }

private:
    void AddLane(float32 height)
    {
        const float32 floor = height - kPlateHalfHeight - 0.5f;
        AddGroundBox(m_world, b2Vec2(0.0f, floor - 0.25f), 15.0f, 0.25f);
        AddGroundBox(m_world, b2Vec2(14.75f, height), 0.25f, kPlateHalfHeight + 0.5f);
        for (const float32 x : {-4.2f, 0.8f, 5.8f})
        {
            const b2Vec2 hook(x, height + kPlateHalfHeight);
            b2Body* beam = AddGroundBox(m_world, hook + b2Vec2(0.0f, 0.3f), 0.3f, 0.1f);
            b2Body* plate = AddBox(m_world, b2Vec2(x, height), kPlateHalfThickness,
                                   kPlateHalfHeight, {.density = 20.0f});
            plate->SetAngularDamping(1.0f); // hangs still again for the next shot
            AddHinge(m_world, beam, plate, hook);
        }
    }

    b2Body* AddShot(float32 height)
    {
        b2Body* shot = AddBall(m_world, b2Vec2(kMuzzle, height), kRadius, {.density = 5.0f});
        shot->SetGravityScale(0.0f);
        return shot;
    }

    // Each from the height of its lane.
    void Fire(b2Body& shot)
    {
        const float32 height = &shot == m_bullet ? kLanes[0] : kLanes[1];
        shot.SetTransform(m_origin + b2Vec2(kMuzzle, height), 0.0f);
        shot.SetAngularVelocity(0.0f);
        shot.SetLinearVelocity(b2Vec2(kSpeed, 0.0f));
    }

    b2Body* m_bullet;
    b2Body* m_plain;
    float32 m_time = 0.0f; ///< [s]
    int32 m_shots = 0;
    b2Vec2 m_origin; ///< of the scene, in the world [m]
};

} // namespace

std::unique_ptr<Scene> MakeBulletTest(const SceneSettings& settings)
{
    return std::make_unique<BulletTest>(settings);
}

} // namespace boxreel
