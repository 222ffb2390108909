// SPDX-License-Identifier: MIT
#include "Program.h"

int main(int argc, char** argv)
{
    return boxreel::RunProgram(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc));
}
