// SPDX-License-Identifier: MIT
// The pages of docs/manual show only code that its listings compile and run, and all their links
// exist. The listings test themselves.
#include "../base/ReadBytes.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace
{

const fs::path kPages = BOXREEL_MANUAL_PAGES;

std::vector<std::string> LinesOf(const fs::path& path)
{
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);)
    {
        lines.push_back(line);
    }
    return lines;
}

/// The names of the chapters, without their ends.
std::set<std::string> Chapters()
{
    std::set<std::string> chapters;
    for (const auto& entry : fs::directory_iterator(kPages))
    {
        const fs::path& path = entry.path();
        if (path.extension() == ".md" && path.filename() != "README.md")
        {
            chapters.insert(path.stem().string());
        }
    }
    return chapters;
}

/// The text of every block of C++ of a page, in order.
std::vector<std::string> BlocksOf(const fs::path& page)
{
    std::vector<std::string> blocks;
    bool inside = false;
    for (const std::string& line : LinesOf(page))
    {
        if (!inside && line == "```cpp")
        {
            inside = true;
            blocks.emplace_back();
        }
        else if (inside && line == "```")
        {
            inside = false;
        }
        else if (inside)
        {
            blocks.back() += line + "\n";
        }
    }
    EXPECT_FALSE(inside) << page << " has a block without an end";
    return blocks;
}

std::string Dedented(const std::vector<std::string>& lines)
{
    std::size_t indent = std::string::npos;
    for (const std::string& line : lines)
    {
        indent = std::min(indent, line.find_first_not_of(' '));
    }
    std::string text;
    for (const std::string& line : lines)
    {
        text += (line.empty() ? line : line.substr(indent)) + "\n";
    }
    return text;
}

/// Returns the text between the lines `// [name]` and `// [/name]`, by name.
std::map<std::string, std::string> RegionsOf(const fs::path& listing)
{
    const std::regex mark(R"( *// \[(/?)([a-z0-9-]+)\])");
    std::map<std::string, std::string> regions;
    std::string open;
    std::vector<std::string> lines;
    for (const std::string& line : LinesOf(listing))
    {
        std::smatch match;
        if (!std::regex_match(line, match, mark))
        {
            lines.push_back(line);
            continue;
        }
        const bool ends = match[1].length() > 0;
        const std::string name = match[2];
        EXPECT_EQ(ends ? name : "", open) << listing << ": a mark inside another region: " << line;
        if (ends)
        {
            EXPECT_TRUE(regions.emplace(name, Dedented(lines)).second)
                << listing << " has two regions " << name;
        }
        open = ends ? "" : name;
        lines.clear();
    }
    EXPECT_EQ(open, "") << listing << ": a region without an end";
    return regions;
}

TEST(Manual, ShowsTheRegionsOfItsListingsAndNoOtherCode)
{
    std::size_t shown = 0;
    for (const std::string& chapter : Chapters())
    {
        const std::map<std::string, std::string> regions =
            RegionsOf(kPages / "listings" / (chapter + ".cpp"));
        std::set<std::string> used;
        for (const std::string& block : BlocksOf(kPages / (chapter + ".md")))
        {
            const auto region = std::find_if(regions.begin(), regions.end(),
                                             [&](const auto& r) { return r.second == block; });
            EXPECT_TRUE(region != regions.end())
                << chapter << ".md shows what no region of its listing is:\n"
                << block;
            if (region != regions.end())
            {
                used.insert(region->first);
                ++shown;
            }
        }
        for (const auto& [name, text] : regions)
        {
            EXPECT_TRUE(used.contains(name)) << chapter << ".md does not show region " << name;
        }
    }
    EXPECT_GT(shown, 2u);
}

TEST(Manual, CompilesTheListingOfEveryChapter)
{
    std::istringstream compiled(BOXREEL_MANUAL_CHAPTERS);
    std::set<std::string> chapters;
    for (std::string chapter; compiled >> chapter;)
    {
        chapters.insert(chapter);
    }
    EXPECT_EQ(chapters, Chapters()) << "add it to tests/docs/CMakeLists.txt";
}

TEST(Manual, HasNoListingWithoutAChapter)
{
    const std::set<std::string> chapters = Chapters();
    for (const auto& entry : fs::directory_iterator(kPages / "listings"))
    {
        const fs::path& path = entry.path();
        EXPECT_TRUE(path.extension() != ".cpp" || chapters.contains(path.stem().string())) << path;
    }
}

/// Headings as GitHub names them: lower case, dashes for spaces, letters and digits only.
std::set<std::string> AnchorsOf(const fs::path& page)
{
    std::set<std::string> anchors;
    for (const std::string& line : LinesOf(page))
    {
        const std::size_t start = line.find_first_not_of('#');
        if (start == 0 || start == std::string::npos || line[start] != ' ')
        {
            continue;
        }
        std::string anchor;
        for (const char c : line.substr(start + 1))
        {
            if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_')
            {
                anchor += char(std::tolower(static_cast<unsigned char>(c)));
            }
            else if (c == ' ')
            {
                anchor += '-';
            }
        }
        anchors.insert(anchor);
    }
    return anchors;
}

/// Returns the targets of the links and pictures of a page, without web addresses.
std::vector<std::string> TargetsOf(const fs::path& page)
{
    const std::string text = ReadBytes(page);
    const std::regex link(R"re(\]\(([^)\s]+)\)|(?:src|srcset)="([^"]+)")re");
    std::vector<std::string> targets;
    for (std::sregex_iterator i(text.begin(), text.end(), link), end; i != end; ++i)
    {
        const std::string target = (*i)[1].matched ? (*i)[1] : (*i)[2];
        if (!target.starts_with("http"))
        {
            targets.push_back(target);
        }
    }
    return targets;
}

TEST(Manual, LinksOnlyToExistingTargets)
{
    std::size_t targets = 0;
    for (const auto& entry : fs::directory_iterator(kPages))
    {
        if (entry.path().extension() != ".md")
        {
            continue;
        }
        for (const std::string& target : TargetsOf(entry.path()))
        {
            ++targets;
            const std::size_t hash = target.find('#');
            const std::string file = target.substr(0, hash);
            const fs::path there = file.empty() ? entry.path() : kPages / file;
            EXPECT_TRUE(fs::exists(there)) << entry.path() << " leads to " << target;
            if (hash != std::string::npos)
            {
                EXPECT_TRUE(AnchorsOf(there).contains(target.substr(hash + 1)))
                    << entry.path() << " leads to a heading that is not there: " << target;
            }
        }
    }
    EXPECT_GT(targets, 20u);
}

/// The lines of a page that show a picture, as the page of the figures has them.
std::set<std::string> PicturesOf(const fs::path& page)
{
    std::set<std::string> pictures;
    for (std::string line : LinesOf(page))
    {
        const std::size_t folder = line.find("../figures/");
        if (folder != std::string::npos)
        {
            line.erase(folder, std::string("../figures/").size());
        }
        if (line.starts_with("  <img "))
        {
            pictures.insert(line);
        }
    }
    return pictures;
}

TEST(Manual, ShowsEveryFigureWithTheSameWords)
{
    std::set<std::string> shown;
    for (const std::string& chapter : Chapters())
    {
        shown.merge(PicturesOf(kPages / (chapter + ".md")));
    }
    EXPECT_EQ(shown, PicturesOf(kPages / "../figures/README.md"));
    EXPECT_GT(shown.size(), 30u);
}

TEST(Manual, ListsEveryChapterOnItsFirstPage)
{
    const std::vector<std::string> targets = TargetsOf(kPages / "README.md");
    for (const std::string& chapter : Chapters())
    {
        EXPECT_THAT(targets, testing::Contains(chapter + ".md"));
    }
}

TEST(Manual, ListsEveryPageOfDocsOnItsFirstPage)
{
    const std::vector<std::string> targets = TargetsOf(kPages / "README.md");
    std::size_t pages = 0;
    for (const auto& entry : fs::directory_iterator(kPages / ".."))
    {
        if (entry.path().extension() == ".md")
        {
            ++pages;
            EXPECT_THAT(targets, testing::Contains("../" + entry.path().filename().string()));
        }
    }
    EXPECT_GT(pages, 5u);
}

} // namespace
