// SPDX-License-Identifier: MIT
#include "TreeText.h"

#include <algorithm>
#include <fstream>
#include <set>

namespace fs = std::filesystem;

namespace architecture
{

std::vector<std::string> ReadLines(const fs::path& file)
{
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
    {
        lines.push_back(line);
    }
    return lines;
}

namespace
{

/// True for files of git or a build. In a worktree of git, .git is a file.
bool IsMade(const fs::path& path)
{
    static const std::set<std::string> made{".git", "build", ".cache"};
    return made.contains(path.filename().string()) || fs::exists(path / "CMakeCache.txt");
}

} // namespace

std::vector<std::string> FilesBelow(const fs::path& root)
{
    std::vector<std::string> files;
    for (auto it = fs::recursive_directory_iterator(root); it != fs::recursive_directory_iterator();
         ++it)
    {
        if (IsMade(it->path()))
        {
            it.disable_recursion_pending();
        }
        else if (it->is_regular_file())
        {
            files.push_back(it->path().lexically_relative(root).generic_string());
        }
    }
    std::ranges::sort(files);
    return files;
}

bool IsCpp(std::string_view path)
{
    return path.ends_with(".h") || path.ends_with(".cpp");
}

std::string At(const std::string& path, std::size_t line)
{
    return path + ":" + std::to_string(line) + ": ";
}

} // namespace architecture
