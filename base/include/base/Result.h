// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <variant>

/// @file
/// How the toolkit reports errors of the environment (files, codecs, drivers, arguments).
/// Libraries return them; they never print, exit or throw across a module. Programming errors of
/// the caller are asserted instead.
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

/// What went wrong, as data. Text() is the only place that makes a sentence of it.
struct Error
{
    ErrorKind kind = ErrorKind::Failed; ///< whose fault it is
    std::string culprit; ///< what is at fault, as the caller named it: an option, a file, a name
    std::string problem = {}; ///< what is wrong with it: lower case, no full stop
    std::string remedy = {};  ///< what to do about it: lower case, no full stop; may be empty

    /// "film.mp4: already exists; use --force to replace it"
    std::string Text() const;
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
    /// Moves the error out; only where there is no value.
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
    /// Failure.
    Result(Error error) : m_error(std::move(error)), m_failed(true) {}

    /// Whether all went well.
    explicit operator bool() const { return !m_failed; }
    /// What went wrong; empty where nothing did.
    const Error& GetError() const { return m_error; }
    /// Moves the error out; empty where nothing went wrong.
    Error TakeError() && { return std::move(m_error); }

private:
    Error m_error;
    bool m_failed = false;
};

} // namespace boxreel
