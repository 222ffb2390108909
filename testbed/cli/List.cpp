// SPDX-License-Identifier: MIT
#include "List.h"
#include "Declare.h"

#include <base/ErrorMacros.h>
#include <base/Terminal.h>

#include <algorithm>
#include <cstring>

namespace boxreel
{
namespace
{

std::string Padded(const std::string& text, std::size_t width)
{
    return text + std::string(width > text.size() ? width - text.size() : 0, ' ');
}

std::string Table()
{
    std::size_t categoryWidth = std::strlen("CATEGORY");
    std::size_t nameWidth = std::strlen("NAME");
    for (const SceneEntry& entry : AllScenes())
    {
        categoryWidth = std::max(categoryWidth, std::strlen(entry.category));
        nameWidth = std::max(nameWidth, std::strlen(entry.name));
    }
    const auto row = [&](const std::string& category, const std::string& name,
                         const std::string& summary) {
        return Padded(category, categoryWidth) + "  " + Padded(name, nameWidth) + "  " + summary;
    };
    std::string table = Bold(row("CATEGORY", "NAME", "SHOWS"), stdout) + "\n";
    for (const SceneEntry& entry : AllScenes())
    {
        table += row(entry.category, entry.name, entry.summary) + "\n";
    }
    return table;
}

std::string Names()
{
    std::string names;
    for (const SceneEntry& entry : AllScenes())
    {
        names += std::string(entry.name) + "\n";
    }
    return names;
}

} // namespace

Result<int> Run(const ListOptions& options)
{
    RETURN_IF_ERROR(WriteOutput(options.namesOnly ? Names() : Table()));
    return 0;
}

Command& Declare(Command& program, ListOptions& options)
{
    Command& command = AddCommand(program, "list", "List the scenes");
    AddFlag(command, "--names", options.namesOnly, "Print names only, one per line");
    command.examples = {"boxreel list", "boxreel list --names | head -3"};
    return command;
}

} // namespace boxreel
