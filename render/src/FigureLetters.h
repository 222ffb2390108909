// SPDX-License-Identifier: MIT
#pragma once

#include <render/Figure.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// Handles text of unknown content for figures: which characters can be shown, and names derived
/// from it.
namespace boxreel
{

/// Returns UTF-8 without control characters; a tab or a line feed becomes a space. Invalid UTF-8
/// becomes U+FFFD.
std::string Readable(std::string_view text);

/// Replaces each character that is not allowed in an identifier of XML (an NCName) by '-'. The
/// result may not start an identifier: a leading digit is kept.
std::string AsIdPart(std::string_view text);

/// Returns the characters of the figure's texts for which `has` is false, each once, in order.
std::vector<std::string> LettersWithout(const Figure& figure,
                                        const std::function<bool(char32_t)>& has);

} // namespace boxreel
