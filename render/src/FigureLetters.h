// SPDX-License-Identifier: MIT
#pragma once

#include <render/Figure.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// The letters of texts that others wrote: what of them figures show, and what goes into names.
namespace boxreel
{

/// UTF-8 without control characters; a tab or a line feed is a space. What is no UTF-8 becomes the
/// sign for that, U+FFFD.
std::string Readable(std::string_view text);

/// What may follow in an identifier of XML (an NCName) as it is, anything else as '-', a letter
/// each. No beginning of one: a digit stays a digit.
std::string AsIdPart(std::string_view text);

/// The letters of the figure's texts that are not had: each once, as they come.
std::vector<std::string> LettersWithout(const Figure& figure,
                                        const std::function<bool(char32_t)>& has);

} // namespace boxreel
