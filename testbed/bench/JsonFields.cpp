// SPDX-License-Identifier: MIT
#include "JsonFields.h"

namespace boxreel
{

Json ParseJson(const std::string& text)
{
    return Json::parse(text, nullptr, false);
}

std::string LinesOf(const Json& json)
{
    return json.dump(2) + "\n";
}

double Number(const Json& json, const char* name, double otherwise)
{
    return json.is_object() && json.contains(name) && json[name].is_number()
               ? json[name].get<double>()
               : otherwise;
}

int Integer(const Json& json, const char* name, int otherwise)
{
    const double number = Number(json, name, otherwise);
    return number >= -1e6 && number <= 1e6 ? int(number) : -1;
}

std::string Text(const Json& json, const char* name)
{
    return json.is_object() && json.contains(name) && json[name].is_string()
               ? json[name].get<std::string>()
               : "";
}

} // namespace boxreel
