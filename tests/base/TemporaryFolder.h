// SPDX-License-Identifier: MIT
#pragma once

#include "ReadBytes.h"

#include <base/WorkFolder.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// A folder of a test's own, removed with all that is in it. Used by tests that write files.
class TemporaryFolder
{
public:
    std::filesystem::path operator/(const std::string& name) const { return Path() / name; }
    const std::filesystem::path& Path() const { return m_folder.Path(); }

    /// Returns the names of the files in it, sorted.
    std::vector<std::string> Names() const
    {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(Path()))
        {
            names.push_back(entry.path().filename().string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }

private:
    static boxreel::WorkFolder Created()
    {
        boxreel::Result<boxreel::WorkFolder> folder = boxreel::WorkFolder::Create();
        if (!folder)
        {
            throw std::runtime_error(folder.GetError().problem);
        }
        return *std::move(folder);
    }

    boxreel::WorkFolder m_folder = Created();
};

inline void WriteBytes(const std::filesystem::path& path, const std::string& bytes)
{
    std::ofstream(path, std::ios::binary) << bytes;
}
