// SPDX-License-Identifier: MIT
#include <debugdraw/Theme.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace boxreel;

namespace
{

using Triple = std::array<double, 3>;

/// Linear light, 0 to 1 (IEC 61966-2-1).
Triple Linear(Color color)
{
    const auto channel = [](std::uint8_t byte) {
        const double c = byte / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return {channel(color.r), channel(color.g), channel(color.b)};
}

/// WCAG 2.1, "contrast ratio".
double Contrast(Color a, Color b)
{
    const auto luminance = [](Color color) {
        const Triple light = Linear(color);
        return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
    };
    const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
    return (lighter + 0.05) / (darker + 0.05);
}

using Matrix = std::array<double, 9>;

Triple Times(const Matrix& m, const Triple& v)
{
    Triple product{};
    for (std::size_t row = 0; row < 3; ++row)
    {
        const double sum = m[3 * row] * v[0] + m[3 * row + 1] * v[1] + m[3 * row + 2] * v[2];
        product[row] = std::clamp(sum, 0.0, 1.0);
    }
    return product;
}

enum class Vision
{
    Normal,
    Protanopia,
    Deuteranopia,
    Tritanopia,
};

/// Returns the light that a dichromat sees. For red and green: Vienot, Brettel and Mollon, "Digital
/// Video Colourmaps for Checking the Legibility of Displays by Dichromats" (1999). For blue:
/// Brettel, Vienot and Mollon, "Computerized Simulation of Color Appearance for Dichromats" (1997),
/// which has two half planes.
Triple Seen(const Triple& light, Vision vision)
{
    constexpr Matrix kProtan{0.11238, 0.88762, 0.0, 0.11238, 0.88762, 0.0, 0.00401, -0.00401, 1.0};
    constexpr Matrix kDeutan{0.29275, 0.70725, 0.0, 0.29275, 0.70725, 0.0, -0.02234, 0.02234, 1.0};
    constexpr Matrix kTritanOne{1.01277, 0.13548, -0.14826, -0.01243, 0.86812,
                                0.14431, 0.07589, 0.80500,  0.11911};
    constexpr Matrix kTritanTwo{0.93678, 0.18979,  -0.12657, 0.06154, 0.81526,
                                0.12320, -0.37562, 1.12767,  0.24796};
    switch (vision)
    {
    case Vision::Protanopia:
        return Times(kProtan, light);
    case Vision::Deuteranopia:
        return Times(kDeutan, light);
    case Vision::Tritanopia: {
        const double side = 0.03901 * light[0] - 0.02788 * light[1] - 0.01113 * light[2];
        return Times(side > 0.0 ? kTritanOne : kTritanTwo, light);
    }
    default:
        return light;
    }
}

/// Ottosson, "A perceptual color space for image processing" (2020).
Triple Oklab(const Triple& c)
{
    const double l = std::cbrt(0.4122214708 * c[0] + 0.5363325363 * c[1] + 0.0514459929 * c[2]);
    const double m = std::cbrt(0.2119034982 * c[0] + 0.6806995451 * c[1] + 0.1073969566 * c[2]);
    const double s = std::cbrt(0.0883024619 * c[0] + 0.2817188376 * c[1] + 0.6299787005 * c[2]);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

double Distance(Color a, Color b, Vision vision)
{
    const Triple p = Oklab(Seen(Linear(a), vision));
    const Triple q = Oklab(Seen(Linear(b), vision));
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

bool Share(std::size_t a, std::size_t b)
{
    // Bodies that are out of the simulation have the colour of letters, which are no shapes.
    const auto [less, more] = std::minmax(a, b);
    return less == std::size_t(ColorRole::InactiveBody) && more == std::size_t(ColorRole::Ink);
}

double LeastDistance(const Palette& palette, Vision vision)
{
    double minimum = 1.0;
    for (std::size_t a = 0; a < kColorRoles; ++a)
    {
        for (std::size_t b = a + 1; b < kColorRoles; ++b)
        {
            minimum =
                Share(a, b) ? minimum : std::min(minimum, Distance(palette[a], palette[b], vision));
        }
    }
    return minimum;
}

constexpr std::array kVisions{Vision::Normal, Vision::Protanopia, Vision::Deuteranopia,
                              Vision::Tritanopia};

Theme Named(std::string_view name)
{
    const std::optional<Theme> theme = FindTheme(name);
    EXPECT_TRUE(theme) << name;
    return theme.value_or(Theme());
}

} // namespace

TEST(Theme, IsFoundByItsName)
{
    EXPECT_THAT(ThemeNames(), testing::ElementsAre("classic", "okabe-ito", "print", "dark"));
    EXPECT_FALSE(FindTheme("Classic"));
    EXPECT_FALSE(FindTheme(""));
    EXPECT_EQ(Named("print").background, (Color{255, 255, 255}));
}

TEST(Theme, KeepsEveryColourInClassic)
{
    const Theme classic = Theme::Classic();
    for (const Paint asked : {Paint(ColorRole::StaticBody), Paint(1, 2, 3, 4), Paint(26, 26, 26)})
    {
        EXPECT_EQ(classic.Outline(asked), asked.color);
        EXPECT_EQ(classic.Fill(asked), asked.color);
    }
}

TEST(Theme, HasAColourForEachRoleAndKeepsItsOpacity)
{
    for (const std::string_view name : {"okabe-ito", "print", "dark"})
    {
        const Theme theme = Named(name);
        for (std::size_t role = 0; role < kColorRoles; ++role)
        {
            const Paint asked(ColorRole(role), 77);
            Color expected = theme.palette[role];
            expected.a = 77;
            EXPECT_EQ(theme.Outline(asked), expected) << name << " " << role;
            EXPECT_EQ(theme.Fill(asked), expected) << name << " " << role;
        }
    }
}

/// Equal bytes are not a role: only what would hardly be seen is changed.
TEST(Theme, KeepsAUsersColourThatEqualsAClassicOne)
{
    for (const std::string_view name : {"okabe-ito", "dark"})
    {
        const Theme theme = Named(name);
        for (const Color color : kClassicPalette)
        {
            const Color shown = theme.Outline(color);
            EXPECT_TRUE(shown == color || Contrast(color, theme.background) < 4.0) << name;
            EXPECT_EQ(theme.Fill(color), color) << name;
        }
    }
}

TEST(Theme, ContrastsWithItsBackground)
{
    for (const std::string_view name : ThemeNames())
    {
        const Theme theme = Named(name);
        for (const Color color : theme.palette)
        {
            EXPECT_GE(Contrast(color, theme.background), 3.0)
                << name << " " << testing::PrintToString(std::array{color.r, color.g, color.b});
        }
        EXPECT_GE(Contrast(theme.xAxis, theme.background), 3.0) << name;
        EXPECT_GE(Contrast(theme.yAxis, theme.background), 3.0) << name;
        EXPECT_GE(Contrast(theme.text, theme.background), 7.0) << name << ", which is for reading";
    }
}

TEST(Theme, KeepsUsersColoursWithVisibleOutlines)
{
    const Color brick{180, 40, 20, 200};
    EXPECT_EQ(Theme::Print().Outline(brick), brick) << "it is seen as it is";
    const Color pale{250, 240, 120};
    EXPECT_EQ(Theme::Print().Fill(pale), pale);
    EXPECT_NE(Theme::Print().Outline(pale), pale);
    for (const std::string_view name : {"okabe-ito", "print", "dark"})
    {
        const Theme theme = Named(name);
        for (int i = 0; i < 4096; ++i)
        {
            const Color user{std::uint8_t(i % 16 * 17), std::uint8_t(i / 16 % 16 * 17),
                             std::uint8_t(i / 256 * 17)};
            ASSERT_GE(Contrast(theme.Outline(user), theme.background), 3.0)
                << name << " " << int(user.r) << "," << int(user.g) << "," << int(user.b);
        }
    }
}

// In OKLab a difference of about 0.02 is just visible side by side. The classic palette goes down
// to 0.002 (contacts to a protanope), this one never below 0.079. All layers may overlap, so every
// role is compared with every other.
TEST(Theme, IsDistinctForEveryColourVisionInOkabeIto)
{
    for (const Vision vision : kVisions)
    {
        EXPECT_GE(LeastDistance(Theme::OkabeIto().palette, vision), 0.075) << int(vision);
    }
    EXPECT_LT(LeastDistance(kClassicPalette, Vision::Protanopia), 0.01) << "the measure can fail";
}

TEST(Theme, HasDistinctArrowsForEveryColourVision)
{
    for (const std::string_view name : {"okabe-ito", "print", "dark"})
    {
        const Palette palette = Named(name).palette;
        for (const ColorRole arrow : {ColorRole::ContactImpulse, ColorRole::ContactFriction,
                                      ColorRole::JointForce, ColorRole::Velocity})
        {
            for (std::size_t other = 0; other < kColorRoles; ++other)
            {
                for (const Vision vision : kVisions)
                {
                    const double distance =
                        Distance(palette[std::size_t(arrow)], palette[other], vision);
                    EXPECT_TRUE(distance >= 0.075 || other == std::size_t(arrow))
                        << name << " " << int(arrow) << " " << other << " " << int(vision);
                }
            }
        }
    }
}

TEST(Theme, KeepsTheColoursOfBox2DInClassic)
{
    const auto classic = [](ColorRole role) { return kClassicPalette[std::size_t(role)]; };
    EXPECT_EQ(classic(ColorRole::AwakeBody), (Color{230, 179, 179}));
    EXPECT_EQ(classic(ColorRole::Joint), (Color{128, 204, 204}));
    EXPECT_EQ(classic(ColorRole::ContactImpulse), (Color{230, 230, 77}));
    EXPECT_LT(Distance(classic(ColorRole::ContactImpulse), classic(ColorRole::ContactFriction),
                       Vision::Normal),
              0.001)
        << "they look the same";
}

TEST(Theme, HasDistinctThinJointsAndPairs)
{
    for (const Theme& theme : {Theme::Print(), Theme::Dark()})
    {
        const Color joint = theme.palette[std::size_t(ColorRole::Joint)];
        const Color pair = theme.palette[std::size_t(ColorRole::Pair)];
        EXPECT_GT(std::abs(joint.r - pair.r) + std::abs(joint.g - pair.g) +
                      std::abs(joint.b - pair.b),
                  120);
    }
}
