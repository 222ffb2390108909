// SPDX-License-Identifier: MIT
#pragma once

#include "PageEncoder.h"

#include <map>

/// What is on a page beside its frames: HTML around them, and JSON for the player.
namespace boxreel
{

/// What is known at the end of a page.
struct PageFacts
{
    std::int64_t frames = 0;
    std::map<std::uint32_t, std::string> names; ///< of bodies
};

/// Shortest text that is read as the same number, in every locale.
std::string NumberText(double number);

/// The page before its frames. Title and texts are escaped.
std::string PageBegin(const PageSettings& settings);

/// A group of frames, packed.
Result<std::string> PageGroup(const std::string& bytes, std::int64_t frames);

/// The page behind its frames.
Result<std::string> PageEnd(const PageSettings& settings, const PageEncoder& encoder,
                            const PageFacts& facts);

} // namespace boxreel
