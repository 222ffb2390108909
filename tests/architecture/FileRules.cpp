// SPDX-License-Identifier: MIT
#include "SourceTree.h"

#include "TreeText.h"

#include <algorithm>
#include <array>
#include <regex>
#include <set>
#include <string_view>

namespace fs = std::filesystem;

namespace architecture
{
namespace
{

/// More than this is more than one idea.
constexpr std::size_t kMaxLines = 700;

/// ctest and CI print names in one line beside status and time; longer names describe two
/// behaviours.
constexpr std::size_t kMaxTestName = 60;

/// Returns the folder of one machine that a line names, or empty. A name inside a longer path
/// ("build/…", "${…}/…", an address of the web) does not count.
std::string MachineFolder(const std::string& line)
{
    // Put together here so as not to find themselves.
    static const std::array<std::string, 5> folders{
        "/ho" + std::string("me/"), "/ro" + std::string("ot/"), "/wo" + std::string("rk/"),
        "/Us" + std::string("ers/"), "C:" + std::string("\\")};
    for (const std::string& folder : folders)
    {
        const std::size_t at = line.find(folder);
        if (at != std::string::npos &&
            (at == 0 ||
             std::string_view(" \t\"'`=(:<>").find(line[at - 1]) != std::string_view::npos))
        {
            return folder;
        }
    }
    return "";
}

void CheckSource(const std::string& path, const std::vector<std::string>& lines, Findings& findings)
{
    const std::string licence = "// SPDX-License-Identifier: MIT";
    if (lines.empty() || lines[0] != licence)
    {
        findings.push_back(At(path, 1) + "does not open with the line \"" + licence + "\"");
    }
    if (lines.size() > kMaxLines)
    {
        findings.push_back(At(path, kMaxLines + 1) + "is longer than " + std::to_string(kMaxLines) +
                           " lines");
    }
}

void CheckTestName(const std::string& path, std::size_t line, const std::string& name,
                   Findings& findings)
{
    if (name.size() > kMaxTestName)
    {
        findings.push_back(At(path, line) + name + " has " + std::to_string(name.size()) +
                           " characters; the limit is " + std::to_string(kMaxTestName));
    }
}

/// The parentheses of a test may extend over several lines.
void CheckCppTests(const std::string& path, const std::vector<std::string>& lines,
                   Findings& findings)
{
    static const std::regex test(R"(\bTEST(?:_F|_P)?\s*\(\s*(\w+)\s*,\s*(\w+)\s*\))");
    std::string text;
    for (const std::string& line : lines)
    {
        text += line + "\n";
    }
    for (std::sregex_iterator found(text.begin(), text.end(), test), end; found != end; ++found)
    {
        const auto before = std::count(text.cbegin(), (*found)[0].first, '\n');
        CheckTestName(path, std::size_t(before) + 1, (*found)[1].str() + "." + (*found)[2].str(),
                      findings);
    }
}

/// Methods have the name "Class.test_method", as unittest prints it.
void CheckPythonTests(const std::string& path, const std::vector<std::string>& lines,
                      Findings& findings)
{
    static const std::regex classes(R"(^class\s+(\w+))");
    static const std::regex test(R"(^(\s*)def\s+(test_\w+))");
    std::string suite;
    std::smatch found;
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
        if (std::regex_search(lines[i], found, classes))
        {
            suite = found[1].str() + ".";
        }
        else if (std::regex_search(lines[i], found, test))
        {
            CheckTestName(path, i + 1, (found.length(1) > 0 ? suite : "") + found[2].str(),
                          findings);
        }
    }
}

} // namespace

Findings CheckFiles(const fs::path& root)
{
    static const std::set<std::string> textual{"",      ".h",  ".cpp",  ".txt", ".cmake",
                                               ".json", ".md", ".glsl", ".sh",  ".in"};
    Findings findings;
    for (const std::string& path : FilesBelow(root))
    {
        if (!textual.contains(fs::path(path).extension().string()))
        {
            continue;
        }
        const std::vector<std::string> lines = ReadLines(root / path);
        if (IsCpp(path))
        {
            CheckSource(path, lines, findings);
        }
        for (std::size_t i = 0; i < lines.size(); ++i)
        {
            if (const std::string folder = MachineFolder(lines[i]); !folder.empty())
            {
                findings.push_back(At(path, i + 1) + "names a folder of one machine (" + folder +
                                   "…)");
            }
        }
    }
    return findings;
}

Findings CheckTestNames(const fs::path& root)
{
    Findings findings;
    for (const std::string& path : FilesBelow(root))
    {
        if (IsCpp(path))
        {
            CheckCppTests(path, ReadLines(root / path), findings);
        }
        else if (path.ends_with(".py"))
        {
            CheckPythonTests(path, ReadLines(root / path), findings);
        }
    }
    return findings;
}

Findings CheckExactArithmetic(const fs::path& root, const fs::path& compileCommands)
{
    const std::string ours = "\"file\": \"" + root.generic_string() + "/";
    Findings findings;
    std::size_t commands = 0;
    std::string command;
    for (const std::string& line : ReadLines(compileCommands))
    {
        if (line.find("\"command\": ") != std::string::npos)
        {
            command = line;
        }
        const std::size_t at = line.find(ours);
        if (at == std::string::npos)
        {
            continue;
        }
        ++commands;
        const std::string file = line.substr(at + ours.size(), line.rfind('"') - at - ours.size());
        const std::size_t last = command.rfind("-ffp-contract=");
        if (last == std::string::npos || !command.substr(last).starts_with("-ffp-contract=off"))
        {
            findings.push_back(file +
                               ": is compiled without -ffp-contract=off; use boxreel_configure");
        }
        for (const char* flag :
             {"-ffast-math", "-Ofast", "-funsafe-math-optimizations", "-march=native"})
        {
            if (command.find(flag) != std::string::npos)
            {
                findings.push_back(file + ": is compiled with " + flag + ", which changes results");
            }
        }
    }
    if (commands == 0)
    {
        findings.push_back(compileCommands.string() +
                           ": names no source of this checkout; configure with a preset");
    }
    std::ranges::sort(findings);
    return findings;
}

Findings CheckWatchedFolders(const fs::path& root)
{
    std::string watched;
    for (const std::string& line : ReadLines(root / "boxreel"))
    {
        if (line.starts_with("programSources='"))
        {
            watched = line;
        }
    }
    Findings findings;
    const std::vector<std::string> lines = ReadLines(root / "CMakeLists.txt");
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
        const std::size_t at = lines[i].find("add_subdirectory(");
        if (at == std::string::npos)
        {
            continue;
        }
        const std::size_t name = at + std::string_view("add_subdirectory(").size();
        const std::string folder = lines[i].substr(name, lines[i].find_first_of(" )", name) - name);
        if (!folder.starts_with("tests") && watched.find(" " + folder) == std::string::npos)
        {
            findings.push_back(At("CMakeLists.txt", i + 1) + folder +
                               " is missing in programSources of the boxreel script");
        }
    }
    return findings;
}

} // namespace architecture
