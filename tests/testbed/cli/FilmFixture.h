// SPDX-License-Identifier: MIT
#pragma once

#include "Subprocess.h"

#include <recorder/VideoReader.h>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

/// For tests that make films with the real program, in a folder of their own.
namespace boxreel
{

class FilmFixture : public testing::Test
{
protected:
    Outcome Run(const std::vector<std::string>& arguments) const
    {
        return RunBoxreel(arguments, folder.Path());
    }

    std::vector<Frame> Decode(const std::string& name, Frames which = Frames::Shown) const
    {
        std::vector<Frame> frames;
        Result<VideoReader> reader = VideoReader::Open(folder / name, which);
        if (!reader)
        {
            ADD_FAILURE() << reader.GetError().Text();
            return frames;
        }
        Frame frame;
        Result<bool> more = reader->Next(frame);
        while (more && *more)
        {
            frames.push_back(frame);
            more = reader->Next(frame);
        }
        EXPECT_TRUE(more);
        return frames;
    }

    /// Stops a recording by a signal once the file contains whole groups of 100 frames. Its
    /// manifest then names `frame`, the beginning of the second group after them.
    void StopAfterGroups(int process, int signal, int frame = 200) const
    {
        const std::string named = "\"" + std::to_string(frame) + "\"";
        for (int i = 0; i < 100'000; ++i) // ms; the thread sanitizer takes a while
        {
            for (const auto& entry : std::filesystem::directory_iterator(folder.Path()))
            {
                const std::string name = entry.path().filename().string();
                const bool isManifest =
                    name.ends_with(".json") && name.find(".part.") != std::string::npos;
                if (isManifest && ReadBytes(entry.path()).find(named) != std::string::npos)
                {
                    kill(process, signal);
                    return;
                }
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        kill(process, SIGKILL);
    }

    TemporaryFolder folder;
};

} // namespace boxreel
