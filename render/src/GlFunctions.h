// SPDX-License-Identifier: MIT
#pragma once

#include "Context.h"

#include <GL/glcorearb.h>

#include <string>

/// The GL functions of the renderer, loaded at run time. One table per context, so that two back
/// ends work in one process and GL is never linked.
namespace boxreel
{

// F(type, name): type as in glcorearb.h without PFNGL and PROC.
#define BOXREEL_GL_FUNCTIONS(F)                                                                    \
    F(ACTIVETEXTURE, ActiveTexture)                                                                \
    F(ATTACHSHADER, AttachShader)                                                                  \
    F(BINDBUFFER, BindBuffer)                                                                      \
    F(BINDFRAMEBUFFER, BindFramebuffer)                                                            \
    F(BINDRENDERBUFFER, BindRenderbuffer)                                                          \
    F(BINDTEXTURE, BindTexture)                                                                    \
    F(BINDVERTEXARRAY, BindVertexArray)                                                            \
    F(BLENDFUNC, BlendFunc)                                                                        \
    F(BLITFRAMEBUFFER, BlitFramebuffer)                                                            \
    F(BUFFERDATA, BufferData)                                                                      \
    F(BUFFERSUBDATA, BufferSubData)                                                                \
    F(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus)                                              \
    F(CLEAR, Clear)                                                                                \
    F(CLEARCOLOR, ClearColor)                                                                      \
    F(COMPILESHADER, CompileShader)                                                                \
    F(CREATEPROGRAM, CreateProgram)                                                                \
    F(CREATESHADER, CreateShader)                                                                  \
    F(DELETEBUFFERS, DeleteBuffers)                                                                \
    F(DELETEFRAMEBUFFERS, DeleteFramebuffers)                                                      \
    F(DELETEPROGRAM, DeleteProgram)                                                                \
    F(DELETERENDERBUFFERS, DeleteRenderbuffers)                                                    \
    F(DELETESHADER, DeleteShader)                                                                  \
    F(DELETETEXTURES, DeleteTextures)                                                              \
    F(DELETEVERTEXARRAYS, DeleteVertexArrays)                                                      \
    F(DISABLE, Disable)                                                                            \
    F(DRAWARRAYS, DrawArrays)                                                                      \
    F(DRAWELEMENTS, DrawElements)                                                                  \
    F(ENABLE, Enable)                                                                              \
    F(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray)                                            \
    F(FLUSH, Flush)                                                                                \
    F(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer)                                            \
    F(GENBUFFERS, GenBuffers)                                                                      \
    F(GENFRAMEBUFFERS, GenFramebuffers)                                                            \
    F(GENRENDERBUFFERS, GenRenderbuffers)                                                          \
    F(GENTEXTURES, GenTextures)                                                                    \
    F(GENVERTEXARRAYS, GenVertexArrays)                                                            \
    F(GETERROR, GetError)                                                                          \
    F(GETINTEGERV, GetIntegerv)                                                                    \
    F(GETPROGRAMINFOLOG, GetProgramInfoLog)                                                        \
    F(GETPROGRAMIV, GetProgramiv)                                                                  \
    F(GETSTRING, GetString)                                                                        \
    F(GETUNIFORMLOCATION, GetUniformLocation)                                                      \
    F(LINKPROGRAM, LinkProgram)                                                                    \
    F(PIXELSTOREI, PixelStorei)                                                                    \
    F(READPIXELS, ReadPixels)                                                                      \
    F(RENDERBUFFERSTORAGE, RenderbufferStorage)                                                    \
    F(SCISSOR, Scissor)                                                                            \
    F(SHADERSOURCE, ShaderSource)                                                                  \
    F(TEXBUFFER, TexBuffer)                                                                        \
    F(TEXIMAGE2D, TexImage2D)                                                                      \
    F(TEXPARAMETERI, TexParameteri)                                                                \
    F(UNIFORM1I, Uniform1i)                                                                        \
    F(UNIFORM2F, Uniform2f)                                                                        \
    F(USEPROGRAM, UseProgram)                                                                      \
    F(VERTEXATTRIBIPOINTER, VertexAttribIPointer)                                                  \
    F(VERTEXATTRIBPOINTER, VertexAttribPointer)                                                    \
    F(VIEWPORT, Viewport)

struct GlFunctions
{
#define BOXREEL_GL_MEMBER(type, name) PFNGL##type##PROC name = nullptr;
    BOXREEL_GL_FUNCTIONS(BOXREEL_GL_MEMBER)
#undef BOXREEL_GL_MEMBER

    /// Fills the table; returns the name of the first missing function, or an empty string.
    std::string Load(const Context& context)
    {
#define BOXREEL_GL_LOAD(type, name)                                                                \
    name = reinterpret_cast<PFNGL##type##PROC>(context.ProcAddress("gl" #name));                   \
    if (name == nullptr)                                                                           \
    {                                                                                              \
        return "gl" #name;                                                                         \
    }
        BOXREEL_GL_FUNCTIONS(BOXREEL_GL_LOAD)
#undef BOXREEL_GL_LOAD
        return {};
    }
};

} // namespace boxreel
