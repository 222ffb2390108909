// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

/// A variable of the environment for as long as this lives; nullptr takes it out.
class EnvironmentVariable
{
public:
    EnvironmentVariable(std::string name, const char* value) : m_name(std::move(name))
    {
        if (const char* const before = std::getenv(m_name.c_str()))
        {
            m_before = before;
        }
        Set(value);
    }
    EnvironmentVariable(const EnvironmentVariable&) = delete;
    EnvironmentVariable& operator=(const EnvironmentVariable&) = delete;
    ~EnvironmentVariable() { Set(m_before ? m_before->c_str() : nullptr); }

    void Set(const char* value)
    {
        value ? ::setenv(m_name.c_str(), value, 1) : ::unsetenv(m_name.c_str());
    }

private:
    std::string m_name;
    std::optional<std::string> m_before;
};

/// Clears the environment variables that a golden test reads. The tests themselves run under CTest,
/// in shards or in CI.
struct GoldenEnvironment
{
    EnvironmentVariable references{"BOXREEL_GOLDEN_REFERENCES", nullptr};
    EnvironmentVariable output{"BOXREEL_GOLDEN_OUTPUT", nullptr};
    EnvironmentVariable accept{"BOXREEL_GOLDEN_ACCEPT", nullptr};
    EnvironmentVariable shards{"GTEST_TOTAL_SHARDS", nullptr};
    EnvironmentVariable shard{"GTEST_SHARD_INDEX", nullptr};
    EnvironmentVariable ctest{"DASHBOARD_TEST_FROM_CTEST", nullptr};
    EnvironmentVariable debug{"CTEST_INTERACTIVE_DEBUG_MODE", nullptr};
    EnvironmentVariable ci{"CI", nullptr};
};
