// SPDX-License-Identifier: MIT
#pragma once

#include "Widgets.h"

#include <string>

/// Finding a scene by a few letters of its name.
namespace boxreel
{

class ScenePicker
{
public:
    /// Draws over the middle of a picture of this size [px] while `isOpen`. Returns the name of the
    /// chosen scene; empty if none was chosen.
    std::string Build(bool& isOpen, int width, int height, Widgets& widgets);

private:
    std::string Choose(bool& isOpen, Widgets& widgets);

    char m_query[64] = {};
    int m_chosen = 0; // of those that match
    bool m_wasOpen = false;
};

} // namespace boxreel
