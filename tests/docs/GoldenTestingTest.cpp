// SPDX-License-Identifier: MIT
// The project of docs/golden.md, which tests/consumer builds.
#include "Shown.h"

#include <gtest/gtest.h>

namespace
{

/// In a block of that language, but for the licence in the first line of a source.
bool IsShownInTheGuide(const std::string& file, const std::string& language)
{
    const std::string text = ReadBytes(BOXREEL_CONSUMER_PROJECT "/" + file);
    const std::size_t start = text.starts_with("// SPDX") ? text.find('\n') + 1 : 0;
    const std::string shown = "```" + language + "\n" + text.substr(start) + "```\n";
    return !text.empty() && ReadBytes(BOXREEL_DOCS "/golden.md").find(shown) != std::string::npos;
}

TEST(GoldenTesting, ShowsTheTestedProjectUnchanged)
{
    EXPECT_TRUE(IsShownInTheGuide("CMakeLists.txt", "cmake"));
    for (const char* const source : {"Seesaw.h", "Seesaw.cpp", "SeesawTest.cpp"})
    {
        EXPECT_TRUE(IsShownInTheGuide(source, "cpp")) << source;
    }
}

} // namespace
