// SPDX-License-Identifier: MIT
// PDF through Cairo, with the renderer's font loaded from its file, so that the bytes do not depend
// on installed fonts. Both libraries are loaded on first use.
#include "FigureCairo.h"
#include "FigureCanvas.h"
#include "FigureLetters.h"
#include "FontAtlas.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <base/SharedLibrary.h>

#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>

#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <cairo.h>

namespace boxreel
{
namespace
{

constexpr double kPointsPerPixel = 0.75; // 1/96 inch each, as in SVG

// A constant date, so that the same figure gives the same file.
constexpr const char* kDate = "2000-01-01T00:00:00Z";

#define BOXREEL_CAIRO_FUNCTIONS(X)                                                                 \
    X(cairo_arc)                                                                                   \
    X(cairo_clip)                                                                                  \
    X(cairo_close_path)                                                                            \
    X(cairo_create)                                                                                \
    X(cairo_destroy)                                                                               \
    X(cairo_fill)                                                                                  \
    X(cairo_fill_preserve)                                                                         \
    X(cairo_font_options_create)                                                                   \
    X(cairo_font_options_destroy)                                                                  \
    X(cairo_font_options_set_antialias)                                                            \
    X(cairo_font_options_set_hint_metrics)                                                         \
    X(cairo_font_options_set_hint_style)                                                           \
    X(cairo_ft_font_face_create_for_ft_face)                                                       \
    X(cairo_image_surface_create)                                                                  \
    X(cairo_image_surface_get_data)                                                                \
    X(cairo_image_surface_get_stride)                                                              \
    X(cairo_line_to)                                                                               \
    X(cairo_move_to)                                                                               \
    X(cairo_new_path)                                                                              \
    X(cairo_paint)                                                                                 \
    X(cairo_pdf_surface_create_for_stream)                                                         \
    X(cairo_pdf_surface_set_metadata)                                                              \
    X(cairo_rectangle)                                                                             \
    X(cairo_restore)                                                                               \
    X(cairo_save)                                                                                  \
    X(cairo_scale)                                                                                 \
    X(cairo_set_font_face)                                                                         \
    X(cairo_set_font_options)                                                                      \
    X(cairo_set_font_size)                                                                         \
    X(cairo_set_line_cap)                                                                          \
    X(cairo_set_line_join)                                                                         \
    X(cairo_set_line_width)                                                                        \
    X(cairo_set_miter_limit)                                                                       \
    X(cairo_set_source_rgba)                                                                       \
    X(cairo_set_tolerance)                                                                         \
    X(cairo_show_text)                                                                             \
    X(cairo_status)                                                                                \
    X(cairo_status_to_string)                                                                      \
    X(cairo_stroke)                                                                                \
    X(cairo_surface_destroy)                                                                       \
    X(cairo_surface_finish)                                                                        \
    X(cairo_surface_flush)                                                                         \
    X(cairo_surface_status)                                                                        \
    X(cairo_tag_begin)                                                                             \
    X(cairo_tag_end)                                                                               \
    X(cairo_translate)

#define BOXREEL_FREETYPE_FUNCTIONS(X)                                                              \
    X(FT_Get_Char_Index)                                                                           \
    X(FT_Init_FreeType)                                                                            \
    X(FT_New_Face)

struct Libraries
{
#define BOXREEL_DECLARE(name) decltype(&::name) name = nullptr;
    BOXREEL_CAIRO_FUNCTIONS(BOXREEL_DECLARE)
    BOXREEL_FREETYPE_FUNCTIONS(BOXREEL_DECLARE)
#undef BOXREEL_DECLARE
};

Libraries g_cairo;

Result<void> LoadLibraries()
{
    ASSIGN_OR_RETURN(const SharedLibrary cairo, SharedLibrary::Open("libcairo.so.2", "libcairo2"));
    ASSIGN_OR_RETURN(const SharedLibrary freetype,
                     SharedLibrary::Open("libfreetype.so.6", "libfreetype6"));
#define BOXREEL_BIND(library, name)                                                                \
    if (!library.Bind(#name, g_cairo.name))                                                        \
    {                                                                                              \
        return library.MissingError("the function " #name);                                        \
    }
#define BOXREEL_BIND_CAIRO(name) BOXREEL_BIND(cairo, name)
#define BOXREEL_BIND_FREETYPE(name) BOXREEL_BIND(freetype, name)
    BOXREEL_CAIRO_FUNCTIONS(BOXREEL_BIND_CAIRO)
    BOXREEL_FREETYPE_FUNCTIONS(BOXREEL_BIND_FREETYPE)
#undef BOXREEL_BIND_FREETYPE
#undef BOXREEL_BIND_CAIRO
#undef BOXREEL_BIND
    return {};
}

Result<void> Prepare()
{
    static const Result<void> loaded = LoadLibraries();
    return loaded;
}

struct Font
{
    FT_Face letters;
    cairo_font_face_t* face;
};

/// The renderer's font. Never freed, because Cairo keeps scaled copies that refer to it.
Result<Font> LoadFont()
{
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    if (g_cairo.FT_Init_FreeType(&library) != 0 ||
        g_cairo.FT_New_Face(library, kFontFile, 0, &face) != 0)
    {
        return Error{ErrorKind::Absent, kFontFile, "cannot be loaded",
                     "install it with: apt install fonts-dejavu-core"};
    }
    return Font{face, g_cairo.cairo_ft_font_face_create_for_ft_face(face, 0)};
}

Result<Font> NeedFont()
{
    static const Result<Font> font = LoadFont();
    return font;
}

/// True for characters of right-to-left scripts such as Arabic. Unicode 15, blocks Hebrew to Arabic
/// Extended-A, and their presentation forms.
bool IsFromTheRight(char32_t code)
{
    return (code >= 0x590 && code <= 0x8FF) || (code >= 0xFB1D && code <= 0xFDFF) ||
           (code >= 0xFE70 && code <= 0xFEFC);
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

bool HasText(const Figure& figure)
{
    for (const FigurePanel& panel : figure.panels)
    {
        if (!panel.list.texts.empty())
        {
            return true;
        }
    }
    return false;
}

class CairoCanvas final : public FigureCanvas
{
public:
    /// `unit`: surface units per pixel of the figure. `font`: null without text.
    CairoCanvas(cairo_t* context, const Figure& figure, double unit, cairo_font_face_t* font)
        : m_context(context)
    {
        g_cairo.cairo_scale(m_context, unit, unit);
        g_cairo.cairo_set_tolerance(m_context, 0.02); // [px], for curves
        g_cairo.cairo_set_line_width(m_context, double(figure.theme.outlineWidth));
        g_cairo.cairo_set_line_cap(m_context, CAIRO_LINE_CAP_ROUND);
        g_cairo.cairo_set_miter_limit(m_context, kFigureMitreLimit);
        if (font != nullptr)
        {
            SetFont(font);
        }
        const Color ground = figure.theme.background;
        Use({ground, ground.a / 255.0});
        g_cairo.cairo_paint(m_context);
    }

    void BeginPanel(const FigurePanel& panel) override
    {
        g_cairo.cairo_save(m_context);
        g_cairo.cairo_translate(m_context, panel.x, panel.y);
        g_cairo.cairo_rectangle(m_context, 0.0, 0.0, panel.camera.width, panel.camera.height);
        g_cairo.cairo_clip(m_context);
    }

    void EndPanel() override { g_cairo.cairo_restore(m_context); }

    void BeginGroup(const FigureGroup& group) override
    {
        g_cairo.cairo_tag_begin(m_context, "Sect", "");
        g_cairo.cairo_tag_begin(m_context, CAIRO_TAG_DEST, ("name='" + group.id + "'").c_str());
    }

    void EndGroup() override
    {
        g_cairo.cairo_tag_end(m_context, CAIRO_TAG_DEST);
        g_cairo.cairo_tag_end(m_context, "Sect");
    }

    void Polygon(std::span<const Point> corners, bool sharp, const FigurePaint& paint) override
    {
        for (const Point p : corners) // the first line of a path acts as a move
        {
            g_cairo.cairo_line_to(m_context, p.x, p.y);
        }
        g_cairo.cairo_close_path(m_context);
        g_cairo.cairo_set_line_join(m_context,
                                    sharp ? CAIRO_LINE_JOIN_MITER : CAIRO_LINE_JOIN_ROUND);
        Draw(paint);
    }

    void Circle(Point center, double radius, const FigurePaint& paint) override
    {
        g_cairo.cairo_arc(m_context, center.x, center.y, radius, 0.0, 2.0 * std::numbers::pi);
        g_cairo.cairo_close_path(m_context);
        Draw(paint);
    }

    void Line(Point from, Point to, const FigureInk& ink) override
    {
        g_cairo.cairo_move_to(m_context, from.x, from.y);
        g_cairo.cairo_line_to(m_context, to.x, to.y);
        Draw({{}, ink});
    }

    void Text(Point at, const std::string& line, const FigureInk& ink) override
    {
        Use(ink);
        g_cairo.cairo_move_to(m_context, at.x, at.y);
        g_cairo.cairo_show_text(m_context, line.c_str());
        g_cairo.cairo_new_path(m_context);
    }

private:
    void SetFont(cairo_font_face_t* font)
    {
        // No hinting: glyph shapes and advances are the same at every size.
        const std::unique_ptr<cairo_font_options_t, CairoDelete> options(
            g_cairo.cairo_font_options_create());
        g_cairo.cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
        g_cairo.cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
        g_cairo.cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
        g_cairo.cairo_set_font_options(m_context, options.get());
        g_cairo.cairo_set_font_face(m_context, font);
        g_cairo.cairo_set_font_size(m_context, kFigureFontSize);
    }

    void Use(const FigureInk& ink)
    {
        g_cairo.cairo_set_source_rgba(m_context, ink.color.r / 255.0, ink.color.g / 255.0,
                                      ink.color.b / 255.0, ink.opacity);
    }

    /// Fills or strokes the current path and clears it.
    void Draw(const FigurePaint& paint)
    {
        if (paint.fill)
        {
            Use(*paint.fill);
            g_cairo.cairo_fill_preserve(m_context);
        }
        if (paint.stroke)
        {
            Use(*paint.stroke);
            g_cairo.cairo_stroke(m_context);
        }
        g_cairo.cairo_new_path(m_context);
    }

    cairo_t* m_context;
};

cairo_status_t Collect(void* bytes, const unsigned char* data, unsigned int length)
{
    auto& all = *static_cast<std::vector<std::uint8_t>*>(bytes);
    all.insert(all.end(), data, data + length);
    return CAIRO_STATUS_SUCCESS;
}

/// Paints on an existing surface of `unit` units per pixel, and finishes the drawing.
Result<void> PaintOn(cairo_surface_t* surface, const Figure& figure, double unit)
{
    cairo_font_face_t* font = nullptr;
    if (HasText(figure))
    {
        ASSIGN_OR_RETURN(const Font loaded, NeedFont());
        font = loaded.face;
    }
    const Context context(g_cairo.cairo_create(surface));
    CairoCanvas canvas(context.get(), figure, unit, font);
    g_cairo.cairo_tag_begin(context.get(), "Document", ""); // the required root of a PDF's
                                                            // structure
    PaintFigure(figure, canvas);
    g_cairo.cairo_tag_end(context.get(), "Document");
    const cairo_status_t status = g_cairo.cairo_status(context.get());
    if (status != CAIRO_STATUS_SUCCESS)
    {
        return Error{ErrorKind::Failed, "figure",
                     std::string("cannot be drawn: ") + g_cairo.cairo_status_to_string(status)};
    }
    return {};
}

/// Checks sizes and libraries.
Result<void> CheckAll(const Figure& figure)
{
    const Result<void> usable = CheckFigure(figure);
    return usable ? Prepare() : usable;
}

// One font face for all threads: its tables are read while a page is drawn and finished.
std::mutex g_access;

} // namespace

Result<std::vector<std::uint8_t>> ToPdf(const Figure& figure)
{
    RETURN_IF_ERROR(CheckAll(figure));
    const std::lock_guard lock(g_access);
    const double unit = kPointsPerPixel * figure.scale;
    std::vector<std::uint8_t> bytes;
    const Surface surface(g_cairo.cairo_pdf_surface_create_for_stream(
        Collect, &bytes, unit * figure.width, unit * figure.height));
    const auto describe = [&](cairo_pdf_metadata_t what, const std::string& text) {
        g_cairo.cairo_pdf_surface_set_metadata(surface.get(), what, text.c_str());
    };
    describe(CAIRO_PDF_METADATA_CREATE_DATE, kDate);
    describe(CAIRO_PDF_METADATA_CREATOR, "boxreel");
    if (!figure.title.empty())
    {
        describe(CAIRO_PDF_METADATA_TITLE, Readable(figure.title));
    }
    RETURN_IF_ERROR(PaintOn(surface.get(), figure, unit));
    g_cairo.cairo_surface_finish(surface.get());
    const cairo_status_t status = g_cairo.cairo_surface_status(surface.get());
    if (status != CAIRO_STATUS_SUCCESS)
    {
        return Error{ErrorKind::Failed, "PDF",
                     std::string("cannot be written: ") + g_cairo.cairo_status_to_string(status)};
    }
    return bytes;
}

Result<void> PreparePdf()
{
    RETURN_IF_ERROR(Prepare());
    const std::lock_guard lock(g_access);
    const Result<Font> font = NeedFont();
    return font ? Result<void>() : Result<void>(font.GetError());
}

Result<std::vector<std::string>> LettersWithoutPdf(const Figure& figure)
{
    RETURN_IF_ERROR(PreparePdf());
    const std::lock_guard lock(g_access);
    const Result<Font> font = NeedFont();
    return LettersWithout(figure, [&font](char32_t code) {
        return !IsFromTheRight(code) && g_cairo.FT_Get_Char_Index(font->letters, code) != 0;
    });
}

Result<Frame> RasterizeFigure(const Figure& figure)
{
    RETURN_IF_ERROR(CheckAll(figure));
    const std::lock_guard lock(g_access);
    Frame frame(int(std::lround(figure.width * figure.scale)),
                int(std::lround(figure.height * figure.scale)));
    const Surface surface(
        g_cairo.cairo_image_surface_create(CAIRO_FORMAT_ARGB32, frame.width, frame.height));
    RETURN_IF_ERROR(PaintOn(surface.get(), figure, figure.scale));
    g_cairo.cairo_surface_flush(surface.get());
    const int stride = g_cairo.cairo_image_surface_get_stride(surface.get());
    const unsigned char* const data = g_cairo.cairo_image_surface_get_data(surface.get());
    for (int y = 0; y < frame.height; ++y)
    {
        const auto* const row =
            reinterpret_cast<const std::uint32_t*>(data + std::ptrdiff_t(y) * stride);
        for (int x = 0; x < frame.width; ++x)
        {
            std::uint8_t* const pixel = frame.Pixel(x, y);
            for (int channel = 0; channel < 4; ++channel) // bytes of 0xAARRGGBB
            {
                const int shift = channel == 3 ? 24 : 16 - 8 * channel;
                pixel[channel] = static_cast<std::uint8_t>(row[x] >> shift & 0xffu);
            }
        }
    }
    return frame;
}

Result<void> WritePdf(const std::filesystem::path& path, const Figure& figure,
                      const FigureFileSettings& settings)
{
    const Result<std::vector<std::uint8_t>> bytes = ToPdf(figure);
    return bytes ? WriteWhole(path, *bytes, settings.overwrite) : Result<void>(bytes.GetError());
}

} // namespace boxreel
