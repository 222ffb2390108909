// SPDX-License-Identifier: MIT
#pragma once

#include "Subprocess.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <string>

/// For tests of what the program refuses.
namespace boxreel
{

/// The exit code, and one line that begins with the whole culprit.
inline void ExpectRefused(const Outcome& outcome, const std::string& culprit, int code = 1)
{
    EXPECT_EQ(outcome.code, code) << outcome.errors;
    EXPECT_THAT(outcome.errors, testing::StartsWith("boxreel: " + culprit + ": "));
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
}

} // namespace boxreel
