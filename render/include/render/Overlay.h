// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/DrawList.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// @file
/// Panels over a frame. An Overlay is a list of triangles with texture coordinates into the single
/// font texture. A Hud creates one with Dear ImGui, which only ImGui*.cpp use.
namespace boxreel
{

/// A vertex of a triangle.
struct OverlayVertex
{
    Vec2 position; ///< in the picture [px], y down
    Vec2 uv;       ///< into the font texture
    Color color;   ///< not premultiplied
    /// True if all members are equal.
    friend bool operator==(const OverlayVertex&, const OverlayVertex&) = default;
};

/// A range of triangles with a clip rectangle.
struct OverlayCommand
{
    std::uint32_t firstIndex = 0; ///< into Overlay::indices
    std::uint32_t indexCount = 0; ///< three for each triangle
    int clipX0 = 0;               ///< left edge of the clip rectangle [px]
    int clipY0 = 0;               ///< its upper edge [px], y down
    int clipX1 = 0;               ///< its right edge, excluded [px]
    int clipY1 = 0;               ///< its lower edge, excluded [px]
    /// True if all members are equal.
    friend bool operator==(const OverlayCommand&, const OverlayCommand&) = default;
};

/// Triangles drawn on top of the frame.
struct Overlay
{
    std::vector<OverlayVertex> vertices;  ///< shared by triangles
    std::vector<std::uint32_t> indices;   ///< three for each triangle, into vertices
    std::vector<OverlayCommand> commands; ///< in drawing order
    /// True if nothing is drawn.
    bool IsEmpty() const { return commands.empty(); }
    /// True if all members are equal.
    friend bool operator==(const Overlay&, const Overlay&) = default;
};

/// The content of the panel: a title and rows of name and value.
struct HudContent
{
    std::string title;                                     ///< above the rows; may be empty
    std::vector<std::pair<std::string, std::string>> rows; ///< name and value, UTF-8
};

/// A Dear ImGui panel in the top left corner. Same content, same triangles.
class Hud
{
public:
    /// Creates a panel. `width`, `height`: size of the picture after scaling, 1 to 8192 [px].
    /// `scale`: factor of the panel and its text, 0.1 to 16, as in the renderer. An Error
    /// (Unusable) for a value out of range.
    static Result<Hud> Create(int width, int height, double scale = 1.0);
    /// Leaves the source in a moved-from state.
    Hud(Hud&&) noexcept;
    /// Leaves the source in a moved-from state.
    Hud& operator=(Hud&&) noexcept;
    ~Hud();

    /// Returns the panel's triangles, valid until the next call.
    const Overlay& Build(const HudContent& content);

private:
    struct Impl;
    explicit Hud(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
