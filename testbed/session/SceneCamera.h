// SPDX-License-Identifier: MIT
#pragma once

#include "SceneLabels.h"

#include <Box2D/Box2D.h>
#include <debugdraw/FollowCamera.h>
#include <options/ViewChoice.h>

#include <span>

/// The camera of a ViewChoice on a world. It passes the positions of bodies to debugdraw's cameras,
/// which do not depend on worlds. Only reads the world.
namespace boxreel
{

class SceneCamera
{
public:
    /// Creates the camera of a picture of `width` x `height` pixels. Unusable if the view names a
    /// body that does not exist, unless bodies may be created later. Until the first of the named
    /// bodies exists, the view shows the dynamic bodies. `framed`: boxes [m] that a view which fits
    /// the scene shows beside bodies.
    static Result<SceneCamera> Create(const ViewChoice& choice, b2World& world, int width,
                                      int height, bool bodiesMayCome = false,
                                      const std::vector<b2AABB>& framed = {});

    /// Once after every step of `dt` seconds; `time`: simulated since the start [s]; `framed` as in
    /// Create.
    void Update(b2World& world, double time, double dt, const std::vector<b2AABB>& framed = {});

    const Camera& View() const { return m_view; }

    /// It goes with bodies, wherever they are.
    bool Follows() const { return std::holds_alternative<FollowCamera>(m_mover); }

    /// Unusable while a body that the view names has never been there.
    Result<void> CheckBodiesCame() const { return CheckBodies("--camera", m_made, m_bodies); }

    /// All that Update changes, as numbers.
    std::vector<double> State() const;
    /// Continues from the numbers of a camera of the same choice, picture and scene. Returns false
    /// and leaves the camera unchanged if they belong to another.
    bool Restore(std::span<const double> state);

private:
    using Mover = std::variant<std::monostate, FitCamera, FollowCamera, CameraPath>;
    SceneCamera(const ViewChoice& choice, b2World& world, int width, int height,
                const std::vector<b2AABB>& framed);
    Rect Subject(b2World& world) const;
    void LookAtBodies(b2World& world);
    void LookAtAll(b2World& world, bool whole, const std::vector<b2AABB>& framed);
    void VisitState(const NumberVisitor& visit);

    std::vector<int> m_bodies;
    bool m_seesCentersOnly = false;       // of the bodies, for how large they look does not matter
    std::optional<double> m_followHeight; // [m]
    bool m_waits = false;                 // for the first of the bodies, and shows all until then
    int m_made = 0;                       // bodies so far
    Mover m_mover;                        // none: the view stays
    Camera m_view;
};

} // namespace boxreel
