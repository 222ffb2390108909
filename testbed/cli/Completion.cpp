// SPDX-License-Identifier: MIT
#include "Completion.h"
#include "CommandTree.h"
#include "Declare.h"

#include <base/ErrorMacros.h>
#include <base/Terminal.h>

namespace boxreel
{

Command& Declare(Command& program, CompletionOptions& options)
{
    Command& command = AddCommand(program, "completion", "Print a completion script for a shell");
    AddValue(command, "SHELL", "", options.shell,
             OneOf<Shell>({{"bash", Shell::Bash}, {"zsh", Shell::Zsh}}), "Choose bash or zsh");
    command.notes = {
        {"Completes commands, options, values, scenes and files. Scene names come from\n"
         "`boxreel list --names` and need no quotes, such as newtons-cradle."}};
    command.examples = {
        "source <(boxreel completion bash)   # in ~/.bashrc",
        "source <(boxreel completion zsh)    # in ~/.zshrc, after compinit",
        "boxreel completion bash > ~/.local/share/bash-completion/completions/boxreel"};
    return command;
}

Result<void> Check(CompletionOptions& options)
{
    return options.shell
               ? Result<void>()
               : Error{ErrorKind::Unusable, "completion", "requires SHELL", "give bash or zsh"};
}

Result<int> Run(const CompletionOptions& options)
{
    const CommandText program = DescribeProgram();
    RETURN_IF_ERROR(WriteOutput(options.shell == Shell::Bash ? BashCompletion(program)
                                                             : ZshCompletion(program)));
    return 0;
}

} // namespace boxreel
