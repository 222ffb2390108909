// SPDX-License-Identifier: MIT
#include "SceneLayers.h"
#include "Values.h"

#include <base/Nearest.h>
#include <debugdraw/DrawCollector.h>
#include <debugdraw/Faded.h>
#include <debugdraw/WorldArrows.h>
#include <debugdraw/WorldGlyphs.h>

#include <algorithm>
#include <utility>

namespace boxreel
{
namespace
{

uint32 EngineFlags(const LayerSet& layers)
{
    const std::pair<DrawLayer, uint32> flags[] = {
        {DrawLayer::Shapes, b2Draw::e_shapeBit},
        {DrawLayer::Joints, b2Draw::e_jointBit},
        {DrawLayer::Aabbs, b2Draw::e_aabbBit},
        {DrawLayer::Pairs, b2Draw::e_pairBit},
        {DrawLayer::CentersOfMass, b2Draw::e_centerOfMassBit}};
    uint32 all = 0;
    for (const auto& [layer, flag] : flags)
    {
        all |= layers[layer] ? flag : 0u;
    }
    return all;
}

Error UnknownLayer(const std::string& option, const std::string& layer)
{
    return BadValue(option, layer, "unknown layer",
                    DidYouMean(layer, LayerNames(), "use any of " + JoinedBy(",", LayerNames())));
}

bool HasContacts(const ContactLook& look)
{
    return look.points || look.normals || look.impulses || look.friction;
}

} // namespace

std::vector<std::string> LayerNames()
{
    std::vector<std::string> names;
    for (const LayerInfo& known : kOptionalLayers)
    {
        names.emplace_back(known.option);
    }
    return names;
}

Result<LayerSet> ParseLayers(const std::string& option, const std::string& text)
{
    LayerSet layers = LayerSet::None();
    for (const std::string& part : SplitAt(',', text))
    {
        const auto known =
            std::find_if(kOptionalLayers.begin(), kOptionalLayers.end(),
                         [&part](const LayerInfo& info) { return part == info.option; });
        if (known == kOptionalLayers.end())
        {
            return UnknownLayer(option, part);
        }
        layers[known->layer] = true;
    }
    return layers;
}

std::string TextOf(const LayerSet& layers)
{
    std::string text;
    for (const LayerInfo& known : kOptionalLayers)
    {
        if (layers[known.layer])
        {
            text.append(text.empty() ? "" : ",").append(known.option);
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

LayerCollector::LayerCollector(const LayerSet& layers, const ArrowScales& scales,
                               double stepsPerSecond, const b2World& world)
    : m_layers(layers), m_velocitySeconds(scales.velocitySeconds)
{
    m_contactLook.points = layers[DrawLayer::Contacts];
    m_contactLook.normals = layers[DrawLayer::ContactNormals];
    m_contactLook.impulses = layers[DrawLayer::ContactImpulses];
    m_contactLook.friction = layers[DrawLayer::ContactFriction];
    m_contactLook.stepsPerSecond = stepsPerSecond;
    const bool hasForces = layers[DrawLayer::JointForces] || layers[DrawLayer::ContactImpulses] ||
                           layers[DrawLayer::ContactFriction];
    if (scales.metersPerNewton || hasForces)
    {
        m_metersPerNewton = scales.metersPerNewton.value_or(MetersPerNewtonFor(world, kForceShare));
        m_contactLook.metersPerNewton =
            scales.metersPerNewton.value_or(MetersPerNewtonFor(world, kImpulseShare));
    }
}

void LayerCollector::BeforeStep(const b2World& world)
{
    if (m_layers[DrawLayer::Contacts])
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
    if (m_layers[DrawLayer::JointGlyphs])
    {
        AddJointGlyphs(world, view, list);
    }
    if (m_layers[DrawLayer::CenterMarks])
    {
        AddCenterMarks(world, view, list);
    }
    if (m_layers[DrawLayer::JointForces])
    {
        AddJointForces(world, view, m_metersPerNewton, list);
    }
    if (m_layers[DrawLayer::Velocities])
    {
        AddVelocities(world, view, m_velocitySeconds, list);
    }
    if (HasContacts(m_contactLook))
    {
        m_contacts.Collect(world, view, m_contactLook, list);
    }
    Append(list, notes);
    if (m_layers[DrawLayer::Labels])
    {
        AddBodyNames(world, view, names, list);
        AddJointNames(world, view, jointNames, list);
    }
}

} // namespace boxreel
