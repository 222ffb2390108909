// SPDX-License-Identifier: MIT
#pragma once

#include <render/Figure.h>

#include <string>
#include <string_view>
#include <vector>

/// Every drawing of the manual: what it is called, what it says, and who draws it.
namespace figures
{

struct FigureEntry
{
    std::string_view name;  ///< of its files: NAME-light.svg and NAME-dark.svg
    std::string_view title; ///< what there is to see, for readers who do not see it
    std::string_view says;  ///< a sentence of the gallery
    boxreel::Figure (*draw)();
};

/// In the order of the manual.
const std::vector<FigureEntry>& FigureTable();

/// The page that shows them all, as Markdown.
std::string Gallery(const std::vector<FigureEntry>& table);

} // namespace figures
