// SPDX-License-Identifier: MIT
#include "FontAtlas.h"

#include <base/ReadWhole.h>

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <cstring>
#include <map>
#include <mutex>

namespace boxreel
{
namespace
{

constexpr float kBuiltInPixels = 13.0f; // native size of Dear ImGui's built-in font

// Western, Greek and Cyrillic letters, dashes and quotes, arrows, common mathematical symbols.
constexpr ImWchar kRanges[] = {0x0020, 0x017F, 0x0391, 0x03C9, 0x0400, 0x045F, 0x2010,
                               0x2027, 0x2030, 0x203A, 0x2070, 0x209C, 0x2190, 0x2199,
                               0x2202, 0x2265, 0x22C5, 0x22C5, 0};

constexpr std::uintmax_t kLargestFont = 64u << 20; // [bytes]
constexpr char kFallback = '?';                    // replaces missing characters

/// True if the bytes start like a TrueType or OpenType font; Dear ImGui aborts on others.
bool LooksLikeFont(const std::string& bytes)
{
    const std::string_view start = std::string_view(bytes).substr(0, 4);
    return start == std::string_view("\0\1\0\0", 4) || start == "true" || start == "OTTO";
}

// Until Dear ImGui 1.92 a font had one size; since then glyphs belong to a baked size.
#if IMGUI_VERSION_NUM >= 19200
using Letters = ImFontBaked;

Letters& LettersOf(ImFont& font)
{
    return *font.GetFontBaked(font.LegacySize);
}

float LineHeightOf(const Letters& letters)
{
    return letters.Size;
}

void ApplyAdvances(Letters& letters)
{
    for (const ImFontGlyph& glyph : letters.Glyphs)
    {
        letters.IndexAdvanceX[int(glyph.Codepoint)] = glyph.AdvanceX;
    }
}

/// Rasterizes the glyphs and fixes the atlas, ready for contexts that share it. One byte per pixel;
/// another format would discard it.
void Build(ImFontAtlas& atlas)
{
    constexpr ImWchar kNoLetter = 0xFFFF;
    atlas.TexDesiredFormat = ImTextureFormat_Alpha8;
    atlas.Build();
    LettersOf(*atlas.Fonts[0]).FindGlyph(kNoLetter); // creates the fallback
    atlas.Fonts[0]->Flags |= ImFontFlags_NoLoadGlyphs | ImFontFlags_LockBakedSizes;
    ImFontAtlasUpdateNewFrame(&atlas, 0, false);
}
#else
using Letters = ImFont;

Letters& LettersOf(ImFont& font)
{
    return font;
}

float LineHeightOf(const Letters& letters)
{
    return letters.FontSize;
}

void ApplyAdvances(Letters& letters)
{
    letters.BuildLookupTable();
}

void Build(ImFontAtlas& atlas)
{
    atlas.Build();
    atlas.ClearInputData();
}
#endif

} // namespace

const FontAtlas& FontAtlas::Get(double scale)
{
    if (scale == 1.0)
    {
        static const FontAtlas atlas(kFontFile);
        return atlas;
    }
    static std::mutex access;
    static std::map<double, FontAtlas> others; // a map, because its entries never move
    const std::lock_guard lock(access);
    return others.try_emplace(scale, kFontFile, scale).first->second;
}

FontAtlas::FontAtlas(const char* fontFile, double scale) : m_atlas(IM_NEW(ImFontAtlas)())
{
    ImFontConfig config;
    // Glyphs are placed on whole pixels, so each is rasterized once without subpixel positions.
    config.OversampleH = 1;
    config.OversampleV = 1;
    config.PixelSnapH = true;
    m_atlas->Flags |= ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoBakedLines;
    const Result<std::string> file = ReadWhole(fontFile, kLargestFont);
    if (file && LooksLikeFont(*file))
    {
        void* const bytes = IM_ALLOC(file->size()); // freed by the atlas
        std::memcpy(bytes, file->data(), file->size());
        m_atlas->AddFontFromMemoryTTF(bytes, int(file->size()), float(kFontPixels * scale), &config,
                                      kRanges);
    }
    else
    {
        config.SizePixels = float(kBuiltInPixels * scale);
        m_atlas->AddFontDefault(scale == 1.0 ? nullptr : &config);
    }
    m_atlas->Fonts[0]->FallbackChar = kFallback;
    Build(*m_atlas);
    if (scale != 1.0)
    {
        SpaceAs(Get(), float(scale));
    }
    KeepLetters();
    unsigned char* pixels = nullptr;
    m_atlas->GetTexDataAsAlpha8(&pixels, &m_width, &m_height);
    m_coverage = pixels;
}

FontAtlas::~FontAtlas()
{
    IM_DELETE(m_atlas);
}

/// Gives glyphs the advances of `model` times the scale: a larger picture has the same text layout.
void FontAtlas::SpaceAs(const FontAtlas& model, float scale)
{
    Letters& letters = LettersOf(*m_atlas->Fonts[0]);
    for (ImFontGlyph& glyph : letters.Glyphs)
    {
        glyph.AdvanceX = scale * model.LetterOf(glyph.Codepoint).advance;
    }
    ApplyAdvances(letters);
}

/// Copies the drawing data of each glyph. Dear ImGui allows lookups only under its lock.
void FontAtlas::KeepLetters()
{
    Letters& letters = LettersOf(*m_atlas->Fonts[0]);
    m_lineHeight = LineHeightOf(letters);
    for (const ImFontGlyph& glyph : letters.Glyphs)
    {
        if (glyph.Codepoint == IM_UNICODE_CODEPOINT_INVALID)
        {
            continue; // Dear ImGui 1.92 adds its own replacement character; ours is '?'
        }
        m_letters[glyph.Codepoint] = {glyph.AdvanceX, glyph.Visible != 0, glyph.X0, glyph.Y0,
                                      glyph.X1,       glyph.Y1,           glyph.U0, glyph.V0};
    }
    m_letters.try_emplace(kFallback); // even that may be missing in a font
}

const FontAtlas::Letter& FontAtlas::LetterOf(char32_t letter) const
{
    const auto found = m_letters.find(letter);
    return found != m_letters.end() ? found->second : m_letters.at(kFallback);
}

bool FontAtlas::Has(char32_t letter) const
{
    return m_letters.contains(letter);
}

GlyphQuad FontAtlas::QuadOf(const Letter& letter, float x, float y) const
{
    // Pixels whose centre is inside: at fractional scales lines lie between two rows.
    const auto pixel = [](float at) { return int(std::ceil(at - 0.5f)); };
    const auto texel = [](float at, int size) { return int(std::floor(at * float(size) + 0.5f)); };
    const float left = std::floor(x + 0.5f);
    return {pixel(left + letter.x0),      pixel(y + letter.y0),      pixel(letter.x1 - letter.x0),
            pixel(letter.y1 - letter.y0), texel(letter.u0, m_width), texel(letter.v0, m_height)};
}

void FontAtlas::Layout(std::string_view text, std::vector<GlyphQuad>& quads) const
{
    quads.clear();
    float x = 0.0f;
    float y = 0.0f;
    const char* const end = text.data() + text.size();
    for (const char* at = text.data(); at < end;)
    {
        unsigned int character = 0;
        at += ImTextCharFromUtf8(&character, at, end);
        if (character == '\n')
        {
            x = 0.0f;
            y += m_lineHeight;
            continue;
        }
        character = character == '\t' ? ' ' : character;
        if (character < ' ')
        {
            continue;
        }
        const Letter& letter = LetterOf(character);
        if (letter.isVisible)
        {
            quads.push_back(QuadOf(letter, x, y));
        }
        x += letter.advance;
    }
}

} // namespace boxreel
