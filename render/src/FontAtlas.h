// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

struct ImFontAtlas;
struct ImFontGlyph;

/// The one font of the toolkit's pictures, rasterised once a process and size: DejaVu Sans, or the
/// font inside Dear ImGui where that is not installed. Labels are laid out here, panels by Dear
/// ImGui with the same texture. Immutable once made, so any thread may read it.
namespace boxreel
{

inline constexpr const char* kFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

/// Height of a line [px]: legible in a film of 720 lines after 4:2:0, and small beside a shape.
inline constexpr float kFontPixels = 15.0f;

/// A letter to draw, relative to the text's top left corner [px, y down]. A pixel of it is a texel
/// of the texture.
struct GlyphQuad
{
    int x, y; ///< top left corner
    int width, height;
    int texelX, texelY; ///< of its top left corner
};

class FontAtlas
{
public:
    /// Letters `scale` times as large as kFontPixels says. Kept from then on.
    static const FontAtlas& Get(double scale = 1.0);

    /// With the built-in font when the file is missing or is none. For Get and tests.
    explicit FontAtlas(const char* fontFile, double scale = 1.0);
    ~FontAtlas();
    FontAtlas(const FontAtlas&) = delete;
    FontAtlas& operator=(const FontAtlas&) = delete;

    int Width() const { return m_width; }   ///< of the texture [px]
    int Height() const { return m_height; } ///< [px]
    const std::uint8_t* Coverage() const
    {
        return m_coverage;
    } ///< one byte a pixel, rows top to bottom

    /// Replaces `quads` by the visible letters of a UTF-8 text; a line feed starts a line.
    void Layout(std::string_view text, std::vector<GlyphQuad>& quads) const;

    /// Whether there is a picture of this letter; others are drawn as '?'.
    bool Has(char32_t letter) const;

    /// For ImGuiFrame.cpp alone.
    ImFontAtlas* ImGuiAtlas() const { return m_atlas; }

private:
    /// As the atlas has it: the box about the pen [px], and where it begins in the atlas (0 to 1).
    struct Letter
    {
        float advance = 0.0f; ///< to the next one [px]
        bool isVisible = false;
        float x0 = 0.0f, y0 = 0.0f, x1 = 0.0f, y1 = 0.0f;
        float u0 = 0.0f, v0 = 0.0f;
    };

    void SpaceAs(const FontAtlas& model, float scale);
    void KeepLetters();
    const Letter& LetterOf(char32_t letter) const;
    /// At a place in the text [px].
    GlyphQuad QuadOf(const Letter& letter, float x, float y) const;

    ImFontAtlas* m_atlas;
    std::unordered_map<char32_t, Letter>
        m_letters;             // looked up only: its order depends on the library
    float m_lineHeight = 0.0f; // [px]
    const std::uint8_t* m_coverage = nullptr;
    int m_width = 0;
    int m_height = 0;
};

} // namespace boxreel
