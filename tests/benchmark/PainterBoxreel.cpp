// SPDX-License-Identifier: MIT
// Boxreel's renderer, and the minimum of every picture through the same library: GL clears and
// returns its pixels, without a Renderer.
#include "Painter.h"

#include "Context.h"
#include "GlFunctions.h"

#include <render/Renderer.h>

#include <utility>

namespace bench
{
namespace
{

using namespace boxreel;

class RendererPainter final : public Painter
{
public:
    explicit RendererPainter(Renderer renderer) : m_renderer(std::move(renderer)) {}

    static Result<std::unique_ptr<Painter>> Make(int width, int height)
    {
        RendererSettings settings;
        settings.width = width;
        settings.height = height;
        Result<Renderer> renderer = Renderer::Create(settings);
        if (!renderer)
        {
            return renderer.GetError();
        }
        return std::unique_ptr<Painter>(std::make_unique<RendererPainter>(std::move(*renderer)));
    }

    Result<void> Submit(const DrawList& list, const Camera& camera) override
    {
        return m_renderer.Submit(list, camera);
    }
    /// Reads only the changes. The frame belongs to the renderer and already contains the rest.
    Result<void> Read() override
    {
        const Result<const Frame*> frame = m_renderer.ReadChanges();
        m_frame = frame ? *frame : nullptr;
        return frame ? Result<void>() : Result<void>(frame.GetError());
    }
    Frame Picture() const override { return m_frame ? *m_frame : Frame(); }
    std::string Description() const override { return m_renderer.Description(); }

private:
    Renderer m_renderer;
    const Frame* m_frame = nullptr; // the renderer's
};

class FloorPainter final : public Painter
{
public:
    FloorPainter(std::unique_ptr<Context> context, const GlFunctions& gl, int width, int height)
        : m_context(std::move(context)), m_gl(gl), m_frame(width, height)
    {
        m_gl.GenFramebuffers(1, &m_framebuffer);
        m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
        m_gl.GenRenderbuffers(1, &m_renderbuffer);
        m_gl.BindRenderbuffer(GL_RENDERBUFFER, m_renderbuffer);
        m_gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
        m_gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                     m_renderbuffer);
        m_gl.Viewport(0, 0, width, height);
        m_gl.ClearColor(0.1f, 0.1f, 0.1f, 1.0f);
    }
    ~FloorPainter() override
    {
        if (m_context->MakeCurrent())
        {
            m_gl.DeleteFramebuffers(1, &m_framebuffer);
            m_gl.DeleteRenderbuffers(1, &m_renderbuffer);
        }
    }

    static Result<std::unique_ptr<Painter>> Make(int width, int height)
    {
        Result<std::unique_ptr<Context>> context = CreateContext(Backend::Auto);
        if (!context)
        {
            return context.GetError();
        }
        if (Result<void> current = (*context)->MakeCurrent(); !current)
        {
            return current.GetError();
        }
        GlFunctions gl;
        if (const std::string missing = gl.Load(**context); !missing.empty())
        {
            return Error{ErrorKind::Absent, "The GL library lacks " + missing + "."};
        }
        return std::unique_ptr<Painter>(
            std::make_unique<FloorPainter>(std::move(*context), gl, width, height));
    }

    Result<void> Submit(const DrawList&, const Camera&) override
    {
        if (Result<void> current = m_context->MakeCurrent(); !current)
        {
            return current;
        }
        m_gl.Clear(GL_COLOR_BUFFER_BIT);
        m_gl.Flush();
        return {};
    }
    Result<void> Read() override
    {
        m_gl.ReadPixels(0, 0, m_frame.width, m_frame.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        m_frame.rgba.data());
        if (m_gl.GetError() != GL_NO_ERROR)
        {
            return Error{ErrorKind::Failed, "GL failed to clear and read a picture."};
        }
        return {};
    }
    Frame Picture() const override { return m_frame; }
    std::string Description() const override { return "GL"; }

private:
    std::unique_ptr<Context> m_context;
    GlFunctions m_gl;
    Frame m_frame;
    GLuint m_framebuffer = 0;
    GLuint m_renderbuffer = 0;
};

} // namespace

const std::vector<Method>& Methods()
{
    static const std::vector<Method> methods{
        {"boxreel " BOXREEL_VERSION, RendererPainter::Make, FloorPainter::Make, true}};
    return methods;
}

} // namespace bench
