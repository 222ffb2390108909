// SPDX-License-Identifier: MIT
#include <scenes/Notes.h>
#include <scenes/Parts.h>
#include <scenes/Random.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kSweepTime = 2.5f; ///< of one sweep [s]
constexpr float32 kRange = 7.0f;     ///< where sweeps start and end, from the block [m]
constexpr float32 kMaxMiss = 2.5f;   ///< how far past the middle of the block one leads [m]
constexpr float32 kMaxTurn = 6.0f;   ///< in one sweep [rad]

/// The bar goes through the block; drawn are where its sweep begins and ends, and where it is when
/// they first touch.
class TimeOfImpact : public Scene
{
public:
    explicit TimeOfImpact(const SceneSettings& settings) : Scene(settings), m_random(settings.seed)
    {
        m_world.SetGravity(b2Vec2(0.0f, 0.0f));
        m_block = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, 0.0f), 0.4f);
        AttachBox(*m_block, 1.6f, 1.2f, {})->SetFilterData({.maskBits = 0});
        m_bar = AddBox(m_world, b2Vec2(-kRange, 0.0f), 1.6f, 0.2f);
        m_bar->GetFixtureList()->SetFilterData({.maskBits = 0});
        m_bar->SetSleepingAllowed(false);
        BeginSweep();
    }

    void Step(const StepSettings& settings) override
    {
        if (m_time >= kSweepTime)
        {
            BeginSweep();
        }
        Scene::Step(settings);
        m_time += settings.timeStep;
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        const b2TOIOutput output = FindImpact();
        const bool hits = output.state == b2TOIOutput::e_touching;
        return {{"impact", hits ? WithUnit(output.t, "of the way") : "none"}};
    }

    void Draw(b2Draw& draw) const override
    {
        const b2TOIOutput output = FindImpact();
        DrawBarAt(draw, 0.0f, kSkyBlue);
        DrawBarAt(draw, 1.0f, kSkyBlue);
        draw.DrawSegment(PoseAt(0.0f).p, PoseAt(1.0f).p, kSkyBlue);
        if (output.state == b2TOIOutput::e_touching)
        {
            DrawBarAt(draw, output.t, kOrange);
        }
    }

    void VisitState(SceneState& state) override
    {
        state(m_block, m_bar, m_random, m_time, m_from.x, m_from.y, m_way.x, m_way.y, m_angle,
              m_turn);
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 0.0f), .halfSize = b2Vec2(9.0f, 9.0f)};
    }

private:
    void BeginSweep()
    {
        const b2Rot direction(m_random.Between(-b2_pi, b2_pi));
        const float32 miss = m_random.Between(-kMaxMiss, kMaxMiss);
        m_angle = m_random.Between(-b2_pi, b2_pi);
        m_turn = m_random.Between(-kMaxTurn, kMaxTurn);
        m_from = miss * direction.GetYAxis() - kRange * direction.GetXAxis();
        m_way = 2.0f * kRange * direction.GetXAxis();
        m_time = 0.0f;
        m_bar->SetTransform(m_block->GetPosition() + m_from, m_angle);
        m_bar->SetLinearVelocity((1.0f / kSweepTime) * m_way);
        m_bar->SetAngularVelocity(m_turn / kSweepTime);
    }

    b2Sweep SweepOfBar() const
    {
        b2Sweep sweep;
        sweep.c0 = m_block->GetPosition() + m_from;
        sweep.c = sweep.c0 + m_way;
        sweep.a0 = m_angle;
        sweep.a = m_angle + m_turn;
        return sweep;
    }

    b2TOIOutput FindImpact() const
    {
        b2TOIInput input;
        input.proxyA.Set(m_block->GetFixtureList()->GetShape(), 0);
        input.proxyB.Set(m_bar->GetFixtureList()->GetShape(), 0);
        input.sweepA.c0 = input.sweepA.c = m_block->GetPosition();
        input.sweepA.a0 = input.sweepA.a = m_block->GetAngle();
        input.sweepB = SweepOfBar();
        b2TOIOutput output;
        b2TimeOfImpact(&output, &input);
        return output;
    }

    b2Transform PoseAt(float32 fraction) const
    {
        b2Transform pose;
        SweepOfBar().GetTransform(&pose, fraction);
        return pose;
    }

    void DrawBarAt(b2Draw& draw, float32 fraction, const b2Color& color) const
    {
        DrawOutline(draw, *m_bar->GetFixtureList()->GetShape(), PoseAt(fraction), color);
    }

    b2Body* m_block;
    b2Body* m_bar;
    Random m_random;
    float32 m_time = 0.0f;  ///< since the sweep began [s]
    b2Vec2 m_from;          ///< where it began, from the block [m]
    b2Vec2 m_way;           ///< to its end [m]
    float32 m_angle = 0.0f; ///< where it began [rad]
    float32 m_turn = 0.0f;  ///< to its end [rad]
};

} // namespace

std::unique_ptr<Scene> MakeTimeOfImpact(const SceneSettings& settings)
{
    return std::make_unique<TimeOfImpact>(settings);
}

} // namespace boxreel
