// SPDX-License-Identifier: MIT
#include "ImmediateDraw.h"

#include <debugdraw/Theme.h>

#include <dlfcn.h>

#include <cmath>
#include <string>

namespace bench
{
namespace
{

using namespace boxreel;

// Constants of OpenGL 1.1 and OSMesa, whose headers need not be installed.
constexpr unsigned kLines = 1, kLineLoop = 2, kTriangleFan = 6;
constexpr unsigned kColorBuffer = 0x4000, kBlend = 0xBE2, kSourceAlpha = 0x302;
constexpr unsigned kOneMinusSourceAlpha = 0x303, kProjection = 0x1701;
constexpr unsigned kUnsignedByte = 0x1401, kRgba = 0x1908;

constexpr int kCircleSegments = 16;
constexpr float kPi = 3.14159265f;
constexpr float kAxisLength = 0.4f; // m

struct Gl
{
    void* (*createContext)(unsigned, int, int, int, void*) = nullptr;
    void (*destroyContext)(void*) = nullptr;
    unsigned char (*makeCurrent)(void*, void*, unsigned, int, int) = nullptr;
    void (*begin)(unsigned) = nullptr;
    void (*end)() = nullptr;
    void (*vertex)(float, float) = nullptr;
    void (*color)(float, float, float, float) = nullptr;
    void (*enable)(unsigned) = nullptr;
    void (*disable)(unsigned) = nullptr;
    void (*blendFunc)(unsigned, unsigned) = nullptr;
    void (*clearColor)(float, float, float, float) = nullptr;
    void (*clear)(unsigned) = nullptr;
    void (*matrixMode)(unsigned) = nullptr;
    void (*loadIdentity)() = nullptr;
    void (*ortho)(double, double, double, double, double, double) = nullptr;
    void (*readPixels)(int, int, int, int, unsigned, unsigned, void*) = nullptr;

    bool Load(void* library)
    {
        const auto find = [library](const char* name, auto& function) {
            function =
                reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
            return function != nullptr;
        };
        return find("OSMesaCreateContextExt", createContext) &&
               find("OSMesaDestroyContext", destroyContext) &&
               find("OSMesaMakeCurrent", makeCurrent) && find("glBegin", begin) &&
               find("glEnd", end) && find("glVertex2f", vertex) && find("glColor4f", color) &&
               find("glEnable", enable) && find("glDisable", disable) &&
               find("glBlendFunc", blendFunc) && find("glClearColor", clearColor) &&
               find("glClear", clear) && find("glMatrixMode", matrixMode) &&
               find("glLoadIdentity", loadIdentity) && find("glOrtho", ortho) &&
               find("glReadPixels", readPixels);
    }
};

class OSMesaDraw final : public ImmediateDraw
{
public:
    OSMesaDraw(const Gl& gl, void* context, int width, int height)
        : m_gl(gl), m_context(context), m_width(width), m_height(height),
          m_buffer(std::size_t(width) * std::size_t(height) * 4), m_pixels(m_buffer.size())
    {
        SetFlags(e_shapeBit | e_jointBit);
    }
    ~OSMesaDraw() override { m_gl.destroyContext(m_context); }

    bool MakeCurrent()
    {
        return m_gl.makeCurrent(m_context, m_buffer.data(), kUnsignedByte, m_width, m_height) != 0;
    }

    void Begin(const Camera& camera) override
    {
        const Rect area = camera.VisibleArea();
        const Color ground = Theme::Classic().background;
        m_gl.matrixMode(kProjection);
        m_gl.loadIdentity();
        m_gl.ortho(double(area.lower.x), double(area.upper.x), double(area.lower.y),
                   double(area.upper.y), -1.0, 1.0);
        m_gl.clearColor(float(ground.r) / 255.0f, float(ground.g) / 255.0f,
                        float(ground.b) / 255.0f, 1.0f);
        m_gl.clear(kColorBuffer);
        m_gl.blendFunc(kSourceAlpha, kOneMinusSourceAlpha);
    }

    const std::vector<std::uint8_t>& Read() override
    {
        m_gl.readPixels(0, 0, m_width, m_height, kRgba, kUnsignedByte, m_pixels.data());
        return m_pixels;
    }

    void DrawPolygon(const b2Vec2* vertices, int32 count, const b2Color& color) override
    {
        Color4(color, 1.0f, 1.0f);
        Polygon(kLineLoop, vertices, count);
    }

    void DrawSolidPolygon(const b2Vec2* vertices, int32 count, const b2Color& color) override
    {
        Fill(color);
        Polygon(kTriangleFan, vertices, count);
        m_gl.disable(kBlend);
        DrawPolygon(vertices, count, color);
    }

    void DrawCircle(const b2Vec2& center, float32 radius, const b2Color& color) override
    {
        Color4(color, 1.0f, 1.0f);
        Circle(kLineLoop, center, radius);
    }

    void DrawSolidCircle(const b2Vec2& center, float32 radius, const b2Vec2& axis,
                         const b2Color& color) override
    {
        Fill(color);
        Circle(kTriangleFan, center, radius);
        m_gl.disable(kBlend);
        DrawCircle(center, radius, color);
        DrawSegment(center, center + radius * axis, color);
    }

    void DrawSegment(const b2Vec2& p1, const b2Vec2& p2, const b2Color& color) override
    {
        Color4(color, 1.0f, 1.0f);
        m_gl.begin(kLines);
        m_gl.vertex(p1.x, p1.y);
        m_gl.vertex(p2.x, p2.y);
        m_gl.end();
    }

    void DrawTransform(const b2Transform& xf) override
    {
        DrawSegment(xf.p, xf.p + kAxisLength * xf.q.GetXAxis(), b2Color(1.0f, 0.0f, 0.0f));
        DrawSegment(xf.p, xf.p + kAxisLength * xf.q.GetYAxis(), b2Color(0.0f, 1.0f, 0.0f));
    }

private:
    void Color4(const b2Color& color, float shade, float alpha)
    {
        m_gl.color(shade * color.r, shade * color.g, shade * color.b, alpha);
    }

    void Fill(const b2Color& color)
    {
        const Theme theme = Theme::Classic();
        m_gl.enable(kBlend);
        Color4(color, theme.fillShade, theme.fillAlpha);
    }

    void Polygon(unsigned kind, const b2Vec2* vertices, int32 count)
    {
        m_gl.begin(kind);
        for (int32 i = 0; i < count; ++i)
        {
            m_gl.vertex(vertices[i].x, vertices[i].y);
        }
        m_gl.end();
    }

    void Circle(unsigned kind, const b2Vec2& center, float radius)
    {
        m_gl.begin(kind);
        for (int i = 0; i < kCircleSegments; ++i)
        {
            const float angle = 2.0f * kPi * float(i) / float(kCircleSegments);
            m_gl.vertex(center.x + radius * std::cos(angle), center.y + radius * std::sin(angle));
        }
        m_gl.end();
    }

    Gl m_gl;
    void* m_context;
    int m_width;                        // [px]
    int m_height;                       // [px]
    std::vector<std::uint8_t> m_buffer; // what Mesa draws into
    std::vector<std::uint8_t> m_pixels; // what was read
};

} // namespace

Result<std::unique_ptr<ImmediateDraw>> ImmediateDraw::Create(int width, int height)
{
    const Error absent{ErrorKind::Absent, "Immediate mode needs Mesa's off-screen library; install "
                                          "it with: apt install libosmesa6"};
    void* const library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    Gl gl;
    if (library == nullptr || !gl.Load(library))
    {
        return absent;
    }
    void* const context = gl.createContext(kRgba, 0, 0, 0, nullptr);
    if (context == nullptr)
    {
        return absent;
    }
    auto draw = std::make_unique<OSMesaDraw>(gl, context, width, height);
    return draw->MakeCurrent() ? Result<std::unique_ptr<ImmediateDraw>>(std::move(draw)) : absent;
}

} // namespace bench
