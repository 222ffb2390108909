// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

/// page.html, page.css and page.js, embedded by the build (cmake/EmbedTexts.cmake).
namespace boxreel
{

extern const std::string_view kPageHtml;
extern const std::string_view kPageCss;
extern const std::string_view kPageJs;

} // namespace boxreel
