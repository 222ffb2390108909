// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

#include <algorithm>
#include <iterator>

namespace boxreel
{

namespace
{

constexpr int32 kSide = 16;         ///< balls in a row and in a column
constexpr float32 kPitch = 1.0f;    ///< from ball to ball [m]
constexpr float32 kRadius = 0.3f;   ///< [m]
constexpr int32 kNails[] = {0, 10}; ///< columns of the top row
constexpr float32 kHertz = 12.0f;   ///< stiff enough to stretch by little under its own weight
constexpr float32 kDamping = 0.2f;  ///< waves are to last

/// A cloth of balls. Springs connect the centres of neighbours, so it can shear like cloth. Hinges
/// halfway between the balls would make a stiff plate. The part beyond the second nail falls,
/// swings and sends waves through the rest.
class JointGrid : public Scene
{
public:
    explicit JointGrid(const SceneSettings& settings) : Scene(settings)
    {
        b2Body* above[kSide] = {};
        for (int32 row = 0; row < kSide; ++row)
        {
            b2Body* left = nullptr;
            for (int32 column = 0; column < kSide; ++column)
            {
                b2Body* ball = AddNode(row, column);
                Tie(left, ball);
                Tie(above[column], ball);
                left = ball;
                above[column] = ball;
            }
        }
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 10.5f), .halfSize = b2Vec2(13.0f, 12.0f)};
    }

private:
    b2Body* AddNode(int32 row, int32 column)
    {
        const b2Vec2 place(kPitch * (static_cast<float32>(column) - 0.5f * (kSide - 1)),
                           20.0f - kPitch * static_cast<float32>(row));
        b2Body* ball = AddBall(m_world, place, kRadius);
        SetGroup(*ball, -1);
        if (row == 0 && std::ranges::find(kNails, column) != std::end(kNails))
        {
            ball->SetType(b2_staticBody);
        }
        return ball;
    }

    void Tie(b2Body* first, b2Body* second)
    {
        if (first != nullptr)
        {
            AddRod(m_world, first, second, first->GetPosition(), second->GetPosition(), kHertz,
                   kDamping);
        }
    }
};

} // namespace

std::unique_ptr<Scene> MakeJointGrid(const SceneSettings& settings)
{
    return std::make_unique<JointGrid>(settings);
}

} // namespace boxreel
