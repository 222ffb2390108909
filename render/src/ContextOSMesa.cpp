// SPDX-License-Identifier: MIT
#include "Context.h"

#include <dlfcn.h>

#include <array>

namespace boxreel
{
namespace
{

// The attributes of OSMesaCreateContextAttribs and the types of glMakeCurrent's buffer. They are
// part of the library's binary interface; naming them here lets the toolkit build where its header
// is not installed.
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

/// The library's functions, by the names it exports.
struct OSMesa
{
    void* (*createContextAttribs)(const int*, void*) = nullptr;
    void (*destroyContext)(void*) = nullptr;
    unsigned char (*makeCurrent)(void*, void*, unsigned, int, int) = nullptr;
    void* (*getCurrentContext)() = nullptr;
    void* (*getProcAddress)(const char*) = nullptr;

    bool Load(void* library)
    {
        return Find(library, "OSMesaCreateContextAttribs", createContextAttribs) &&
               Find(library, "OSMesaDestroyContext", destroyContext) &&
               Find(library, "OSMesaMakeCurrent", makeCurrent) &&
               Find(library, "OSMesaGetCurrentContext", getCurrentContext) &&
               Find(library, "OSMesaGetProcAddress", getProcAddress);
    }

private:
    template <class Function>
    static bool Find(void* library, const char* name, Function& function)
    {
        function = reinterpret_cast<Function>(dlsym(library, name));
        return function != nullptr;
    }
};

class OSMesaContext final : public Context
{
public:
    OSMesaContext(const OSMesa& mesa, void* context) : m_mesa(mesa), m_context(context) {}
    OSMesaContext(const OSMesaContext&) = delete;
    OSMesaContext& operator=(const OSMesaContext&) = delete;
    ~OSMesaContext() override { m_mesa.destroyContext(m_context); }

    Result<void> MakeCurrent() override
    {
        if (m_mesa.getCurrentContext() == m_context ||
            m_mesa.makeCurrent(m_context, m_pixel.data(), kUnsignedByte, 1, 1))
        {
            return {};
        }
        return Error{ErrorKind::Failed, "OSMesa refused to make its GL context current"};
    }

    void* ProcAddress(const char* name) const override { return m_mesa.getProcAddress(name); }
    const char* BackEnd() const override { return "OSMesa"; }

private:
    OSMesa m_mesa;
    void* m_context;
    // OSMesa insists on a buffer of its own; one pixel keeps its copy at every flush free.
    std::array<unsigned char, 4> m_pixel{};
};

} // namespace

Result<std::unique_ptr<Context>> CreateOSMesaContext(const std::string& library)
{
    // Local, so that its GL symbols never meet those of another GL library in this process; and
    // never closed, because Mesa's worker threads and thread-local data outlive a context.
    void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr)
    {
        const char* const reason = dlerror();
        return Error{ErrorKind::Absent, "cannot draw: the library " + library + " did not load (" +
                                            (reason ? reason : "no reason given") +
                                            "); install it with: apt install libosmesa6"};
    }
    OSMesa mesa;
    if (!mesa.Load(handle))
    {
        return Error{ErrorKind::Absent,
                     "cannot draw: " + library +
                         " lacks functions of OSMesa 11.2; install a newer one with: "
                         "apt install libosmesa6"};
    }
    const int attributes[] = {
        kFormat,  kFormatRgba,  kDepthBits,    0, kStencilBits,  0, kAccumBits, 0,
        kProfile, kCoreProfile, kMajorVersion, 3, kMinorVersion, 3, 0,          0};
    void* const context = mesa.createContextAttribs(attributes, nullptr);
    if (context == nullptr)
    {
        return Error{ErrorKind::Absent,
                     "cannot draw: " + library +
                         " offers no GL 3.3 core context; install Mesa 17 or newer with: "
                         "apt install libosmesa6"};
    }
    return std::unique_ptr<Context>(std::make_unique<OSMesaContext>(mesa, context));
}

} // namespace boxreel
