// SPDX-License-Identifier: MIT
#include "SceneLabels.h"

#include <algorithm>

namespace boxreel
{

std::vector<const b2Body*> OldestFirst(const b2World& world)
{
    std::vector<const b2Body*> bodies;
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        bodies.push_back(body); // the world's list has the newest first
    }
    std::reverse(bodies.begin(), bodies.end());
    return bodies;
}

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

Result<void> CheckBodies(const std::string& option, const b2World& world,
                         const std::vector<int>& numbers)
{
    const std::vector<const b2Body*> bodies = FindBodies(world, numbers);
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
        if (bodies[i] == nullptr)
        {
            const int count = world.GetBodyCount();
            const std::string has =
                count == 0 ? "no bodies"
                : count == 1
                    ? "one body, number 0"
                    : std::to_string(count) + " bodies, numbers 0 to " + std::to_string(count - 1);
            return Error{ErrorKind::Unusable, option + ": there is no body " +
                                                  std::to_string(numbers[i]) + "; the scene has " +
                                                  has + ", and `--labels` shows which is which."};
        }
    }
    return {};
}

} // namespace boxreel
