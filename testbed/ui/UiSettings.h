// SPDX-License-Identifier: MIT
#pragma once

#include "PanelData.h"

#include <base/Result.h>

#include <filesystem>
#include <set>
#include <string>

/// The settings of the window that persist between runs, in a small JSON file of the user.
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

/// Returns $XDG_CONFIG_HOME/boxreel/ui.json, or ~/.config/boxreel/ui.json; empty without a home.
std::filesystem::path UiSettingsPath();

/// Returns the settings; defaults if there is no file. Missing and invalid values are defaults.
/// Error if the file cannot be read or is not JSON.
Result<UiSettings> ReadUiSettings(const std::filesystem::path& file);

/// Writes atomically; creates the folder.
Result<void> WriteUiSettings(const std::filesystem::path& file, const UiSettings& settings);

} // namespace boxreel
