// SPDX-License-Identifier: MIT
#include "ChildProcess.h"

#include <cerrno>
#include <cstring>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace boxreel
{
namespace
{

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

/// The program with its standard output in a pipe; returns 0 or the reason why not.
int Spawn(const std::filesystem::path& program, std::vector<char*>& words, const int (&ends)[2],
          pid_t& child)
{
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addclose(&actions, ends[0]);
    posix_spawn_file_actions_addclose(&actions, ends[1]);
    const int failure =
        posix_spawn(&child, program.c_str(), &actions, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return failure;
}

} // namespace

Result<std::string> OutputOf(const std::filesystem::path& program,
                             const std::vector<std::string>& arguments)
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
    pid_t child = 0;
    const int failure = Spawn(program, words, ends, child);
    close(ends[1]);
    const std::string output = failure == 0 ? ReadAll(ends[0]) : std::string();
    close(ends[0]);
    if (failure != 0)
    {
        return CannotRun(program, std::strerror(failure));
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
    {}
    if (WIFSIGNALED(status))
    {
        return CannotRun(program, "signal " + std::to_string(WTERMSIG(status)) + " ended it");
    }
    if (WEXITSTATUS(status) != 0)
    {
        return CannotRun(program, "it ended with code " + std::to_string(WEXITSTATUS(status)));
    }
    return output;
}

} // namespace boxreel
