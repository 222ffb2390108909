// SPDX-License-Identifier: MIT
#pragma once

#include "../../base/TemporaryFolder.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// Runs the real program the way a shell would, for tests of exit codes, messages and files.
namespace boxreel
{

struct Outcome
{
    int code = -1; ///< exit code, or 128 + the signal that ended it
    std::string output;
    std::string errors;
    long peakKilobytes = 0; ///< most memory it had at once
};

/// Runs the program in `folder`. `whileRunning`, when given, is called with its process id once
/// started.
Outcome RunBoxreel(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                   const std::function<void(int)>& whileRunning = {});

/// Runs another program, which is looked for on the PATH; `words`: its name and its arguments.
Outcome RunTool(const std::vector<std::string>& words, const std::filesystem::path& folder);

/// A variable of the environment, which is as it was before when this goes.
class Variable
{
public:
    Variable(const char* name, const std::string& value);
    ~Variable();
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* m_name;
    std::optional<std::string> m_before;
};

} // namespace boxreel
