// SPDX-License-Identifier: MIT
#pragma once

#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace boxreel
{

/// The numbers of a row of --stats, in their order; none if there is no such row. Tests compare
/// these and not the words beside them.
inline std::vector<double> NumbersOf(const std::string& stats, const std::string& row)
{
    const std::size_t start = ("\n" + stats).find("\n  " + row + "  ");
    if (start == std::string::npos)
    {
        return {};
    }
    const std::string line = stats.substr(start, stats.find('\n', start) - start);
    const std::regex number("[0-9]+([.][0-9]+)?");
    std::vector<double> numbers;
    for (std::sregex_iterator i(line.begin(), line.end(), number), end; i != end; ++i)
    {
        numbers.push_back(std::stod(i->str()));
    }
    return numbers;
}

} // namespace boxreel
