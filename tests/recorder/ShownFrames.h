// SPDX-License-Identifier: MIT
#pragma once

#include "VideoSource.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

/// Films by what they show at each moment, of which some formats store less, and some not how
/// often.
namespace testfilm
{

/// Returns the frames that a film of this rate shows, one per period.
inline std::vector<boxreel::Frame> ReadShown(const std::filesystem::path& path,
                                             const boxreel::Rational& rate)
{
    const auto source = boxreel::OpenVideoSource(path);
    EXPECT_TRUE(source) << (source ? "" : source.GetError().Text());
    std::vector<boxreel::Frame> shown;
    const auto fillUntil = [&](double seconds) {
        while (!shown.empty() && double(shown.size()) + 0.4 < seconds * rate.ToDouble())
        {
            shown.push_back(shown.back());
        }
    };
    boxreel::StoredFrame stored;
    while (source)
    {
        const boxreel::Result<bool> more = (*source)->Next(stored);
        EXPECT_TRUE(more) << (more ? "" : more.GetError().Text());
        if (!more || !*more)
        {
            break;
        }
        fillUntil(stored.seconds);
        EXPECT_NEAR(double(shown.size()), stored.seconds * rate.ToDouble(), 0.4);
        shown.push_back(stored.frame);
    }
    fillUntil(stored.seconds + stored.length);
    return shown;
}

/// Returns the stored frames of a film.
inline std::vector<boxreel::StoredFrame> ReadStored(const std::filesystem::path& path)
{
    const auto source = boxreel::OpenVideoSource(path);
    EXPECT_TRUE(source) << (source ? "" : source.GetError().Text());
    std::vector<boxreel::StoredFrame> all;
    boxreel::StoredFrame stored;
    while (source)
    {
        const boxreel::Result<bool> more = (*source)->Next(stored);
        EXPECT_TRUE(more) << (more ? "" : more.GetError().Text());
        if (!more || !*more)
        {
            break;
        }
        all.push_back(stored);
    }
    return all;
}

} // namespace testfilm
