// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kSide = 16;       ///< balls in a row and in a column
constexpr float32 kPitch = 1.0f;  ///< from ball to ball [m]
constexpr float32 kRadius = 0.4f; ///< [m]

/// A cloth of balls, each hinged to its neighbours halfway, swings from one nail at its corner.
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

private:
    b2Body* AddNode(int32 row, int32 column)
    {
        const b2Vec2 place(kPitch * (static_cast<float32>(column) - 0.5f * (kSide - 1)),
                           20.0f - kPitch * static_cast<float32>(row));
        b2Body* ball = AddBall(m_world, place, kRadius);
        SetGroup(*ball, -1);
        if (row == 0 && column == 0)
        {
            ball->SetType(b2_staticBody);
        }
        return ball;
    }

    void Tie(b2Body* first, b2Body* second)
    {
        if (first != nullptr)
        {
            AddHinge(m_world, first, second, 0.5f * (first->GetPosition() + second->GetPosition()));
        }
    }
};

} // namespace

std::unique_ptr<Scene> MakeJointGrid(const SceneSettings& settings)
{
    return std::make_unique<JointGrid>(settings);
}

} // namespace boxreel
