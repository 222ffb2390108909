// SPDX-License-Identifier: MIT
#include "SourceTree.h"

#include "TreeText.h"

#include <algorithm>
#include <fnmatch.h>
#include <regex>

namespace fs = std::filesystem;

namespace architecture
{
namespace
{

/// The pages that lead through the tree by the names of its files.
bool IsGuide(const std::string& path)
{
    return path == "ARCHITECTURE.md" || path == "CONTRIBUTING.md" ||
           (path.starts_with("docs/notes/") && path.ends_with(".md"));
}

/// Returns the words that a line shows as code, without arguments: `engine/src/Solver.h` or
/// `Solver.h`.
std::vector<std::string> CodeWords(const std::string& line)
{
    static const std::regex code("`([A-Za-z0-9_.*/-]+)`");
    std::vector<std::string> words;
    for (std::sregex_iterator it(line.begin(), line.end(), code), end; it != end; ++it)
    {
        words.push_back((*it)[1]);
    }
    return words;
}

/// The files and folders that a line links to, without the section within them.
std::vector<std::string> LinkedPaths(const std::string& line)
{
    static const std::regex link("\\]\\(([^):#]+)[^):]*\\)");
    std::vector<std::string> paths;
    for (std::sregex_iterator it(line.begin(), line.end(), link), end; it != end; ++it)
    {
        paths.push_back((*it)[1]);
    }
    return paths;
}

class Tree
{
public:
    explicit Tree(const fs::path& root) : m_root(root), m_files(FilesBelow(root)) {}

    /// True if a word is a path: below a folder of the tree, or a file of one of its kinds. Files
    /// that a recipe asks the reader to add are called Your….
    bool MeansAPath(const std::string& word) const
    {
        static const std::regex file(
            "[A-Za-z0-9*].*\\.(h|cpp|md|txt|py|sh|cmake|play|dox|html|css|js|supp)");
        const std::size_t slash = word.find('/');
        const bool below = slash != std::string::npos && slash > 0 && slash + 1 <= word.size() &&
                           fs::is_directory(m_root / word.substr(0, slash)) &&
                           !word.starts_with("build/");
        return (below || std::regex_match(word, file)) && !word.starts_with("*.") &&
               !word.starts_with("./") && word.find("Your") == std::string::npos &&
               word.find("your") == std::string::npos;
    }

    /// True if a file or folder of the tree has this path, or one that ends like it. A star matches
    /// anything.
    bool Has(const std::string& word) const
    {
        return std::ranges::any_of(m_files, [&](const std::string& file) {
            const std::string path = "/" + file + "/";
            return word.find('*') == std::string::npos
                       ? path.find("/" + word + (word.ends_with('/') ? "" : "/")) !=
                             std::string::npos
                       : fnmatch(("*/" + word + "/*").c_str(), path.c_str(), 0) == 0;
        });
    }

    const std::vector<std::string>& Files() const { return m_files; }

private:
    fs::path m_root;
    std::vector<std::string> m_files;
};

void CheckLine(const fs::path& root, const Tree& tree, const std::string& page, std::size_t number,
               const std::string& line, Findings& findings)
{
    for (const std::string& word : CodeWords(line))
    {
        if (tree.MeansAPath(word) && !tree.Has(word))
        {
            findings.push_back(At(page, number) + "names " + word + ", which does not exist");
        }
    }
    for (const std::string& path : LinkedPaths(line))
    {
        if (!fs::exists(root / fs::path(page).parent_path() / path))
        {
            findings.push_back(At(page, number) + "links to " + path + ", which does not exist");
        }
    }
}

} // namespace

Findings CheckDocumentPaths(const fs::path& root)
{
    const Tree tree(root);
    Findings findings;
    for (const std::string& page : tree.Files())
    {
        if (!IsGuide(page))
        {
            continue;
        }
        const std::vector<std::string> lines = ReadLines(root / page);
        for (std::size_t i = 0; i < lines.size(); ++i)
        {
            CheckLine(root, tree, page, i + 1, lines[i], findings);
        }
    }
    return findings;
}

} // namespace architecture
