// SPDX-License-Identifier: MIT
#include "SceneLabels.h"

#include <string>

namespace boxreel
{
namespace
{

// Of a digit in the renderer's font [px]. A little off is a label a little off its centre.
constexpr double kDigitWidth = 8.3;
constexpr double kLineHeight = 16.0;

/// Asked for the centres of mass, the engine says of each whose it is.
class NumberWriter : public b2Draw
{
public:
    NumberWriter(double pixelsPerMeter, DrawList& list)
        : m_metersPerPixel(1.0 / pixelsPerMeter), m_list(list)
    {
        SetFlags(e_centerOfMassBit);
    }

    void BeginBody(int32 number) override { m_body = number; }

    void DrawTransform(const b2Transform& xf) override
    {
        if (m_body >= 0)
        {
            m_list.owner = static_cast<std::uint32_t>(m_body);
            const std::string number = std::to_string(m_body);
            const double left = 0.5 * kDigitWidth * double(number.size()) * m_metersPerPixel;
            const double up = 0.5 * kLineHeight * m_metersPerPixel;
            m_list.AddText(Vec2{float(xf.p.x - left), float(xf.p.y + up)}, number,
                           Color{255, 255, 255, 255});
        }
    }

    void DrawPolygon(const b2Vec2*, int32, const b2Color&) override {}
    void DrawSolidPolygon(const b2Vec2*, int32, const b2Color&) override {}
    void DrawCircle(const b2Vec2&, float32, const b2Color&) override {}
    void DrawSolidCircle(const b2Vec2&, float32, const b2Vec2&, const b2Color&) override {}
    void DrawSegment(const b2Vec2&, const b2Vec2&, const b2Color&) override {}

private:
    double m_metersPerPixel;
    DrawList& m_list;
    int32 m_body = -1;
};

} // namespace

void AddBodyNumbers(b2World& world, double pixelsPerMeter, DrawList& list)
{
    list.layer = DrawLayer::Labels;
    NumberWriter writer(pixelsPerMeter, list);
    world.SetDebugDraw(&writer);
    world.DrawDebugData();
    world.SetDebugDraw(nullptr);
    list.owner = kNoOwner;
}

} // namespace boxreel
