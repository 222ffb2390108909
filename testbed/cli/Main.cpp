// SPDX-License-Identifier: MIT
#include "Program.h"

#include <csignal>

int main(int argc, char** argv)
{
    // A file that grows beyond a limit of the shell's is an error of writing, for which all that
    // write know a sentence and leave nothing behind.
    std::signal(SIGXFSZ, SIG_IGN);
    return boxreel::RunProgram(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc));
}
