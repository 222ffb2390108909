// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <string>

/// Fields of what the benchmark programs print, and of files that may be anybody's: what is not
/// there, or is something else, is the given value.
namespace boxreel
{

using Json = nlohmann::ordered_json;

inline double Number(const Json& json, const char* name, double otherwise)
{
    return json.is_object() && json.contains(name) && json[name].is_number()
               ? json[name].get<double>()
               : otherwise;
}

/// What is beyond a million either way, and no int for sure, is -1.
inline int Integer(const Json& json, const char* name, int otherwise)
{
    const double number = Number(json, name, otherwise);
    return number >= -1e6 && number <= 1e6 ? int(number) : -1;
}

inline std::string Text(const Json& json, const char* name)
{
    return json.is_object() && json.contains(name) && json[name].is_string()
               ? json[name].get<std::string>()
               : "";
}

} // namespace boxreel
