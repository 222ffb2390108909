// SPDX-License-Identifier: MIT
#include <debugdraw/Theme.h>

#include <algorithm>
#include <utility>

namespace boxreel
{

namespace
{

// Relative luminance (IEC 61966-2-1, as in WCAG 2.1), with a square instead of the sRGB curve, in
// units of 1 / (255^2 * 10000). Whole numbers are the same on every machine; powers are not. The
// maximum error is 0.04 too bright, in the middle.
constexpr std::int64_t kWhiteLuminance = 255LL * 255 * 10000;
std::int64_t Luminance(Color c)
{
    return 2126LL * c.r * c.r + 7152LL * c.g * c.g + 722LL * c.b * c.b;
}

// WCAG 2.1 requires 3:1 for graphics; a quarter more covers the approximation.
bool IsSeen(Color color, Color ground)
{
    const std::int64_t flare = kWhiteLuminance / 20;
    const auto [darker, lighter] = std::minmax({Luminance(color), Luminance(ground)});
    return 4 * (lighter + flare) >= 15 * (darker + flare);
}

// Sixteenths are finer than visible steps, and the last, black or white, is always visible.
Color MadeSeen(Color color, Color ground)
{
    const bool lighten = Luminance(ground) < kWhiteLuminance / 5;
    const int goal = lighten ? 255 : 0;
    Color seen = color;
    for (int share = 1; share <= 16 && !IsSeen(seen, ground); ++share)
    {
        const auto mix = [&](std::uint8_t channel) {
            return static_cast<std::uint8_t>((channel * (16 - share) + goal * share) / 16);
        };
        seen = {mix(color.r), mix(color.g), mix(color.b), color.a};
    }
    return seen;
}

const std::vector<std::pair<std::string_view, Theme (*)()>>& Themes()
{
    static const std::vector<std::pair<std::string_view, Theme (*)()>> themes{
        {"classic", Theme::Classic},
        {"okabe-ito", Theme::OkabeIto},
        {"print", Theme::Print},
        {"dark", Theme::Dark}};
    return themes;
}

} // namespace

Color Theme::Outline(const Paint& asked) const
{
    return recolors && asked.role == ColorRole::None ? MadeSeen(asked.color, background)
                                                     : Fill(asked);
}

Color Theme::Fill(const Paint& asked) const
{
    if (!recolors || asked.role == ColorRole::None)
    {
        return asked.color;
    }
    Color color = palette[std::size_t(asked.role)];
    color.a = asked.color.a;
    return color;
}

Theme Theme::Classic()
{
    return Theme{};
}

Theme Theme::OkabeIto()
{
    constexpr Color kOrange{230, 159, 0};
    constexpr Color kSkyBlue{86, 180, 233};
    constexpr Color kGreen{0, 158, 115};
    constexpr Color kYellow{240, 228, 66};
    constexpr Color kBlue{0, 114, 178};
    constexpr Color kVermillion{213, 94, 0};
    constexpr Color kPurple{204, 121, 167};
    constexpr Color kInkWhite{255, 255, 255};
    Theme theme;
    theme.recolors = true;
    theme.xAxis = kVermillion;
    theme.yAxis = kGreen;
    // Found by a search for the largest distances to the eight colours and each other, for the
    // colour vision with the smallest differences (ThemeTest contains the measure).
    constexpr Color kLavender{165, 105, 240};
    constexpr Color kViolet{150, 0, 255};
    constexpr Color kPaleGreen{180, 210, 180};
    constexpr Color kMint{165, 255, 180};
    constexpr Color kOlive{165, 180, 135};
    constexpr Color kCrimson{195, 45, 60};
    constexpr Color kCyan{15, 225, 255};
    // Sleeping bodies have the darkest colour, to recede. It is shared only with text and with
    // inactive bodies, which are rare.
    theme.palette = {kGreen,    kSkyBlue, kOrange,     kBlue,    kInkWhite,  kYellow,
                     kLavender, kPurple,  kVermillion, kViolet,  kPaleGreen, kMint,
                     kOlive,    kCrimson, kCyan,       kInkWhite};
    return theme;
}

Theme Theme::Print()
{
    Theme theme;
    theme.recolors = true;
    theme.background = {255, 255, 255};
    theme.text = {17, 17, 17};
    theme.xAxis = {198, 40, 40};
    theme.yAxis = {46, 125, 50};
    theme.fillShade = 1.0f; // half a colour would be grey on white
    theme.fillAlpha = 0.22f;
    theme.palette = {{{43, 110, 63},
                      {47, 79, 168},
                      {166, 60, 44},
                      {107, 107, 107},
                      {122, 106, 26},
                      {0, 116, 125},
                      {36, 84, 230},
                      {142, 42, 142},
                      {27, 122, 27},
                      {42, 42, 200},
                      {64, 64, 64},
                      {0, 0, 120},
                      {135, 150, 105},
                      {240, 75, 195},
                      {15, 150, 240},
                      {17, 17, 17}}};
    return theme;
}

Theme Theme::Dark()
{
    Theme theme;
    theme.recolors = true;
    theme.background = {13, 17, 23};
    theme.text = {230, 237, 243};
    theme.xAxis = {255, 107, 107};
    theme.yAxis = {76, 217, 100};
    theme.palette = {{{125, 220, 140},
                      {138, 180, 255},
                      {255, 179, 167},
                      {154, 164, 174},
                      {181, 173, 106},
                      {92, 214, 214},
                      {200, 205, 255},
                      {229, 138, 240},
                      {95, 227, 95},
                      {143, 143, 255},
                      {221, 227, 234},
                      {225, 120, 0},
                      {135, 90, 30},
                      {225, 0, 120},
                      {60, 90, 195},
                      {240, 246, 252}}};
    return theme;
}

const std::vector<std::string_view>& ThemeNames()
{
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        for (const auto& [name, make] : Themes())
        {
            all.push_back(name);
        }
        return all;
    }();
    return names;
}

std::optional<Theme> FindTheme(std::string_view name)
{
    for (const auto& [known, make] : Themes())
    {
        if (known == name)
        {
            return make();
        }
    }
    return std::nullopt;
}

} // namespace boxreel
