// SPDX-License-Identifier: MIT
#include "ContextLibrary.h"
#include "ContextWindow.h"

#include <base/ErrorMacros.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <limits>
#include <utility>

namespace boxreel
{
namespace
{

constexpr const char* kLibrary = "libglfw.so.3";
constexpr const char* kPackages = "libglfw3";

// All GLFW functions in use, as declared in glfw3.h.
#define BOXREEL_GLFW_FUNCTIONS(F)                                                                  \
    F(InitHint)                                                                                    \
    F(Init)                                                                                        \
    F(Terminate)                                                                                   \
    F(GetError)                                                                                    \
    F(WindowHint)                                                                                  \
    F(CreateWindow)                                                                                \
    F(DestroyWindow)                                                                               \
    F(SetWindowTitle)                                                                              \
    F(SetWindowSizeLimits)                                                                         \
    F(SetWindowUserPointer)                                                                        \
    F(GetWindowUserPointer)                                                                        \
    F(GetWindowSize)                                                                               \
    F(GetFramebufferSize)                                                                          \
    F(GetWindowContentScale)                                                                       \
    F(GetCursorPos)                                                                                \
    F(GetKeyName)                                                                                  \
    F(GetProcAddress)                                                                              \
    F(MakeContextCurrent)                                                                          \
    F(GetCurrentContext)                                                                           \
    F(SwapInterval)                                                                                \
    F(SwapBuffers)                                                                                 \
    F(PollEvents)                                                                                  \
    F(WaitEventsTimeout)                                                                           \
    F(SetKeyCallback)                                                                              \
    F(SetCharCallback)                                                                             \
    F(SetMouseButtonCallback)                                                                      \
    F(SetCursorPosCallback)                                                                        \
    F(SetScrollCallback)                                                                           \
    F(SetFramebufferSizeCallback)                                                                  \
    F(GetPrimaryMonitor)                                                                           \
    F(GetMonitorWorkarea)                                                                          \
    F(SetWindowRefreshCallback)                                                                    \
    F(SetWindowFocusCallback)                                                                      \
    F(SetWindowCloseCallback)

struct Glfw
{
#define BOXREEL_GLFW_MEMBER(name) decltype(&::glfw##name) name = nullptr;
    BOXREEL_GLFW_FUNCTIONS(BOXREEL_GLFW_MEMBER)
#undef BOXREEL_GLFW_MEMBER

    bool Load(const SharedLibrary& library)
    {
#define BOXREEL_GLFW_LOAD(name)                                                                    \
    if (!library.Bind("glfw" #name, name))                                                         \
    {                                                                                              \
        return false;                                                                              \
    }
        BOXREEL_GLFW_FUNCTIONS(BOXREEL_GLFW_LOAD)
#undef BOXREEL_GLFW_LOAD
        return true;
    }
};

/// GLFW 3.4 also supports Wayland and tries it first, with error messages if it is missing.
void PreferX11([[maybe_unused]] const Glfw& glfw)
{
#ifdef GLFW_PLATFORM
    const auto isSet = [](const char* variable) {
        const char* const value = std::getenv(variable);
        return value != nullptr && *value != '\0';
    };
    if (isSet("DISPLAY") || !isSet("WAYLAND_DISPLAY"))
    {
        glfw.InitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
    }
#endif
}

/// Loads and initializes the library. `Terminate` ends it.
Result<Glfw> Start()
{
    ASSIGN_OR_RETURN(const SharedLibrary library, OpenContextLibrary(kLibrary, kPackages));
    Glfw glfw;
    if (!glfw.Load(library))
    {
        return library.MissingError("functions of GLFW 3.3");
    }
    PreferX11(glfw);
    if (!glfw.Init())
    {
        const char* reason = nullptr;
        glfw.GetError(&reason);
        return Error{ErrorKind::Absent, "display",
                     std::string("cannot open a window (") +
                         (reason != nullptr ? reason : "GLFW does not start") + ")"};
    }
    return glfw;
}

Key KeyOfName(const Glfw& glfw, int key, int scancode)
{
    static constexpr std::pair<int, Key> kNamed[] = {
        {GLFW_KEY_SPACE, Key::Space},       {GLFW_KEY_TAB, Key::Tab},
        {GLFW_KEY_ENTER, Key::Enter},       {GLFW_KEY_KP_ENTER, Key::Enter},
        {GLFW_KEY_ESCAPE, Key::Escape},     {GLFW_KEY_BACKSPACE, Key::Backspace},
        {GLFW_KEY_DELETE, Key::Delete},     {GLFW_KEY_LEFT, Key::Left},
        {GLFW_KEY_RIGHT, Key::Right},       {GLFW_KEY_UP, Key::Up},
        {GLFW_KEY_DOWN, Key::Down},         {GLFW_KEY_HOME, Key::Home},
        {GLFW_KEY_END, Key::End},           {GLFW_KEY_PAGE_UP, Key::PageUp},
        {GLFW_KEY_PAGE_DOWN, Key::PageDown}};
    for (const auto& [code, named] : kNamed)
    {
        if (code == key)
        {
            return named;
        }
    }
    // The character in the user's keyboard layout, not its position on a US keyboard.
    const char* const name = glfw.GetKeyName(key, scancode);
    const bool isAscii = name != nullptr && name[0] != '\0' && name[1] == '\0' &&
                         static_cast<unsigned char>(name[0]) < 128;
    return isAscii ? KeyOf(static_cast<char>(std::tolower(static_cast<unsigned char>(name[0]))))
                   : Key::None;
}

struct Room
{
    int width, height;
};

/// Work area of the display, without docks. A larger window would have unreachable panels.
Room RoomOn(const Glfw& glfw)
{
    Room room{0, 0};
    if (GLFWmonitor* const monitor = glfw.GetPrimaryMonitor())
    {
        int x = 0;
        int y = 0;
        glfw.GetMonitorWorkarea(monitor, &x, &y, &room.width, &room.height);
    }
    const int any = std::numeric_limits<int>::max();
    return {room.width > 0 ? room.width : any, room.height > 0 ? room.height : any};
}

std::string Utf8(unsigned int letter)
{
    std::string text;
    const auto put = [&text](unsigned int byte) { text += static_cast<char>(byte); };
    if (letter < 0x80u)
    {
        put(letter);
    }
    else if (letter < 0x800u)
    {
        put(0xc0u | letter >> 6);
        put(0x80u | (letter & 0x3fu));
    }
    else if (letter < 0x10000u)
    {
        put(0xe0u | letter >> 12);
        put(0x80u | (letter >> 6 & 0x3fu));
        put(0x80u | (letter & 0x3fu));
    }
    else
    {
        put(0xf0u | letter >> 18);
        put(0x80u | (letter >> 12 & 0x3fu));
        put(0x80u | (letter >> 6 & 0x3fu));
        put(0x80u | (letter & 0x3fu));
    }
    return text;
}

} // namespace

/// The library, its one window, and the pending events.
struct Window::Impl
{
    explicit Impl(const Glfw& library) : glfw(library) {}
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl()
    {
        if (window != nullptr)
        {
            glfw.DestroyWindow(window);
        }
        glfw.Terminate();
    }

    static Impl& Of(GLFWwindow* window)
    {
        return *static_cast<Impl*>(s_glfw->GetWindowUserPointer(window));
    }

    /// Creates an event with the mouse position at its time; GLFW only returns the current one.
    WindowEvent Event(WindowEvent::Kind kind) const
    {
        WindowEvent event;
        event.kind = kind;
        event.point = pointer;
        return event;
    }
    /// In pixels of the picture.
    void SetPointer(double x, double y)
    {
        int width = 0;
        int height = 0;
        int pixelWidth = 0;
        int pixelHeight = 0;
        glfw.GetWindowSize(window, &width, &height);
        glfw.GetFramebufferSize(window, &pixelWidth, &pixelHeight);
        pointer = {float(x * pixelWidth / std::max(1, width)),
                   float(y * pixelHeight / std::max(1, height))};
    }
    static void SetModifiers(WindowEvent& event, int mods)
    {
        event.shift = (mods & GLFW_MOD_SHIFT) != 0;
        event.control = (mods & GLFW_MOD_CONTROL) != 0;
        event.alt = (mods & GLFW_MOD_ALT) != 0;
    }

    void Listen();

    Glfw glfw;
    GLFWwindow* window = nullptr;
    Vec2 pointer{-1.0f, -1.0f}; // last position of the mouse
    std::vector<WindowEvent> events;
    static inline const Glfw* s_glfw = nullptr; // callbacks receive only the window
};

void Window::Impl::Listen()
{
    using Kind = WindowEvent::Kind;
    s_glfw = &glfw;
    glfw.SetWindowUserPointer(window, this);
    glfw.SetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
        Impl& impl = Of(w);
        WindowEvent event = impl.Event(action == GLFW_PRESS    ? Kind::KeyDown
                                       : action == GLFW_REPEAT ? Kind::KeyRepeat
                                                               : Kind::KeyUp);
        event.key = KeyOfName(impl.glfw, key, scancode);
        SetModifiers(event, mods);
        impl.events.push_back(event);
    });
    glfw.SetCharCallback(window, [](GLFWwindow* w, unsigned int letter) {
        WindowEvent event = Of(w).Event(Kind::Text);
        event.text = Utf8(letter);
        Of(w).events.push_back(event);
    });
    glfw.SetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
        WindowEvent event = Of(w).Event(action == GLFW_PRESS ? Kind::ButtonDown : Kind::ButtonUp);
        event.button = button;
        SetModifiers(event, mods);
        Of(w).events.push_back(event);
    });
    glfw.SetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        Of(w).SetPointer(x, y);
        Of(w).events.push_back(Of(w).Event(Kind::Pointer));
    });
    glfw.SetScrollCallback(window, [](GLFWwindow* w, double, double notches) {
        WindowEvent event = Of(w).Event(Kind::Wheel);
        event.wheel = float(notches);
        Of(w).events.push_back(event);
    });
    glfw.SetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) {
        Of(w).events.push_back(Of(w).Event(Kind::Resized));
    });
    glfw.SetWindowRefreshCallback(
        window, [](GLFWwindow* w) { Of(w).events.push_back(Of(w).Event(Kind::Exposed)); });
    glfw.SetWindowFocusCallback(window, [](GLFWwindow* w, int hasFocus) {
        if (!hasFocus)
        {
            Of(w).events.push_back(Of(w).Event(Kind::LostFocus));
        }
    });
    glfw.SetWindowCloseCallback(
        window, [](GLFWwindow* w) { Of(w).events.push_back(Of(w).Event(Kind::Close)); });
}

namespace
{

class WindowContext final : public Context
{
public:
    explicit WindowContext(Window::Impl& window) : m_window(window) {}
    ~WindowContext() override { Leave(); }

    void* ProcAddress(const char* name) const override
    {
        return reinterpret_cast<void*>(m_window.glfw.GetProcAddress(name));
    }
    const char* BackEnd() const override { return "window"; }
    void SwapBuffers() override { m_window.glfw.SwapBuffers(m_window.window); }

protected:
    bool IsCurrent() const override { return m_window.glfw.GetCurrentContext() == m_window.window; }
    Result<void> Bind() override
    {
        m_window.glfw.MakeContextCurrent(m_window.window);
        return IsCurrent() ? Result<void>()
                           : Error{ErrorKind::Failed, "window", "its GL context is lost"};
    }
    void Unbind() override { m_window.glfw.MakeContextCurrent(nullptr); }

private:
    Window::Impl& m_window;
};

} // namespace

Window::Window(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;
Window::~Window() = default;

Result<Window> Window::Create(const std::string& title, int width, int height)
{
    ASSIGN_OR_RETURN(const Glfw glfw, Start());
    auto impl = std::make_unique<Impl>(glfw);
    impl->glfw.WindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    impl->glfw.WindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    impl->glfw.WindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    impl->glfw.WindowHint(GLFW_DEPTH_BITS, 0);
    impl->glfw.WindowHint(GLFW_STENCIL_BITS, 0);
    impl->glfw.WindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    const Room room = RoomOn(impl->glfw);
    impl->window =
        impl->glfw.CreateWindow(std::min(width, room.width), std::min(height, room.height),
                                title.c_str(), nullptr, nullptr);
    if (impl->window == nullptr)
    {
        const char* reason = nullptr;
        impl->glfw.GetError(&reason);
        return Error{ErrorKind::Absent, "display",
                     std::string("cannot open a window with OpenGL 3.3 (") +
                         (reason != nullptr ? reason : "no reason given") + ")",
                     "install its driver, or Mesa's with: apt install libgl1-mesa-dri"};
    }
    impl->glfw.SetWindowSizeLimits(impl->window, 320, 240, GLFW_DONT_CARE, GLFW_DONT_CARE);
    impl->Listen();
    impl->glfw.MakeContextCurrent(impl->window);
    impl->glfw.SwapInterval(1);
    impl->glfw.MakeContextCurrent(nullptr);
    return Window(std::move(impl));
}

std::vector<WindowEvent> Window::Poll(double seconds)
{
    if (seconds > 0.0)
    {
        m_impl->glfw.WaitEventsTimeout(seconds);
    }
    else
    {
        m_impl->glfw.PollEvents();
    }
    return std::exchange(m_impl->events, {});
}

int Window::Width() const
{
    int width = 0;
    int height = 0;
    m_impl->glfw.GetFramebufferSize(m_impl->window, &width, &height);
    return width;
}

int Window::Height() const
{
    int width = 0;
    int height = 0;
    m_impl->glfw.GetFramebufferSize(m_impl->window, &width, &height);
    return height;
}

double Window::Scale() const
{
    float x = 1.0f;
    float y = 1.0f;
    m_impl->glfw.GetWindowContentScale(m_impl->window, &x, &y);
    return std::clamp(double(std::max(x, y)), 0.5, 4.0);
}

void Window::SetTitle(const std::string& title)
{
    m_impl->glfw.SetWindowTitle(m_impl->window, title.c_str());
}

std::unique_ptr<Context> CreateWindowContext(Window& window)
{
    return std::make_unique<WindowContext>(window.Inside());
}

Result<void> CheckDisplay()
{
    ASSIGN_OR_RETURN(const Glfw glfw, Start());
    glfw.Terminate();
    return {};
}

} // namespace boxreel
