// SPDX-License-Identifier: MIT
#pragma once

#include "RubeScene.h"

#include <string>

/// How sentences about a scene file call its parts.
namespace boxreel
{

/// In quotes, at most 60 bytes long, and without control characters.
std::string QuotedName(const std::string& name);

/// `fixture 3 "left wheel"`, or `fixture 3` of one that has no name.
std::string WithName(const char* what, std::size_t index, const std::string& name);

/// body 3 "wheel"
std::string NameOfBody(const RubeScene& scene, std::size_t index);

} // namespace boxreel
