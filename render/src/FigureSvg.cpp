// SPDX-License-Identifier: MIT
// Cairo's SVG converts text to outlines and has no groups, so this writes SVG directly: text that
// can be read, edited and compared.
#include "FigureCanvas.h"
#include "FigureLetters.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <base/Quoting.h>
#include <base/Words.h>
#include <debugdraw/DrawListText.h>
#include <debugdraw/TextWidth.h>

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace boxreel
{
namespace
{

/// Formats with at most three decimals, no trailing zeros, no negative zero, independent of the
/// locale.
std::string Number(double value)
{
    std::array<char, 64> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                   std::chars_format::fixed, 3)
                         .ptr;
    std::string text(digits.data(), end);
    text.erase(text.find_last_not_of('0') + 1);
    text.erase(text.find_last_not_of('.') + 1);
    return text == "-0" ? std::string(1, '0') : text;
}

std::string Hex(Color color)
{
    return "#" + HexByte(color.r) + HexByte(color.g) + HexByte(color.b);
}

std::string Attribute(std::string_view name, std::string_view value)
{
    return std::string(" ").append(name).append("=\"").append(value).append("\"");
}

std::string Attribute(std::string_view name, double value)
{
    return Attribute(name, Number(value));
}

class SvgCanvas final : public FigureCanvas
{
public:
    explicit SvgCanvas(const Figure& figure) : m_figure(figure)
    {
        m_text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
        m_text +=
            "<svg" + Attribute("xmlns", "http://www.w3.org/2000/svg") +
            Attribute("width", figure.width * figure.scale) +
            Attribute("height", figure.height * figure.scale) +
            Attribute("viewBox", "0 0 " + Number(figure.width) + " " + Number(figure.height)) +
            Attribute("fill", "none") + Attribute("stroke-width", figure.theme.outlineWidth) +
            Attribute("stroke-linecap", "round") + Attribute("stroke-linejoin", "miter") +
            Attribute("stroke-miterlimit", kFigureMitreLimit) +
            Attribute("font-family", "DejaVu Sans, Verdana, sans-serif") +
            Attribute("font-size", kFigureFontSize) + Attribute("xml:space", "preserve") + ">\n";
        if (!figure.title.empty())
        {
            Line("<title>" + MarkupEscaped(Readable(figure.title)) + "</title>");
        }
        const Color ground = figure.theme.background;
        Line("<rect" + Attribute("class", "ground") + Attribute("width", figure.width) +
             Attribute("height", figure.height) + Ink("fill", FigureInk{ground, ground.a / 255.0}) +
             "/>");
    }

    std::string Finished() { return std::move(m_text.append("</svg>\n")); }

    void BeginPanel(const FigurePanel& panel) override
    {
        const bool fills = panel.x == 0.0 && panel.y == 0.0 &&
                           panel.camera.width == m_figure.width &&
                           panel.camera.height == m_figure.height;
        m_nested.push_back(!fills);
        if (!fills) // clips what lies outside
        {
            Line("<svg" + Attribute("x", panel.x) + Attribute("y", panel.y) +
                 Attribute("width", panel.camera.width) + Attribute("height", panel.camera.height) +
                 ">");
            ++m_depth;
        }
    }

    void EndPanel() override
    {
        if (m_nested.back())
        {
            --m_depth;
            Line("</svg>");
        }
        m_nested.pop_back();
    }

    void BeginGroup(const FigureGroup& group) override
    {
        Line("<g" + Attribute("id", group.id) + Attribute("class", group.layer) + ">");
        ++m_depth;
        m_inLabels = std::string_view(group.layer) == InfoOf(DrawLayer::Labels).name;
        if (!group.title.empty())
        {
            Line("<title>" + MarkupEscaped(group.title) + "</title>");
        }
    }

    void EndGroup() override
    {
        --m_depth;
        Line("</g>");
    }

    void Polygon(std::span<const Point> corners, bool sharp, const FigurePaint& paint) override
    {
        const std::string points =
            JoinedBy(" ", corners, [](const Point& p) { return Number(p.x) + "," + Number(p.y); });
        Line("<polygon" + Attribute("points", points) + Inks(paint) +
             (sharp ? "" : Attribute("stroke-linejoin", "round")) + "/>");
    }

    void Circle(Point center, double radius, const FigurePaint& paint) override
    {
        Line("<circle" + Attribute("cx", center.x) + Attribute("cy", center.y) +
             Attribute("r", radius) + Inks(paint) + "/>");
    }

    void Line(Point from, Point to, const FigureInk& ink) override
    {
        Line("<line" + Attribute("x1", from.x) + Attribute("y1", from.y) + Attribute("x2", to.x) +
             Attribute("y2", to.y) + Ink("stroke", ink) + "/>");
    }

    void Text(Point at, const std::string& line, const FigureInk& ink) override
    {
        // Centre labels with missing characters, so that they keep their position with the viewer's
        // font.
        const bool centered = m_inLabels && !HasLettersOf(line);
        Line("<text" + Attribute("x", at.x + (centered ? 0.5 * TextWidth(line) : 0.0)) +
             Attribute("y", at.y) + (centered ? Attribute("text-anchor", "middle") : "") +
             Ink("fill", ink) + ">" + MarkupEscaped(line) + "</text>");
    }

private:
    void Line(const std::string& element)
    {
        m_text.append(2 * m_depth, ' ').append(element).append("\n");
    }

    static std::string Ink(const std::string& use, const FigureInk& ink)
    {
        return Attribute(use, Hex(ink.color)) +
               (ink.opacity < 1.0 ? Attribute(use + "-opacity", ink.opacity) : "");
    }

    static std::string Inks(const FigurePaint& paint)
    {
        return (paint.fill ? Ink("fill", *paint.fill) : "") +
               (paint.stroke ? Ink("stroke", *paint.stroke) : "");
    }

    const Figure& m_figure;
    std::string m_text;
    std::size_t m_depth = 1;
    bool m_inLabels = false;
    std::vector<bool> m_nested;
};

} // namespace

Result<std::string> ToSvg(const Figure& figure)
{
    RETURN_IF_ERROR(CheckFigure(figure));
    SvgCanvas canvas(figure);
    PaintFigure(figure, canvas);
    return canvas.Finished();
}

Result<void> WriteSvg(const std::filesystem::path& path, const Figure& figure,
                      const FigureFileSettings& settings)
{
    const Result<std::string> text = ToSvg(figure);
    return text ? WriteWhole(path, std::string_view(*text), settings.overwrite)
                : Result<void>(text.GetError());
}

} // namespace boxreel
