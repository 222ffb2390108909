// SPDX-License-Identifier: MIT
#include "CompareChoice.h"

#include <string>

namespace boxreel
{
namespace
{

template <class Value>
void Replace(Value& limit, const std::optional<Value>& given, const char* option,
             std::string& options)
{
    if (given)
    {
        limit = *given;
        options += (options.empty() ? ", with " : ", ") + std::string(option);
    }
}

} // namespace

CompareSettings Effective(const CompareChoice& choice)
{
    CompareSettings settings = choice.preset;
    std::string options;
    Replace(settings.tolerance, choice.tolerance, "--tolerance", options);
    Replace(settings.edgeShift, choice.edgeShift, "--edge-shift", options);
    Replace(settings.maxPixels, choice.maxPixels, "--max-pixels", options);
    Replace(settings.maxRatio, choice.maxRatio, "--max-ratio", options);
    Replace(settings.maxInWindow, choice.maxInWindow, "--max-in-window", options);
    Replace(settings.densityWindow, choice.window, "--window", options);
    settings.adaptsToRenderer = settings.adaptsToRenderer && options.empty();
    settings.ignored = choice.ignored;
    settings.ignoredBodies = choice.ignoredBodies;
    for (const auto& [isGiven, option] :
         {std::pair(!choice.ignored.empty(), "--ignore"),
          std::pair(!choice.ignoredBodies.empty(), "--ignore-body")})
    {
        options += !isGiven ? "" : (options.empty() ? ", with " : ", ") + std::string(option);
    }
    settings.preset += options + (options.empty() ? "" : ",");
    return settings;
}

} // namespace boxreel
