// SPDX-License-Identifier: MIT
#include "Declare.h"

namespace boxreel
{
CLI::Option* AddFlag(CLI::App& command, const std::string& names, bool& flag,
                     const std::string& help)
{
    return command.add_flag(names, flag, help);
}

CLI::Option* AddText(CLI::App& command, const std::string& names,
                     const std::function<void(const std::string&)>& read, const std::string& help)
{
    return command.add_option_function<std::string>(names, read, help);
}

CLI::Option* AddTexts(CLI::App& command, const std::string& names,
                      const std::function<void(const std::vector<std::string>&)>& read,
                      const std::string& help)
{
    return command.add_option_function<std::vector<std::string>>(names, read, help);
}

std::string Filled(std::string start, const std::vector<std::string>& words,
                   const std::string& separator)
{
    constexpr std::size_t kLineLength = 66;
    std::size_t lineStart = 0;
    for (std::size_t i = 0; i < words.size(); ++i)
    {
        const std::string word = words[i] + (i + 1 < words.size() ? separator : "");
        if (start.size() - lineStart + word.size() > kLineLength)
        {
            start.erase(start.find_last_not_of(' ') + 1);
            start += '\n';
            lineStart = start.size();
        }
        start += word;
    }
    return start;
}

Error Missing(const std::string& subject, const std::string& argument, const std::string& example)
{
    return {ErrorKind::Unusable, subject, "requires " + argument, "such as `" + example + "`"};
}

Error Conflict(const std::string& option, const std::string& other)
{
    return {ErrorKind::Unusable, option, "cannot be used with " + other, "remove one of them"};
}

Error Requires(const std::string& option, const std::string& other)
{
    return {ErrorKind::Unusable, option, "requires " + other};
}

CLI::Option* AddScene(CLI::App& command, std::string& scene)
{
    CLI::Option* option =
        AddName(command, "SCENE", scene, "A name from `boxreel list`, or a R.U.B.E. .json file");
    return Completes(option, {Completion::Kind::Scenes, {".json"}});
}

CLI::Option* AddName(CLI::App& command, const std::string& argument, std::string& name,
                     const std::string& help)
{
    const auto read = [&name](const std::string& text) {
        name = NotEmpty("", text, "give a name");
    };
    return AddText(command, argument, read, help)->type_name("");
}

std::string NotEmpty(const std::string& option, const std::string& text, const std::string& remedy)
{
    if (text.empty())
    {
        throw Refusal({ErrorKind::Unusable, option.empty() ? "\"\"" : option, "is empty", remedy});
    }
    return text;
}

std::vector<std::filesystem::path> PathsOf(const std::vector<std::string>& texts)
{
    std::vector<std::filesystem::path> paths;
    for (const std::string& text : texts)
    {
        paths.emplace_back(NotEmpty("", text));
    }
    return paths;
}

void AddPath(CLI::App& command, const std::string& names, const std::string& unit,
             std::filesystem::path& path, const std::string& help,
             const std::vector<std::string>& ends)
{
    const std::string named = names.starts_with("-") ? names.substr(0, names.find(',')) : "";
    const auto read = [&path, named](const std::string& text) { path = NotEmpty(named, text); };
    CLI::Option* option = AddText(command, names, read, help);
    option->type_name(unit);
    Completes(option, unit == "DIR" ? Completion{Completion::Kind::Folders, {}}
                                    : Completion{Completion::Kind::Files, ends});
}

void AddForce(CLI::App& command, bool& force)
{
    AddFlag(command, "--force", force, "Overwrite an existing file");
}

void AddStats(CLI::App& command, bool& stats)
{
    AddFlag(command, "--stats", stats, "Print rendering statistics and a timing breakdown");
}

CLI::Option* AddBackend(CLI::App& command, Backend& backend)
{
    CLI::Option* option = AddValue(command, "--backend", "NAME", backend, ParseBackend,
                                   "Draw with " + JoinedBy(", ", BackendNames()) +
                                       "\n(auto: $BOXREEL_BACKEND, or what works)");
    return Completes(option, {Completion::Kind::Words, BackendNames()});
}

} // namespace boxreel
