// SPDX-License-Identifier: MIT
#pragma once

#include "RubeScene.h"

#include <string>

namespace boxreel
{

/// The text of a scene file that ParseRubeScene reads back as the same data, bit by bit. Numbers
/// are as short as that allows; what has the format's default is left out where R.U.B.E. leaves it
/// out, too. The same data make the same text.
std::string WriteRubeText(const RubeScene& scene);

} // namespace boxreel
