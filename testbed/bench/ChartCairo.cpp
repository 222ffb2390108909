// SPDX-License-Identifier: MIT
// Cairo is opened when a chart is asked for, like the libraries for films: every other command
// starts without it.
#include "ChartCairo.h"

#include <memory>

#include <cairo-svg.h>
#include <cairo.h>
#include <dlfcn.h>

namespace boxreel
{
namespace
{

constexpr const char* kLibrary = "libcairo.so.2";
constexpr double kPixelsPerPoint = 2.0; // of a PNG: sharp on paper
constexpr const char* kFont = "DejaVu Sans";

#define BOXREEL_CAIRO_FUNCTIONS(X)                                                                 \
    X(cairo_arc)                                                                                   \
    X(cairo_create)                                                                                \
    X(cairo_destroy)                                                                               \
    X(cairo_fill)                                                                                  \
    X(cairo_image_surface_create)                                                                  \
    X(cairo_line_to)                                                                               \
    X(cairo_move_to)                                                                               \
    X(cairo_new_path)                                                                              \
    X(cairo_paint)                                                                                 \
    X(cairo_rectangle)                                                                             \
    X(cairo_restore)                                                                               \
    X(cairo_rotate)                                                                                \
    X(cairo_save)                                                                                  \
    X(cairo_scale)                                                                                 \
    X(cairo_select_font_face)                                                                      \
    X(cairo_set_dash)                                                                              \
    X(cairo_set_font_options)                                                                      \
    X(cairo_set_font_size)                                                                         \
    X(cairo_set_line_join)                                                                         \
    X(cairo_set_line_width)                                                                        \
    X(cairo_set_source_rgb)                                                                        \
    X(cairo_show_text)                                                                             \
    X(cairo_status)                                                                                \
    X(cairo_status_to_string)                                                                      \
    X(cairo_stroke)                                                                                \
    X(cairo_surface_destroy)                                                                       \
    X(cairo_surface_finish)                                                                        \
    X(cairo_surface_status)                                                                        \
    X(cairo_surface_write_to_png_stream)                                                           \
    X(cairo_svg_surface_create_for_stream)                                                         \
    X(cairo_text_extents)                                                                          \
    X(cairo_translate)                                                                             \
    X(cairo_font_options_create)                                                                   \
    X(cairo_font_options_destroy)                                                                  \
    X(cairo_font_options_set_antialias)                                                            \
    X(cairo_font_options_set_hint_metrics)                                                         \
    X(cairo_font_options_set_hint_style)

struct CairoLibrary
{
#define BOXREEL_DECLARE(name) decltype(&::name) name = nullptr;
    BOXREEL_CAIRO_FUNCTIONS(BOXREEL_DECLARE)
#undef BOXREEL_DECLARE
};

CairoLibrary g_cairo;

Result<void> Load()
{
    // Never closed: the fonts that it has read stay.
    void* handle = dlopen(kLibrary, RTLD_LAZY | RTLD_LOCAL);
    if (handle == nullptr)
    {
        const char* reason = dlerror();
        return Error{ErrorKind::Absent, std::string("Charts need ") + kLibrary +
                                            ", which cannot be loaded (" +
                                            (reason != nullptr ? reason : "no reason given") +
                                            "); install Debian's libcairo2."};
    }
#define BOXREEL_BIND(name)                                                                         \
    g_cairo.name = reinterpret_cast<decltype(g_cairo.name)>(dlsym(handle, #name));                 \
    if (g_cairo.name == nullptr)                                                                   \
    {                                                                                              \
        return Error{ErrorKind::Absent, std::string(kLibrary) + " lacks the function " #name       \
                                                                "; install Debian's libcairo2."};  \
    }
    BOXREEL_CAIRO_FUNCTIONS(BOXREEL_BIND)
#undef BOXREEL_BIND
    return {};
}

struct CairoDelete
{
    void operator()(cairo_t* context) const { g_cairo.cairo_destroy(context); }
    void operator()(cairo_surface_t* surface) const { g_cairo.cairo_surface_destroy(surface); }
    void operator()(cairo_font_options_t* options) const
    {
        g_cairo.cairo_font_options_destroy(options);
    }
};

using Context = std::unique_ptr<cairo_t, CairoDelete>;
using Surface = std::unique_ptr<cairo_surface_t, CairoDelete>;

class CairoCanvas final : public ChartCanvas
{
public:
    explicit CairoCanvas(cairo_t* context) : m_context(context)
    {
        // Letters keep their shape and their distances at every size, so that both formats agree.
        const std::unique_ptr<cairo_font_options_t, CairoDelete> options(
            g_cairo.cairo_font_options_create());
        g_cairo.cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
        g_cairo.cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
        g_cairo.cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
        g_cairo.cairo_set_font_options(m_context, options.get());
        g_cairo.cairo_set_line_join(m_context, CAIRO_LINE_JOIN_ROUND);
        Use(ChartColor{1.0, 1.0, 1.0});
        g_cairo.cairo_paint(m_context);
    }

    double TextWidth(const std::string& text, const TextStyle& style) override
    {
        Use(style);
        cairo_text_extents_t extents;
        g_cairo.cairo_text_extents(m_context, text.c_str(), &extents);
        return extents.x_advance;
    }

    void Text(double x, double y, const std::string& text, const TextStyle& style) override
    {
        const double width = TextWidth(text, style);
        const double back = style.place == TextPlace::LeftOf   ? width
                            : style.place == TextPlace::Around ? 0.5 * width
                                                               : 0.0;
        g_cairo.cairo_save(m_context);
        g_cairo.cairo_translate(m_context, x, y);
        if (style.upward)
        {
            g_cairo.cairo_rotate(m_context, -1.5707963267948966);
        }
        Use(style.color);
        g_cairo.cairo_move_to(m_context, -back, 0.0);
        g_cairo.cairo_show_text(m_context, text.c_str());
        g_cairo.cairo_new_path(m_context);
        g_cairo.cairo_restore(m_context);
    }

    void Lines(const std::vector<std::pair<double, double>>& points,
               const LineStyle& style) override
    {
        const bool dotted = style.stroke == ChartStroke::Dotted;
        const double dashes[] = {dotted ? 1.5 : 6.0, dotted ? 3.0 : 4.0};
        Use(style.color);
        g_cairo.cairo_set_line_width(m_context, style.width);
        g_cairo.cairo_set_dash(m_context, dashes, style.stroke == ChartStroke::Solid ? 0 : 2, 0.0);
        for (const auto& [x, y] : points)
        {
            g_cairo.cairo_line_to(m_context, x, y); // the first of a path moves there
        }
        g_cairo.cairo_stroke(m_context);
    }

    void Rectangle(double x, double y, double width, double height,
                   const ChartColor& color) override
    {
        Use(color);
        g_cairo.cairo_rectangle(m_context, x, y, width, height);
        g_cairo.cairo_fill(m_context);
    }

    void Disc(double x, double y, double radius, const ChartColor& color) override
    {
        Use(color);
        g_cairo.cairo_new_path(m_context);
        g_cairo.cairo_arc(m_context, x, y, radius, 0.0, 6.2831853071795865);
        g_cairo.cairo_fill(m_context);
    }

private:
    void Use(const ChartColor& color)
    {
        g_cairo.cairo_set_source_rgb(m_context, color.red, color.green, color.blue);
    }
    void Use(const TextStyle& style)
    {
        g_cairo.cairo_select_font_face(m_context, kFont, CAIRO_FONT_SLANT_NORMAL,
                                       style.bold ? CAIRO_FONT_WEIGHT_BOLD
                                                  : CAIRO_FONT_WEIGHT_NORMAL);
        g_cairo.cairo_set_font_size(m_context, style.size);
    }

    cairo_t* m_context;
};

cairo_status_t Collect(void* bytes, const unsigned char* data, unsigned int length)
{
    auto& all = *static_cast<std::vector<std::uint8_t>*>(bytes);
    all.insert(all.end(), data, data + length);
    return CAIRO_STATUS_SUCCESS;
}

Error CannotDraw(cairo_status_t status)
{
    return Error{ErrorKind::Failed, std::string("Drawing the chart failed: ") +
                                        g_cairo.cairo_status_to_string(status) + "."};
}

} // namespace

Result<void> PrepareCharts()
{
    static const Result<void> loaded = Load();
    return loaded;
}

Result<std::vector<std::uint8_t>> PaintFile(ChartFormat format, int width, int height,
                                            const std::function<void(ChartCanvas&)>& paint)
{
    if (const Result<void> loaded = PrepareCharts(); !loaded)
    {
        return loaded.GetError();
    }
    std::vector<std::uint8_t> bytes;
    const bool isPng = format == ChartFormat::Png;
    const Surface surface(
        isPng ? g_cairo.cairo_image_surface_create(CAIRO_FORMAT_RGB24, int(kPixelsPerPoint * width),
                                                   int(kPixelsPerPoint * height))
              : g_cairo.cairo_svg_surface_create_for_stream(Collect, &bytes, width, height));
    const Context context(g_cairo.cairo_create(surface.get()));
    if (isPng)
    {
        g_cairo.cairo_scale(context.get(), kPixelsPerPoint, kPixelsPerPoint);
    }
    CairoCanvas canvas(context.get());
    paint(canvas);
    cairo_status_t status = g_cairo.cairo_status(context.get());
    if (isPng && status == CAIRO_STATUS_SUCCESS)
    {
        status = g_cairo.cairo_surface_write_to_png_stream(surface.get(), Collect, &bytes);
    }
    g_cairo.cairo_surface_finish(surface.get());
    if (status == CAIRO_STATUS_SUCCESS)
    {
        status = g_cairo.cairo_surface_status(surface.get());
    }
    if (status != CAIRO_STATUS_SUCCESS)
    {
        return CannotDraw(status);
    }
    return bytes;
}

} // namespace boxreel
