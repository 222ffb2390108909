// SPDX-License-Identifier: MIT
#include "Canvas.h"

#include "FontAtlas.h"

#include <base/ErrorMacros.h>

#include <algorithm>
#include <cstddef>

namespace boxreel
{
namespace
{

constexpr std::size_t kVectorBytes = 4 * sizeof(float);

// Texture units.
constexpr GLint kFontUnit = 0;
constexpr GLint kInstancesUnit = 1;

// Initial number of quads in the index buffer; doubled when it is too small.
constexpr std::size_t kFirstQuads = 4096;

std::size_t VectorsOf(const Batch& batch)
{
    return batch.data.size() / 4;
}

const void* Offset(std::size_t bytes)
{
    // OpenGL passes offsets as pointers. NOLINTNEXTLINE(performance-no-int-to-ptr)
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
        return Error{ErrorKind::Absent, context.BackEnd(), "lacks the GL function " + missing,
                     "install Mesa 17 or newer"};
    }
    std::unique_ptr<Canvas> canvas(new Canvas(gl, width, height, scale));
    RETURN_IF_ERROR(canvas->MakeTarget());
    return canvas;
}

Canvas::~Canvas()
{
    const auto drop = [this](const std::optional<Program>& program) {
        if (program)
        {
            m_gl.DeleteProgram(program->program);
        }
    };
    for (const auto& ofKind : m_programs)
    {
        std::for_each(ofKind.begin(), ofKind.end(), drop);
    }
    drop(m_meshProgram);
    const GLuint arrays[] = {m_quadArray, m_meshArray};
    m_gl.DeleteVertexArrays(2, arrays);
    const GLuint buffers[] = {m_instances, m_quadIndices, m_meshCorners};
    m_gl.DeleteBuffers(3, buffers);
    const GLuint textures[] = {m_font, m_instancesTexture};
    m_gl.DeleteTextures(2, textures);
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
        return Error{ErrorKind::Failed, std::to_string(m_width) + "x" + std::to_string(m_height),
                     "GL has not enough memory for a picture of this size",
                     "choose a smaller size"};
    }
    m_gl.Viewport(0, 0, m_width, m_height);
    m_gl.Disable(GL_DITHER);
    m_gl.Enable(GL_PROGRAM_POINT_SIZE);
    m_gl.Enable(GL_BLEND);
    m_gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    m_gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (GLuint* const buffer : {&m_instances, &m_quadIndices, &m_meshCorners})
    {
        m_gl.GenBuffers(1, buffer);
    }
    m_gl.GenVertexArrays(1, &m_quadArray);
    m_gl.GenVertexArrays(1, &m_meshArray);
    m_gl.GenTextures(1, &m_instancesTexture);
    m_gl.ActiveTexture(GL_TEXTURE0 + kInstancesUnit);
    m_gl.BindTexture(GL_TEXTURE_BUFFER, m_instancesTexture);
    m_gl.ActiveTexture(GL_TEXTURE0 + kFontUnit);
    GLint maximum = 0;
    m_gl.GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &maximum);
    m_mostVectors = std::size_t(maximum);
    return {};
}

Result<GLuint> Canvas::Compile(GLenum stage, const std::string& source)
{
    const GLuint shader = m_gl.CreateShader(stage);
    const char* const text = source.c_str();
    m_gl.ShaderSource(shader, 1, &text, nullptr);
    m_gl.CompileShader(shader);
    return shader; // errors are reported by linking
}

Result<Canvas::Program> Canvas::Link(const ShaderSource& source)
{
    const Result<GLuint> vertex = Compile(GL_VERTEX_SHADER, source.vertex);
    const Result<GLuint> fragment = Compile(GL_FRAGMENT_SHADER, source.fragment);
    Program made;
    made.vectors = std::size_t(source.vectors);
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
        return Error{ErrorKind::Failed, "GL", "cannot compile a shader (" + log + ")"};
    }
    m_gl.UseProgram(made.program);
    m_gl.Uniform2f(m_gl.GetUniformLocation(made.program, "pixelToClip"), 2.0f / float(m_width),
                   2.0f / float(m_height));
    m_gl.Uniform1i(m_gl.GetUniformLocation(made.program, "font"), kFontUnit);
    m_gl.Uniform1i(m_gl.GetUniformLocation(made.program, "instances"), kInstancesUnit);
    made.first = m_gl.GetUniformLocation(made.program, "first");
    return made;
}

Result<const Canvas::Program*> Canvas::Need(ProgramKind kind, Form form)
{
    std::optional<Program>& program = m_programs[std::size_t(kind)][std::size_t(form)];
    if (!program)
    {
        ASSIGN_OR_RETURN(Program made, Link(InstancedShader(kind, form)));
        program = made;
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
    if (!m_meshProgram)
    {
        ASSIGN_OR_RETURN(Program made, Link(MeshShader()));
        m_meshProgram = made;
        m_gl.BindVertexArray(m_meshArray);
        m_gl.BindBuffer(GL_ARRAY_BUFFER, m_meshCorners);
        m_gl.EnableVertexAttribArray(0);
        m_gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(MeshCorner),
                                 Offset(offsetof(MeshCorner, pixel)));
        const auto plane = [this](GLuint index, GLint size, std::size_t offset) {
            m_gl.EnableVertexAttribArray(index);
            m_gl.VertexAttribIPointer(index, size, GL_INT, sizeof(MeshCorner), Offset(offset));
        };
        plane(1, 4, offsetof(MeshCorner, ink));
        plane(2, 4, offsetof(MeshCorner, inkX));
        plane(3, 4, offsetof(MeshCorner, inkY));
        plane(4, 4, offsetof(MeshCorner, texel));
        plane(5, 2, offsetof(MeshCorner, texelY));
    }
    return &*m_meshProgram;
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
    for (const auto& [name, value] : {std::pair<GLenum, GLint>{GL_TEXTURE_MIN_FILTER, GL_NEAREST},
                                      {GL_TEXTURE_MAG_FILTER, GL_NEAREST},
                                      {GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE},
                                      {GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE}})
    {
        m_gl.TexParameteri(GL_TEXTURE_2D, name, value);
    }
    m_gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8UI, atlas.Width(), atlas.Height(), 0, GL_RED_INTEGER,
                    GL_UNSIGNED_BYTE, atlas.Coverage());
}

void Canvas::Clear(const std::array<float, 4>& background)
{
    m_gl.ClearColor(background[0], background[1], background[2], background[3]);
    m_gl.Clear(GL_COLOR_BUFFER_BIT);
}

/// Two triangles per quad; the vertex shader places the corners.
void Canvas::NeedQuads(std::size_t count)
{
    m_gl.BindVertexArray(m_quadArray);
    if (count <= m_quads)
    {
        return;
    }
    m_quads = std::max({count, 2 * m_quads, kFirstQuads});
    std::vector<GLuint> indices;
    indices.reserve(6 * m_quads);
    for (GLuint corner = 0; corner < GLuint(4 * m_quads); corner += 4)
    {
        for (const GLuint index : {0u, 1u, 2u, 2u, 1u, 3u})
        {
            indices.push_back(corner + index);
        }
    }
    m_gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_quadIndices);
    m_gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(GLuint)),
                    indices.data(), GL_STATIC_DRAW);
}

Result<void> Canvas::Draw(std::span<const Batch> batches)
{
    std::size_t total = 0;
    std::size_t maximum = 0;
    for (const Batch& batch : batches)
    {
        total += VectorsOf(batch);
        maximum = std::max(maximum, batch.instances);
    }
    if (total == 0)
    {
        return {};
    }
    NeedQuads(maximum);
    if (total <= m_mostVectors)
    {
        MakeRoom(total);
        return DrawFitting(batches);
    }
    for (const Batch& batch : batches)
    {
        RETURN_IF_ERROR(DrawSliced(batch));
    }
    return {};
}

void Canvas::MakeRoom(std::size_t vectors)
{
    m_gl.BindBuffer(GL_TEXTURE_BUFFER, m_instances);
    m_gl.BufferData(GL_TEXTURE_BUFFER, GLsizeiptr(vectors * kVectorBytes), nullptr, GL_STREAM_DRAW);
    m_gl.ActiveTexture(GL_TEXTURE0 + kInstancesUnit);
    m_gl.TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, m_instances);
    m_gl.ActiveTexture(GL_TEXTURE0 + kFontUnit);
}

Result<void> Canvas::DrawFitting(std::span<const Batch> batches)
{
    std::size_t first = 0;
    for (const Batch& batch : batches)
    {
        m_gl.BufferSubData(GL_TEXTURE_BUFFER, GLintptr(first * kVectorBytes),
                           GLsizeiptr(batch.data.size() * sizeof(float)), batch.data.data());
        first += VectorsOf(batch);
    }
    first = 0;
    for (const Batch& batch : batches)
    {
        ASSIGN_OR_RETURN(const Program* program, Need(batch.kind, batch.form));
        DrawInstances(batch, *program, first, batch.instances);
        first += VectorsOf(batch);
    }
    return {};
}

/// For a GL whose maximum texture size is too small for all instances.
Result<void> Canvas::DrawSliced(const Batch& batch)
{
    ASSIGN_OR_RETURN(const Program* program, Need(batch.kind, batch.form));
    const std::size_t vectors = program->vectors;
    const std::size_t maximum = m_mostVectors / vectors;
    for (std::size_t done = 0; done < batch.instances; done += maximum)
    {
        const std::size_t count = std::min(maximum, batch.instances - done);
        MakeRoom(count * vectors);
        m_gl.BufferSubData(GL_TEXTURE_BUFFER, 0, GLsizeiptr(count * vectors * kVectorBytes),
                           batch.data.data() + done * vectors * 4);
        DrawInstances(batch, *program, 0, count);
    }
    return {};
}

void Canvas::DrawInstances(const Batch& batch, const Program& program, std::size_t first,
                           std::size_t count)
{
    m_gl.UseProgram(program.program);
    m_gl.Uniform1i(program.first, GLint(first));
    const bool wipes = batch.kind == ProgramKind::Ground;
    if (wipes)
    {
        m_gl.Disable(GL_BLEND);
    }
    if (batch.form == Form::Square)
    {
        m_gl.DrawArrays(GL_POINTS, 0, GLsizei(count));
    }
    else
    {
        m_gl.DrawElements(GL_TRIANGLES, GLsizei(6 * count), GL_UNSIGNED_INT, nullptr);
    }
    if (wipes)
    {
        m_gl.Enable(GL_BLEND);
    }
}

Result<void> Canvas::Draw(const Overlay& overlay, std::span<const PixelBounds> rectangles)
{
    if (overlay.IsEmpty())
    {
        return {};
    }
    const FontAtlas& atlas = FontAtlas::Get(m_scale);
    BuildMesh(overlay, rectangles, atlas.Width(), atlas.Height(), m_mesh);
    if (m_mesh.runs.empty())
    {
        return {};
    }
    ASSIGN_OR_RETURN(const Program* program, NeedMesh());
    m_gl.UseProgram(program->program);
    m_gl.BindVertexArray(m_meshArray);
    m_gl.BindBuffer(GL_ARRAY_BUFFER, m_meshCorners);
    m_gl.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(m_mesh.corners.size() * sizeof(MeshCorner)),
                    m_mesh.corners.data(), GL_STREAM_DRAW);
    m_gl.Enable(GL_SCISSOR_TEST);
    for (const MeshRun& run : m_mesh.runs)
    {
        const PixelBounds& b = run.bounds;
        m_gl.Scissor(b.x0, b.y0, b.x1 - b.x0, b.y1 - b.y0);
        m_gl.DrawArrays(GL_TRIANGLES, GLint(run.first), GLsizei(run.count));
    }
    m_gl.Disable(GL_SCISSOR_TEST);
    return {};
}

Result<void> Canvas::Read(std::span<const PixelBounds> rectangles, Frame& frame)
{
    m_gl.PixelStorei(GL_PACK_ROW_LENGTH, m_width);
    for (const PixelBounds& r : rectangles)
    {
        m_gl.ReadPixels(r.x0, r.y0, r.x1 - r.x0, r.y1 - r.y0, GL_RGBA, GL_UNSIGNED_BYTE,
                        frame.Pixel(r.x0, r.y0));
    }
    if (const GLenum error = m_gl.GetError(); error != GL_NO_ERROR)
    {
        return Error{ErrorKind::Failed, "GL",
                     "cannot draw the picture (error " + std::to_string(error) +
                         (error == GL_OUT_OF_MEMORY ? ", out of memory)" : ")"),
                     error == GL_OUT_OF_MEMORY ? "choose a smaller size" : ""};
    }
    return {};
}

void Canvas::CopyToScreen()
{
    m_gl.Disable(GL_SCISSOR_TEST);
    m_gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    // Frame rows run from top to bottom, those of the screen from bottom to top.
    m_gl.BlitFramebuffer(0, 0, m_width, m_height, 0, m_height, m_width, 0, GL_COLOR_BUFFER_BIT,
                         GL_NEAREST);
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
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
