// SPDX-License-Identifier: MIT
#include "ChildProcess.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace boxreel
{
namespace
{

enum class Heard
{
    Output,          ///< its standard error is ours
    OutputAndErrors, ///< both
};

Error CannotRun(const std::filesystem::path& program, const std::string& why)
{
    return Error{ErrorKind::Failed, "Running '" + program.string() + "' failed: " + why + "."};
}

/// Everything until the other end is closed.
std::string ReadAll(int file)
{
    std::string text;
    char buffer[4096];
    for (;;)
    {
        const ssize_t count = read(file, buffer, sizeof buffer);
        if (count > 0)
        {
            text.append(buffer, std::size_t(count));
        }
        else if (count == 0 || errno != EINTR)
        {
            return text;
        }
    }
}

/// The program with its words in a pipe; returns 0 or the reason why not.
int Spawn(const std::filesystem::path& program, std::vector<char*>& words, Heard heard,
          const int (&ends)[2], pid_t& child)
{
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    if (heard == Heard::OutputAndErrors)
    {
        posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
    }
    posix_spawn_file_actions_addclose(&actions, ends[0]);
    posix_spawn_file_actions_addclose(&actions, ends[1]);
    const int failure =
        posix_spawnp(&child, program.c_str(), &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return failure;
}

double SecondsOf(const timeval& time)
{
    return double(time.tv_sec) + 1e-6 * double(time.tv_usec);
}

/// How it ended; empty: well, with 0 or `otherCode`.
std::string Ending(int status, int otherCode)
{
    if (WIFSIGNALED(status))
    {
        return "signal " + std::to_string(WTERMSIG(status)) + " ended it";
    }
    const int code = WEXITSTATUS(status);
    return code == 0 || code == otherCode ? "" : "it ended with code " + std::to_string(code);
}

/// The last line that is not empty, as the end of a sentence.
std::string LastWords(std::string output)
{
    output.erase(output.find_last_not_of(" \t\r\n") + 1);
    const std::string line = output.substr(output.rfind('\n') + 1);
    return line.empty() ? "" : ", saying \"" + line + "\"";
}

Result<ChildRun> Run(const std::filesystem::path& program,
                     const std::vector<std::string>& arguments, Heard heard, int otherCode)
{
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments)
    {
        words.push_back(const_cast<char*>(argument.c_str()));
    }
    words.push_back(nullptr);
    int ends[2];
    if (pipe(ends) != 0)
    {
        return CannotRun(program, std::strerror(errno));
    }
    ChildRun run;
    const auto start = std::chrono::steady_clock::now();
    pid_t child = 0;
    const int failure = Spawn(program, words, heard, ends, child);
    close(ends[1]);
    run.output = failure == 0 ? ReadAll(ends[0]) : std::string();
    close(ends[0]);
    if (failure != 0)
    {
        return CannotRun(program, std::strerror(failure));
    }
    int status = 0;
    rusage usage{};
    while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR)
    {}
    run.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    run.cpu = SecondsOf(usage.ru_utime) + SecondsOf(usage.ru_stime);
    run.memory = 1024.0 * double(usage.ru_maxrss);
    run.code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    const std::string ending = Ending(status, otherCode);
    if (!ending.empty())
    {
        return CannotRun(program, ending + (heard == Heard::OutputAndErrors ? LastWords(run.output)
                                                                            : std::string()));
    }
    return run;
}

} // namespace

Result<std::string> OutputOf(const std::filesystem::path& program,
                             const std::vector<std::string>& arguments)
{
    Result<ChildRun> run = Run(program, arguments, Heard::Output, 0);
    return run ? Result<std::string>(std::move(run->output)) : Result<std::string>(run.GetError());
}

Result<ChildRun> RunMeasured(const std::filesystem::path& program,
                             const std::vector<std::string>& arguments, int otherCode)
{
    return Run(program, arguments, Heard::OutputAndErrors, otherCode);
}

} // namespace boxreel
