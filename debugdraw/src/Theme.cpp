// SPDX-License-Identifier: MIT
#include <debugdraw/Theme.h>

namespace boxreel
{

Theme Theme::Classic()
{
    return Theme{};
}

} // namespace boxreel
