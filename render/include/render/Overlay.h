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
/// Panels over a frame. An Overlay is plain triangles with texture coordinates into the one font
/// texture; a Hud lays one out with Dear ImGui, which only ImGui*.cpp know.
namespace boxreel
{

/// A corner of a triangle.
struct OverlayVertex
{
    Vec2 position; ///< in the picture [px], y down
    Vec2 uv;       ///< into the font texture
    Color color;   ///< not premultiplied
    /// Whether all members are equal.
    friend bool operator==(const OverlayVertex&, const OverlayVertex&) = default;
};

/// Some triangles, and where they may be seen.
struct OverlayCommand
{
    std::uint32_t firstIndex = 0; ///< into Overlay::indices
    std::uint32_t indexCount = 0; ///< three for each triangle
    int clipX0 = 0;               ///< left end of what is seen [px]
    int clipY0 = 0;               ///< its upper end [px], y down
    int clipX1 = 0;               ///< its right end, excluded [px]
    int clipY1 = 0;               ///< its lower end, excluded [px]
    /// Whether all members are equal.
    friend bool operator==(const OverlayCommand&, const OverlayCommand&) = default;
};

/// Triangles that are drawn above all else.
struct Overlay
{
    std::vector<OverlayVertex> vertices;  ///< shared by triangles
    std::vector<std::uint32_t> indices;   ///< three for each triangle, into vertices
    std::vector<OverlayCommand> commands; ///< in their order
    /// Whether nothing is drawn.
    bool IsEmpty() const { return commands.empty(); }
    /// Whether all members are equal.
    friend bool operator==(const Overlay&, const Overlay&) = default;
};

/// What the panel shows: a title and rows of name and value.
struct HudContent
{
    std::string title;                                     ///< above the rows; empty: none
    std::vector<std::pair<std::string, std::string>> rows; ///< name and value, UTF-8
};

/// One Dear ImGui panel in the top left corner. Same content, same triangles.
class Hud
{
public:
    /// `width`, `height`: of the picture, with its scale in it, 1 to 8192 [px]; `scale`: how much
    /// larger than usual the panel and its letters are, 0.1 to 16, the renderer's. An Error
    /// (Unusable) for a size or a scale out of range.
    static Result<Hud> Create(int width, int height, double scale = 1.0);
    /// The other may only be assigned to or destroyed.
    Hud(Hud&&) noexcept;
    /// The other may only be assigned to or destroyed.
    Hud& operator=(Hud&&) noexcept;
    ~Hud();

    /// Valid until the next call.
    const Overlay& Build(const HudContent& content);

private:
    struct Impl;
    explicit Hud(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
