// SPDX-License-Identifier: MIT
#include <debugdraw/WorldLayers.h>

#include <debugdraw/DrawCollector.h>
#include <debugdraw/Faded.h>
#include <debugdraw/WorldArrows.h>
#include <debugdraw/WorldGlyphs.h>

namespace boxreel
{
namespace
{

uint32 EngineFlags(const LayerSet& layers)
{
    uint32 all = 0;
    for (const LayerInfo& info : kDrawLayers)
    {
        all |= layers[info.layer] ? info.flag : 0u;
    }
    return all;
}

bool HasContacts(const ContactLook& look)
{
    return look.points || look.normals || look.impulses || look.friction;
}

} // namespace

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
