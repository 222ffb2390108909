// SPDX-License-Identifier: MIT
#include <base/Result.h>

namespace boxreel
{

std::string Error::Text() const
{
    std::string text = culprit;
    if (!problem.empty())
    {
        text += (text.empty() ? "" : ": ") + problem;
    }
    if (!remedy.empty())
    {
        text += (text.empty() ? "" : "; ") + remedy;
    }
    return text;
}

} // namespace boxreel
