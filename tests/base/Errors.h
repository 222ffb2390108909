// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <gmock/gmock.h>

#include <ostream>
#include <string>

/// Expectations on errors as data. The sentence that Error::Text() makes is not compared.
namespace boxreel
{

/// Prints the Error of a failed expectation.
inline void PrintTo(const Error& error, std::ostream* out)
{
    *out << "kind " << int(error.kind) << ", culprit [" << error.culprit << "]: " << error.problem
         << " [" << error.remedy << "]";
}

/// Without it the bytes of the object are shown.
template <class T>
void PrintTo(const Result<T>& result, std::ostream* out)
{
    if (result)
    {
        *out << "success";
        return;
    }
    PrintTo(result.GetError(), out);
}

/// An Error of this kind with this culprit, a text or a matcher.
MATCHER_P2(IsError, kind, culprit, "")
{
    return testing::ExplainMatchResult(kind, arg.kind, result_listener) &&
           testing::ExplainMatchResult(culprit, arg.culprit, result_listener);
}

/// A Result without a value, with an error of this kind and culprit.
MATCHER_P2(Fails, kind, culprit, "")
{
    return !arg &&
           testing::ExplainMatchResult(IsError(kind, culprit), arg.GetError(), result_listener);
}

/// The same of the kind Unusable, which most errors are.
MATCHER_P(Refuses, culprit, "")
{
    return testing::ExplainMatchResult(Fails(ErrorKind::Unusable, culprit), arg, result_listener);
}

/// Same as Refuses, and problem or remedy contain this number or name.
MATCHER_P2(RefusesWith, culprit, detail, "")
{
    if (!testing::ExplainMatchResult(Refuses(culprit), arg, result_listener))
    {
        return false;
    }
    const Error& error = arg.GetError();
    return (error.problem + " " + error.remedy).Text().find(detail) != std::string::npos;
}

} // namespace boxreel
