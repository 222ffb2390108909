// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <golden/Verdicts.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

/// @file
/// One HTML page of verdicts that needs nothing else: pictures, style and script are in it. What
/// the script does with it stands in page.js. Reads the files beside the verdicts; writes none.
namespace boxreel
{

/// The steps around the first that differs, small.
struct FilmStrip
{
    struct Picture
    {
        std::int64_t step = 0;
        std::string actual;          ///< the bytes of a PNG
        std::string closeUp;         ///< around the first body; empty: there is none
        std::string expected;        ///< by another program; empty: none was asked
        std::string expectedCloseUp; ///< of the same place
        std::vector<int> mark; ///< of the first body: left, top, width, height [px]; empty: none
    };
    int width = 0, height = 0; ///< of each picture [px]
    std::vector<Picture> pictures;
    std::string note;    ///< why there are none
    std::string earlier; ///< the moment of the same scene that shows where they parted; empty: this
};

/// `strips`: by the names of moments.
Result<std::string> ReportPage(const std::vector<ReportedMoment>& moments,
                               const std::map<std::string, FilmStrip>& strips);

/// "3 not as approved", "all as approved": of all moments, for a line.
std::string DescribeOutcome(const std::vector<ReportedMoment>& moments);

} // namespace boxreel
