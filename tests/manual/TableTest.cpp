// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

/// Checks README.md of this folder: the tests in its table exist, and it contains all tests of this
/// folder and all sections of the specification.
namespace
{

std::string Read(const std::filesystem::path& path)
{
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Every first group of the pattern in the text, in order.
std::vector<std::string> Matches(const std::string& text, const std::string& pattern)
{
    const std::regex expression(pattern);
    std::vector<std::string> found;
    for (std::sregex_iterator i(text.begin(), text.end(), expression), end; i != end; ++i)
    {
        found.push_back((*i)[1]);
    }
    return found;
}

/// "Suite.Name" of every test in a source file.
std::vector<std::string> TestsIn(const std::filesystem::path& source)
{
    const std::string text = Read(source);
    const std::regex expression(R"(\nTEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\))");
    std::vector<std::string> found;
    for (std::sregex_iterator i(text.begin(), text.end(), expression), end; i != end; ++i)
    {
        found.push_back((*i)[1].str() + "." + (*i)[2].str());
    }
    return found;
}

std::set<std::string> TestsBelow(const std::filesystem::path& folder)
{
    std::set<std::string> tests;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    {
        if (entry.path().extension() == ".cpp")
        {
            const std::vector<std::string> found = TestsIn(entry.path());
            tests.insert(found.begin(), found.end());
        }
    }
    return tests;
}

std::string SuiteOf(const std::string& test)
{
    return test.substr(0, test.find('.'));
}

/// "Suite.Name" or "Suite.*" as the table names them.
std::vector<std::string> NamedTests()
{
    return Matches(Read(BOXREEL_MANUAL_TABLE), R"(`(\w+\.(?:\w+|\*))`)");
}

TEST(Table, NamesOnlyTestsThatExist)
{
    const std::set<std::string> tests = TestsBelow(BOXREEL_TESTS);
    std::set<std::string> suites;
    for (const std::string& test : tests)
    {
        suites.insert(SuiteOf(test));
    }
    const std::vector<std::string> named = NamedTests();
    EXPECT_GT(named.size(), 50u);
    for (const std::string& name : named)
    {
        const bool whole = name.ends_with(".*");
        EXPECT_TRUE(whole ? suites.contains(SuiteOf(name)) : tests.contains(name)) << name;
    }
}

TEST(Table, MissesNoTestOfThisFolder)
{
    const std::vector<std::string> named = NamedTests();
    const std::set<std::string> known(named.begin(), named.end());
    for (const std::string& test : TestsBelow(std::filesystem::path(BOXREEL_TESTS) / "manual"))
    {
        EXPECT_TRUE(known.contains(SuiteOf(test) + ".*") || known.contains(test) ||
                    SuiteOf(test) == "Table")
            << test;
    }
}

TEST(Table, HasEverySectionOfTheSpecificationInItsOrder)
{
    const std::string manual = Read(BOXREEL_MANUAL);
    if (manual.empty())
    {
        GTEST_SKIP() << "The specification is not beside this checkout: " << BOXREEL_MANUAL;
    }
    // Headings as they stand, without what Markdown escapes; one of them is empty.
    std::vector<std::string> sections;
    for (std::string& title : Matches(manual, R"((?:^|\n) ?#+ ([^\r\n]*\S)[ \t]*(?=\r?\n))"))
    {
        sections.push_back(std::regex_replace(title, std::regex(R"(\\)"), ""));
    }
    EXPECT_GT(sections.size(), 100u);
    std::vector<std::string> rows =
        Matches(Read(BOXREEL_MANUAL_TABLE), R"(\n\| \**([^|*]*[^|* ])\** +\| )");
    ASSERT_GT(rows.size(), 2u);
    rows.erase(rows.begin(), rows.begin() + 2); // the table's own heading
    EXPECT_EQ(rows, sections);
}

} // namespace
