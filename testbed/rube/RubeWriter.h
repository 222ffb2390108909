// SPDX-License-Identifier: MIT
#pragma once

#include "RubeScene.h"

#include <string>

namespace boxreel
{

/// Returns the text of a scene file that ParseRubeScene reads back as the same data, bit by bit.
/// Numbers are as short as possible. Values equal to the format's default are omitted where
/// R.U.B.E. omits them. The same data gives the same text.
std::string WriteRubeText(const RubeScene& scene);

} // namespace boxreel
