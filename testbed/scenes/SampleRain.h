// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/Random.h>
#include <scenes/Scene.h>

namespace boxreel
{

/// Samples of all kinds fall one by one from random places onto the bodies of the scene. The keys 1
/// to 5 drop one of a kind.
class SampleRain : public Scene
{
public:
    SampleRain(const SceneSettings& settings, float32 reach, float32 height);

    bool MakesBodiesLater() const override { return true; }
    void Step(const StepSettings& settings) override;
    std::span<const KeyBinding> Keys() const override;
    void KeyDown(char key) override;
    void ShiftOrigin(const b2Vec2& newOrigin) override;
    void VisitState(SceneState& state) override;

protected:
    float32 Time() const { return m_time; }
    const b2Vec2& Origin() const { return m_origin; } ///< of the scene, in the world [m]

private:
    void Drop(int32 kind);

    float32 m_reach;  ///< maximum distance from the middle [m]
    float32 m_height; ///< from which they fall [m]
    Random m_random;
    int32 m_dropped = 0;
    float32 m_time = 0.0f; ///< [s]
    b2Vec2 m_origin;
};

} // namespace boxreel
