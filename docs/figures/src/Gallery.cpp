// SPDX-License-Identifier: MIT
#include "FigureTable.h"

namespace figures
{

std::string Gallery(const std::vector<FigureEntry>& table)
{
    std::string page = "# The figures of the manual\n"
                       "\n"
                       "Each shows a world that was simulated for it, by the programs in `src/`; "
                       "this page too is\n"
                       "written by them. Not so: `modules` shows no world; in `manifolds` shapes "
                       "overlap more than a world\n"
                       "lets them, and in `time-of-impact` and `time-of-impact-turning` a body is "
                       "put where it is at times\n"
                       "that are asked about, so those worlds take no step. To draw all of them "
                       "again, with the same bytes:\n"
                       "\n"
                       "<!-- not run: tests/docs/FiguresTest.cpp draws them all, elsewhere -->\n"
                       "```\n"
                       "cmake --build build/release --target figures\n"
                       "```\n"
                       "\n"
                       "| colour | of |\n"
                       "| --- | --- |\n"
                       "| green | bodies that never move |\n"
                       "| red | bodies that move; fainter: how they stood earlier |\n"
                       "| blue | bodies that move as they were told |\n";
    for (const FigureEntry& entry : table)
    {
        const std::string name(entry.name);
        page += "\n## " + name + "\n\n" + std::string(entry.says) + "\n\n<picture>\n" +
                "  <source media=\"(prefers-color-scheme: dark)\" srcset=\"" + name +
                "-dark.svg\">\n  <img src=\"" + name + "-light.svg\" alt=\"" +
                std::string(entry.title) + "\">\n</picture>\n";
    }
    return page;
}

} // namespace figures
