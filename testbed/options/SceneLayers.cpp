// SPDX-License-Identifier: MIT
#include "SceneLayers.h"
#include "Values.h"

#include <base/Nearest.h>
#include <debugdraw/DrawCollector.h>
#include <debugdraw/Faded.h>
#include <debugdraw/WorldArrows.h>
#include <debugdraw/WorldGlyphs.h>

#include <utility>

namespace boxreel
{
namespace
{

uint32 EngineFlags(const SceneLayers& layers)
{
    const std::pair<bool, uint32> flags[] = {{layers.shapes, b2Draw::e_shapeBit},
                                             {layers.joints, b2Draw::e_jointBit},
                                             {layers.aabbs, b2Draw::e_aabbBit},
                                             {layers.pairs, b2Draw::e_pairBit},
                                             {layers.centers, b2Draw::e_centerOfMassBit}};
    uint32 all = 0;
    for (const auto& [isOn, flag] : flags)
    {
        all |= isOn ? flag : 0u;
    }
    return all;
}

Error UnknownLayer(const std::string& option, const std::string& layer)
{
    std::string all;
    for (const std::string& name : LayerNames())
    {
        all.append(all.empty() ? "" : ",").append(name);
    }
    return BadValue(option, layer, "unknown layer",
                    DidYouMean(layer, LayerNames(), "use any of " + all));
}

bool HasContacts(const ContactLook& look)
{
    return look.points || look.normals || look.impulses || look.friction;
}

} // namespace

std::vector<std::string> LayerNames()
{
    std::vector<std::string> names;
    for (const SceneLayer& known : kSceneLayers)
    {
        names.emplace_back(known.name);
    }
    return names;
}

Result<SceneLayers> ParseLayers(const std::string& option, const std::string& text)
{
    SceneLayers layers;
    layers.shapes = false;
    layers.joints = false;
    for (const std::string& part : SplitAt(',', text))
    {
        bool isKnown = false;
        for (const SceneLayer& known : kSceneLayers)
        {
            if (part == known.name)
            {
                layers.*known.layer = true;
                isKnown = true;
            }
        }
        if (!isKnown)
        {
            return UnknownLayer(option, part);
        }
    }
    return layers;
}

std::string TextOf(const SceneLayers& layers)
{
    std::string text;
    for (const SceneLayer& known : kSceneLayers)
    {
        if (layers.*known.layer)
        {
            text.append(text.empty() ? "" : ",").append(known.name);
        }
    }
    return text;
}

View PictureView(const Camera& camera, const Theme& theme, double scale)
{
    constexpr double kCorners = 8.0; // how far a pointed one reaches, in widths of an outline
    constexpr double kEdge = 2.0;    // of the picture: pixels that are touched a little [px]
    return ViewOf(camera, kCorners * double(theme.outlineWidth) + kEdge / scale);
}

LayerCollector::LayerCollector(const SceneLayers& layers, const ArrowScales& scales,
                               double stepsPerSecond, const b2World& world)
    : m_layers(layers), m_velocitySeconds(scales.velocitySeconds)
{
    m_contactLook.points = layers.contacts;
    m_contactLook.normals = layers.normals;
    m_contactLook.impulses = layers.impulses;
    m_contactLook.friction = layers.friction;
    m_contactLook.stepsPerSecond = stepsPerSecond;
    const bool hasForces = layers.forces || layers.impulses || layers.friction;
    if (scales.metersPerNewton || hasForces)
    {
        m_metersPerNewton = scales.metersPerNewton.value_or(MetersPerNewtonFor(world, kForceShare));
        m_contactLook.metersPerNewton =
            scales.metersPerNewton.value_or(MetersPerNewtonFor(world, kImpulseShare));
    }
}

void LayerCollector::BeforeStep(const b2World& world)
{
    if (m_layers.contacts)
    {
        m_contacts.Remember(world);
    }
}

void LayerCollector::Collect(b2World& world, const View& view, const BodyNames& names,
                             const JointNames& jointNames, DrawList& list,
                             const DrawList& notes) const
{
    DrawCollector collector(list);
    collector.SetFlags(EngineFlags(m_layers));
    collector.LookAt(view);
    world.SetDebugDraw(&collector);
    world.DrawDebugData();
    world.SetDebugDraw(nullptr);
    if (m_layers.glyphs)
    {
        AddJointGlyphs(world, view, list);
    }
    if (m_layers.masses)
    {
        AddCenterMarks(world, view, list);
    }
    if (m_layers.forces)
    {
        AddJointForces(world, view, m_metersPerNewton, list);
    }
    if (m_layers.velocities)
    {
        AddVelocities(world, view, m_velocitySeconds, list);
    }
    if (HasContacts(m_contactLook))
    {
        m_contacts.Collect(world, view, m_contactLook, list);
    }
    Append(list, notes);
    if (m_layers.names)
    {
        AddBodyNames(world, view, names, list);
        AddJointNames(world, view, jointNames, list);
    }
}

} // namespace boxreel
