// SPDX-License-Identifier: MIT
#pragma once

#include <base/ErrorText.h>

#include <string>
#include <utility>
#include <variant>

/// @file
/// Errors of the environment (files, codecs, drivers, arguments). Libraries return them; they never
/// print, exit or throw across a module. Programming errors of the caller are asserted instead.
namespace boxreel
{

/// The value is the exit code of the `boxreel` command.
enum class ErrorKind
{
    Unusable = 1,  ///< what the caller named is unknown, missing, malformed, contradictory or
                   ///< already exists
    Different = 2, ///< two things that should be equal differ
    Absent = 3,    ///< a library, encoder or device is not available on this machine
    Failed = 4,    ///< reading or writing failed during the operation
};

/// An error as data. Only Text() forms a sentence.
struct Error
{
    ErrorKind kind = ErrorKind::Failed; ///< category of the cause
    ErrorText culprit;      ///< the setting, file or name at fault, as the caller named it
    ErrorText problem = {}; ///< the problem: lower case, no full stop
    ErrorText remedy = {};  ///< the remedy: lower case, no full stop; may be empty

    /// Returns "film.mp4: already exists; choose another name", settings in these names.
    std::string Text(SettingNames names = {}) const;
};

/// Either a value or an Error. Test it before use: `if (!result) return result.GetError();`
template <class T>
class [[nodiscard]] Result
{
public:
    /// Creates a success.
    Result(T value) : m_content(std::in_place_index<0>, std::move(value)) {}
    /// Creates a failure.
    Result(Error error) : m_content(std::in_place_index<1>, std::move(error)) {}

    /// True if there is a value.
    explicit operator bool() const { return m_content.index() == 0; }
    /// Returns the value; only if there is one.
    T& operator*() & { return std::get<0>(m_content); }
    /// Returns the value; only if there is one.
    const T& operator*() const& { return std::get<0>(m_content); }
    /// Returns the value; only if there is one.
    T&& operator*() && { return std::get<0>(std::move(m_content)); }
    /// Accesses a member of the value; only if there is one.
    T* operator->() { return &std::get<0>(m_content); }
    /// Accesses a member of the value; only if there is one.
    const T* operator->() const { return &std::get<0>(m_content); }
    /// Returns the error; only if there is no value.
    const Error& GetError() const { return std::get<1>(m_content); }
    /// Moves the error out; only if there is no value.
    Error TakeError() && { return std::get<1>(std::move(m_content)); }

private:
    std::variant<T, Error> m_content;
};

/// Success without a value, or an Error.
template <>
class [[nodiscard]] Result<void>
{
public:
    Result() = default;
    /// Creates a failure.
    Result(Error error) : m_error(std::move(error)), m_failed(true) {}

    /// True on success.
    explicit operator bool() const { return !m_failed; }
    /// Returns the error; empty on success.
    const Error& GetError() const { return m_error; }
    /// Moves the error out; empty on success.
    Error TakeError() && { return std::move(m_error); }

private:
    Error m_error;
    bool m_failed = false;
};

} // namespace boxreel
