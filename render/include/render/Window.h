// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/DrawList.h>
#include <render/Keys.h>

#include <memory>
#include <string>
#include <vector>

/// @file
/// A window on a display, and what is done in it. A Renderer made for it (Renderer::CreateIn) draws
/// in its GL context. GLFW is loaded by Create, not before; only WindowGlfw.cpp knows it. To be
/// used by the thread that began the program, one window at a time.
namespace boxreel
{

/// What a person did at the window.
struct WindowEvent
{
    /// What was done.
    enum class Kind
    {
        KeyDown,
        KeyRepeat, ///< it is held
        KeyUp,
        Text,       ///< letters were typed
        ButtonDown, ///< of the mouse
        ButtonUp,
        Pointer, ///< the mouse has moved
        Wheel,
        Resized,
        Exposed,   ///< what it showed is lost
        LostFocus, ///< keys that are down will not be heard to go up
        Close,     ///< it is asked to
    };
    Kind kind = Kind::Pointer; ///< what was done
    Key key = Key::None;       ///< of keys that went down or up
    std::string text;          ///< of Text, UTF-8
    int button = 0;            ///< 0 left, 1 right, 2 middle
    Vec2 point{0.0f, 0.0f};    ///< where the mouse is, at every event [px], y down
    float wheel = 0.0f;        ///< notches, up and away is above zero
    bool shift = false;        ///< whether Shift is down, at keys and buttons
    bool control = false;      ///< whether Control is down, at keys and buttons
    bool alt = false;          ///< whether Alt is down, at keys and buttons
};

/// A window with a GL context.
class Window
{
public:
    /// `width`, `height`: as the display's other windows measure; the picture may have more pixels.
    /// No larger than the display has room for.
    /// An Error (Absent) when there is no display, no GL 3.3 or no GLFW.
    static Result<Window> Create(const std::string& title, int width, int height);
    /// The other may only be assigned to or destroyed.
    Window(Window&&) noexcept;
    /// The other may only be assigned to or destroyed.
    Window& operator=(Window&&) noexcept;
    ~Window();

    /// What happened since the last call, after at most so many seconds when nothing does.
    std::vector<WindowEvent> Poll(double seconds = 0.0);

    int Width() const;    ///< of its picture [px]; 0 while it is minimised
    int Height() const;   ///< of its picture [px]
    double Scale() const; ///< of letters and lines, 1 on an ordinary display
    /// What stands above the window, UTF-8.
    void SetTitle(const std::string& title);

    struct Impl;
    /// For Renderer::CreateIn.
    Impl& Inside() const { return *m_impl; }

private:
    explicit Window(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

/// Whether a window could be made here, without making one: an Error (Absent) says why not.
Result<void> CheckDisplay();

} // namespace boxreel
