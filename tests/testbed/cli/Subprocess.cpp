// SPDX-License-Identifier: MIT
#include "Subprocess.h"

#include <cstdlib>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace boxreel
{
namespace
{

// A process that runs longer than any test needs is ended [s].
#ifdef BOXREEL_LONGEST_RUN
constexpr unsigned kLongestRun = BOXREEL_LONGEST_RUN;
#else
constexpr unsigned kLongestRun = 280;
#endif

/// Replaces this process, which is a fresh copy, by the program. `arguments`: its name first.
[[noreturn]] void Become(const char* program, const std::vector<std::string>& arguments,
                         const std::filesystem::path& folder, const std::filesystem::path& output,
                         const std::filesystem::path& errors)
{
    std::vector<char*> words;
    for (const std::string& argument : arguments)
    {
        words.push_back(const_cast<char*>(argument.c_str()));
    }
    words.push_back(nullptr);
    const int outputFile = open(output.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
    const int errorFile = open(errors.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
    alarm(kLongestRun);
    if (chdir(folder.c_str()) == 0 && dup2(outputFile, STDOUT_FILENO) >= 0 &&
        dup2(errorFile, STDERR_FILENO) >= 0)
    {
        execvp(program, words.data());
    }
    _exit(127);
}

Outcome Run(const char* program, const std::vector<std::string>& words,
            const std::filesystem::path& folder, const std::function<void(int)>& whileRunning)
{
    const TemporaryFolder logs;
    const pid_t child = fork();
    if (child == 0)
    {
        Become(program, words, folder, logs / "output", logs / "errors");
    }
    if (whileRunning)
    {
        whileRunning(child);
    }
    int status = 0;
    rusage usage = {};
    wait4(child, &status, 0, &usage);
    Outcome outcome;
    outcome.peakKilobytes = usage.ru_maxrss;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.output = ReadBytes(logs / "output");
    outcome.errors = ReadBytes(logs / "errors");
    return outcome;
}

} // namespace

Outcome RunBoxreel(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                   const std::function<void(int)>& whileRunning)
{
    std::vector<std::string> words{"boxreel"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return Run(BOXREEL_PROGRAM, words, folder, whileRunning);
}

Outcome RunTool(const std::vector<std::string>& words, const std::filesystem::path& folder)
{
    return Run(words.front().c_str(), words, folder, {});
}

Variable::Variable(const char* name, const std::string& value) : m_name(name)
{
    if (const char* const before = std::getenv(name))
    {
        m_before = before;
    }
    setenv(name, value.c_str(), 1);
}

Variable::~Variable()
{
    m_before ? setenv(m_name, m_before->c_str(), 1) : unsetenv(m_name);
}

} // namespace boxreel
