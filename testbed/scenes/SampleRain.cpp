// SPDX-License-Identifier: MIT
#include <scenes/SampleRain.h>

#include <scenes/Samples.h>
#include <scenes/SceneState.h>

namespace boxreel
{

namespace
{

constexpr int32 kCount = 30;
constexpr float32 kEvery = 0.25f; ///< [s]
constexpr float32 kSize = 0.8f;   ///< [m]

constexpr KeyBinding kKeys[] = {{'1', "drops a triangle"},
                                {'2', "drops a trapezium"},
                                {'3', "drops a box"},
                                {'4', "drops an octagon"},
                                {'5', "drops a disc"}};

} // namespace

SampleRain::SampleRain(const SceneSettings& settings, float32 reach, float32 height)
    : Scene(settings), m_reach(reach), m_height(height), m_random(settings.seed)
{}

void SampleRain::Step(const StepSettings& settings)
{
    if (m_dropped < kCount && m_time >= kEvery * static_cast<float32>(m_dropped))
    {
        Drop(m_dropped % kSampleKinds);
    }
    Scene::Step(settings);
    m_time += settings.timeStep;
}

std::span<const KeyBinding> SampleRain::Keys() const
{
    return kKeys;
}

void SampleRain::KeyDown(char key)
{
    if ('1' <= key && key < '1' + kSampleKinds)
    {
        Drop(key - '1');
    }
}

void SampleRain::ShiftOrigin(const b2Vec2& newOrigin)
{
    Scene::ShiftOrigin(newOrigin);
    m_origin -= newOrigin;
}

void SampleRain::VisitState(SceneState& state)
{
    state(m_random, m_dropped, m_time, m_origin.x, m_origin.y);
}

void SampleRain::Drop(int32 kind)
{
    const float32 x = m_random.Between(-m_reach, m_reach);
    const float32 angle = m_random.Between(-b2_pi, b2_pi);
    AddSample(m_world, kind, m_origin + b2Vec2(x, m_height), angle, kSize, {.friction = 0.4f});
    ++m_dropped;
}

} // namespace boxreel
