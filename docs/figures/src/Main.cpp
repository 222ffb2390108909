// SPDX-License-Identifier: MIT
// boxreel_docs_figures OUTDIR [NAME…]: draws the figures of the manual, all of them and their page
// unless some are named, each for light and for dark pages.
#include "FigureTable.h"

#include <base/AtomicFile.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iostream>

using namespace boxreel;

namespace
{

Result<void> Write(const std::filesystem::path& folder, const figures::FigureEntry& entry)
{
    Figure figure = entry.draw();
    figure.title = entry.title;
    for (const auto& [twin, theme] :
         {std::pair("-light.svg", Theme::Print()), std::pair("-dark.svg", Theme::Dark())})
    {
        figure.theme = theme;
        const Result<void> written =
            WriteSvg(folder / (std::string(entry.name) + twin), figure, {.overwrite = true});
        if (!written)
        {
            return written;
        }
    }
    return {};
}

/// Returns the named figures, or all. Error: unknown name.
Result<std::vector<figures::FigureEntry>> Wanted(const std::vector<std::string_view>& names)
{
    if (names.empty())
    {
        return figures::FigureTable();
    }
    std::vector<figures::FigureEntry> wanted;
    for (const std::string_view name : names)
    {
        const auto& table = figures::FigureTable();
        const auto entry = std::ranges::find(table, name, &figures::FigureEntry::name);
        if (entry == table.end())
        {
            return Error{ErrorKind::Unusable,
                         "there is no figure \"" + std::string(name) +
                             "\"; name none to draw them all, or one of FigureTable.cpp"};
        }
        wanted.push_back(*entry);
    }
    return wanted;
}

Result<void> Run(const std::filesystem::path& folder, const std::vector<std::string_view>& names)
{
    const auto wanted = Wanted(names);
    if (!wanted)
    {
        return wanted.GetError();
    }
    for (const figures::FigureEntry& entry : *wanted)
    {
        if (const Result<void> written = Write(folder, entry); !written)
        {
            return written;
        }
    }
    return names.empty()
               ? WriteWhole(folder / "README.md", std::string_view(figures::Gallery(*wanted)), true)
               : Result<void>();
}

} // namespace

// NOLINTNEXTLINE(bugprone-exception-escape): what is thrown where memory runs out may end it
int main(int argc, char** argv)
{
    constexpr const char* kUsage = "usage: boxreel_docs_figures OUTDIR [NAME…]\n";
    const std::string_view first = argc < 2 ? "" : argv[1];
    if (first == "--help" || first == "-h")
    {
        std::cout << kUsage;
        return 0;
    }
    if (first.empty() || first.front() == '-')
    {
        std::cerr << kUsage;
        return 1;
    }
    std::signal(SIGXFSZ, SIG_IGN); // a limit of the shell's is an error of writing
    const Result<void> done = Run(argv[1], {argv + 2, argv + argc});
    if (!done)
    {
        std::cerr << "boxreel_docs_figures: " << done.GetError().Text() << '\n';
        return int(done.GetError().kind);
    }
    return 0;
}
