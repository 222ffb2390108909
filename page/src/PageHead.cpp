// SPDX-License-Identifier: MIT
#include "PageHead.h"

#include "PlayerTexts.h"

#include <base/ErrorMacros.h>
#include <base/Gzip.h>
#include <base/Quoting.h>
#include <base/Words.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace boxreel
{
namespace
{

constexpr std::string_view kFramesMark = "{{frames}}";

/// A JSON string that may stand in a script of HTML.
std::string StringText(std::string_view text)
{
    std::string json = "\"";
    for (const char c : text)
    {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || c == '"' || c == '\\')
        {
            json += "\\u00" + HexByte(byte);
        }
        else
        {
            json += c;
        }
    }
    return JsonForScript(json + "\"");
}

template <class Range, class Function>
std::string ListText(const Range& range, Function&& text)
{
    std::string json = "[";
    for (const auto& element : range)
    {
        json += (json.size() > 1 ? "," : "") + text(element);
    }
    return json + "]";
}

/// A colour of CSS, as a JSON string.
std::string ColorText(Color color, double opacity)
{
    const auto channels =
        std::to_string(color.r) + "," + std::to_string(color.g) + "," + std::to_string(color.b);
    return opacity == 1.0 ? "\"rgb(" + channels + ")\""
                          : "\"rgba(" + channels + "," + NumberText(opacity) + ")\"";
}

std::string StrokeText(const PageStyle& style, const Theme& theme)
{
    return ColorText(theme.Outline(style.paint), style.paint.color.a / 255.0);
}

/// As renderers fill solid shapes.
std::string FillText(const PageStyle& style, const Theme& theme)
{
    if (style.layer == DrawLayer::Annotations)
    {
        return StrokeText(style, theme);
    }
    const Color fill = theme.Fill(style.paint);
    const auto shaded = [&theme](std::uint8_t channel) {
        return static_cast<std::uint8_t>(std::floor(theme.fillShade * channel + 0.5f));
    };
    return ColorText({shaded(fill.r), shaded(fill.g), shaded(fill.b)},
                     double(theme.fillAlpha) * style.paint.color.a / 255.0);
}

bool IsDark(const Theme& theme)
{
    const Color& c = theme.background;
    return c.r + c.g + c.b < 3 * 128;
}

std::string ThemeText(const Theme& theme, const std::vector<PageStyle>& styles)
{
    return std::string("{\"dark\":") + (IsDark(theme) ? "true" : "false") +
           ",\"background\":" + ColorText(theme.background, 1.0) +
           ",\"text\":" + ColorText(theme.text, 1.0) + ",\"xAxis\":" + ColorText(theme.xAxis, 1.0) +
           ",\"yAxis\":" + ColorText(theme.yAxis, 1.0) +
           ",\"nameLine\":" + ColorText(theme.Outline(kNameLine), kNameLine.color.a / 255.0) +
           ",\"lineWidth\":" + NumberText(double(theme.outlineWidth)) + ",\"strokes\":" +
           ListText(styles, [&](const PageStyle& style) { return StrokeText(style, theme); }) +
           ",\"fills\":" +
           ListText(styles, [&](const PageStyle& style) { return FillText(style, theme); }) + "}";
}

/// Those that the page has, in the order of their table.
std::string LayersText(const PageSettings& settings, const std::vector<PageStyle>& styles)
{
    std::string json = "[";
    for (const LayerInfo& info : kDrawLayers)
    {
        const bool isThere = std::any_of(styles.begin(), styles.end(), [&](const PageStyle& style) {
            return style.layer == info.layer;
        });
        // What other options or the scene switch on is always on.
        const bool isOn = info.option == nullptr || settings.shown[info.layer];
        const char* const label = info.label != nullptr ? info.label : info.name;
        json += (json.size() > 1 ? ",{\"number\":" : "{\"number\":") +
                std::to_string(int(info.layer)) + ",\"label\":" + StringText(label) +
                ",\"isThere\":" + (isThere ? "true" : "false") +
                ",\"isOn\":" + (isOn ? "true" : "false") + "}";
    }
    return json + "]";
}

std::string NamesText(const std::map<std::uint32_t, std::string>& names)
{
    std::string json = "{";
    for (const auto& [number, name] : names)
    {
        json +=
            (json.size() > 1 ? ",\"" : "\"") + std::to_string(number) + "\":" + StringText(name);
    }
    return json + "}";
}

/// Returns the script without indentation and without lines that are comments: a fifth of it.
std::string WithoutComments(std::string_view script)
{
    std::string lean;
    while (!script.empty())
    {
        const std::size_t end = std::min(script.find('\n'), script.size() - 1) + 1;
        const std::string_view line = script.substr(0, end);
        const std::size_t first = std::min(line.find_first_not_of(" \n"), line.size());
        const std::string_view code = line.substr(first);
        lean += code.starts_with("//") ? std::string_view() : code;
        script.remove_prefix(end);
    }
    return lean;
}

} // namespace

std::string NumberText(double number)
{
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

std::string PageBegin(const PageSettings& settings)
{
    return FilledTemplate(kPlayerHtml.substr(0, kPlayerHtml.find(kFramesMark)),
                          {{"title", MarkupEscaped(settings.title)}, {"style", kPlayerCss}});
}

Result<std::string> PageGroup(const std::string& bytes, std::int64_t frames)
{
    ASSIGN_OR_RETURN(const std::string packed, Gzip("page", bytes));
    return "<script type=\"application/octet-stream\" class=\"frames\" data-frames=\"" +
           std::to_string(frames) + "\">" + Base64(packed) + "</script>\n";
}

Result<std::string> PageEnd(const PageSettings& settings, const PageEncoder& encoder,
                            const PageFacts& facts)
{
    const std::vector<PageStyle>& styles = encoder.Styles().All();
    ASSIGN_OR_RETURN(const std::string forms, Gzip("page", encoder.Forms().Bytes()));
    const Theme other = IsDark(settings.theme) ? Theme::Print() : Theme::Dark();
    std::string json = "{\"format\":1,\"width\":" + std::to_string(settings.width) +
                       ",\"height\":" + std::to_string(settings.height) +
                       ",\"frames\":" + std::to_string(facts.frames) +
                       ",\"framesPerSecond\":" + NumberText(settings.framesPerSecond) +
                       ",\"speed\":" + NumberText(settings.speed) +
                       ",\"firstTime\":" + NumberText(settings.firstTime) +
                       ",\"quantum\":" + NumberText(encoder.Quantum()) +
                       ",\"fullScale\":" + NumberText(encoder.FullScale());
    json += ",\n\"layers\":" + LayersText(settings, styles);
    json += ",\n\"styles\":" + ListText(styles, [](const PageStyle& style) {
                return std::to_string(int(style.layer));
            });
    json += ",\n\"themes\":[" + ThemeText(settings.theme, styles) + "," + ThemeText(other, styles) +
            "]";
    json += ",\n\"names\":" + NamesText(facts.names);
    json += ",\n\"texts\":" + ListText(encoder.Forms().Texts(), StringText);
    json += ",\n\"forms\":\"" + Base64(forms) + "\"}";
    const std::string script = std::string(kDecodeJs)
                                   .append(kLabelsJs)
                                   .append(kDrawJs)
                                   .append(kExactJs)
                                   .append(kViewJs)
                                   .append(kPlayerJs);
    ASSIGN_OR_RETURN(const std::string player, Gzip("page", WithoutComments(script)));
    return FilledTemplate(
        kPlayerHtml.substr(kPlayerHtml.find(kFramesMark) + kFramesMark.size()),
        {{"head", json}, {"player", Base64(player)}, {"load", WithoutComments(kLoadJs)}});
}

} // namespace boxreel
