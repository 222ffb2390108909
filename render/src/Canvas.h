// SPDX-License-Identifier: MIT
#pragma once

#include "GlFunctions.h"
#include "OverlayMesh.h"
#include "Shaders.h"

#include <base/Result.h>
#include <render/Frame.h>
#include <render/Overlay.h>

#include <array>
#include <memory>
#include <optional>

/// The GL side of a Renderer: its framebuffer, programs and buffers. Owned by Renderer, which makes
/// the context current before every call, including the destructor. Programs are compiled on first
/// use, because each takes a few milliseconds.
namespace boxreel
{

class Canvas
{
public:
    static Result<std::unique_ptr<Canvas>> Create(const Context& context, int width, int height,
                                                  double scale);
    ~Canvas();
    Canvas(const Canvas&) = delete;
    Canvas& operator=(const Canvas&) = delete;

    /// Premultiplied, 0 to 1.
    void Clear(const std::array<float, 4>& background);
    Result<void> Draw(std::span<const Batch> batches);

    /// Draws the parts of the overlay in the rectangles, which do not overlap.
    Result<void> Draw(const Overlay& overlay, std::span<const PixelBounds> rectangles);
    void Flush() { m_gl.Flush(); }

    /// Reads the pixels of the rectangles into a frame of the canvas's size.
    Result<void> Read(std::span<const PixelBounds> rectangles, Frame& frame);

    /// Copies the picture to the default framebuffer of the window.
    void CopyToScreen();

    /// Returns the GL renderer, e.g. "llvmpipe (LLVM 15.0.6, 256 bits), 4.5 (Core Profile) Mesa
    /// 22.3.6".
    std::string Description() const;

private:
    struct Program
    {
        GLuint program = 0;
        GLint first = -1; // uniform location of the first vector's index
        std::size_t vectors = 0;
    };

    Canvas(const GlFunctions& gl, int width, int height, double scale)
        : m_gl(gl), m_width(width), m_height(height), m_scale(scale)
    {}
    Result<void> MakeTarget();
    Result<GLuint> Compile(GLenum stage, const std::string& source);
    Result<Program> Link(const ShaderSource& source);
    Result<const Program*> Need(ProgramKind kind, Form form);
    Result<const Program*> NeedMesh();
    void NeedFont();
    void NeedQuads(std::size_t count);
    Result<void> DrawFitting(std::span<const Batch> batches);
    Result<void> DrawSliced(const Batch& batch);
    void MakeRoom(std::size_t vectors);
    void DrawInstances(const Batch& batch, const Program& program, std::size_t first,
                       std::size_t count);

    GlFunctions m_gl;
    int m_width;
    int m_height;
    double m_scale; // of the text
    GLuint m_framebuffer = 0;
    GLuint m_renderbuffer = 0;
    GLuint m_instances = 0;        // a buffer of vectors of four floats
    GLuint m_instancesTexture = 0; // the same buffer as a texture
    std::size_t m_mostVectors = 0; // capacity of the buffer
    GLuint m_quadArray = 0;
    GLuint m_quadIndices = 0;
    std::size_t m_quads = 0; // capacity of the index buffer
    GLuint m_meshArray = 0;
    GLuint m_meshCorners = 0;
    GLuint m_font = 0;
    std::array<std::array<std::optional<Program>, kForms>, kProgramKinds> m_programs;
    std::optional<Program> m_meshProgram;
    OverlayMesh m_mesh; // mesh of the last overlay; keeps its memory
};

} // namespace boxreel
