// SPDX-License-Identifier: MIT
#include "UiSettings.h"

#include <base/AtomicFile.h>
#include <base/ReadWhole.h>
#include <debugdraw/Theme.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <iterator>

namespace boxreel
{
namespace
{

using nlohmann::json;

constexpr std::uintmax_t kMaxBytes = 1'000'000;

/// Calls `visit(name, value)` for everything that a file holds, so that reading and writing cannot
/// come apart.
template <class Settings, class Visit>
void VisitAll(Settings& s, const Visit& visit)
{
    visit("width", s.width);
    visit("height", s.height);
    visit("scene", s.scene);
    VisitKept(s.choices, visit);
    visit("open", s.openSections);
}

/// Within what the window and its panels can show.
void Limit(UiSettings& settings)
{
    const auto limit = [](int& value, int lowest, int highest) {
        value = std::clamp(value, lowest, highest);
    };
    limit(settings.width, 320, 8192);
    limit(settings.height, 240, 8192);
    SolverChoices& solver = settings.choices.solver;
    limit(solver.hertz, 5, 480);
    for (const SolverSetting& setting : SolverSettings())
    {
        if (const auto* const number = std::get_if<int SolverChoices::*>(&setting.member))
        {
            limit(solver.**number, 1, setting.maximum);
        }
    }
    if (!FindTheme(settings.choices.theme))
    {
        settings.choices.theme = "classic";
    }
}

template <class Value>
void Take(const json& object, const char* name, Value& value)
{
    const auto found = object.find(name);
    if (found == object.end())
    {
        return;
    }
    try
    {
        value = found->get<Value>();
    }
    catch (const json::exception&)
    {
        // of another type: as a new user has it
    }
}

} // namespace

std::filesystem::path UiSettingsPath()
{
    const char* const config = std::getenv("XDG_CONFIG_HOME");
    if (config != nullptr && *config == '/')
    {
        return std::filesystem::path(config) / "boxreel" / "ui.json";
    }
    const char* const home = std::getenv("HOME");
    return home != nullptr && *home == '/'
               ? std::filesystem::path(home) / ".config" / "boxreel" / "ui.json"
               : std::filesystem::path();
}

Result<UiSettings> ReadUiSettings(const std::filesystem::path& file)
{
    UiSettings settings;
    std::error_code error;
    if (!std::filesystem::exists(file, error))
    {
        return settings;
    }
    const Error unreadable{ErrorKind::Failed, file.string(), "is not a settings file of boxreel",
                           "it is replaced when settings are saved"};
    const Result<std::string> text = ReadWhole(file, kMaxBytes);
    const json object = text ? json::parse(*text, nullptr, false) : json();
    if (!object.is_object())
    {
        return unreadable;
    }
    VisitAll(settings, [&](const char* name, auto& value) { Take(object, name, value); });
    Limit(settings);
    return settings;
}

Result<void> WriteUiSettings(const std::filesystem::path& file, const UiSettings& settings)
{
    json object = json::object();
    VisitAll(settings, [&](const char* name, const auto& value) { object[name] = value; });
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error)
    {
        return Error{ErrorKind::Unusable, file.parent_path().string(),
                     "cannot be created: " + error.message(),
                     "set XDG_CONFIG_HOME to another folder"};
    }
    // Names of scene files may contain any bytes, and invalid UTF-8 is not valid JSON.
    return WriteWhole(file, object.dump(1, ' ', false, json::error_handler_t::replace) + "\n",
                      true);
}

} // namespace boxreel
