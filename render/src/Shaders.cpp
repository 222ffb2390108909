// SPDX-License-Identifier: MIT
#include "Shaders.h"

#include "OverlayMesh.h"

namespace boxreel
{
namespace
{

// The coverage of a pixel within t of a straight edge's inner side, minus one half. Projected on
// the edge's normal n, the pixel (a unit square) is a trapezoid. With a = max and b = min of |n.x|,
// |n.y|, its base is a + b and its top a - b. Coverage is the exact integral of that trapezoid.
//   k = (base / 2, top / 2, 1 / a, 1 / (2 b))
// Two parallel edges at distance h from a centre line cover G(h - x) + G(h + x), which is exact at
// any distance.
constexpr const char* kCoverage = R"(
vec4 Trapezoid(vec2 n)
{
    n = abs(n);
    float a = max(n.x, n.y);
    float b = max(min(n.x, n.y), 1e-4);
    return vec4(0.5 * (a + b), 0.5 * (a - b), 1.0 / a, 0.5 / b);
}
float G(float t, vec4 k)
{
    float u = min(abs(t), k.x);
    float v = max(u - k.y, 0.0);
    float g = (u - v * v * k.w) * k.z;
    return t < 0.0 ? -g : g;
}
// The same, to the bit, for edges farther apart than a pixel is wide, when x >= 0: of the far one,
// all is inside.
float Edge(float x, float h, vec4 k)
{
    float v = max(k.x - k.y, 0.0);
    return G(h - x, k) + (k.x - v * v * k.w) * k.z;
}
float Slab(float x, float h, vec4 k)
{
    return G(h - x, k) + G(h + x, k);
}
)";

// Corners of the part to draw: a rectangle of whole pixels. Every pixel's colour depends on its
// position only, not on the quad. A shape may be drawn in parts with the same bits.
constexpr const char* kPart = R"(
uniform samplerBuffer instances; // VECTORS for each VERTICES vertices
uniform int first;               // vector of the draw call
uniform vec2 pixelToClip;        // 2 / size
vec4 Attribute(int i)
{
    return texelFetch(instances, first + gl_VertexID / VERTICES * VECTORS + i);
}
vec2 Corner()
{
#if VERTICES == 1
    return vec2(0.5);
#else
    return vec2(gl_VertexID & 1, gl_VertexID >> 1 & 1);
#endif
}
void PlacePart(vec4 part)
{
    vec2 pixel = mix(part.xy, part.zw, Corner());
    gl_Position = vec4(pixel * pixelToClip - 1.0, 0.0, 1.0);
#if VERTICES == 1
    gl_PointSize = max(part.z - part.x, part.w - part.y);
#endif
}
)";

// Without a part: a quad around an oriented box, larger by kQuadMargin than its coverage.
constexpr const char* kQuad = R"(
void PlaceQuad(vec2 center, vec2 axis, vec2 reach)
{
    vec4 part = Attribute(0); // [px]
    vec2 local = (Corner() * 2.0 - 1.0) * (reach + 0.75);
    vec2 pixel = center + local.x * axis + local.y * vec2(-axis.y, axis.x);
    PlacePart(part);
    if (part.x == part.z)
    {
        gl_Position = vec4(pixel * pixelToClip - 1.0, 0.0, 1.0);
    }
}
)";

constexpr const char* kGroundVertex = R"(
flat out vec4 ground; // premultiplied
void main()
{
    PlacePart(Attribute(0));
    ground = Attribute(1);
}
)";

constexpr const char* kGroundFragment = R"(
flat in vec4 ground;
layout(location = 0) out vec4 color;
void main()
{
    color = ground;
}
)";

constexpr const char* kShapeVertex = R"(
flat out vec4 place;
flat out vec4 size;
flat out vec4 stroke;
flat out vec4 fill;
flat out vec4 k;
void main()
{
    place = Attribute(1);
    size = Attribute(2);
    stroke = Attribute(3);
    fill = Attribute(4);
    k = Trapezoid(place.zw);
    PlaceQuad(place.xy, place.zw, REACH);
}
)";

constexpr const char* kShapeInputs = R"(
flat in vec4 place; // centre [px], unit axis
flat in vec4 size;
flat in vec4 stroke; // premultiplied
flat in vec4 fill;   // premultiplied
flat in vec4 k;      // of the axis, and of the direction across it, which has the same trapezoid
layout(location = 0) out vec4 color;
)";

// size: outer half extents, inner half extents (0, 0 without interior). Exact along edges; at
// corners of rotated boxes the product of two slabs is an approximation. SIDES: Edge or Slab.
constexpr const char* kBoxFragment = R"(
void main()
{
    vec2 p = gl_FragCoord.xy - place.xy;
    float x = abs(dot(p, place.zw));
    float y = abs(place.z * p.y - place.w * p.x);
    float outer = SIDES(x, size.x, k) * SIDES(y, size.y, k);
    float inner = SIDES(x, size.z, k) * SIDES(y, size.w, k);
    color = stroke * (outer - inner) + fill * inner;
}
)";

// size: 0, outer radius, inner radius (negative without interior), half width of the axis line (0
// for none). A pixel uses the tangent of the edge. A circle curves away from it by 1/(24 d) on
// average over a pixel; the 1/12 under the root corrects that.
constexpr const char* kDiscFragment = R"(
void main()
{
    vec2 p = gl_FragCoord.xy - place.xy;
    float x = dot(p, place.zw);
    float y = place.z * p.y - place.w * p.x;
    float d = sqrt(x * x + y * y + 1.0 / 12.0);
    vec2 n = vec2(x * place.z - y * place.w, x * place.w + y * place.z) / d;
    vec4 kn = Trapezoid(dot(n, n) > 0.01 ? n : vec2(1.0, 0.0));
    float outer = G(size.y - d, kn) + 0.5;
    float inner = G(size.z - d, kn) + 0.5;
    float axis = Slab(abs(y), size.w, k) * (G(x + 0.785 * size.w, k) + 0.5);
    float filled = inner * (1.0 - axis);
    color = stroke * (outer - filled) + fill * filled;
}
)";

// size: half length of the spine, radius. Round ends as in discs.
constexpr const char* kCapsuleFragment = R"(
void main()
{
    vec2 p = gl_FragCoord.xy - place.xy;
    float x = dot(p, place.zw);
    float y = place.z * p.y - place.w * p.x;
    float beyond = sign(x) * max(abs(x) - size.x, 0.0);
    float bend = size.x == 0.0 || beyond != 0.0 ? 1.0 / 12.0 : 0.0;
    float d = sqrt(beyond * beyond + y * y + bend);
    vec2 n = vec2(beyond * place.z - y * place.w, beyond * place.w + y * place.z) / max(d, 1e-6);
    vec4 kn = Trapezoid(dot(n, n) > 0.01 ? n : vec2(1.0, 0.0));
    color = stroke * (G(size.y - d, kn) + 0.5);
}
)";

// The exact area of a polygon within a pixel: the sum over its edges of the area between the edge
// and the pixel's lower side. With the edge's ends clamped to the pixel's width, this is the width
// times the mean of a linear function clamped to [0, 1]. Its integral Q(y) = c^2/2 + c r uses the
// clamped value c and the rest r = y - c, to avoid cancellation.
constexpr const char* kPolygonArea = R"(
float UnderEdge(vec2 a, vec2 b, float slope)
{
    vec2 x = clamp(vec2(a.x, b.x), 0.0, 1.0);
    vec2 y = a.y + (x - a.x) * slope;
    vec2 c = clamp(y, 0.0, 1.0);
    vec2 r = y - c;
    float rise = c.y - c.x;
    float run = rise + (r.y - r.x);
    float integral = 0.5 * rise * (c.x + c.y) + c.y * r.y - c.x * r.x;
    float mean = abs(run) > 1e-6 ? integral / run : 0.5 * (c.x + c.y);
    return (x.y - x.x) * mean;
}
)";

constexpr const char* kPolygonVertex = R"(
flat out vec4 stroke;
flat out vec4 fill;
flat out vec3 core;
flat out vec4 corners[(OUTER + INNER) / 2];
flat out vec2 slopes[(OUTER + INNER) / 2];
float Slope(vec2 a, vec2 b)
{
    return a.x == b.x ? 0.0 : (b.y - a.y) / (b.x - a.x);
}
void Ring(int begin, int count)
{
    for (int i = begin; i < begin + count; ++i)
    {
        vec4 here = Attribute(5 + i);
        vec4 next = Attribute(5 + (i + 1 < begin + count ? i + 1 : begin));
        corners[i] = here;
        slopes[i] = vec2(Slope(here.xy, here.zw), Slope(here.zw, next.xy));
    }
}
void main()
{
    vec4 place = Attribute(1); // centre and axis of the box around
    vec4 size = Attribute(2);  // its half extents, and the distance within which all is fill
    stroke = Attribute(3);
    fill = Attribute(4);
    core = vec3(place.xy, size.z > 0.0 ? size.z * size.z : -1.0);
    Ring(0, OUTER / 2);
    Ring(OUTER / 2, INNER / 2);
    PlaceQuad(place.xy, place.zw, size.xy);
}
)";

// Evaluated for all pixels, including those of the core: on a software rasterizer a loop for some
// pixels costs more than it saves.
constexpr const char* kPolygonFragment = R"(
flat in vec4 stroke; // premultiplied
flat in vec4 fill;   // premultiplied
flat in vec3 core;   // centre [px], and the square of the distance within which all is fill
flat in vec4 corners[(OUTER + INNER) / 2];
flat in vec2 slopes[(OUTER + INNER) / 2];
layout(location = 0) out vec4 color;
void main()
{
    vec2 p = gl_FragCoord.xy - core.xy;
    vec4 pixel = (gl_FragCoord.xy - 0.5).xyxy;
    float outer = 0.0;
    float inner = 0.0;
    for (int i = 0; i < OUTER / 2; ++i)
    {
        vec4 here = corners[i] - pixel;
        vec2 next = corners[i + 1 < OUTER / 2 ? i + 1 : 0].xy - pixel.xy;
        outer += UnderEdge(here.xy, here.zw, slopes[i].x) + UnderEdge(here.zw, next, slopes[i].y);
    }
    for (int i = OUTER / 2; i < (OUTER + INNER) / 2; ++i)
    {
        vec4 here = corners[i] - pixel;
        vec2 next = corners[i + 1 < (OUTER + INNER) / 2 ? i + 1 : OUTER / 2].xy - pixel.xy;
        inner += UnderEdge(here.xy, here.zw, slopes[i].x) + UnderEdge(here.zw, next, slopes[i].y);
    }
    bool isCore = dot(p, p) < core.z;
    outer = isCore ? 1.0 : min(abs(outer), 1.0);
    inner = isCore ? 1.0 : min(abs(inner), outer);
    color = stroke * (outer - inner) + fill * inner;
}
)";

// More corners than a vertex shader can pass on: each edge is fetched, with its slope.
constexpr const char* kManyCornersVertex = R"(
flat out vec4 stroke;
flat out vec4 fill;
flat out vec3 core;
flat out int edges;
void main()
{
    vec4 place = Attribute(1);
    vec4 size = Attribute(2);
    stroke = Attribute(3);
    fill = Attribute(4);
    core = vec3(place.xy, size.z > 0.0 ? size.z * size.z : -1.0);
    edges = first + gl_VertexID / VERTICES * VECTORS + 5;
    PlaceQuad(place.xy, place.zw, size.xy);
}
)";

constexpr const char* kManyCornersFragment = R"(
uniform samplerBuffer instances;
flat in vec4 stroke; // premultiplied
flat in vec4 fill;   // premultiplied
flat in vec3 core;   // centre [px], and the square of the distance within which all is fill
flat in int edges;   // vector of the first
layout(location = 0) out vec4 color;
float Covered(int begin)
{
    vec2 pixel = gl_FragCoord.xy - 0.5;
    float sum = 0.0;
    vec4 next = texelFetch(instances, begin);
    for (int i = 1; i <= CORNERS; ++i)
    {
        vec4 here = next;
        next = texelFetch(instances, begin + (i < CORNERS ? i : 0));
        sum += UnderEdge(here.xy - pixel, next.xy - pixel, here.z);
    }
    return abs(sum);
}
void main()
{
    vec2 p = gl_FragCoord.xy - core.xy;
    bool isCore = dot(p, p) < core.z;
    float outer = isCore ? 1.0 : min(Covered(edges), 1.0);
    float inner = isCore ? 1.0 : min(Covered(edges + CORNERS), outer);
    color = stroke * (outer - inner) + fill * inner;
}
)";

// Texels of a glyph are on whole pixels. They are fetched as integers, because filtering depends on
// the processor.
constexpr const char* kGlyphVertex = R"(
flat out ivec2 offset; // from pixel to texel
flat out vec4 ink;
void main()
{
    offset = ivec2(Attribute(1).xy);
    ink = Attribute(2); // premultiplied
    PlacePart(Attribute(0));
}
)";

constexpr const char* kGlyphFragment = R"(
uniform usampler2D font;
flat in ivec2 offset;
flat in vec4 ink;
layout(location = 0) out vec4 color;
void main()
{
    uint coverage = texelFetch(font, ivec2(gl_FragCoord.xy) + offset, 0).r;
    color = ink * (float(coverage) / 255.0);
}
)";

// Planes with integer coefficients (OverlayMesh.h).
constexpr const char* kMeshVertex = R"(
layout(location = 0) in vec2 position; // [px]
layout(location = 1) in ivec4 inkIn;
layout(location = 2) in ivec4 inkXIn;
layout(location = 3) in ivec4 inkYIn;
layout(location = 4) in ivec4 texelIn;
layout(location = 5) in ivec2 texelYIn;
uniform vec2 pixelToClip;
flat out ivec4 ink;
flat out ivec4 inkX;
flat out ivec4 inkY;
flat out ivec4 texel;
flat out ivec2 texelY;
void main()
{
    ink = inkIn;
    inkX = inkXIn;
    inkY = inkYIn;
    texel = texelIn;
    texelY = texelYIn;
    gl_Position = vec4(position * pixelToClip - 1.0, 0.0, 1.0);
}
)";

// The quotient is within 1e-7 of a multiple of 1 / 65025, and none of these is halfway between two
// steps of 1 / 255. It therefore rounds to the same byte on every machine.
constexpr const char* kMeshFragment = R"(
uniform usampler2D font;
flat in ivec4 ink;
flat in ivec4 inkX;
flat in ivec4 inkY;
flat in ivec4 texel;
flat in ivec2 texelY;
layout(location = 0) out vec4 color;
void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 place = (texel.xy + texel.zw * pixel.x + texelY * pixel.y) >> TEXEL_BITS;
    place = clamp(place, ivec2(0), textureSize(font, 0) - 1);
    int coverage = int(texelFetch(font, place, 0).r);
    ivec4 level = (ink + inkX * pixel.x + inkY * pixel.y) >> INK_BITS;
    color = vec4(level * coverage) / 65025.0;
}
)";

const std::string kVersion = "#version 330 core\n";

std::string Define(const char* name, const std::string& value)
{
    return std::string("#define ") + name + " " + value + "\n";
}

/// Quads placed by their index, with `vectors` vectors each.
ShaderSource QuadShader(int vectors, const std::string& vertex, const std::string& fragment)
{
    return {Define("VECTORS", std::to_string(vectors)) + kPart + vertex, kVersion + fragment,
            vectors};
}

ShaderSource ShapeShader(const char* reach, const std::string& fragment)
{
    return QuadShader(5, Define("REACH", reach) + kCoverage + kQuad + kShapeVertex,
                      kCoverage + (kShapeInputs + fragment));
}

ShaderSource PolygonShader(CornerSlots slots)
{
    const int outer = int(slots.outer);
    const int inner = int(slots.inner);
    const std::string head =
        Define("OUTER", std::to_string(outer)) + Define("INNER", std::to_string(inner));
    return QuadShader(5 + (outer + inner) / 2, head + kQuad + kPolygonVertex,
                      head + kPolygonArea + kPolygonFragment);
}

ShaderSource ManyCornersShader()
{
    const std::string head = Define("CORNERS", std::to_string(kMaxCorners));
    return QuadShader(5 + 2 * int(kMaxCorners), kQuad + std::string(kManyCornersVertex),
                      head + kPolygonArea + kManyCornersFragment);
}

} // namespace

CornerSlots SlotsOf(ProgramKind polygon)
{
    switch (polygon)
    {
    case ProgramKind::SmallPolygon: // up to four corners, and two cut mitres
        return {6, 4};
    case ProgramKind::Hexagon:
        return {6, 6};
    case ProgramKind::Polygon:
        return {8, 8};
    case ProgramKind::LargePolygon:
        return {12, 12};
    default:
        return {kMaxCorners, kMaxCorners};
    }
}

namespace
{

/// The source of its vertex shader, without the first lines.
ShaderSource ShaderOf(ProgramKind kind)
{
    switch (kind)
    {
    case ProgramKind::Ground:
        return QuadShader(2, kGroundVertex, kGroundFragment);
    case ProgramKind::Box:
        return ShapeShader("size.xy", Define("SIDES", "Edge") + kBoxFragment);
    case ProgramKind::ThinBox:
        return ShapeShader("size.xy", Define("SIDES", "Slab") + kBoxFragment);
    case ProgramKind::Disc:
        return ShapeShader("size.yy", kDiscFragment);
    case ProgramKind::Capsule:
        return ShapeShader("vec2(size.x + size.y, size.y)", kCapsuleFragment);
    case ProgramKind::SmallPolygon:
    case ProgramKind::Hexagon:
    case ProgramKind::Polygon:
    case ProgramKind::LargePolygon:
        return PolygonShader(SlotsOf(kind));
    case ProgramKind::ManyCorners:
        return ManyCornersShader();
    case ProgramKind::Glyph:
        break;
    }
    return QuadShader(3, kGlyphVertex, kGlyphFragment);
}

} // namespace

ShaderSource InstancedShader(ProgramKind kind, Form form)
{
    ShaderSource source = ShaderOf(kind);
    source.vertex = kVersion + Define("VERTICES", form == Form::Square ? "1" : "4") + source.vertex;
    return source;
}

ShaderSource MeshShader()
{
    const std::string bits = Define("INK_BITS", std::to_string(kInkBits)) +
                             Define("TEXEL_BITS", std::to_string(kTexelBits));
    return {kVersion + kMeshVertex, kVersion + bits + kMeshFragment, 0};
}

} // namespace boxreel
