// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/Scene.h>

namespace boxreel
{

/// A body that drifts and turns about another that stays, to and fro, through it: for scenes that
/// show what the engine's geometry has to say of two shapes. Keys move the drifter by hand, the
/// mouse drags it. What the two are made of is the scene's; Detach makes it collide with nothing.
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
