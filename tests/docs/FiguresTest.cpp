// SPDX-License-Identifier: MIT
// The drawings of the manual are what their program draws today, and no others lie beside them.
#include "../base/TemporaryFolder.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>

namespace
{

const std::filesystem::path kFigures = BOXREEL_DOCS "/figures";

int Draw(const TemporaryFolder& folder, const std::string& names = "")
{
    return std::system((BOXREEL_DOCS_FIGURES " '" + (folder / "").string() + "' " + names +
                        " 2> '" + (folder / "errors").string() + "'")
                           .c_str());
}

/// Returns the names of the drawings that the program must keep up to date, without the charts of
/// accuracy.md and their page.
std::set<std::string> DrawnNames(const std::filesystem::path& folder)
{
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        const std::string name = entry.path().filename().string();
        const bool isDrawing = name.ends_with(".svg") && !name.starts_with("accuracy-");
        if (isDrawing || name == "README.md")
        {
            names.insert(name);
        }
    }
    return names;
}

const char* const kRemedy =
    "; look at the drawings, then run: cmake --build build/release --target figures";

TEST(Figures, EqualThoseThatTheirProgramDraws)
{
    const TemporaryFolder drawn;
    ASSERT_EQ(Draw(drawn), 0) << ReadBytes(drawn / "errors");
    const std::set<std::string> names = DrawnNames(drawn / "");
    EXPECT_GT(names.size(), 50u);
    for (const std::string& name : names)
    {
        // Not EXPECT_EQ, which would print both.
        EXPECT_TRUE(ReadBytes(drawn / name) == ReadBytes(kFigures / name))
            << "docs/figures/" << name << " is not what the program draws" << kRemedy;
    }
}

TEST(Figures, IncludeNoStaleOnes)
{
    const TemporaryFolder drawn;
    ASSERT_EQ(Draw(drawn), 0) << ReadBytes(drawn / "errors");
    const std::set<std::string> current = DrawnNames(drawn / "");
    for (const std::string& name : DrawnNames(kFigures))
    {
        EXPECT_TRUE(current.contains(name)) << "no figure writes docs/figures/" << name
                                            << "; remove it, or add it to FigureTable.cpp";
    }
}

TEST(Figures, AreDrawnAloneWhenNamed)
{
    const TemporaryFolder drawn;
    ASSERT_EQ(Draw(drawn, "chain"), 0) << ReadBytes(drawn / "errors");
    EXPECT_THAT(DrawnNames(drawn / ""), testing::ElementsAre("chain-dark.svg", "chain-light.svg"));
}

TEST(Figures, AreNotDrawnForHelpAndUnknownOptions)
{
    const TemporaryFolder drawn;
    const std::string program = "cd '" + (drawn / "").string() + "' && " BOXREEL_DOCS_FIGURES;
    EXPECT_EQ(std::system((program + " --help > usage").c_str()), 0);
    EXPECT_THAT(ReadBytes(drawn / "usage"), testing::StartsWith("usage: boxreel_docs_figures"));
    EXPECT_NE(std::system((program + " --figures 2> errors").c_str()), 0);
    EXPECT_THAT(ReadBytes(drawn / "errors"), testing::StartsWith("usage: boxreel_docs_figures"));
}

TEST(Figures, AreRefusedWhenUnknown)
{
    const TemporaryFolder drawn;
    EXPECT_NE(Draw(drawn, "chian"), 0);
    EXPECT_THAT(ReadBytes(drawn / "errors"), testing::HasSubstr("no figure \"chian\""));
}

} // namespace
