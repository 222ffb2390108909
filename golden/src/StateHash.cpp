// SPDX-License-Identifier: MIT
#include <golden/StateHash.h>

#include <Box2D/Box2D.h>

#include <bit>
#include <vector>

namespace boxreel
{

namespace
{

// G. Fowler, L. C. Noll, K.-P. Vo: FNV-1a, 64 bits (RFC 9923). Byte after byte, so that a single
// changed bit reaches all that follows.
constexpr std::uint64_t kOffsetBasis = 0xcbf29ce484222325u;
constexpr std::uint64_t kPrime = 0x100000001b3u;

// Lowest byte first on every machine. -0 equals 0, so it counts as the same state.
void Mix(std::uint64_t& hash, float value)
{
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value == 0.0f ? 0.0f : value);
    for (int shift = 0; shift < 32; shift += 8)
    {
        hash = (hash ^ (bits >> shift & 255u)) * kPrime;
    }
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

} // namespace

std::uint64_t StateHash(const b2World& world)
{
    // The world lists its newest body first.
    std::vector<const b2Body*> bodies;
    for (const b2Body* body = world.GetBodyList(); body; body = body->GetNext())
    {
        bodies.push_back(body);
    }
    std::uint64_t hash = kOffsetBasis;
    for (auto body = bodies.rbegin(); body != bodies.rend(); ++body)
    {
        Mix(hash, **body);
    }
    return hash;
}

std::string StateHashText(const b2World& world)
{
    const std::uint64_t hash = StateHash(world);
    std::string text;
    for (int shift = 60; shift >= 0; shift -= 4)
    {
        text += "0123456789abcdef"[hash >> shift & 15u];
    }
    return text;
}

} // namespace boxreel
