// SPDX-License-Identifier: MIT
#include <debugdraw/Paper.h>

#include <debugdraw/Arrow.h>
#include <debugdraw/TextWidth.h>

namespace boxreel
{

Paper::Paper(DrawList& list, const Camera& camera) : m_list(list), m_camera(camera) {}

PixelPoint Paper::ToPixel(Vec2 world) const
{
    return {0.5 * m_camera.width + (world.x - m_camera.centerX) * m_camera.pixelsPerMeter,
            0.5 * m_camera.height - (world.y - m_camera.centerY) * m_camera.pixelsPerMeter};
}

Vec2 Paper::ToWorld(PixelPoint pixel) const
{
    return {static_cast<float>(m_camera.centerX +
                               (pixel.x - 0.5 * m_camera.width) / m_camera.pixelsPerMeter),
            static_cast<float>(m_camera.centerY -
                               (pixel.y - 0.5 * m_camera.height) / m_camera.pixelsPerMeter)};
}

template <class Add>
void Paper::Stamped(Add add) const
{
    const DrawLayer layer = m_list.layer;
    const std::uint32_t owner = m_list.owner;
    m_list.layer = DrawLayer::Annotations;
    m_list.owner = kNoOwner;
    add();
    m_list.layer = layer;
    m_list.owner = owner;
}

void Paper::Line(PixelPoint from, PixelPoint to, const Paint& paint) const
{
    Stamped([&] { m_list.AddSegment(ToWorld(from), ToWorld(to), paint); });
}

void Paper::Circle(PixelPoint center, double radius, const Paint& paint) const
{
    Stamped([&] {
        m_list.AddCircle(ToWorld(center), static_cast<float>(radius / m_camera.pixelsPerMeter),
                         paint);
    });
}

void Paper::Arrow(PixelPoint from, PixelPoint to, const Paint& paint) const
{
    Stamped([&] { AddArrow(m_list, m_camera, ToWorld(from), ToWorld(to), paint); });
}

void Paper::Text(PixelPoint at, std::string_view line, TextAnchor anchor, const Paint& paint) const
{
    if (line.empty())
    {
        return;
    }
    const PixelPoint corner{at.x - anchor.x * TextWidth(line), at.y - anchor.y * kTextHeight};
    Stamped([&] { m_list.AddText(ToWorld(corner), line, paint); });
}

Camera PaperCamera(int width, int height)
{
    Camera camera;
    camera.width = width;
    camera.height = height;
    camera.centerX = 0.5 * width;
    camera.centerY = -0.5 * height;
    camera.pixelsPerMeter = 1.0;
    return camera;
}

} // namespace boxreel
