// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

/// Colours and line widths of a picture. A DrawList carries the colours that an engine's debug
/// drawing asked for (the classic palette); a theme says what they become.
namespace boxreel
{

struct Theme
{
    Color background{26, 26, 26, 255};
    Color text{230, 230, 230, 255};
    float outlineWidth = 1.25f; ///< of shapes and segments [px]
    float fillAlpha = 0.5f;     ///< a solid shape is filled with half its colour at this opacity

    /// The colours every user of this debug drawing knows.
    static Theme Classic();
};

} // namespace boxreel
