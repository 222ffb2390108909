// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>

/// For tests of what a caller can get wrong.
namespace dynamics
{

inline constexpr float32 kNaN = std::numeric_limits<float32>::quiet_NaN();
inline constexpr float32 kInfinity = std::numeric_limits<float32>::infinity();

/// Makes the mistake: with asserts on it must end with `sentence` (a part of it), with asserts off
/// it must return.
inline void ExpectMisuse(const char* sentence, const std::function<void()>& mistake)
{
#if BOXREEL_ASSERTS
    EXPECT_DEATH(mistake(), sentence);
#else
    SCOPED_TRACE(sentence);
    mistake();
#endif
}

} // namespace dynamics
