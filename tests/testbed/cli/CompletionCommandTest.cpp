// SPDX-License-Identifier: MIT
// Completions in real shells, and the warnings of groff about the manual page.
#include "Subprocess.h"

#include <cli/CommandTree.h>
#include <session/SceneSearch.h>

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

namespace boxreel
{
namespace
{

using testing::Contains;
using testing::HasSubstr;
using testing::UnorderedElementsAreArray;

class CompletionCommand : public testing::Test
{
protected:
    void SetUp() override
    {
        for (const char* name : {"film.mp4", "my film.mkv", "it's.json", "car.play", "a.png"})
        {
            std::ofstream(folder / name) << "\n";
        }
        std::filesystem::create_directory(folder / "my films");
        const Outcome bash = RunBoxreel({"completion", "bash"}, folder.Path());
        EXPECT_EQ(bash.errors, "");
        Write("bash", bash.output);
        Write("zsh", RunBoxreel({"completion", "zsh"}, folder.Path()).output);
    }

    void Write(const std::string& name, const std::string& text) const
    {
        std::ofstream(folder / name, std::ios::binary) << text;
    }

    /// Returns the completions of bash at the end of each line, with the words as readline splits
    /// them.
    std::vector<std::vector<std::string>> BashOffers(const std::vector<std::string>& lines) const
    {
        Write("ask.bash", R"sh(
            source ./bash
            program=$1
            shift
            for line; do
                eval "COMP_WORDS=(\"\$program\" $line)"
                COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
                _boxreel
                printf '%s|' "${COMPREPLY[@]}"
                echo
            done
        )sh");
        std::vector<std::string> words{"bash", "--noprofile", "--norc", "-u", "ask.bash", program};
        words.insert(words.end(), lines.begin(), lines.end());
        const Outcome outcome = RunTool(words, folder.Path());
        EXPECT_EQ(outcome.errors, "");
        std::vector<std::vector<std::string>> offers;
        std::istringstream answers(outcome.output);
        for (std::string answer; std::getline(answers, answer);)
        {
            offers.emplace_back();
            std::istringstream parts(answer);
            for (std::string part; std::getline(parts, part, '|');)
            {
                if (!part.empty())
                {
                    offers.back().push_back(part);
                }
            }
        }
        EXPECT_EQ(offers.size(), lines.size()) << outcome.output;
        offers.resize(lines.size());
        return offers;
    }

    std::vector<std::string> BashOffer(const std::string& line) const
    {
        return BashOffers({line}).front();
    }

    /// Each line as zsh leaves it when Tab is hit at its end. It edits lines on terminals only,
    /// which script(1) provides.
    /// `setup`: how zsh gets to know the script.
    std::vector<std::string> ZshCompletes(const std::vector<std::string>& lines,
                                          const std::string& setup) const
    {
        std::string all;
        for (const std::string& line : lines)
        {
            all += line + "\n";
        }
        Write("lines", all);
        Write(".zshrc", "path=($PROGRAM_FOLDER $path)\n" + setup + R"sh(
            zle-line-init()
            {
                local line
                for line in "${(@f)$(<lines)}"; do
                    BUFFER=$line
                    CURSOR=$#BUFFER
                    zle complete-word
                    print -r -- "$BUFFER" >>completed
                done
                exit
            }
            zle -N zle-line-init
        )sh");
        const std::string programFolder = std::filesystem::path(program).parent_path().string();
        const Outcome outcome =
            RunTool({"env", "ZDOTDIR=" + folder.Path().string(), "PROGRAM_FOLDER=" + programFolder,
                     "TERM=dumb", "script", "-qec", "zsh -o no_global_rcs -i", "/dev/null"},
                    folder.Path());
        std::vector<std::string> completed;
        std::istringstream text(ReadBytes(folder / "completed"));
        for (std::string line; std::getline(text, line);)
        {
            completed.push_back(line);
        }
        EXPECT_EQ(completed.size(), lines.size()) << outcome.output << "Is zsh installed?";
        return completed;
    }

    /// The call of a checkout's script after everything is built.
    void CallThroughAScript()
    {
        program = (folder / "boxreel").string();
        Write("boxreel", std::string("#!/bin/sh\nexec ") + BOXREEL_PROGRAM + " \"$@\"\n");
        std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    }

    TemporaryFolder folder;
    std::string program = BOXREEL_PROGRAM;
};

TEST_F(CompletionCommand, OffersEveryCommandAndOptionInBash)
{
    const CommandText described = DescribeProgram();
    const std::vector<const CommandText*> commands = AllCommands(described);
    std::vector<std::string> lines;
    for (const CommandText* command : commands)
    {
        const std::string words = command->path.substr(described.path.size());
        lines.push_back(words + " --");
        lines.push_back(words + " ''");
    }
    const std::vector<std::vector<std::string>> offers = BashOffers(lines);
    for (std::size_t i = 0; i < commands.size(); ++i)
    {
        std::vector<std::string> options;
        for (const OptionText& option : commands[i]->options)
        {
            options.push_back(option.names.back());
        }
        EXPECT_THAT(offers[2 * i], UnorderedElementsAreArray(options)) << lines[2 * i];
        for (const CommandText& next : commands[i]->commands)
        {
            const std::string name = next.path.substr(next.path.rfind(' ') + 1);
            EXPECT_THAT(offers[2 * i + 1], Contains(name));
        }
    }
}

TEST_F(CompletionCommand, OffersValidSceneNamesInBash)
{
    const std::vector<std::string> offered = BashOffer("record ''");
    std::vector<std::string> slugs;
    for (const SceneEntry& entry : AllScenes())
    {
        slugs.push_back(SceneSlug(entry.name));
    }
    EXPECT_THAT(offered, UnorderedElementsAreArray(slugs));
    for (std::size_t i = 0; i < offered.size(); ++i)
    {
        const Result<const SceneEntry*> scene = FindScene(offered[i]);
        EXPECT_TRUE(scene && *scene == &AllScenes()[i]) << offered[i];
        EXPECT_EQ(offered[i].find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"),
                  std::string::npos);
    }
}

TEST_F(CompletionCommand, OffersValuesOfPositionInBash)
{
    const std::pair<std::string, std::vector<std::string>> cases[] = {
        {"rec", {"record"}},
        {"golden ver", {"verify"}},
        {"shot NEWT", {"newtons-cradle"}},
        {"shot \"Newton\\'s\\ C\"", {"newtons-cradle"}},
        {"shot it", {"it's.json"}},
        {"record pyramid --qual", {"--quality"}},
        {"record --quality h", {"high"}},
        {"record --quality = h", {"high"}},
        {"record --quality =", {"draft", "standard", "high", "lossless"}},
        {"record pyramid -o fi", {"film.mp4"}},
        {"record pyramid --output my", {"my films", "my film.mkv"}},
        {"record pyramid --snapshots ''", {"my films"}},
        {"record --camera follow : 13 : 8 newt", {"newtons-cradle"}},
        {"record --seconds ''", {}},
        {"shot --draw shapes,jo", {"shapes,joints"}},
        {"shot --theme bo", {"both"}},
        {"record --theme bo", {}},
        {"play c", {"car.play"}},
        {"diff --preset ex", {"exact"}},
        {"diff a", {"a.png"}},
        {"merge film.mp4 f", {"film.mp4"}},
        {"golden verify --backend osm", {"osmesa"}},
        {"golden verify bridge newt", {"newtons-cradle"}},
        {"completion z", {"zsh"}},
        {"nonsense ''", {"-h", "--help", "--version"}},
    };
    std::vector<std::string> lines;
    for (const auto& [line, expected] : cases)
    {
        lines.push_back(line);
    }
    const std::vector<std::vector<std::string>> offers = BashOffers(lines);
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
        EXPECT_THAT(offers[i], UnorderedElementsAreArray(cases[i].second)) << lines[i];
    }
}

TEST_F(CompletionCommand, RegistersCompletionByNameInBash)
{
    const Outcome outcome = RunTool({"bash", "-c", ". ./bash; complete -p boxreel"}, folder.Path());
    EXPECT_EQ(outcome.output, "complete -F _boxreel boxreel\n");
}

TEST_F(CompletionCommand, OffersValuesOfPositionInZsh)
{
    const std::pair<std::string, std::string> cases[] = {
        {"boxreel rec", "boxreel record "},
        {"boxreel golden ver", "boxreel golden verify "},
        {"boxreel shot NEWT", "boxreel shot newtons-cradle "},
        {"boxreel shot it", "boxreel shot it\\'s.json "},
        {"boxreel golden verify newt", "boxreel golden verify newtons-cradle "},
        {"boxreel record --qual", "boxreel record --quality="},
        {"boxreel record pyramid --quality=dr", "boxreel record pyramid --quality=draft "},
        {"boxreel record pyramid --quality dr", "boxreel record pyramid --quality draft "},
        {"boxreel record pyramid -o fi", "boxreel record pyramid -o film.mp4 "},
        {"boxreel record pyramid --snapshots m", "boxreel record pyramid --snapshots my\\ films/"},
        {"boxreel shot pyramid --draw shapes,jo", "boxreel shot pyramid --draw shapes,joints,"},
        {"boxreel record pyramid --force --forc", "boxreel record pyramid --force --force-scale="},
        {"boxreel play c", "boxreel play car.play "},
        {"boxreel merge my\\ film.mkv f", "boxreel merge my\\ film.mkv film.mp4 "},
        {"boxreel completion z", "boxreel completion zsh "},
    };
    std::vector<std::string> lines;
    std::vector<std::string> expected;
    for (const auto& [line, completed] : cases)
    {
        lines.push_back(line);
        expected.push_back(completed);
    }
    EXPECT_EQ(ZshCompletes(lines, "autoload -Uz compinit; compinit -u -D; source ./zsh"), expected);
}

TEST_F(CompletionCommand, LoadsScriptFromFpathInZsh)
{
    Write("_boxreel", ReadBytes(folder / "zsh"));
    const std::string setup = "fpath=($PWD $fpath); autoload -Uz compinit; compinit -u -D";
    EXPECT_EQ(ZshCompletes({"boxreel rec", "boxreel shot newt"}, setup),
              (std::vector<std::string>{"boxreel record ", "boxreel shot newtons-cradle "}));
}

TEST_F(CompletionCommand, OffersCommandsOfCheckoutScript)
{
    EXPECT_THAT(BashOffer("te"), testing::IsEmpty()) << "the program itself has no such command";
    CallThroughAScript();
    EXPECT_THAT(BashOffers({"te", "golden te"}),
                testing::ElementsAre(testing::ElementsAre("test"), testing::IsEmpty()));
    EXPECT_THAT(BashOffer("''"), testing::IsSupersetOf({"record", "test"}));
    EXPECT_EQ(ZshCompletes({"./boxreel te", "./boxreel rec"},
                           "autoload -Uz compinit; compinit -u -D; source ./zsh"),
              (std::vector<std::string>{"./boxreel test ", "./boxreel record "}));
}

TEST_F(CompletionCommand, DoesNotBuildThroughCheckoutScript)
{
    const std::string build = std::filesystem::path(BOXREEL_PROGRAM).parent_path().string();
    const auto ask = [&](const std::string& buildFolder) {
        return RunTool({"env", "BOXREEL_NO_BUILD=1", "BOXREEL_BUILD_DIR=" + buildFolder,
                        BOXREEL_SCRIPT, "list", "--names"},
                       folder.Path());
    };
    EXPECT_EQ(ask(build).output, RunBoxreel({"list", "--names"}, folder.Path()).output);
    const Outcome none = ask((folder / "none").string());
    EXPECT_EQ(none.code, 4);
    EXPECT_THAT(none.errors, HasSubstr("BOXREEL_NO_BUILD"));
    EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

TEST_F(CompletionCommand, PrintsManualPageWithoutGroffWarnings)
{
    const Outcome page = RunBoxreel({"man"}, folder.Path());
    EXPECT_EQ(page.code, 0);
    Write("boxreel.1", page.output);
    const Outcome shown = RunTool(
        {"groff", "-man", "-ww", "-Tascii", "-P-cbou", "-rLL=200n", "boxreel.1"}, folder.Path());
    EXPECT_EQ(shown.code, 0) << "Is groff installed?";
    EXPECT_EQ(shown.errors, "");
}

} // namespace
} // namespace boxreel
