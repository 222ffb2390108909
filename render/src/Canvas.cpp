// SPDX-License-Identifier: MIT
#include "Canvas.h"

#include "FontAtlas.h"

#include <cstddef>

namespace boxreel
{
namespace
{

constexpr std::size_t kVectorBytes = 4 * sizeof(float);

const void* Offset(std::size_t bytes)
{
    return reinterpret_cast<const void*>(bytes);
}

} // namespace

Result<std::unique_ptr<Canvas>> Canvas::Create(const Context& context, int width, int height,
                                               double scale)
{
    GlFunctions gl;
    const std::string missing = gl.Load(context);
    if (!missing.empty())
    {
        return Error{ErrorKind::Absent, std::string("cannot draw: ") + context.BackEnd() +
                                            " lacks the GL function " + missing +
                                            "; install Mesa 17 or newer"};
    }
    std::unique_ptr<Canvas> canvas(new Canvas(gl, width, height, scale));
    if (Result<void> made = canvas->MakeTarget(); !made)
    {
        return made.GetError();
    }
    return canvas;
}

Canvas::~Canvas()
{
    const auto drop = [this](const std::optional<Program>& program) {
        if (program)
        {
            m_gl.DeleteProgram(program->program);
            m_gl.DeleteVertexArrays(1, &program->vertexArray);
        }
    };
    for (const std::optional<Program>& program : m_programs)
    {
        drop(program);
    }
    drop(m_mesh);
    const GLuint buffers[] = {m_instances, m_meshVertices, m_meshIndices};
    m_gl.DeleteBuffers(3, buffers);
    m_gl.DeleteTextures(1, &m_font);
    m_gl.DeleteFramebuffers(1, &m_framebuffer);
    m_gl.DeleteRenderbuffers(1, &m_renderbuffer);
}

Result<void> Canvas::MakeTarget()
{
    m_gl.GenRenderbuffers(1, &m_renderbuffer);
    m_gl.BindRenderbuffer(GL_RENDERBUFFER, m_renderbuffer);
    m_gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, m_width, m_height);
    m_gl.GenFramebuffers(1, &m_framebuffer);
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
    m_gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                 m_renderbuffer);
    if (m_gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE ||
        m_gl.GetError() != GL_NO_ERROR)
    {
        return Error{ErrorKind::Failed,
                     "GL has no room for a picture of " + std::to_string(m_width) + " x " +
                         std::to_string(m_height) + " pixels; ask for a smaller size"};
    }
    m_gl.Viewport(0, 0, m_width, m_height);
    m_gl.Disable(GL_DITHER);
    m_gl.Enable(GL_BLEND);
    m_gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    m_gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    m_gl.GenBuffers(1, &m_instances);
    m_gl.GenBuffers(1, &m_meshVertices);
    m_gl.GenBuffers(1, &m_meshIndices);
    return {};
}

Result<GLuint> Canvas::Compile(GLenum stage, const std::string& source)
{
    const GLuint shader = m_gl.CreateShader(stage);
    const char* const text = source.c_str();
    m_gl.ShaderSource(shader, 1, &text, nullptr);
    m_gl.CompileShader(shader);
    return shader; // what is wrong with it, linking tells
}

Result<Canvas::Program> Canvas::Link(const ShaderSource& source)
{
    const Result<GLuint> vertex = Compile(GL_VERTEX_SHADER, source.vertex);
    const Result<GLuint> fragment = Compile(GL_FRAGMENT_SHADER, source.fragment);
    Program made;
    made.vectors = source.vectors;
    made.program = m_gl.CreateProgram();
    m_gl.AttachShader(made.program, *vertex);
    m_gl.AttachShader(made.program, *fragment);
    m_gl.LinkProgram(made.program);
    m_gl.DeleteShader(*vertex);
    m_gl.DeleteShader(*fragment);
    GLint linked = 0;
    m_gl.GetProgramiv(made.program, GL_LINK_STATUS, &linked);
    if (!linked)
    {
        std::string log(1000, '\0');
        GLsizei length = 0;
        m_gl.GetProgramInfoLog(made.program, GLsizei(log.size()), &length, log.data());
        m_gl.DeleteProgram(made.program);
        log.resize(std::size_t(length));
        return Error{ErrorKind::Failed,
                     "this GL does not accept a shader of boxreel's (" + log + ")"};
    }
    m_gl.UseProgram(made.program);
    m_gl.Uniform2f(m_gl.GetUniformLocation(made.program, "pixelToClip"), 2.0f / float(m_width),
                   2.0f / float(m_height));
    m_gl.GenVertexArrays(1, &made.vertexArray);
    return made;
}

Result<const Canvas::Program*> Canvas::Need(ProgramKind kind)
{
    std::optional<Program>& program = m_programs[std::size_t(kind)];
    if (!program)
    {
        Result<Program> made = Link(InstancedShader(kind));
        if (!made)
        {
            return made.GetError();
        }
        program = *made;
        m_gl.BindVertexArray(program->vertexArray);
        for (GLuint i = 0; i < GLuint(program->vectors); ++i)
        {
            m_gl.EnableVertexAttribArray(i);
            m_gl.VertexAttribDivisor(i, 1);
        }
    }
    if (kind == ProgramKind::Glyph)
    {
        NeedFont();
    }
    return &*program;
}

Result<const Canvas::Program*> Canvas::NeedMesh()
{
    NeedFont();
    if (!m_mesh)
    {
        Result<Program> made = Link(MeshShader());
        if (!made)
        {
            return made.GetError();
        }
        m_mesh = *made;
        m_gl.BindVertexArray(m_mesh->vertexArray);
        m_gl.BindBuffer(GL_ARRAY_BUFFER, m_meshVertices);
        m_gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_meshIndices);
        const auto attribute = [this](GLuint index, GLint size, GLenum type, GLboolean normalized,
                                      std::size_t offset) {
            m_gl.EnableVertexAttribArray(index);
            m_gl.VertexAttribPointer(index, size, type, normalized, sizeof(OverlayVertex),
                                     Offset(offset));
        };
        attribute(0, 2, GL_FLOAT, GL_FALSE, offsetof(OverlayVertex, position));
        attribute(1, 2, GL_FLOAT, GL_FALSE, offsetof(OverlayVertex, uv));
        attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(OverlayVertex, color));
    }
    return &*m_mesh;
}

void Canvas::NeedFont()
{
    if (m_font != 0)
    {
        return;
    }
    const FontAtlas& atlas = FontAtlas::Get(m_scale);
    m_gl.GenTextures(1, &m_font);
    m_gl.BindTexture(GL_TEXTURE_2D, m_font);
    for (const auto& [name, value] : {std::pair<GLenum, GLint>{GL_TEXTURE_MIN_FILTER, GL_LINEAR},
                                      {GL_TEXTURE_MAG_FILTER, GL_LINEAR},
                                      {GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE},
                                      {GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE}})
    {
        m_gl.TexParameteri(GL_TEXTURE_2D, name, value);
    }
    m_gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, atlas.Width(), atlas.Height(), 0, GL_RED,
                    GL_UNSIGNED_BYTE, atlas.Coverage());
}

void Canvas::Clear(Color background)
{
    const float alpha = float(background.a) / 255.0f;
    const float scale = alpha / 255.0f;
    m_gl.ClearColor(float(background.r) * scale, float(background.g) * scale,
                    float(background.b) * scale, alpha);
    m_gl.Clear(GL_COLOR_BUFFER_BIT);
}

Result<void> Canvas::Draw(std::span<const Batch> batches)
{
    std::size_t total = 0;
    for (const Batch& batch : batches)
    {
        total += batch.data.size() * sizeof(float);
    }
    if (total == 0)
    {
        return {};
    }
    m_gl.BindBuffer(GL_ARRAY_BUFFER, m_instances);
    m_gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(total), nullptr, GL_STREAM_DRAW);
    std::size_t offset = 0;
    for (const Batch& batch : batches)
    {
        m_gl.BufferSubData(GL_ARRAY_BUFFER, GLintptr(offset),
                           GLsizeiptr(batch.data.size() * sizeof(float)), batch.data.data());
        offset += batch.data.size() * sizeof(float);
    }
    offset = 0;
    for (const Batch& batch : batches)
    {
        const Result<const Program*> program = Need(batch.kind);
        if (!program)
        {
            return program.GetError();
        }
        DrawBatch(batch, **program, offset);
        offset += batch.data.size() * sizeof(float);
    }
    return {};
}

void Canvas::DrawBatch(const Batch& batch, const Program& program, std::size_t offset)
{
    m_gl.UseProgram(program.program);
    m_gl.BindVertexArray(program.vertexArray);
    const GLsizei stride = GLsizei(std::size_t(program.vectors) * kVectorBytes);
    for (GLuint i = 0; i < GLuint(program.vectors); ++i)
    {
        m_gl.VertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, stride,
                                 Offset(offset + i * kVectorBytes));
    }
    m_gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, GLsizei(batch.instances));
}

Result<void> Canvas::Draw(const Overlay& overlay)
{
    if (overlay.IsEmpty())
    {
        return {};
    }
    const Result<const Program*> program = NeedMesh();
    if (!program)
    {
        return program.GetError();
    }
    m_gl.UseProgram((*program)->program);
    m_gl.BindVertexArray((*program)->vertexArray);
    m_gl.BindBuffer(GL_ARRAY_BUFFER, m_meshVertices);
    m_gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(overlay.vertices.size() * sizeof(OverlayVertex)),
                    overlay.vertices.data(), GL_STREAM_DRAW);
    m_gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                    GLsizeiptr(overlay.indices.size() * sizeof(std::uint32_t)),
                    overlay.indices.data(), GL_STREAM_DRAW);
    m_gl.Enable(GL_SCISSOR_TEST);
    for (const OverlayCommand& command : overlay.commands)
    {
        if (command.clipX1 <= command.clipX0 || command.clipY1 <= command.clipY0)
        {
            continue;
        }
        m_gl.Scissor(command.clipX0, command.clipY0, command.clipX1 - command.clipX0,
                     command.clipY1 - command.clipY0);
        m_gl.DrawElements(GL_TRIANGLES, GLsizei(command.indexCount), GL_UNSIGNED_INT,
                          Offset(command.firstIndex * sizeof(std::uint32_t)));
    }
    m_gl.Disable(GL_SCISSOR_TEST);
    return {};
}

Result<void> Canvas::Read(Frame& frame)
{
    if (frame.width != m_width || frame.height != m_height ||
        frame.rgba.size() != std::size_t(m_width) * std::size_t(m_height) * 4)
    {
        frame = Frame(m_width, m_height);
    }
    m_gl.ReadPixels(0, 0, m_width, m_height, GL_RGBA, GL_UNSIGNED_BYTE, frame.rgba.data());
    if (const GLenum error = m_gl.GetError(); error != GL_NO_ERROR)
    {
        return Error{
            ErrorKind::Failed,
            "GL failed to draw the picture (error " + std::to_string(error) +
                (error == GL_OUT_OF_MEMORY ? ", out of memory; ask for a smaller size)" : ")")};
    }
    return {};
}

std::string Canvas::Description() const
{
    const auto text = [this](GLenum name) {
        const GLubyte* const value = m_gl.GetString(name);
        return std::string(value ? reinterpret_cast<const char*>(value) : "unknown");
    };
    return text(GL_RENDERER) + ", " + text(GL_VERSION);
}

} // namespace boxreel
