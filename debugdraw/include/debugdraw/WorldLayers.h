// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawLayer.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/View.h>
#include <debugdraw/WorldBodies.h>
#include <debugdraw/WorldContacts.h>

#include <optional>

/// @file
/// The layers of a world in a picture. A layer that is off is not collected.
namespace boxreel
{

/// The scales of arrows.
struct ArrowScales
{
    double velocitySeconds = 0.2;          ///< a velocity is drawn as the displacement in this time
    std::optional<double> metersPerNewton; ///< none: what suits the world at the start, of joints
                                           ///< kForceShare and of contacts kImpulseShare
};

/// Collects the layers of one world from step to step.
class LayerCollector
{
public:
    /// `world`: as it is at the start.
    LayerCollector(const LayerSet& layers, const ArrowScales& scales, double stepsPerSecond,
                   const b2World& world);

    /// Call before each step, so that its new contact points are drawn as such.
    void BeforeStep(const b2World& world);

    /// Adds the items to a list, which may be non-empty. `notes` cover all items except names,
    /// which avoid them. Replaces the world's debug drawing; none is registered afterwards.
    void Collect(b2World& world, const View& view, const BodyNames& names,
                 const JointNames& jointNames, DrawList& list, const DrawList& notes = {}) const;

private:
    LayerSet m_layers;
    double m_velocitySeconds;
    double m_metersPerNewton = 0.0; // of joints
    ContactLook m_contactLook;
    ContactCollector m_contacts;
};

} // namespace boxreel
