// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/Scene.h>

namespace boxreel
{

/// A body that moves to and fro and rotates through another, static body. It is the base of scenes
/// that show the engine's geometry queries for two shapes. Keys move the drifter by hand, and the
/// mouse drags it. The scene defines both shapes. Detach makes the body collide with nothing.
class DriftingPair : public Scene
{
public:
    explicit DriftingPair(const SceneSettings& settings);

    void Step(const StepSettings& settings) override;
    std::span<const KeyBinding> Keys() const override;
    void KeyDown(char key) override;
    void VisitState(SceneState& state) override;
    std::optional<SceneArea> PreferredView() const override;

protected:
    static void Detach(b2Fixture& fixture);

    b2Body* m_still;   ///< static, at the origin
    b2Body* m_drifter; ///< dynamic, without gravity
};

} // namespace boxreel
