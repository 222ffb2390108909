// SPDX-License-Identifier: MIT
// Prints a line for each of some pictures: hashes of its shapes and labels, of a panel above them,
// and of the panel's corners. At several scales, where letters and corners of panels lie between
// whole pixels.
#include <render/Overlay.h>
#include <render/Renderer.h>

#include <cstdio>

using namespace boxreel;

namespace
{

constexpr int kWidth = 1280;
constexpr int kHeight = 900;

/// FNV-1a.
unsigned long long HashOf(const void* data, std::size_t size)
{
    const auto* const bytes = static_cast<const unsigned char*>(data);
    unsigned long long hash = 14695981039346656037ull;
    for (std::size_t i = 0; i < size; ++i)
    {
        hash = (hash ^ bytes[i]) * 1099511628211ull;
    }
    return hash;
}

/// Every kind of shape in many colours, each with a label.
DrawList Shapes()
{
    DrawList list;
    for (int i = 0; i < 60; ++i)
    {
        const float x = float(i % 10) * 2.1f;
        const float y = float(i / 10) * 2.3f - 3.0f;
        const Vec2 corners[5] = {{x, y},
                                 {x + 1.3f, y + 0.21f},
                                 {x + 1.1f, y + 1.3f},
                                 {x + 0.3f, y + 1.5f},
                                 {x - 0.2f, y + 0.7f}};
        const Color color{std::uint8_t(40 + 3 * i), 200, std::uint8_t(255 - 4 * i),
                          std::uint8_t(255 - 2 * i)};
        switch (i % 5)
        {
        case 0:
            list.AddSolidPolygon(corners, std::size_t(3 + i / 5 % 3), color);
            break;
        case 1:
            list.AddSolidCircle({x, y}, 0.1f + 0.02f * float(i), {0.6f, 0.8f}, color);
            break;
        case 2:
            list.AddSegment(corners[0], corners[2], color);
            break;
        case 3:
            list.AddCircle({x, y}, 0.7f, color);
            break;
        default:
            list.AddPoint({x, y}, 3.0f + 0.1f * float(i), color);
        }
        list.AddText({x, y + 1.0f}, "Ag" + std::to_string(i) + "\nfy", color);
    }
    return list;
}

HudContent Rows()
{
    HudContent content{"Vertical Stack \xC3\xA9", {}};
    for (int i = 0; i < 12; ++i)
    {
        content.rows.push_back({"velocity " + std::to_string(i), "12.345 [ 6.789 ]"});
    }
    return content;
}

Result<void> Print(double scale)
{
    Result<Renderer> renderer =
        Renderer::Create({.width = kWidth, .height = kHeight, .scale = scale});
    Result<Hud> hud = Hud::Create(kWidth, kHeight, scale);
    if (!renderer || !hud)
    {
        return renderer ? hud.GetError() : renderer.GetError();
    }
    const Camera camera{kWidth, kHeight, 10.0, 5.0, 20.0 * scale};
    const Overlay& panel = hud->Build(Rows());
    Frame bare;
    Frame whole;
    for (const auto& [frame, overlay] :
         {std::pair<Frame*, const Overlay*>{&bare, nullptr}, {&whole, &panel}})
    {
        if (Result<void> drawn = renderer->Draw(Shapes(), camera, *frame, overlay); !drawn)
        {
            return drawn;
        }
    }
    std::printf("scale %.1f: shapes %016llx, with a panel %016llx, its corners %016llx\n", scale,
                HashOf(bare.rgba.data(), bare.rgba.size()),
                HashOf(whole.rgba.data(), whole.rgba.size()),
                HashOf(panel.vertices.data(), panel.vertices.size() * sizeof(OverlayVertex)));
    return {};
}

} // namespace

int main()
{
    for (const double scale : {0.5, 1.0, 1.3, 1.5, 2.0, 3.7})
    {
        if (const Result<void> printed = Print(scale); !printed)
        {
            std::fprintf(stderr, "%s\n", printed.GetError().Text().c_str());
            return 3;
        }
    }
}
