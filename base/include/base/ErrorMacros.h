// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <string_view>
#include <utility>

/// @file
/// Macros that pass an error on in one line, or name a member in one. For our own sources: public
/// headers must not include this file, because the macros have no prefix.

/// The name of a member, for an ErrorSetting: "VideoSettings::codec". Does not compile if there is
/// none.
#define BOXREEL_MEMBER(type, member)                                                               \
    (static_cast<void>(&type::member), std::string_view(#type "::" #member))
/// The name of two members that have a value together: "VideoSettings::width x height".
#define BOXREEL_MEMBERS(type, one, other)                                                          \
    (static_cast<void>(&type::one), static_cast<void>(&type::other),                               \
     std::string_view(#type "::" #one " x " #other))

/// Joins two names, after their macros are expanded.
#define BOXREEL_JOIN_NAMES(a, b) a##b
/// Used by ASSIGN_OR_RETURN.
#define BOXREEL_UNIQUE_NAME(a, b) BOXREEL_JOIN_NAMES(a, b)

/// Returns the error of the expression, a Result, from the enclosing function if it has one.
#define RETURN_IF_ERROR(...)                                                                       \
    do                                                                                             \
    {                                                                                              \
        if (auto resultToReturn = (__VA_ARGS__); !resultToReturn)                                  \
        {                                                                                          \
            return std::move(resultToReturn).TakeError();                                          \
        }                                                                                          \
    } while (false)

/// Declares or assigns `target` from the value of `expression`, a Result, or returns its error:
/// `ASSIGN_OR_RETURN(const Frame frame, ReadPng(path));` A target with a comma needs parentheses
/// around its type, so name the type before.
#define ASSIGN_OR_RETURN(target, ...)                                                              \
    ASSIGN_OR_RETURN_FROM(BOXREEL_UNIQUE_NAME(resultOfLine, __LINE__), target, (__VA_ARGS__))
/// Used by ASSIGN_OR_RETURN.
#define ASSIGN_OR_RETURN_FROM(result, target, expression)                                          \
    auto result = expression;                                                                      \
    if (!result)                                                                                   \
    {                                                                                              \
        return std::move(result).TakeError();                                                      \
    }                                                                                              \
    target = *std::move(result)
