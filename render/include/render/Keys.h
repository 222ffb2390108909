// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// The keys of a keyboard, for windows and panels.
namespace boxreel
{

/// A key. Printing keys have the ASCII code of their character without Shift, in lower case ('a',
/// '1', '['); those in use have names. The others have names only.
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

inline constexpr int kKeyCount = 271; ///< all Keys are below

/// Returns the key that prints `character`, 0 to 127.
constexpr Key KeyOf(char character)
{
    return static_cast<Key>(static_cast<unsigned char>(character));
}

} // namespace boxreel
