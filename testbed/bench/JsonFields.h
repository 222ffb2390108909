// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include <string>

/// Fields of what the benchmark programs print, and of files that may be anybody's: what is not
/// there, or is something else, is the given value. What of the JSON library takes long to compile
/// is compiled once, in JsonFields.cpp.
namespace boxreel
{

using Json = nlohmann::ordered_json;

/// Of a text that is no JSON, a value that is_discarded().
Json ParseJson(const std::string& text);

/// In lines, with a line feed at the end.
std::string LinesOf(const Json& json);

double Number(const Json& json, const char* name, double otherwise);

/// What is beyond a million either way, and no int for sure, is -1.
int Integer(const Json& json, const char* name, int otherwise);

std::string Text(const Json& json, const char* name);

} // namespace boxreel
