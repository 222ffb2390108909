// SPDX-License-Identifier: MIT
#pragma once

#include "PanelData.h"

#include <base/Result.h>

#include <filesystem>
#include <set>
#include <string>

/// What the window keeps from one run to the next, in a small JSON file of the user's.
namespace boxreel
{

struct UiSettings
{
    int width = 1280; ///< of the window [px]
    int height = 720; ///< [px]
    std::string scene = "Pyramid";
    PanelChoices choices;
    std::set<std::string> openSections{"Solver", "Draw", "Statistics", "Profile"};
    friend bool operator==(const UiSettings&, const UiSettings&) = default;
};

/// $XDG_CONFIG_HOME/boxreel/ui.json, else ~/.config/boxreel/ui.json; empty without a home.
std::filesystem::path UiSettingsPath();

/// As a new user has them when there is no such file; what it does not say, or says wrongly, is as
/// a new user has it. An Error when it cannot be read or is no JSON.
Result<UiSettings> ReadUiSettings(const std::filesystem::path& file);

/// Whole or not at all; makes its folder.
Result<void> WriteUiSettings(const std::filesystem::path& file, const UiSettings& settings);

} // namespace boxreel
