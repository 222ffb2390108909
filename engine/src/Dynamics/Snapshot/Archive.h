// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2Collision.h>
#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/Internal/BodyData.h>
#include <Box2D/Dynamics/b2Fixture.h>
#include <Box2D/Dynamics/b2Snapshot.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

class b2Body;
class b2Contact;
class b2Joint;

/// Saving and restoring. One function, Visit(archive, structure), lists the saved members of a
/// structure. With a SnapshotWriter it saves and with a SnapshotReader it restores, so the two
/// cannot differ. Numbers are written one by one, little end first. Memory images are not used,
/// because they contain padding and pointers and change with every member.
namespace box2d
{

/// Objects that are referenced, oldest first; references are stored as indices into these lists.
struct SnapshotLists
{
    Array<b2Body*> bodies;
    Array<b2Joint*> joints; ///< by ascending number
    Array<b2Contact*> contacts;
    b2SnapshotUserData* userData = nullptr;
};

namespace snapshot
{

/// Converts a number to little-endian bytes on any machine.
template <class Number>
void Order(uint8 (&bytes)[sizeof(Number)])
{
    if constexpr (std::endian::native == std::endian::big)
    {
        std::reverse(std::begin(bytes), std::end(bytes));
    }
}

} // namespace snapshot

class SnapshotWriter
{
public:
    static constexpr bool kReads = false;

    template <class... Values>
    void operator()(Values&... values)
    {
        (Visit(*this, values), ...);
    }

    template <class Number>
    void PutNumber(Number number)
    {
        uint8 bytes[sizeof(Number)];
        std::memcpy(bytes, &number, sizeof(Number));
        snapshot::Order<Number>(bytes);
        if (m_bytes.size() - m_size < sizeof(Number))
        {
            Grow();
        }
        std::memcpy(m_bytes.data() + m_size, bytes, sizeof(Number));
        m_size += sizeof(Number);
    }
    void Count(int32& count, std::size_t minBytes)
    {
        (void)minBytes;
        PutNumber(count);
    }
    template <class Value>
    void Within(Value& value, Value minimum, Value maximum)
    {
        (void)minimum, (void)maximum;
        PutNumber(int32(value));
    }
    void Require(bool) {}
    bool IsSound() const { return true; }

    /// Returns the written bytes.
    std::vector<uint8> Take()
    {
        m_bytes.resize(m_size);
        return std::move(m_bytes);
    }

    SnapshotLists lists;

private:
    void Grow() { m_bytes.resize(2 * m_bytes.size() + 1024); }

    std::vector<uint8> m_bytes;
    std::size_t m_size = 0;
};

/// Reads a snapshot. After an error all values are zero, including counts, so that readers
/// terminate.
class SnapshotReader
{
public:
    static constexpr bool kReads = true;

    explicit SnapshotReader(std::span<const uint8> bytes) : m_left(bytes) {}

    template <class... Values>
    void operator()(Values&... values)
    {
        (Visit(*this, values), ...);
    }

    template <class Number>
    Number TakeNumber()
    {
        Number number = {};
        if (m_left.size() < sizeof(Number))
        {
            Require(false);
            return number;
        }
        uint8 bytes[sizeof(Number)];
        std::memcpy(bytes, m_left.data(), sizeof(Number));
        snapshot::Order<Number>(bytes);
        std::memcpy(&number, bytes, sizeof(Number));
        m_left = m_left.subspan(sizeof(Number));
        return number;
    }
    /// The number of items that follow, each of at least `minBytes`.
    void Count(int32& count, std::size_t minBytes)
    {
        count = TakeNumber<int32>();
        Require(count >= 0 && std::size_t(count) <= m_left.size() / minBytes);
        count = m_sound ? count : 0;
    }
    /// Reads a number or enumerator and checks its range.
    template <class Value>
    void Within(Value& value, Value minimum, Value maximum)
    {
        const auto number = TakeNumber<int32>();
        Require(number >= int32(minimum) && number <= int32(maximum));
        value = m_sound ? static_cast<Value>(number) : minimum;
    }
    /// After the first false condition everything is rejected.
    void Require(bool condition)
    {
        if (!condition)
        {
            m_sound = false;
            m_left = {};
        }
    }
    bool IsSound() const { return m_sound; }
    bool IsAtEnd() const { return m_left.empty(); }

    SnapshotLists lists;

private:
    std::span<const uint8> m_left;
    bool m_sound = true;
};

template <class Archive, class Number>
requires std::is_arithmetic_v<Number>
void Visit(Archive& archive, Number& number)
{
    if constexpr (std::is_same_v<Number, bool>)
    {
        auto value = uint8(number);
        archive(value);
        archive.Require(value <= 1);
        number = value == 1;
    }
    else if constexpr (Archive::kReads)
    {
        number = archive.template TakeNumber<Number>();
    }
    else
    {
        archive.PutNumber(number);
    }
}

template <class Archive, class Value, std::size_t count>
void Visit(Archive& archive, Value (&values)[count])
{
    for (Value& value : values)
    {
        archive(value);
    }
}

/// Reads or writes an array of numbers.
template <class Archive, class Number>
void Visit(Archive& archive, Array<Number>& numbers)
{
    auto count = int32(numbers.size());
    archive.Count(count, sizeof(Number));
    numbers.resize(std::size_t(count));
    for (Number& number : numbers)
    {
        archive(number);
    }
}

// Bindings name every member of a structure, so that one more does not compile until it is decided
// here what becomes of it.

template <class Archive>
void Visit(Archive& archive, b2Vec2& v)
{
    archive(v.x, v.y);
}

template <class Archive>
void Visit(Archive& archive, b2Rot& rotation)
{
    archive(rotation.s, rotation.c);
}

template <class Archive>
void Visit(Archive& archive, b2Transform& transform)
{
    archive(transform.p, transform.q);
}

template <class Archive>
void Visit(Archive& archive, Pose& pose)
{
    auto& [x, y, angle] = pose;
    archive(x, y, angle);
}

template <class Archive>
void Visit(Archive& archive, b2AABB& box)
{
    auto& [lower, upper] = box;
    archive(lower, upper);
}

template <class Archive>
void Visit(Archive& archive, b2Filter& filter)
{
    auto& [categories, mask, group] = filter;
    archive(categories, mask, group);
}

template <class Archive>
void Visit(Archive& archive, b2ManifoldPoint& point)
{
    auto& [place, normalImpulse, tangentImpulse, id] = point;
    archive(place, normalImpulse, tangentImpulse, id.cf.indexA, id.cf.indexB, id.cf.typeA,
            id.cf.typeB);
}

template <class Archive>
void Visit(Archive& archive, b2Manifold& manifold)
{
    auto& [points, normal, place, type, count] = manifold;
    archive(normal, place);
    archive.Within(type, b2Manifold::e_circles, b2Manifold::e_faceB);
    archive.Within(count, 0, int32(b2_maxManifoldPoints));
    for (int32 i = 0; i < count; ++i) // the rest is not read
    {
        archive(points[i]);
    }
}

/// Reads or writes user data as the program's number.
template <class Archive>
void VisitUserData(Archive& archive, void*& userData)
{
    bool known = userData != nullptr && archive.lists.userData != nullptr;
    archive(known);
    if (!known)
    {
        return;
    }
    if constexpr (Archive::kReads)
    {
        const auto number = archive.template TakeNumber<std::uint64_t>();
        userData = archive.lists.userData ? archive.lists.userData->ToPointer(number) : nullptr;
    }
    else
    {
        archive.PutNumber(archive.lists.userData->ToNumber(userData));
    }
}

} // namespace box2d
