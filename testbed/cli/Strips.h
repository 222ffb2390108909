// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <golden/ReportPage.h>
#include <render/Backend.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// The steps around the first that differs, simulated again by this program, for those of our
/// scenes whose worlds parted. Called by `boxreel golden report`.
namespace boxreel
{

/// Returns the steps of a strip, sorted, at most ten. They are two before `first`, `first` itself,
/// and some after it up to `last` with growing distance.
std::vector<std::int64_t> StepsAround(std::int64_t first, std::int64_t last);

/// By name. A name of no known scene has no strip. `against`: another build of the program,
/// by its whole path, whose pictures become the expected ones; empty: none.
Result<std::map<std::string, FilmStrip>> MakeStrips(const std::vector<ReportedMoment>& moments,
                                                    const std::filesystem::path& against,
                                                    Backend backend);

} // namespace boxreel
