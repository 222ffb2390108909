// SPDX-License-Identifier: MIT
#include "WorldObject.h"

#include <cmath>
#include <optional>

namespace boxreel::python
{
namespace
{

/// The conversion of points to pixels by b2DrawExtended.
struct Screen
{
    float32 zoom;
    b2Vec2 offset; ///< [px]
    b2Vec2 size;   ///< [px]
    bool flipX;
    bool flipY;

    explicit Screen(const py::object& renderer)
        : zoom(From<float32>(renderer.attr("zoom"), "zoom")),
          offset(From<b2Vec2>(renderer.attr("offset"), "offset")),
          size(From<b2Vec2>(renderer.attr("screenSize"), "screenSize")),
          flipX(From<bool>(renderer.attr("flipX"), "flipX")),
          flipY(From<bool>(renderer.attr("flipY"), "flipY"))
    {}

    py::object Convert(const b2Vec2& point) const
    {
        const b2Vec2 pixel = zoom * point - offset;
        return py::make_tuple(static_cast<long>(flipX ? size.x - pixel.x : pixel.x),
                              static_cast<long>(flipY ? size.y - pixel.y : pixel.y));
    }
};

/// Passes each call to an object of Python.
class PythonDraw final : public b2Draw
{
public:
    PythonDraw(WorldObject& world, const py::object& renderer)
        : m_world(world), m_renderer(renderer)
    {
        SetFlags(From<uint32>(renderer.attr("_bits"), "flags"));
        if (From<bool>(renderer.attr("_converts"), "flags"))
        {
            m_screen.emplace(renderer);
        }
    }

    void DrawPolygon(const b2Vec2* vertices, int32 count, const b2Color& color) override
    {
        m_world.Call(
            [&] { m_renderer.attr("DrawPolygon")(Points(vertices, count), b2Color(color)); });
    }
    void DrawSolidPolygon(const b2Vec2* vertices, int32 count, const b2Color& color) override
    {
        m_world.Call(
            [&] { m_renderer.attr("DrawSolidPolygon")(Points(vertices, count), b2Color(color)); });
    }
    void DrawCircle(const b2Vec2& center, float32 radius, const b2Color& color) override
    {
        m_world.Call([&] { m_renderer.attr("DrawCircle")(Point(center), radius, b2Color(color)); });
    }
    void DrawSolidCircle(const b2Vec2& center, float32 radius, const b2Vec2& axis,
                         const b2Color& color) override
    {
        m_world.Call([&] {
            m_renderer.attr("DrawSolidCircle")(Point(center), radius, b2Vec2(axis), b2Color(color));
        });
    }
    void DrawSegment(const b2Vec2& p1, const b2Vec2& p2, const b2Color& color) override
    {
        m_world.Call([&] { m_renderer.attr("DrawSegment")(Point(p1), Point(p2), b2Color(color)); });
    }
    void DrawTransform(const b2Transform& xf) override
    {
        m_world.Call([&] { m_renderer.attr("DrawTransform")(b2Transform(xf)); });
    }

private:
    py::object Point(const b2Vec2& point) const
    {
        return m_screen ? m_screen->Convert(point) : py::cast(b2Vec2(point));
    }

    py::list Points(const b2Vec2* points, int32 count) const
    {
        if (!m_screen)
        {
            return TuplesOf(points, count);
        }
        py::list list(count);
        for (int32 i = 0; i < count; ++i)
        {
            list[static_cast<std::size_t>(i)] = m_screen->Convert(points[i]);
        }
        return list;
    }

    WorldObject& m_world;
    py::object m_renderer;
    std::optional<Screen> m_screen;
};

} // namespace

void DrawWith(WorldObject& world, const py::object& renderer)
{
    PythonDraw draw(world, renderer);
    {
        const WorldObject::Use use(world);
        world.world.SetDebugDraw(&draw);
        world.isDestroying = true; // what is drawn must not be destroyed meanwhile
        world.world.DrawDebugData();
        world.isDestroying = false;
        world.world.SetDebugDraw(nullptr);
    }
    world.Finish();
}

} // namespace boxreel::python
