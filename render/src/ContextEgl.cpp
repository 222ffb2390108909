// SPDX-License-Identifier: MIT
#include "Context.h"
#include "ContextLibrary.h"

#include <base/ErrorMacros.h>

#include <cstdio>
#include <string_view>
#include <vector>

namespace boxreel
{
namespace
{

// Constants of EGL 1.5 and its extensions. They are part of the library's binary interface;
// defining them here allows a build without its headers.
constexpr int kExtensions = 0x3055;               // EGL_EXTENSIONS
constexpr int kNone = 0x3038;                     // EGL_NONE
constexpr int kMajorVersion = 0x3098;             // EGL_CONTEXT_MAJOR_VERSION
constexpr int kMinorVersion = 0x30FB;             // EGL_CONTEXT_MINOR_VERSION
constexpr int kProfileMask = 0x30FD;              // EGL_CONTEXT_OPENGL_PROFILE_MASK
constexpr int kCoreProfile = 1;                   // EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT
constexpr unsigned kOpenGl = 0x30A2;              // EGL_OPENGL_API
constexpr unsigned kDevicePlatform = 0x313F;      // EGL_PLATFORM_DEVICE_EXT
constexpr unsigned kSurfacelessPlatform = 0x31DD; // EGL_PLATFORM_SURFACELESS_MESA
constexpr unsigned kRenderer = 0x1F01;            // GL_RENDERER

constexpr int kMaxDevices = 32; // more than the GPUs of a machine

constexpr const char* kPackages = "libegl1 libegl-mesa0 libgl1-mesa-dri";

/// Functions of the library; displays, devices, configurations and contexts are pointers.
struct Egl
{
    void* (*getProcAddress)(const char*) = nullptr;
    const char* (*queryString)(void*, int) = nullptr;
    int (*getError)() = nullptr;
    unsigned (*bindApi)(unsigned) = nullptr;
    unsigned (*initialize)(void*, int*, int*) = nullptr;
    void* (*createContext)(void*, void*, void*, const int*) = nullptr;
    unsigned (*destroyContext)(void*, void*) = nullptr;
    unsigned (*makeCurrent)(void*, void*, void*, void*) = nullptr;
    void* (*getCurrentContext)() = nullptr;
    void* (*getPlatformDisplay)(unsigned, void*, const int*) = nullptr;
    // Functions of optional extensions.
    unsigned (*queryDevices)(int, void**, int*) = nullptr;
    const char* (*queryDeviceString)(void*, int) = nullptr;

    bool Load(const SharedLibrary& library)
    {
        return library.Bind("eglGetProcAddress", getProcAddress) &&
               library.Bind("eglQueryString", queryString) &&
               library.Bind("eglGetError", getError) && library.Bind("eglBindAPI", bindApi) &&
               library.Bind("eglInitialize", initialize) &&
               library.Bind("eglCreateContext", createContext) &&
               library.Bind("eglDestroyContext", destroyContext) &&
               library.Bind("eglMakeCurrent", makeCurrent) &&
               library.Bind("eglGetCurrentContext", getCurrentContext) &&
               FindExtension("eglGetPlatformDisplayEXT", getPlatformDisplay);
    }

    template <class Function>
    bool FindExtension(const char* name, Function& function) const
    {
        function = reinterpret_cast<Function>(getProcAddress(name));
        return function != nullptr;
    }
};

/// True if a space-separated list contains the word. The list may be null.
bool HasWord(const char* list, std::string_view word)
{
    std::string_view rest = list ? list : "";
    while (!rest.empty())
    {
        const std::size_t end = rest.find(' ');
        if (rest.substr(0, end) == word)
        {
            return true;
        }
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    return false;
}

/// A platform and device that may provide a context.
struct Place
{
    std::string name; ///< display name
    void* display = nullptr;
};

/// Returns the devices of the requested type. The last entry, if supported, has no device: Mesa
/// chooses, and only the created context shows which renderer it is.
std::vector<Place> PlacesOf(Egl& egl, bool onGpu)
{
    std::vector<Place> places;
    const char* const extensions = egl.queryString(nullptr, kExtensions);
    if (HasWord(extensions, "EGL_EXT_platform_device") &&
        egl.FindExtension("eglQueryDevicesEXT", egl.queryDevices) &&
        egl.FindExtension("eglQueryDeviceStringEXT", egl.queryDeviceString))
    {
        void* devices[kMaxDevices] = {};
        int count = 0;
        egl.queryDevices(kMaxDevices, devices, &count);
        for (int i = 0; i < count; ++i)
        {
            const char* const abilities = egl.queryDeviceString(devices[i], kExtensions);
            if (HasWord(abilities, "EGL_MESA_device_software") != onGpu)
            {
                places.push_back({"device " + std::to_string(i),
                                  egl.getPlatformDisplay(kDevicePlatform, devices[i], nullptr)});
            }
        }
    }
    if (HasWord(extensions, "EGL_MESA_platform_surfaceless"))
    {
        places.push_back({"the surfaceless platform",
                          egl.getPlatformDisplay(kSurfacelessPlatform, nullptr, nullptr)});
    }
    return places;
}

bool IsSoftware(const std::string& renderer)
{
    for (const char* const name : {"llvmpipe", "softpipe", "Software Rasterizer", "SwiftShader"})
    {
        if (renderer.find(name) != std::string::npos)
        {
            return true;
        }
    }
    return false;
}

class EglContext final : public Context
{
public:
    EglContext(const Egl& egl, void* display, void* context)
        : m_egl(egl), m_display(display), m_context(context)
    {}
    ~EglContext() override
    {
        Leave();
        m_egl.destroyContext(m_display, m_context);
        // The display is shared by all users of the library, so it is never terminated.
    }

    void* ProcAddress(const char* name) const override { return m_egl.getProcAddress(name); }
    const char* BackEnd() const override { return "EGL"; }

    /// Returns the renderer of the current context.
    std::string RendererName() const
    {
        using GetString = const unsigned char* (*)(unsigned);
        const auto getString = reinterpret_cast<GetString>(ProcAddress("glGetString"));
        const unsigned char* const text = getString ? getString(kRenderer) : nullptr;
        return text ? reinterpret_cast<const char*>(text) : "an unnamed renderer";
    }

protected:
    bool IsCurrent() const override { return m_egl.getCurrentContext() == m_context; }

    Result<void> Bind() override
    {
        if (m_egl.makeCurrent(m_display, nullptr, nullptr, m_context))
        {
            return {};
        }
        return Error{ErrorKind::Failed, "EGL", "cannot make its GL context current"};
    }

    void Unbind() override { m_egl.makeCurrent(m_display, nullptr, nullptr, nullptr); }

private:
    Egl m_egl;
    void* m_display;
    void* m_context;
};

std::string WithCode(const char* what, const Egl& egl)
{
    char text[80];
    std::snprintf(text, sizeof text, "%s (EGL error 0x%04x)", what, unsigned(egl.getError()));
    return text;
}

/// A context that draws as asked. The culprit of an Error is the place.
Result<std::unique_ptr<Context>> CreateAt(const Egl& egl, const Place& place, bool onGpu)
{
    void* const display = place.display;
    if (display == nullptr || !egl.initialize(display, nullptr, nullptr))
    {
        return Error{ErrorKind::Absent, place.name, WithCode("does not start", egl)};
    }
    egl.bindApi(kOpenGl); // for this thread
    const int attributes[] = {kMajorVersion, 3,    kMinorVersion, 3, kProfileMask,
                              kCoreProfile,  kNone};
    void* const made = egl.createContext(display, nullptr, nullptr, attributes);
    if (made == nullptr)
    {
        return Error{ErrorKind::Absent, place.name, WithCode("has no GL 3.3 core context", egl)};
    }
    auto context = std::make_unique<EglContext>(egl, display, made);
    if (const Result<void> current = context->MakeCurrent(); !current)
    {
        return Error{ErrorKind::Absent, place.name, WithCode("cannot draw without a surface", egl)};
    }
    const std::string renderer = context->RendererName();
    if (IsSoftware(renderer) == onGpu)
    {
        return Error{ErrorKind::Absent, place.name,
                     "draws with " + renderer +
                         (onGpu ? ", which is not a GPU"
                                : ", a GPU, which only BOXREEL_BACKEND=egl-gpu uses")};
    }
    return std::unique_ptr<Context>(std::move(context));
}

} // namespace

Result<std::unique_ptr<Context>> CreateEglContext(const std::string& library, bool onGpu)
{
    ASSIGN_OR_RETURN(const SharedLibrary opened, OpenContextLibrary(library, kPackages));
    Egl egl;
    if (!egl.Load(opened))
    {
        return opened.MissingError("functions of EGL 1.5");
    }
    std::string failures;
    for (const Place& place : PlacesOf(egl, onGpu))
    {
        Result<std::unique_ptr<Context>> context = CreateAt(egl, place, onGpu);
        if (context)
        {
            return context;
        }
        failures += (failures.empty() ? "" : "; ") + context.GetError().Text();
    }
    return Error{ErrorKind::Absent, library,
                 "cannot draw (" + (failures.empty() ? "it needs a display" : failures) + ")",
                 onGpu ? "install the driver of your GPU"
                       : "install a software one with: apt install libegl-mesa0 libgl1-mesa-dri"};
}

} // namespace boxreel
