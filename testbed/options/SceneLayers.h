// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/DrawLayer.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/Theme.h>
#include <debugdraw/View.h>
#include <debugdraw/WorldBodies.h>
#include <debugdraw/WorldContacts.h>

#include <optional>
#include <string>
#include <vector>

/// The layers of a world in a picture, as named by `--draw`, and their collection. A layer that is
/// off is not collected.
namespace boxreel
{

/// Returns the names of all layers, in the order of `--draw` and its help.
std::vector<std::string> LayerNames();

/// Reads a list such as "shapes,contacts" of the only visible layers. For any other text, returns
/// an Error (Unusable) that names `option` and all layers.
Result<LayerSet> ParseLayers(const std::string& option, const std::string& text);

/// Returns the text that ParseLayers accepts; empty when nothing is shown.
std::string TextOf(const LayerSet& layers);

/// Returns the area that is visible in a picture of this camera with `scale` times as many pixels.
/// Includes a margin for outlines and their corners.
View PictureView(const Camera& camera, const Theme& theme, double scale);

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
