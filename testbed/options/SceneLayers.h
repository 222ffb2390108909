// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/Theme.h>
#include <debugdraw/View.h>
#include <debugdraw/WorldBodies.h>
#include <debugdraw/WorldContacts.h>

#include <optional>
#include <string>
#include <vector>

/// What of a world a picture shows, as `--draw` names it, and the collecting of it. A layer that is
/// off is not collected.
namespace boxreel
{

struct SceneLayers
{
    bool shapes = true;
    bool joints = true;   ///< lines from the bodies' origins to the anchors
    bool aabbs = false;   ///< the broad phase's boxes
    bool pairs = false;   ///< of fixtures whose boxes overlap
    bool centers = false; ///< of mass, with the bodies' axes
    bool masses = false;  ///< the centres of mass by their sign
    bool contacts = false;
    bool normals = false;  ///< of contacts
    bool impulses = false; ///< of contacts
    bool friction = false; ///< of contacts
    bool velocities = false;
    bool forces = false; ///< of joints
    bool names = false;  ///< of bodies, their numbers where they have none, and of joints
    bool glyphs = false; ///< signs of the joints
    friend bool operator==(const SceneLayers&, const SceneLayers&) = default;
};

/// A layer by the name that `--draw` and the window's settings give it.
struct SceneLayer
{
    const char* name;
    bool SceneLayers::*layer;
};
inline constexpr SceneLayer kSceneLayers[] = {
    {"shapes", &SceneLayers::shapes},         {"joints", &SceneLayers::joints},
    {"aabbs", &SceneLayers::aabbs},           {"pairs", &SceneLayers::pairs},
    {"centers", &SceneLayers::centers},       {"masses", &SceneLayers::masses},
    {"contacts", &SceneLayers::contacts},     {"normals", &SceneLayers::normals},
    {"impulses", &SceneLayers::impulses},     {"friction", &SceneLayers::friction},
    {"velocities", &SceneLayers::velocities}, {"forces", &SceneLayers::forces},
    {"names", &SceneLayers::names},           {"glyphs", &SceneLayers::glyphs},
};

/// Of all layers, as `--draw` and its help have them.
std::vector<std::string> LayerNames();

/// "shapes,contacts": these and no others. Unusable, one sentence that names `option` and all
/// layers, for anything else.
Result<SceneLayers> ParseLayers(const std::string& option, const std::string& text);

/// What ParseLayers takes; empty when nothing is shown.
std::string TextOf(const SceneLayers& layers);

/// What may reach into a picture of this camera, whose pixels are `scale` times as many: with room
/// for outlines and their corners.
View PictureView(const Camera& camera, const Theme& theme, double scale);

/// How long arrows are.
struct ArrowScales
{
    double velocitySeconds = 0.2;          ///< a velocity is as long as the way of so many seconds
    std::optional<double> metersPerNewton; ///< none: what suits the world at the start, of joints
                                           ///< kForceShare and of contacts kImpulseShare
};

/// Collects the layers of one world from step to step.
class LayerCollector
{
public:
    /// `world`: as it is at the start.
    LayerCollector(const SceneLayers& layers, const ArrowScales& scales, double stepsPerSecond,
                   const b2World& world);

    void BeforeStep(const b2World& world);

    /// Into a list that may have something already; `notes` go over all but names, which keep clear
    /// of them. The world's debug drawing is borrowed for it and none is registered afterwards.
    void Collect(b2World& world, const View& view, const BodyNames& names,
                 const JointNames& jointNames, DrawList& list, const DrawList& notes = {}) const;

private:
    SceneLayers m_layers;
    double m_velocitySeconds;
    double m_metersPerNewton = 0.0; // of joints
    ContactLook m_contactLook;
    ContactCollector m_contacts;
};

} // namespace boxreel
