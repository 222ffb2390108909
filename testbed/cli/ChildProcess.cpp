// SPDX-License-Identifier: MIT
#include "ChildProcess.h"

#include <base/Counting.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace boxreel
{
namespace
{

Error CannotRun(const std::filesystem::path& program, const std::string& why)
{
    return Error{ErrorKind::Failed, program.string(), "failed: " + why};
}

using Clock = std::chrono::steady_clock;

/// The output of a child process. `excess` is the reason if reading ended early.
struct Words
{
    std::string text;
    std::string excess;
};

/// Waits for more to read; false when the time is over.
bool HasMore(int file, const ChildBounds& bounds, Clock::time_point start)
{
    for (;;)
    {
        const double left =
            bounds.wall - std::chrono::duration<double>(Clock::now() - start).count();
        pollfd wanted{file, POLLIN, 0};
        const int ready =
            left > 0.0 ? poll(&wanted, 1, int(std::ceil(1000.0 * std::min(left, 1.0e6)))) : 0;
        if (ready > 0 || (ready < 0 && errno != EINTR))
        {
            return true;
        }
        if (left <= 0.0)
        {
            return false;
        }
    }
}

Words ReadAll(int file, const ChildBounds& bounds, Clock::time_point start)
{
    Words words;
    std::string& text = words.text;
    char buffer[4096];
    for (;;)
    {
        if (!HasMore(file, bounds, start))
        {
            words.excess = "it did not end within " + std::to_string(int(bounds.wall)) + " s";
            return words;
        }
        if (text.size() > bounds.output)
        {
            words.excess = "it wrote more than " + SizeText(bounds.output);
            return words;
        }
        const ssize_t count = read(file, buffer, sizeof buffer);
        if (count > 0)
        {
            text.append(buffer, std::size_t(count));
        }
        else if (count == 0 || errno != EINTR)
        {
            return words;
        }
    }
}

/// The program with its words in a pipe; returns 0 or the reason why not.
int Spawn(const std::filesystem::path& program, std::vector<char*>& words, const int (&ends)[2],
          pid_t& child)
{
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addclose(&actions, ends[0]);
    posix_spawn_file_actions_addclose(&actions, ends[1]);
    const int failure =
        posix_spawnp(&child, program.c_str(), &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return failure;
}

/// Describes how the process ended; empty after exit code 0.
std::string Ending(int status)
{
    if (WIFSIGNALED(status))
    {
        return "signal " + std::to_string(WTERMSIG(status)) + " ended it";
    }
    const int code = WEXITSTATUS(status);
    return code == 0 ? "" : "it ended with code " + std::to_string(code);
}

} // namespace

Result<std::string> OutputOf(const std::filesystem::path& program,
                             const std::vector<std::string>& arguments, const ChildBounds& bounds)
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
    const Clock::time_point start = Clock::now();
    pid_t child = 0;
    const int failure = Spawn(program, words, ends, child);
    close(ends[1]);
    Words said = failure == 0 ? ReadAll(ends[0], bounds, start) : Words{};
    close(ends[0]);
    if (failure != 0)
    {
        return CannotRun(program, std::strerror(failure));
    }
    if (!said.excess.empty())
    {
        kill(child, SIGKILL);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
    {}
    if (!said.excess.empty())
    {
        return CannotRun(program, said.excess);
    }
    const std::string ending = Ending(status);
    return ending.empty() ? Result<std::string>(std::move(said.text)) : CannotRun(program, ending);
}

} // namespace boxreel
