// SPDX-License-Identifier: MIT
#include "FigureTable.h"

namespace figures
{

std::string Gallery(const std::vector<FigureEntry>& table)
{
    std::string page = "# The figures of the manual\n"
                       "\n"
                       "The programs in `src/` simulate a world for each figure and draw it. They "
                       "write this page too.\n"
                       "Exceptions:\n"
                       "\n"
                       "- `modules` shows no world.\n"
                       "- In `manifolds`, shapes overlap more than in a world.\n"
                       "- In `convex-and-concave`, the concave polygon is no shape.\n"
                       "- In `time-of-impact` and `time-of-impact-turning`, a body is placed where "
                       "it is at three times.\n"
                       "- In `dynamic-tree`, the program builds the hierarchy by the rule of\n"
                       "  `b2DynamicTree::RebuildEvenly`, because a tree does not show its nodes. "
                       "The tree itself casts\n"
                       "  the ray.\n"
                       "\n"
                       "This command draws all of them again, with the same bytes:\n"
                       "\n"
                       "<!-- not run: tests/docs/FiguresTest.cpp draws them all, elsewhere -->\n"
                       "```\n"
                       "cmake --build build/release --target figures\n"
                       "```\n"
                       "\n"
                       "| colour | of |\n"
                       "| --- | --- |\n"
                       "| green | static bodies |\n"
                       "| red | dynamic bodies; fainter: their earlier poses |\n"
                       "| blue | kinematic bodies |\n";
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
