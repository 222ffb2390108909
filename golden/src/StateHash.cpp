// SPDX-License-Identifier: MIT
#include <golden/StateHash.h>

#include <Box2D/Box2D.h>
#include <base/Bytes.h>

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <vector>

namespace boxreel
{

namespace
{

// Little-endian on every machine. -0 equals 0, so it has the same hash.
void Mix(std::uint64_t& hash, float value)
{
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value == 0.0f ? 0.0f : value);
    const std::array<std::uint8_t, 4> bytes{std::uint8_t(bits), std::uint8_t(bits >> 8),
                                            std::uint8_t(bits >> 16), std::uint8_t(bits >> 24)};
    hash = ChecksumOf(bytes, hash);
}

void Mix(std::uint64_t& hash, const b2Body& body)
{
    Mix(hash, body.GetPosition().x);
    Mix(hash, body.GetPosition().y);
    Mix(hash, body.GetAngle());
    Mix(hash, body.GetLinearVelocity().x);
    Mix(hash, body.GetLinearVelocity().y);
    Mix(hash, body.GetAngularVelocity());
}

// FNV's low bits depend only on the low bits of the input; its middle bits on all of them.
char Digit(std::uint64_t hash)
{
    return HexText((hash ^ hash >> 32) >> 24 & 15u).back();
}

std::uint64_t HashOf(const b2Body& body)
{
    std::uint64_t hash = ChecksumOf(std::string());
    Mix(hash, body);
    return hash;
}

std::string DigitsOfEach(const std::vector<const b2Body*>& bodies, int made)
{
    std::string digits(std::size_t(made), '.');
    for (const b2Body* body : bodies)
    {
        digits[std::size_t(body->GetNumber())] = Digit(HashOf(*body));
    }
    return digits;
}

std::string DigitsOfRowsAndColumns(const std::vector<const b2Body*>& bodies, int made)
{
    std::size_t side = 1;
    while (side * side < std::size_t(made))
    {
        ++side;
    }
    std::vector<std::uint64_t> rows(side), columns(side);
    for (const b2Body* body : bodies)
    {
        const std::size_t number = std::size_t(body->GetNumber());
        const std::uint64_t hash = HashOf(*body);
        rows[number / side] += hash;
        columns[number % side] += hash;
    }
    std::string digits;
    for (const std::uint64_t row : rows)
    {
        digits += Digit(row);
    }
    digits += '/';
    for (const std::uint64_t column : columns)
    {
        digits += Digit(column);
    }
    return digits;
}

} // namespace

std::vector<const b2Body*> OldestFirst(const b2World& world)
{
    std::vector<const b2Body*> bodies;
    for (const b2Body* body = world.GetBodyList(); body; body = body->GetNext())
    {
        bodies.push_back(body); // the world lists its newest body first
    }
    std::reverse(bodies.begin(), bodies.end());
    return bodies;
}

std::uint64_t StateHash(const b2World& world)
{
    std::uint64_t hash = ChecksumOf(std::string());
    for (const b2Body* body : OldestFirst(world))
    {
        Mix(hash, *body);
    }
    return hash;
}

std::string StateHashText(const b2World& world)
{
    return HexText(StateHash(world));
}

WorldState ReadWorldState(const b2World& world)
{
    WorldState state;
    for (const b2Body* body : OldestFirst(world))
    {
        const b2Vec2 velocity = body->GetLinearVelocity();
        state.bodies.push_back({body->GetNumber(), body->GetPosition().x, body->GetPosition().y,
                                body->GetAngle(), velocity.x, velocity.y,
                                body->GetAngularVelocity()});
    }
    return state;
}

TraceStep ReadTraceStep(const b2World& world, std::int64_t step)
{
    const std::vector<const b2Body*> bodies = OldestFirst(world);
    const int made = bodies.empty() ? 0 : bodies.back()->GetNumber() + 1;
    const std::uint64_t hash = StateHash(world);
    return {step, HexText(hash ^ hash >> 32).substr(8),
            made <= kLongestTrace ? DigitsOfEach(bodies, made)
                                  : DigitsOfRowsAndColumns(bodies, made)};
}

} // namespace boxreel
