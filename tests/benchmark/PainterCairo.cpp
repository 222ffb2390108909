// SPDX-License-Identifier: MIT
// Cairo's image surface with the same shapes, in each of its three qualities: fill and outline of a
// shape as a path, as a program with Cairo would draw it.
#include "Painter.h"

#include <debugdraw/Theme.h>

#include <cairo.h>

#include <cmath>
#include <numbers>

namespace bench
{
namespace
{

using namespace boxreel;

class CairoPainter final : public Painter
{
public:
    CairoPainter(int width, int height, cairo_antialias_t quality)
        : m_theme(Theme::Classic()),
          m_surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height)),
          m_context(cairo_create(m_surface))
    {
        cairo_set_antialias(m_context, quality);
        cairo_set_line_width(m_context, m_theme.outlineWidth);
        cairo_set_line_cap(m_context, CAIRO_LINE_CAP_ROUND);
        // Corners as pointed as they are, which is nearest to ours: those sharper than 60 degrees
        // are cut at one width there, which Cairo cannot do.
        cairo_set_line_join(m_context, CAIRO_LINE_JOIN_MITER);
        cairo_set_miter_limit(m_context, 10.0);
    }
    ~CairoPainter() override
    {
        cairo_destroy(m_context);
        cairo_surface_destroy(m_surface);
    }
    CairoPainter(const CairoPainter&) = delete;
    CairoPainter& operator=(const CairoPainter&) = delete;

    Result<void> Submit(const DrawList& list, const Camera& camera) override
    {
        Use(m_theme.background, 1.0, 1.0);
        cairo_paint(m_context);
        for (const DrawItem& item : list.items)
        {
            Draw(list, item, camera);
        }
        return {};
    }
    Result<void> Read() override
    {
        cairo_surface_flush(m_surface);
        if (const cairo_status_t status = cairo_status(m_context); status != CAIRO_STATUS_SUCCESS)
        {
            return Error{ErrorKind::Failed,
                         std::string("Cairo failed: ") + cairo_status_to_string(status) + "."};
        }
        return {};
    }
    Frame Picture() const override
    {
        Frame frame(cairo_image_surface_get_width(m_surface),
                    cairo_image_surface_get_height(m_surface));
        for (int y = 0; y < frame.height; ++y)
        {
            const unsigned char* const row =
                cairo_image_surface_get_data(m_surface) +
                std::ptrdiff_t(y) * cairo_image_surface_get_stride(m_surface);
            for (int x = 0; x < frame.width; ++x)
            {
                // A word of the machine's own order, alpha in its upper byte.
                const std::uint32_t word = reinterpret_cast<const std::uint32_t*>(row)[x];
                std::uint8_t* const pixel = frame.Pixel(x, y);
                pixel[0] = std::uint8_t(word >> 16);
                pixel[1] = std::uint8_t(word >> 8);
                pixel[2] = std::uint8_t(word);
                pixel[3] = std::uint8_t(word >> 24);
            }
        }
        return frame;
    }
    std::string Description() const override { return "Cairo's image surface"; }

private:
    void Use(Color color, double shade, double alpha)
    {
        cairo_set_source_rgba(m_context, color.r * shade / 255.0, color.g * shade / 255.0,
                              color.b * shade / 255.0, color.a * alpha / 255.0);
    }
    void Fill(const DrawItem& item)
    {
        Use(m_theme.Fill(item.Asked()), m_theme.fillShade, m_theme.fillAlpha);
        cairo_fill_preserve(m_context);
    }
    void Stroke(const DrawItem& item)
    {
        Use(m_theme.Outline(item.Asked()), 1.0, 1.0);
        cairo_stroke(m_context);
    }
    void Draw(const DrawList& list, const DrawItem& item, const Camera& camera)
    {
        // Not Camera::ToPixel, which rounds to float: the truth does not either.
        const auto place = [&](std::size_t i) {
            const Vec2 world = list.points[item.first + i];
            return std::pair{
                0.5 * camera.width + (world.x - camera.centerX) * camera.pixelsPerMeter,
                0.5 * camera.height - (world.y - camera.centerY) * camera.pixelsPerMeter};
        };
        const auto [x, y] = place(0);
        if (item.kind == DrawKind::SolidCircle)
        {
            const double radius = item.size * camera.pixelsPerMeter;
            const Vec2 axis = list.points[item.first + 1];
            cairo_new_path(m_context);
            cairo_arc(m_context, x, y, radius, 0.0, 2.0 * std::numbers::pi);
            cairo_close_path(m_context);
            Fill(item);
            cairo_move_to(m_context, x, y);
            cairo_line_to(m_context, x + radius * axis.x, y - radius * axis.y);
            Stroke(item);
            return;
        }
        cairo_move_to(m_context, x, y);
        for (std::size_t i = 1; i < item.count; ++i)
        {
            const auto [nextX, nextY] = place(i);
            cairo_line_to(m_context, nextX, nextY);
        }
        if (item.kind == DrawKind::SolidPolygon)
        {
            cairo_close_path(m_context);
            Fill(item);
        }
        Stroke(item);
    }

    Theme m_theme;
    cairo_surface_t* m_surface;
    cairo_t* m_context;
};

Method MethodOf(const char* name, cairo_antialias_t quality)
{
    return {std::string("Cairo ") + cairo_version_string() + name,
            [quality](int width, int height) {
                return Result<std::unique_ptr<Painter>>(
                    std::make_unique<CairoPainter>(width, height, quality));
            },
            {},
            false,
            quality == CAIRO_ANTIALIAS_DEFAULT};
}

} // namespace

const std::vector<Method>& Methods()
{
    static const std::vector<Method> methods{MethodOf(", fast", CAIRO_ANTIALIAS_FAST),
                                             MethodOf("", CAIRO_ANTIALIAS_DEFAULT),
                                             MethodOf(", best", CAIRO_ANTIALIAS_BEST)};
    return methods;
}

} // namespace bench
