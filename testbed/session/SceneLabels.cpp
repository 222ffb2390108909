// SPDX-License-Identifier: MIT
#include "SceneLabels.h"

namespace boxreel
{

std::vector<const b2Body*> FindBodies(const b2World& world, const std::vector<int>& numbers)
{
    std::vector<const b2Body*> found(numbers.size());
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        for (std::size_t i = 0; i < numbers.size(); ++i)
        {
            found[i] = numbers[i] == body->GetNumber() ? body : found[i];
        }
    }
    return found;
}

int CountMade(const b2World& world)
{
    const b2Body* const newest = world.GetBodyList();
    return newest != nullptr ? newest->GetNumber() + 1 : 0;
}

Result<void> CheckBodies(const std::string& option, int made, const std::vector<int>& numbers)
{
    for (const int number : numbers)
    {
        if (number >= made)
        {
            const std::string has = made == 0   ? "no bodies"
                                    : made == 1 ? "one body, number 0"
                                                : std::to_string(made) + " bodies, numbers 0 to " +
                                                      std::to_string(made - 1);
            return Error{ErrorKind::Unusable, option + " " + std::to_string(number),
                         "no such body; the scene has " + has, "--labels shows the numbers"};
        }
    }
    return {};
}

} // namespace boxreel
