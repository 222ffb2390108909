// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Timer.h>

#include <optional>

namespace box2d
{

/// Adds the time of a scope to an entry of the profile; free when the profile is not used.
class ProfileScope
{
public:
    ProfileScope(bool enabled, float32& entry) : m_entry(entry)
    {
        if (enabled)
        {
            m_timer.emplace(); // reads the clock
        }
    }
    ~ProfileScope()
    {
        if (m_timer)
        {
            m_entry += m_timer->GetMilliseconds();
        }
    }
    ProfileScope(const ProfileScope&) = delete;
    ProfileScope& operator=(const ProfileScope&) = delete;

private:
    float32& m_entry;
    std::optional<b2Timer> m_timer;
};

} // namespace box2d
