// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// The keyboard as windows report it and panels read it.
namespace boxreel
{

/// A key. Those that print something have the code of what they print without Shift, in lower case
/// ('a', '1', '['), with a name where somebody asks for them; the others have names.
enum class Key : int
{
    None = 0,
    Space = ' ',
    LeftBracket = '[',
    RightBracket = ']',
    O = 'o',
    P = 'p',
    R = 'r',
    X = 'x',
    Z = 'z',
    Tab = 256, // beyond ASCII
    Enter,
    Escape,
    Backspace,
    Delete,
    Left,
    Right,
    Up,
    Down,
    Home,
    End,
    PageUp,
    PageDown,
};

inline constexpr int kKeyCount = 271; ///< every Key lies below

/// The key that prints `character`; 0 to 127.
constexpr Key KeyOf(char character)
{
    return static_cast<Key>(static_cast<unsigned char>(character));
}

} // namespace boxreel
