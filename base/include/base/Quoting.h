// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

/// @file
/// Text escaped for its destination.
namespace boxreel
{

/// Returns 'text', for messages.
std::string Quoted(std::string_view text);

/// An option as it was typed, for the culprit of an Error: "--fps 0", "--label 'two words'". The
/// value alone where `option` is empty.
std::string AsTyped(std::string_view option, std::string_view value);

/// One word of a POSIX shell, in single quotes.
std::string ShellQuoted(std::string_view text);

/// Escapes one line for a field between brackets or colons of zsh's _arguments and _describe.
std::string ZshEscaped(std::string_view text);

/// Escapes text for the content and double-quoted attributes of HTML and XML.
std::string MarkupEscaped(std::string_view text);

/// Escapes '<' in JSON as \u003c. A script of HTML would otherwise end at a "</script" in a string.
std::string JsonForScript(std::string json);

/// Returns Base64 with padding (RFC 4648, section 4).
std::string Base64(std::string_view bytes);

/// Returns two lower-case hex digits.
std::string HexByte(unsigned char byte);

} // namespace boxreel
