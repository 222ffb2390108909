// SPDX-License-Identifier: MIT
#include <debugdraw/DrawListText.h>

#include <base/Quoting.h>

#include <array>
#include <cassert>
#include <charconv>

namespace boxreel
{

namespace
{

const char* KindName(DrawKind kind)
{
    switch (kind)
    {
    case DrawKind::Polygon:
        return "polygon";
    case DrawKind::SolidPolygon:
        return "solid-polygon";
    case DrawKind::Circle:
        return "circle";
    case DrawKind::SolidCircle:
        return "solid-circle";
    case DrawKind::Segment:
        return "segment";
    case DrawKind::Transform:
        return "transform";
    case DrawKind::Point:
        return "point";
    case DrawKind::Text:
        return "text";
    }
    return "unknown-kind";
}

// Returns the meaning of DrawItem::size for a kind; null if it is unused.
const char* SizeName(DrawKind kind)
{
    switch (kind)
    {
    case DrawKind::Circle:
    case DrawKind::SolidCircle:
        return "radius";
    case DrawKind::Transform:
        return "axes";
    case DrawKind::Point:
        return "pixels";
    default:
        return nullptr;
    }
}

template <class Number>
void AppendNumber(std::string& out, Number value)
{
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    out.append(digits.data(), end);
}

void AppendFloat(std::string& out, float value)
{
    AppendNumber(out, value == 0.0f ? 0.0f : value); // -0 equals 0, so it reads the same
}

void AppendColor(std::string& out, Color color)
{
    out += '#';
    out += HexByte(color.r);
    out += HexByte(color.g);
    out += HexByte(color.b);
    if (color.a != 255)
    {
        out += HexByte(color.a);
    }
}

void AppendPoint(std::string& out, Vec2 point)
{
    out += " (";
    AppendFloat(out, point.x);
    out += ", ";
    AppendFloat(out, point.y);
    out += ')';
}

// Appends the text quoted and without line breaks, so that an item stays one line.
void AppendQuoted(std::string& out, const std::string& text)
{
    out += '"';
    for (const char c : text)
    {
        const auto byte = static_cast<std::uint8_t>(c);
        if (c == '"' || c == '\\')
        {
            out += '\\';
            out += c;
        }
        else if (byte < 32 || byte == 127)
        {
            out += "\\x";
            out += HexByte(byte);
        }
        else
        {
            out += c;
        }
    }
    out += '"';
}

void AppendItem(std::string& out, const DrawList& list, const DrawItem& item)
{
    assert(std::size_t{item.first} + item.count <= list.points.size());
    if (item.owner == kNoOwner)
    {
        out += "world ";
    }
    else
    {
        out += "body ";
        AppendNumber(out, item.owner);
        out += ' ';
    }
    out += InfoOf(item.layer).name;
    out += ' ';
    out += KindName(item.kind);
    out += ' ';
    AppendColor(out, item.color);
    for (std::size_t i = 0; i < item.count; ++i)
    {
        AppendPoint(out, list.points[item.first + i]);
    }
    if (const char* name = SizeName(item.kind))
    {
        out += ' ';
        out += name;
        out += ' ';
        AppendFloat(out, item.size);
    }
    if (item.kind == DrawKind::Text)
    {
        assert(item.text < list.texts.size());
        out += ' ';
        AppendQuoted(out, list.texts[item.text]);
    }
    out += '\n';
}

} // namespace

std::string ToText(const DrawList& list)
{
    std::string out;
    out.reserve(list.items.size() * 96);
    for (const DrawItem& item : list.items)
    {
        AppendItem(out, list, item);
    }
    return out;
}

} // namespace boxreel
