// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

/// @file
/// Text made safe for the place it is put into.
namespace boxreel
{

/// 'text', for messages.
std::string Quoted(std::string_view text);

/// An option as it was typed, for the culprit of an Error: "--fps 0", "--label 'two words'". The
/// value alone where `option` is empty.
std::string AsTyped(std::string_view option, std::string_view value);

/// One word of a POSIX shell, in single quotes.
std::string ShellQuoted(std::string_view text);

/// One line for a place between the brackets or colons of zsh's _arguments and _describe.
std::string ZshEscaped(std::string_view text);

/// For text and double-quoted attributes of HTML and XML.
std::string MarkupEscaped(std::string_view text);

/// Base64 with padding (RFC 4648, section 4).
std::string Base64(std::string_view bytes);

/// Two lower-case hex digits.
std::string HexByte(unsigned char byte);

} // namespace boxreel
