// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

/// @file
/// The short form of the most frequent Error.
namespace boxreel
{

/// Returns an Error of kind Unusable.
inline Error Unusable(ErrorText culprit, ErrorText problem, ErrorText remedy = {})
{
    return Error{ErrorKind::Unusable, std::move(culprit), std::move(problem), std::move(remedy)};
}

} // namespace boxreel
