// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/Scene.h>

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

/// A case for each scene of the table, so that a failure names its scene and CTest can share them
/// out: INSTANTIATE_TEST_SUITE_P(Scenes, MySuite, testing::ValuesIn(EveryScene()), CaseName).
namespace boxreel
{

/// A scene as a parameter. CTest shows its name beside the case: the address of an entry would
/// differ from build to build.
struct SceneCase
{
    operator const SceneEntry*() const { return entry; }
    const SceneEntry* operator->() const { return entry; }

    const SceneEntry* entry;
};

inline void PrintTo(const SceneCase& scene, std::ostream* out)
{
    *out << scene->name;
}

inline std::vector<SceneCase> EveryScene()
{
    std::vector<SceneCase> scenes;
    for (const SceneEntry& entry : AllScenes())
    {
        scenes.push_back(SceneCase{&entry});
    }
    return scenes;
}

/// "NewtonsCradle": GoogleTest takes letters and digits only.
inline std::string CaseName(const testing::TestParamInfo<SceneCase>& info)
{
    std::string name(info.param->name);
    std::erase_if(name, [](char c) {
        return !(('0' <= c && c <= '9') || ('A' <= c && c <= 'Z') || ('a' <= c && c <= 'z'));
    });
    return name;
}

} // namespace boxreel
