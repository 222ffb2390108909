// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

/// The files of page/player, embedded by the build (cmake/EmbedTexts.cmake).
namespace boxreel
{

extern const std::string_view kPlayerHtml;
extern const std::string_view kPlayerCss;
extern const std::string_view kDecodeJs;
extern const std::string_view kLabelsJs;
extern const std::string_view kDrawJs;
extern const std::string_view kExactJs;
extern const std::string_view kViewJs;
extern const std::string_view kPlayerJs;
extern const std::string_view kLoadJs;

} // namespace boxreel
