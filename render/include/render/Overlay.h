// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>
#include <debugdraw/Result.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// Panels over a frame. An Overlay is plain triangles with texture coordinates into the one font
/// texture; a Hud lays one out with Dear ImGui, which only ImGui*.cpp know.
namespace boxreel
{

struct OverlayVertex
{
    Vec2 position; ///< [px], y down
    Vec2 uv;       ///< into the font texture
    Color color;   ///< not premultiplied
    friend bool operator==(const OverlayVertex&, const OverlayVertex&) = default;
};

struct OverlayCommand
{
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0;
    int clipX0 = 0, clipY0 = 0, clipX1 = 0, clipY1 = 0; ///< [px], y down, upper bounds excluded
    friend bool operator==(const OverlayCommand&, const OverlayCommand&) = default;
};

struct Overlay
{
    std::vector<OverlayVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<OverlayCommand> commands;
    bool IsEmpty() const { return commands.empty(); }
    friend bool operator==(const Overlay&, const Overlay&) = default;
};

/// What the panel shows: a title and rows of name and value.
struct HudContent
{
    std::string title;
    std::vector<std::pair<std::string, std::string>> rows;
};

/// One Dear ImGui panel in the top left corner. Same content, same triangles.
class Hud
{
public:
    /// `width`, `height`: of the picture, with its scale in it; `scale`: how much larger than
    /// usual the panel and its letters are, 0.1 to 16, the renderer's.
    static Result<Hud> Create(int width, int height, double scale = 1.0);
    Hud(Hud&&) noexcept;
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
