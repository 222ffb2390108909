// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// The layers of a picture, and the only list of them. Draw lists and SVG groups, `--draw` with its
/// help and completion, the check boxes of `boxreel ui` and its settings all read this table.
namespace boxreel
{

/// The layer of an item. Items of a layer that is off are not collected.
enum class DrawLayer : std::uint8_t
{
    // The layers of `--draw`, in the order of its help and of the check boxes.
    Shapes,
    Joints,         ///< lines from the bodies' origins to the anchors
    Aabbs,          ///< the broad phase's boxes
    Pairs,          ///< pairs of fixtures whose boxes overlap
    Contacts,       ///< points; new ones have another colour
    ContactNormals, ///< lines of a fixed length in pixels
    ContactImpulses,
    ContactFriction,
    CentersOfMass, ///< with the bodies' axes
    CenterMarks,   ///< the sign of a centre of mass
    Velocities,
    JointForces,
    JointGlyphs, ///< the sign of each kind of joint
    Labels,      ///< names of bodies and joints; bodies without a name show their number
                 // Layers that other options or the scene itself switch on.
    Trails,      ///< past paths of bodies, as lines
    Poses,       ///< earlier poses of bodies, faded
    Scene,       ///< additional drawings of a scene: rays, hulls, marks
    Annotations, ///< axes, scale bars, dimensions, captions; solid shapes such as arrow
                 ///< heads are filled with their full colour
};

/// The properties of a layer.
struct LayerInfo
{
    DrawLayer layer;        ///< the layer itself
    const char* name;       ///< name in the text of draw lists and in SVG groups
    const char* option;     ///< name in `--draw` and in the settings of the window; null: none
    const char* label;      ///< label of its check box; null: none
    std::uint32_t flag = 0; ///< b2Draw's bit of what the engine draws; 0: not drawn by it
    /// Items usually move as one. Others change their form in every step.
    bool isRigid = false;
    bool isUsual = false; ///< drawn unless options say otherwise
};

/// A row for each layer, in their order.
inline constexpr std::array<LayerInfo, 18> kDrawLayers{{
    {DrawLayer::Shapes, "shapes", "shapes", "Shapes", 0x1, true, true},
    {DrawLayer::Joints, "joints", "joints", "Joints", 0x2, true, true},
    {DrawLayer::Aabbs, "aabbs", "aabbs", "AABBs", 0x4},
    {DrawLayer::Pairs, "pairs", "pairs", "Pairs", 0x8},
    {DrawLayer::Contacts, "contacts", "contacts", "Contact points"},
    {DrawLayer::ContactNormals, "normals", "normals", "Contact normals"},
    {DrawLayer::ContactImpulses, "impulses", "impulses", "Contact impulses"},
    {DrawLayer::ContactFriction, "friction", "friction", "Friction impulses"},
    {DrawLayer::CentersOfMass, "centers-of-mass", "centers", "Centres of mass", 0x10, true},
    {DrawLayer::CenterMarks, "centers-of-mass", "masses", "Mass signs", 0, true},
    {DrawLayer::Velocities, "velocities", "velocities", "Velocities"},
    {DrawLayer::JointForces, "forces", "forces", "Joint forces"},
    {DrawLayer::JointGlyphs, "glyphs", "glyphs", "Joint signs", 0, true},
    {DrawLayer::Labels, "labels", "names", "Names"},
    {DrawLayer::Trails, "trails", nullptr, nullptr},
    {DrawLayer::Poses, "poses", nullptr, nullptr},
    {DrawLayer::Scene, "scene", nullptr, nullptr, 0, true},
    {DrawLayer::Annotations, "annotations", nullptr, nullptr},
}};

/// The rows of the layers that `--draw` names.
inline constexpr std::span<const LayerInfo> kOptionalLayers =
    std::span(kDrawLayers).first(std::size_t(DrawLayer::Trails));

/// Returns the properties of this layer.
constexpr const LayerInfo& InfoOf(DrawLayer layer)
{
    return kDrawLayers[std::size_t(layer)];
}

/// Returns the names of these layers, in their order.
std::vector<std::string> LayerNames();

/// Returns the layer of a name of `--draw`; none if there is no such layer.
std::optional<DrawLayer> FindLayer(std::string_view option);

/// Returns the layer of what the engine announces with a bit of b2Draw.
constexpr DrawLayer LayerOfFlag(std::uint32_t flag)
{
    for (const LayerInfo& info : kDrawLayers)
    {
        if (info.flag != 0 && info.flag == flag)
        {
            return info.layer;
        }
    }
    return DrawLayer::Shapes;
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

/// A set of visible layers. Initially contains the usual ones.
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
    /// Returns a set without layers.
    static constexpr LayerSet None()
    {
        LayerSet none;
        none.m_isShown = {};
        return none;
    }
    /// Access: true if the layer is shown.
    constexpr bool& operator[](DrawLayer layer) { return m_isShown[std::size_t(layer)]; }
    /// Same as above, read-only.
    constexpr const bool& operator[](DrawLayer layer) const
    {
        return m_isShown[std::size_t(layer)];
    }
    /// True if both contain the same layers.
    friend bool operator==(const LayerSet&, const LayerSet&) = default;

private:
    std::array<bool, kDrawLayers.size()> m_isShown{};
};

} // namespace boxreel
