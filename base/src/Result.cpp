// SPDX-License-Identifier: MIT
#include <base/Result.h>

namespace boxreel
{

std::string Error::Text(SettingNames names) const
{
    std::string text = culprit.Text(names);
    for (const auto& [separator, part] : {std::pair(": ", &problem), {"; ", &remedy}})
    {
        const std::string more = part->Text(names);
        text += (text.empty() || more.empty() ? "" : separator) + more;
    }
    return text;
}

} // namespace boxreel
