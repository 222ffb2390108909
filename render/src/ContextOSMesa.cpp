// SPDX-License-Identifier: MIT
#include "Context.h"
#include "ContextLibrary.h"

#include <base/ErrorMacros.h>

#include <array>

namespace boxreel
{
namespace
{

// Attributes of OSMesaCreateContextAttribs and types of glMakeCurrent's buffer. They are part of
// the library's binary interface; defining them here allows a build without its header.
constexpr int kFormat = 0x22;
constexpr int kDepthBits = 0x30;
constexpr int kStencilBits = 0x31;
constexpr int kAccumBits = 0x32;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36;
constexpr int kMinorVersion = 0x37;
constexpr int kFormatRgba = 0x1908;
constexpr unsigned kUnsignedByte = 0x1401;

constexpr const char* kPackages = "libosmesa6 (Mesa 25.1 and later have none)";

/// Functions of the library, by their exported names.
struct OSMesa
{
    void* (*createContextAttribs)(const int*, void*) = nullptr;
    void (*destroyContext)(void*) = nullptr;
    unsigned char (*makeCurrent)(void*, void*, unsigned, int, int) = nullptr;
    void* (*getCurrentContext)() = nullptr;
    void* (*getProcAddress)(const char*) = nullptr;

    bool Load(const SharedLibrary& library)
    {
        return library.Bind("OSMesaCreateContextAttribs", createContextAttribs) &&
               library.Bind("OSMesaDestroyContext", destroyContext) &&
               library.Bind("OSMesaMakeCurrent", makeCurrent) &&
               library.Bind("OSMesaGetCurrentContext", getCurrentContext) &&
               library.Bind("OSMesaGetProcAddress", getProcAddress);
    }
};

class OSMesaContext final : public Context
{
public:
    OSMesaContext(const OSMesa& mesa, void* context) : m_mesa(mesa), m_context(context) {}
    ~OSMesaContext() override
    {
        Leave();
        m_mesa.destroyContext(m_context);
    }

    void* ProcAddress(const char* name) const override { return m_mesa.getProcAddress(name); }
    const char* BackEnd() const override { return "OSMesa"; }

protected:
    bool IsCurrent() const override { return m_mesa.getCurrentContext() == m_context; }

    Result<void> Bind() override
    {
        if (m_mesa.makeCurrent(m_context, m_pixel.data(), kUnsignedByte, 1, 1))
        {
            return {};
        }
        return Error{ErrorKind::Failed, "OSMesa", "cannot make its GL context current"};
    }

    void Unbind() override { m_mesa.makeCurrent(nullptr, nullptr, 0, 0, 0); }

private:
    OSMesa m_mesa;
    void* m_context;
    // OSMesa requires a client buffer; with one pixel its copy at every flush costs nothing.
    std::array<unsigned char, 4> m_pixel{};
};

} // namespace

Result<std::unique_ptr<Context>> CreateOSMesaContext(const std::string& library)
{
    ASSIGN_OR_RETURN(const SharedLibrary opened, OpenContextLibrary(library, kPackages));
    OSMesa mesa;
    if (!mesa.Load(opened))
    {
        return opened.MissingError("functions of OSMesa 11.2");
    }
    const int attributes[] = {
        kFormat,  kFormatRgba,  kDepthBits,    0, kStencilBits,  0, kAccumBits, 0,
        kProfile, kCoreProfile, kMajorVersion, 3, kMinorVersion, 3, 0,          0};
    void* const context = mesa.createContextAttribs(attributes, nullptr);
    if (context == nullptr)
    {
        return opened.MissingError("a GL 3.3 core context, which Mesa has since version 17");
    }
    return std::unique_ptr<Context>(std::make_unique<OSMesaContext>(mesa, context));
}

} // namespace boxreel
