// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// The common parts of the completion scripts of both shells. Private to Completion*.cpp.
namespace boxreel
{

/// Functions of a POSIX shell. The first turns lines into names of scenes that need no quotes, as
/// SceneSlug makes them. The second prints those of all scenes of $program. If that is the script
/// of a checkout, it does not build meanwhile.
constexpr const char* kSceneFunctions = R"sh(_boxreel_slugs()
{
    LC_ALL=C sed -e "s/['\\\\]//g" -e 's/[^A-Za-z0-9][^A-Za-z0-9]*/-/g' -e 's/^-//' -e 's/-$//' \
        -e 'y/ABCDEFGHIJKLMNOPQRSTUVWXYZ/abcdefghijklmnopqrstuvwxyz/'
}

_boxreel_all_scenes()
{
    BOXREEL_NO_BUILD=1 "$program" list --names </dev/null 2>/dev/null | _boxreel_slugs
}
)sh";

/// "record": the last word of a command's path.
inline std::string LastWord(const std::string& path)
{
    return path.substr(path.rfind(' ') + 1);
}

} // namespace boxreel
