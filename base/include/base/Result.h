// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <variant>

/// @file
/// How the toolkit reports what the world outside did wrong (files, codecs, drivers, arguments).
/// Libraries return it; they never print, exit or throw across a module. The caller's own mistakes
/// are asserted instead.
namespace boxreel
{

/// The value is the exit code of the `boxreel` command.
enum class ErrorKind
{
    Unusable =
        1, ///< what the caller named is unknown, missing, malformed, contradictory or in the way
    Different = 2, ///< two things that should be equal are not
    Absent = 3,    ///< a library, encoder or device is not on this machine
    Failed = 4,    ///< reading or writing failed under way
};

/// One sentence for a person: the culprit and the remedy, no trailing newline.
struct Error
{
    ErrorKind kind = ErrorKind::Failed; ///< whose fault it is
    std::string message;                ///< one sentence: the culprit and the remedy
};

/// Either a value or an Error. Test it before use: `if (!result) return result.GetError();`
template <class T>
class [[nodiscard]] Result
{
public:
    /// Success.
    Result(T value) : m_content(std::in_place_index<0>, std::move(value)) {}
    /// Failure.
    Result(Error error) : m_content(std::in_place_index<1>, std::move(error)) {}

    /// Whether there is a value, and no error.
    explicit operator bool() const { return m_content.index() == 0; }
    /// The value; only where there is one.
    T& operator*() & { return std::get<0>(m_content); }
    /// The value; only where there is one.
    const T& operator*() const& { return std::get<0>(m_content); }
    /// The value; only where there is one.
    T&& operator*() && { return std::get<0>(std::move(m_content)); }
    /// Into the value; only where there is one.
    T* operator->() { return &std::get<0>(m_content); }
    /// Into the value; only where there is one.
    const T* operator->() const { return &std::get<0>(m_content); }
    /// What went wrong; only where there is no value.
    const Error& GetError() const { return std::get<1>(m_content); }

private:
    std::variant<T, Error> m_content;
};

/// Success without a value, or an Error.
template <>
class [[nodiscard]] Result<void>
{
public:
    Result() = default;
    /// Failure.
    Result(Error error) : m_error(std::move(error)), m_failed(true) {}

    /// Whether all went well.
    explicit operator bool() const { return !m_failed; }
    /// What went wrong; empty where nothing did.
    const Error& GetError() const { return m_error; }

private:
    Error m_error;
    bool m_failed = false;
};

} // namespace boxreel
