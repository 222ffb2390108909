// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

#include <chrono>

/// @file
/// A stopwatch.

/// A stopwatch for profiles. Starts on construction. Its values never influence a result.
class b2Timer
{
public:
    /// Restarts at zero.
    void Reset() { m_start = std::chrono::steady_clock::now(); }

    /// Returns the time since the start [ms].
    float32 GetMilliseconds() const
    {
        const std::chrono::duration<float32, std::milli> elapsed =
            std::chrono::steady_clock::now() - m_start;
        return elapsed.count();
    }

private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};
