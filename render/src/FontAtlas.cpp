// SPDX-License-Identifier: MIT
#include "FontAtlas.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <mutex>

namespace boxreel
{
namespace
{

constexpr float kBuiltInPixels = 13.0f; // what Dear ImGui's own font is drawn for

// Western, Greek and Cyrillic letters, dashes and quotes, arrows, the common signs of mathematics.
constexpr ImWchar kRanges[] = {0x0020, 0x017F, 0x0391, 0x03C9, 0x0400, 0x045F, 0x2010,
                               0x2027, 0x2030, 0x203A, 0x2070, 0x209C, 0x2190, 0x2199,
                               0x2202, 0x2265, 0x22C5, 0x22C5, 0};

std::vector<char> ReadWhole(const char* path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Whether the bytes begin as a TrueType or OpenType font; Dear ImGui stops the program at others.
bool LooksLikeFont(const std::vector<char>& bytes)
{
    const std::string_view start(bytes.data(), bytes.size() < 4 ? 0 : 4);
    return start == std::string_view("\0\1\0\0", 4) || start == "true" || start == "OTTO";
}

/// Gives letters the distances they have at scale 1, times the scale: a larger picture is the same
/// picture, not one set anew.
void SpaceAs(const ImFont& model, float scale, ImFont& font)
{
    for (ImFontGlyph& glyph : font.Glyphs)
    {
        glyph.AdvanceX = scale * model.FindGlyph(ImWchar(glyph.Codepoint))->AdvanceX;
    }
    font.BuildLookupTable(); // which keeps advances of its own
}

} // namespace

const FontAtlas& FontAtlas::Get(double scale)
{
    if (scale == 1.0)
    {
        static const FontAtlas atlas(kFontFile);
        return atlas;
    }
    static std::mutex access;
    static std::map<double, FontAtlas> others; // whose entries never move
    const std::lock_guard lock(access);
    return others.try_emplace(scale, kFontFile, scale).first->second;
}

FontAtlas::FontAtlas(const char* fontFile, double scale) : m_atlas(IM_NEW(ImFontAtlas)())
{
    ImFontConfig config;
    // Letters stand on whole pixels, so each is rasterised once, exactly there: no blur from
    // filtering.
    config.OversampleH = 1;
    config.OversampleV = 1;
    config.PixelSnapH = true;
    m_atlas->Flags |= ImFontAtlasFlags_NoMouseCursors;
    std::vector<char> file = ReadWhole(fontFile);
    if (LooksLikeFont(file))
    {
        config.FontDataOwnedByAtlas = false;
        m_atlas->AddFontFromMemoryTTF(file.data(), int(file.size()), float(kFontPixels * scale),
                                      &config, kRanges);
        m_atlas->Build(); // reads `file`, so while it lives
    }
    else
    {
        config.SizePixels = float(kBuiltInPixels * scale);
        m_atlas->AddFontDefault(scale == 1.0 ? nullptr : &config);
        m_atlas->Build();
    }
    if (scale != 1.0)
    {
        SpaceAs(*Get().m_atlas->Fonts[0], float(scale), *m_atlas->Fonts[0]);
    }
    unsigned char* pixels = nullptr;
    m_atlas->GetTexDataAsAlpha8(&pixels, &m_width, &m_height);
    m_coverage = pixels;
    m_atlas->ClearInputData();
}

FontAtlas::~FontAtlas()
{
    IM_DELETE(m_atlas);
}

bool FontAtlas::Has(char32_t letter) const
{
    return letter <= 0xFFFF &&
           m_atlas->Fonts[0]->FindGlyphNoFallback(static_cast<ImWchar>(letter)) != nullptr;
}

void FontAtlas::Layout(std::string_view text, std::vector<GlyphQuad>& quads) const
{
    quads.clear();
    const ImFont& font = *m_atlas->Fonts[0];
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
            y += font.FontSize;
            continue;
        }
        character = character == '\t' ? ' ' : character;
        const ImFontGlyph* const glyph =
            character < ' ' ? nullptr : font.FindGlyph(ImWchar(character));
        if (glyph == nullptr)
        {
            continue;
        }
        if (glyph->Visible)
        {
            const float left = std::floor(x + 0.5f);
            quads.push_back({left + glyph->X0, y + glyph->Y0, left + glyph->X1, y + glyph->Y1,
                             glyph->U0, glyph->V0, glyph->U1, glyph->V1});
        }
        x += glyph->AdvanceX;
    }
}

} // namespace boxreel
