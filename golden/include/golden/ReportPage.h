// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <golden/Verdicts.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

/// @file
/// A self-contained HTML page of verdicts, with pictures, style and script (page.js). Reads the
/// files beside the verdicts; writes none.
namespace boxreel
{

/// Small pictures of the steps around the first difference.
struct FilmStrip
{
    /// One step.
    struct Picture
    {
        std::int64_t step = 0;       ///< of the simulation
        std::string actual;          ///< bytes of a PNG
        std::string closeUp;         ///< around the first body; may be empty
        std::string expected;        ///< from another program; may be empty
        std::string expectedCloseUp; ///< of the same position
        std::vector<int> mark; ///< of the first body: left, top, width, height [px]; may be empty
    };
    int width = 0;                 ///< of each picture [px]
    int height = 0;                ///< of each picture [px]
    std::vector<Picture> pictures; ///< by step
    std::string note;              ///< reason why there are none
    std::string earlier;      ///< earlier moment of the same scene that shows the first difference;
                              ///< empty: this one
    std::string actualPage;   ///< HTML that plays the world to the moment; may be empty
    std::string expectedPage; ///< HTML that plays the world of another program; may be empty
};

/// Returns the page. `strips`: by the names of moments.
Result<std::string> ReportPage(const std::vector<ReportedMoment>& moments,
                               const std::map<std::string, FilmStrip>& strips);

/// Returns a summary of all moments: "3 not as approved", "all as approved".
std::string DescribeOutcome(const std::vector<ReportedMoment>& moments);

} // namespace boxreel
