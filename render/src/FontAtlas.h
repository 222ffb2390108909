// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

struct ImFontAtlas;
struct ImFontGlyph;

/// The font of all pictures, rasterized once per process and size: DejaVu Sans, or the font inside
/// Dear ImGui if that is not installed. Labels are laid out here, panels by Dear ImGui with the
/// same texture. Immutable after construction, so any thread may read it.
namespace boxreel
{

inline constexpr const char* kFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

/// Line height [px]: legible in a film of 720 lines after 4:2:0, and small beside a shape.
inline constexpr float kFontPixels = 15.0f;

/// A glyph to draw, relative to the text's top left corner [px, y down]. One pixel is one texel of
/// the texture.
struct GlyphQuad
{
    int x, y; ///< top left corner
    int width, height;
    int texelX, texelY; ///< its top left corner in the texture
};

class FontAtlas
{
public:
    /// Returns the atlas with glyphs of `scale` times kFontPixels. Created once per scale, never
    /// freed.
    static const FontAtlas& Get(double scale = 1.0);

    /// Uses the built-in font when the file is missing or invalid. For Get and tests.
    explicit FontAtlas(const char* fontFile, double scale = 1.0);
    ~FontAtlas();
    FontAtlas(const FontAtlas&) = delete;
    FontAtlas& operator=(const FontAtlas&) = delete;

    int Width() const { return m_width; }   ///< width of the texture [px]
    int Height() const { return m_height; } ///< height of the texture [px]
    const std::uint8_t* Coverage() const
    {
        return m_coverage;
    } ///< one byte per pixel, rows top to bottom

    /// Replaces `quads` by the visible glyphs of a UTF-8 text; a line feed starts a new line.
    void Layout(std::string_view text, std::vector<GlyphQuad>& quads) const;

    /// True if the font has this character; others are drawn as '?'.
    bool Has(char32_t letter) const;

    /// For ImGuiFrame.cpp only.
    ImFontAtlas* ImGuiAtlas() const { return m_atlas; }

private:
    /// A glyph in the atlas: its box relative to the pen [px], and its texture coordinates (0 to
    /// 1).
    struct Letter
    {
        float advance = 0.0f; ///< pen advance [px]
        bool isVisible = false;
        float x0 = 0.0f, y0 = 0.0f, x1 = 0.0f, y1 = 0.0f;
        float u0 = 0.0f, v0 = 0.0f;
    };

    void SpaceAs(const FontAtlas& model, float scale);
    void KeepLetters();
    const Letter& LetterOf(char32_t letter) const;
    /// Returns the quad at a position in the text [px].
    GlyphQuad QuadOf(const Letter& letter, float x, float y) const;

    ImFontAtlas* m_atlas;
    std::unordered_map<char32_t, Letter>
        m_letters;             // for lookups only: the iteration order depends on the library
    float m_lineHeight = 0.0f; // [px]
    const std::uint8_t* m_coverage = nullptr;
    int m_width = 0;
    int m_height = 0;
};

} // namespace boxreel
