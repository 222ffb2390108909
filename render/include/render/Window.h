// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/DrawList.h>
#include <render/Keys.h>

#include <memory>
#include <string>
#include <vector>

/// @file
/// A window on a display, and its events. Renderer::CreateIn draws in its GL context. Create loads
/// GLFW; only WindowGlfw.cpp uses it. Use it in the main thread, one window at a time.
namespace boxreel
{

/// A user input event of a window.
struct WindowEvent
{
    /// The type of an event.
    enum class Kind
    {
        KeyDown,
        KeyRepeat, ///< key held down
        KeyUp,
        Text,       ///< text typed
        ButtonDown, ///< mouse button pressed
        ButtonUp,
        Pointer, ///< mouse moved
        Wheel,
        Resized,
        Exposed,   ///< content lost, must be drawn again
        LostFocus, ///< focus lost; key releases will not be reported
        Close,     ///< the user closes the window
    };
    Kind kind = Kind::Pointer; ///< type of the event
    Key key = Key::None;       ///< of key events
    std::string text;          ///< of Text, UTF-8
    int button = 0;            ///< of button events: 0 left, 1 right, 2 middle
    Vec2 point{0.0f, 0.0f};    ///< position of the mouse, in every event [px], y down
    float wheel = 0.0f;        ///< notches; positive is away from the user
    bool shift = false;        ///< true if Shift is down, for keys and buttons
    bool control = false;      ///< true if Control is down, for keys and buttons
    bool alt = false;          ///< true if Alt is down, for keys and buttons
};

/// A window with a GL context.
class Window
{
public:
    /// Creates a window. `width`, `height`: in the display's screen coordinates, clamped to the
    /// display; the picture may have more pixels. An Error (Absent) without a display, GL 3.3 or
    /// GLFW.
    static Result<Window> Create(const std::string& title, int width, int height);
    /// Leaves the source in a moved-from state.
    Window(Window&&) noexcept;
    /// Leaves the source in a moved-from state.
    Window& operator=(Window&&) noexcept;
    ~Window();

    /// Returns the events since the last call; waits at most `seconds` for one.
    std::vector<WindowEvent> Poll(double seconds = 0.0);

    int Width() const;    ///< width of the picture [px]; 0 while minimized
    int Height() const;   ///< height of the picture [px]
    double Scale() const; ///< scale of text and lines, 1 on an ordinary display
    /// Sets the title, UTF-8.
    void SetTitle(const std::string& title);

    struct Impl;
    /// For Renderer::CreateIn.
    Impl& Inside() const { return *m_impl; }

private:
    explicit Window(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

/// Checks that a window can be created, without creating one. An Error (Absent) states the reason.
Result<void> CheckDisplay();

} // namespace boxreel
