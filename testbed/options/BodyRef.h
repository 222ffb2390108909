// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// A reference to a body in options. It is the body's number in the order of creation, as
/// `--labels` shows it, or its name in the scene file. A name becomes a number once the scene is
/// open.
namespace boxreel
{

struct BodyRef
{
    int number = 0;
    std::string name; ///< not empty: this one, whose number is to be found

    BodyRef(int bodyNumber) : number(bodyNumber) {} // NOLINT: a number is a body
    explicit BodyRef(std::string bodyName) : name(std::move(bodyName)) {}
    friend bool operator==(const BodyRef&, const BodyRef&) = default;
};

/// The parts between separators that stand outside of quotes ("); quotes are kept.
std::vector<std::string> SplitOutsideQuotes(std::string_view separator, std::string_view text);

/// Reads "3", "left wheel", "\"3, or so\"". Digits are a number, unless in quotes. Names with
/// commas, colons and semicolons need quotes, and so do those with " to " where an end follows.
std::optional<BodyRef> ReadBodyRef(std::string_view text);

/// "3,left wheel".
std::optional<std::vector<BodyRef>> ReadBodyRefs(std::string_view text);

/// Gives those that have a name their number. Unusable, a sentence that names `option`, when no
/// body has the name, or several have, with their numbers.
Result<void> FindNames(const std::string& option, const std::vector<BodyRef*>& bodies,
                       const std::map<std::uint32_t, std::string>& names);

/// Returns the numbers of the bodies.
std::vector<int> NumbersOf(const std::vector<BodyRef>& bodies);

} // namespace boxreel
