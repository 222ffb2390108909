// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <string>

/// The options of the settings that errors of the libraries name.
namespace boxreel
{

/// Returns the only table from members of settings to options.
SettingNames OptionNames();

/// Returns the text of an Error for people who write options. Used instead of Error::Text wherever
/// the program shows an error.
std::string TextInOptions(const Error& error);

} // namespace boxreel
