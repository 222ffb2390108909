// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// @file
/// The layers of a picture, and the only list of them. Draw lists and SVG groups, `--draw` with its
/// help and completion, the check boxes of `boxreel ui` and its settings all read this table.
namespace boxreel
{

/// What switched an item on; a layer that is off is never collected.
enum class DrawLayer : std::uint8_t
{
    // Those that `--draw` names, in the order of its help and of the check boxes.
    Shapes,
    Joints,         ///< lines from the bodies' origins to the anchors
    Aabbs,          ///< the broad phase's boxes
    Pairs,          ///< of fixtures whose boxes overlap
    Contacts,       ///< points; which are new is seen
    ContactNormals, ///< lines of a fixed length in pixels
    ContactImpulses,
    ContactFriction,
    CentersOfMass, ///< with the bodies' axes
    CenterMarks,   ///< the sign of a centre of mass
    Velocities,
    JointForces,
    JointGlyphs, ///< the sign of each kind of joint
    Labels,      ///< names of bodies, their numbers where they have none, and of joints
                 // Those that other options or the scene itself switch on.
    Trails,      ///< where bodies have been, as lines
    Poses,       ///< how bodies stood earlier, faded
    Scene,       ///< what a scene draws beside its bodies: rays, hulls, marks
    Annotations, ///< axes, scale bars, dimensions, captions; solid shapes (heads of arrows) are
                 ///< filled with all of their colour
};

/// What there is to say of a layer.
struct LayerInfo
{
    DrawLayer layer;
    const char* name;     ///< in the text of draw lists and in SVG groups
    const char* option;   ///< for `--draw` and in the settings of the window; null: not there
    const char* label;    ///< of its check box; null: none
    bool isUsual = false; ///< drawn unless options say otherwise
};

/// A row for each layer, in their order.
inline constexpr std::array<LayerInfo, 18> kDrawLayers{{
    {DrawLayer::Shapes, "shapes", "shapes", "Shapes", true},
    {DrawLayer::Joints, "joints", "joints", "Joints", true},
    {DrawLayer::Aabbs, "aabbs", "aabbs", "AABBs"},
    {DrawLayer::Pairs, "pairs", "pairs", "Pairs"},
    {DrawLayer::Contacts, "contacts", "contacts", "Contact points"},
    {DrawLayer::ContactNormals, "normals", "normals", "Contact normals"},
    {DrawLayer::ContactImpulses, "impulses", "impulses", "Contact impulses"},
    {DrawLayer::ContactFriction, "friction", "friction", "Friction impulses"},
    {DrawLayer::CentersOfMass, "centers-of-mass", "centers", "Centres of mass"},
    {DrawLayer::CenterMarks, "centers-of-mass", "masses", "Mass signs"},
    {DrawLayer::Velocities, "velocities", "velocities", "Velocities"},
    {DrawLayer::JointForces, "forces", "forces", "Joint forces"},
    {DrawLayer::JointGlyphs, "glyphs", "glyphs", "Joint signs"},
    {DrawLayer::Labels, "labels", "names", "Names"},
    {DrawLayer::Trails, "trails", nullptr, nullptr},
    {DrawLayer::Poses, "poses", nullptr, nullptr},
    {DrawLayer::Scene, "scene", nullptr, nullptr},
    {DrawLayer::Annotations, "annotations", nullptr, nullptr},
}};

/// The rows of the layers that `--draw` names.
inline constexpr std::span<const LayerInfo> kOptionalLayers =
    std::span(kDrawLayers).first(std::size_t(DrawLayer::Trails));

/// What there is to say of this layer.
constexpr const LayerInfo& InfoOf(DrawLayer layer)
{
    return kDrawLayers[std::size_t(layer)];
}

static_assert(
    [] {
        for (std::size_t i = 0; i < kDrawLayers.size(); ++i)
        {
            const LayerInfo& info = kDrawLayers[i];
            const bool isOptional = i < kOptionalLayers.size();
            if (info.layer != DrawLayer(i) || (info.option != nullptr) != isOptional ||
                (info.label != nullptr) != isOptional)
            {
                return false;
            }
        }
        return kDrawLayers.size() == std::size_t(DrawLayer::Annotations) + 1;
    }(),
    "a row for each layer, in their order; options and labels for the first ones alone");

/// Which layers are shown: the usual ones, unless changed.
class LayerSet
{
public:
    constexpr LayerSet()
    {
        for (const LayerInfo& info : kDrawLayers)
        {
            (*this)[info.layer] = info.isUsual;
        }
    }
    /// No layer at all.
    static constexpr LayerSet None()
    {
        LayerSet none;
        none.m_isShown = {};
        return none;
    }
    constexpr bool& operator[](DrawLayer layer) { return m_isShown[std::size_t(layer)]; }
    constexpr const bool& operator[](DrawLayer layer) const
    {
        return m_isShown[std::size_t(layer)];
    }
    /// Whether both show the same.
    friend bool operator==(const LayerSet&, const LayerSet&) = default;

private:
    std::array<bool, kDrawLayers.size()> m_isShown{};
};

} // namespace boxreel
