// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// The specification's sentences are its author's: pages and comments say things in other words.
/// Its listings, which the tests of this folder compile, are taken as they are.
namespace
{

namespace fs = std::filesystem;

/// So many words in a row that they are quoted and not met by chance.
constexpr std::size_t kRun = 7;

std::string Read(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// What is between letters and digits goes, and so do capitals.
std::vector<std::string> Words(std::string_view text)
{
    std::vector<std::string> words(1);
    for (const char c : text)
    {
        if (std::isalnum(static_cast<unsigned char>(c)))
        {
            words.back() += char(std::tolower(static_cast<unsigned char>(c)));
        }
        else if (!words.back().empty())
        {
            words.emplace_back();
        }
    }
    if (words.back().empty())
    {
        words.pop_back();
    }
    return words;
}

std::vector<std::string> Runs(std::string_view text)
{
    const std::vector<std::string> words = Words(text);
    std::vector<std::string> runs;
    for (std::size_t i = 0; i + kRun <= words.size(); ++i)
    {
        std::string run = words[i];
        for (std::size_t k = 1; k < kRun; ++k)
        {
            run += ' ' + words[i + k];
        }
        runs.push_back(run);
    }
    return runs;
}

/// The line's part that people read: all of a page but its listings, of a source the comment.
/// A text ends where a line has none.
std::vector<std::string> Prose(const fs::path& path)
{
    const bool page = path.extension() == ".md";
    std::vector<std::string> texts(1);
    bool listing = false;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);)
    {
        const bool fence = page && line.find("```") != std::string::npos;
        listing ^= fence;
        const std::size_t begin = page ? 0 : line.find("//");
        if (fence || listing || begin == std::string::npos)
        {
            texts.emplace_back();
        }
        else
        {
            texts.back() += line.substr(begin) + '\n';
        }
    }
    return texts;
}

bool IsRead(const fs::path& path)
{
    return path.extension() == ".md" || path.extension() == ".h" || path.extension() == ".cpp";
}

/// Pages and sources, without what is built beside them.
std::vector<fs::path> FilesOfTheTree()
{
    const fs::path root = BOXREEL_SOURCE;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(root))
    {
        if (IsRead(entry.path()))
        {
            files.push_back(entry.path());
        }
    }
    for (const char* folder :
         {"debugdraw", "docs", "engine", "golden", "recorder", "render", "testbed", "tests"})
    {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
        {
            if (IsRead(entry.path()))
            {
                files.push_back(entry.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

TEST(Sentences, OfTheSpecificationStandInNoPageAndNoComment)
{
    const std::vector<std::string> specification = Runs(Read(BOXREEL_MANUAL));
    if (specification.empty())
    {
        GTEST_SKIP() << "The specification is not beside this checkout: " << BOXREEL_MANUAL;
    }
    const std::set<std::string> theirs(specification.begin(), specification.end());
    const std::vector<fs::path> files = FilesOfTheTree();
    EXPECT_GT(files.size(), 500u);
    for (const fs::path& path : files)
    {
        for (const std::string& text : Prose(path))
        {
            for (const std::string& run : Runs(text))
            {
                EXPECT_FALSE(theirs.contains(run)) << path.string() << ": " << run;
            }
        }
    }
}

} // namespace
