// SPDX-License-Identifier: MIT
#include "SceneLabels.h"

#include <algorithm>
#include <cassert>
#include <string>

namespace boxreel
{
namespace
{

// Of a digit in the renderer's font [px]. A little off is a label a little off its centre.
constexpr double kDigitWidth = 8.3;
constexpr double kLineHeight = 16.0;

/// Asked for the centres of mass, the engine says of each whose it is, the oldest body first.
class CenterVisitor : public b2Draw
{
public:
    CenterVisitor() { SetFlags(e_centerOfMassBit); }

    virtual void Visit(int32 body, const b2Vec2& center) = 0;

    void VisitAllOf(b2World& world)
    {
        world.SetDebugDraw(this);
        world.DrawDebugData();
        world.SetDebugDraw(nullptr);
    }

    void BeginBody(int32 number) override { m_body = number; }
    void DrawTransform(const b2Transform& xf) override
    {
        if (m_body >= 0)
        {
            Visit(m_body, xf.p);
        }
    }
    void DrawPolygon(const b2Vec2*, int32, const b2Color&) override {}
    void DrawSolidPolygon(const b2Vec2*, int32, const b2Color&) override {}
    void DrawCircle(const b2Vec2&, float32, const b2Color&) override {}
    void DrawSolidCircle(const b2Vec2&, float32, const b2Vec2&, const b2Color&) override {}
    void DrawSegment(const b2Vec2&, const b2Vec2&, const b2Color&) override {}

private:
    int32 m_body = -1;
};

/// The number of each body, the oldest first.
class NumberReader : public CenterVisitor
{
public:
    void Visit(int32 body, const b2Vec2&) override { numbers.push_back(body); }
    std::vector<int32> numbers;
};

class NumberWriter : public CenterVisitor
{
public:
    NumberWriter(double pixelsPerMeter, DrawList& list)
        : m_metersPerPixel(1.0 / pixelsPerMeter), m_list(list)
    {}

    void Visit(int32 body, const b2Vec2& center) override
    {
        m_list.owner = static_cast<std::uint32_t>(body);
        const std::string number = std::to_string(body);
        const double left = 0.5 * kDigitWidth * double(number.size()) * m_metersPerPixel;
        const double up = 0.5 * kLineHeight * m_metersPerPixel;
        m_list.AddText(Vec2{float(center.x - left), float(center.y + up)}, number,
                       Color{255, 255, 255, 255});
    }

private:
    double m_metersPerPixel;
    DrawList& m_list;
};

} // namespace

std::vector<NumberedBody> NumberedBodies(b2World& world)
{
    NumberReader reader;
    reader.VisitAllOf(world);
    assert(std::is_sorted(reader.numbers.begin(), reader.numbers.end()));
    std::vector<NumberedBody> bodies(reader.numbers.size());
    std::size_t at = bodies.size(); // the world's list has the newest first
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        --at;
        bodies[at] = {reader.numbers[at], body};
    }
    return bodies;
}

std::vector<const b2Body*> FindBodies(b2World& world, const std::vector<int>& numbers)
{
    std::vector<const b2Body*> found(numbers.size());
    for (const NumberedBody& numbered : NumberedBodies(world))
    {
        for (std::size_t i = 0; i < numbers.size(); ++i)
        {
            found[i] = numbers[i] == numbered.number ? numbered.body : found[i];
        }
    }
    return found;
}

Result<void> CheckBodies(const std::string& option, b2World& world, const std::vector<int>& numbers)
{
    const std::vector<const b2Body*> bodies = FindBodies(world, numbers);
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
        if (bodies[i] == nullptr)
        {
            const int count = world.GetBodyCount();
            const std::string has =
                count == 0 ? "no bodies"
                : count == 1
                    ? "one body, number 0"
                    : std::to_string(count) + " bodies, numbers 0 to " + std::to_string(count - 1);
            return Error{ErrorKind::Unusable, option + ": there is no body " +
                                                  std::to_string(numbers[i]) + "; the scene has " +
                                                  has + ", and `--labels` shows which is which."};
        }
    }
    return {};
}

void AddBodyNumbers(b2World& world, double pixelsPerMeter, DrawList& list)
{
    list.layer = DrawLayer::Labels;
    NumberWriter(pixelsPerMeter, list).VisitAllOf(world);
    list.owner = kNoOwner;
}

} // namespace boxreel
