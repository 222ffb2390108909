// SPDX-License-Identifier: MIT
#include "Shown.h"

#include <debugdraw/DrawLayer.h>
#include <debugdraw/Theme.h>

#include <gmock/gmock.h>

using testing::HasSubstr;

namespace
{

/// Returns the row of an option of a page's tables.
std::string RowOf(const std::string& option)
{
    const std::string text = ReadBytes(BOXREEL_DOCS "/cheat-sheet.md");
    const std::size_t start = text.find("\n| `" + option + "` |");
    return start == std::string::npos ? "" : text.substr(start, text.find('\n', start + 1) - start);
}

TEST(CheatSheet, ListsEveryLayer)
{
    for (const std::string& name : boxreel::LayerNames())
    {
        EXPECT_THAT(RowOf("--draw"), HasSubstr("`" + name + "`"));
    }
}

TEST(CheatSheet, ListsEveryTheme)
{
    for (const std::string_view name : boxreel::ThemeNames())
    {
        EXPECT_THAT(RowOf("--theme"), HasSubstr("`" + std::string(name) + "`"));
    }
}

} // namespace
