// SPDX-License-Identifier: MIT
#pragma once

#include "RubeScene.h"

#include <cstddef>
#include <string>
#include <vector>

/// The names of a scene file's parts in messages.
namespace boxreel
{

/// A part of a scene file that cannot be built, cannot be written, or may surprise.
struct RubeNote
{
    std::string part;   ///< such as `fixture 3 "left wheel" of body 0`
    std::string reason; ///< lower case, no full stop

    /// "part: reason"
    std::string Text() const;
};

/// In the order of the file, at most kMaxNotes and one that counts the others.
using RubeNotes = std::vector<RubeNote>;

constexpr std::size_t kMaxNotes = 1000; ///< enough to read; bounds the memory

/// Adds to notes of which there have been `count` so far.
void AddNote(RubeNotes& notes, std::size_t& count, RubeNote note);

/// In quotes, at most 60 bytes long, and without control characters.
std::string QuotedName(const std::string& name);

/// `fixture 3 "left wheel"`, or `fixture 3` of one that has no name.
std::string WithName(const char* what, std::size_t index, const std::string& name);

/// body 3 "wheel"
std::string NameOfBody(const RubeScene& scene, std::size_t index);

} // namespace boxreel
