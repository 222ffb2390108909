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

} // namespace boxreel
