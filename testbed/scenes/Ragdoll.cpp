// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/Random.h>
#include <scenes/Scenes.h>

#include <string>

namespace boxreel
{

namespace
{

constexpr int32 kFigures = 2;
constexpr int32 kSteps = 6;
constexpr float32 kTread = 2.2f;     ///< of a step [m]
constexpr float32 kRiser = 1.2f;     ///< of a step [m]
constexpr float32 kLanding = -12.0f; ///< where the steps begin [m]
constexpr float32 kStiffness = 0.3f; ///< friction of a joint [N m]
constexpr Material kFlesh{.density = 1.0f, .friction = 0.4f, .restitution = 0.1f};

/// Bodies of eleven parts, whose joints turn as far as those of people, fall down a flight of
/// steps and lie.
class Ragdoll : public Scene
{
public:
    explicit Ragdoll(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // joints hold in a heap of limbs
        // A limb that is stopped at its time of impact is turned beyond its joint's limit.
        // Sub-steps are short enough that no limb passes through a stair.
        m_world.SetContinuousPhysics(false);
        AddSteps();
        Random random(settings.seed);
        constexpr const char* kNames[kFigures] = {"first", "second"};
        for (int32 i = 0; i < kFigures; ++i)
        {
            const float32 x = kLanding + 1.5f + 3.5f * static_cast<float32>(i);
            const float32 y = 12.0f + 1.3f * static_cast<float32>(i);
            const float32 angle = random.Between(-0.8f, 0.8f);
            const float32 along = random.Between(2.0f, 5.0f);
            AddFigure(b2Transform(b2Vec2(x, y), b2Rot(angle)), b2Vec2(along, 0.0f),
                      static_cast<int16>(-1 - i), kNames[i]);
        }
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 7.5f), .halfSize = b2Vec2(16.0f, 9.0f)};
    }

private:
    void AddSteps()
    {
        const float32 left = kLanding - 3.0f;
        AddGroundBox(m_world, b2Vec2(0.0f, -0.5f), 15.0f, 0.5f);
        AddGroundBox(m_world, b2Vec2(left - 0.25f, 8.0f), 0.25f, 8.0f);
        AddGroundBox(m_world, b2Vec2(15.25f, 2.0f), 0.25f, 2.0f);
        for (int32 i = 0; i < kSteps; ++i)
        {
            // From the lowest step, which is the longest, to the highest.
            const float32 right = kLanding + kTread * static_cast<float32>(kSteps - i);
            const float32 y = kRiser * (static_cast<float32>(i) + 0.5f);
            AddGroundBox(m_world, b2Vec2(0.5f * (left + right), y), 0.5f * (right - left),
                         0.5f * kRiser);
        }
    }

    /// One figure, seen from the front, while it is made.
    struct Figure
    {
        b2Transform place; ///< of the hips
        int16 group;       ///< a figure's own parts do not collide: they overlap at the joints
    };

    b2Body* AddPart(const Figure& figure, const b2Vec2& center, float32 halfWidth,
                    float32 halfHeight)
    {
        b2Body* part = AddBody(m_world, b2_dynamicBody, b2Mul(figure.place, center),
                               figure.place.q.GetAngle());
        AttachBox(*part, halfWidth, halfHeight, kFlesh);
        return part;
    }

    void Join(const Figure& figure, b2Body* upper, b2Body* lower, const b2Vec2& point, float32 from,
              float32 to)
    {
        AddLimitedHinge(m_world, upper, lower, b2Mul(figure.place, point), from, to, kStiffness);
    }

    void AddFigure(const b2Transform& hips, const b2Vec2& velocity, int16 group, const char* name)
    {
        const Figure figure{hips, group};
        std::vector<b2Body*> parts;
        const auto keep = [&](b2Body* part) { return parts.emplace_back(part); };

        b2Body* belly = keep(AddPart(figure, b2Vec2(0.0f, 0.25f), 0.3f, 0.28f));
        b2Body* chest = keep(AddPart(figure, b2Vec2(0.0f, 0.85f), 0.4f, 0.36f));
        Join(figure, belly, chest, b2Vec2(0.0f, 0.5f), -0.4f, 0.4f);
        b2Body* head =
            keep(AddBall(m_world, b2Mul(figure.place, b2Vec2(0.0f, 1.55f)), 0.34f, kFlesh));
        Join(figure, chest, head, b2Vec2(0.0f, 1.22f), -0.5f, 0.5f);
        for (const float32 side : {-1.0f, 1.0f})
        {
            // Seen from the front, an arm is raised outwards, and a knee bends inwards only.
            const auto join = [&](b2Body* upper, b2Body* lower, const b2Vec2& point,
                                  float32 inwards, float32 outwards) {
                Join(figure, upper, lower, b2Vec2(side * point.x, point.y),
                     side > 0.0f ? -inwards : -outwards, side > 0.0f ? outwards : inwards);
            };
            const auto add = [&](const b2Vec2& center, float32 halfWidth, float32 halfHeight) {
                return keep(
                    AddPart(figure, b2Vec2(side * center.x, center.y), halfWidth, halfHeight));
            };
            b2Body* upperArm = add(b2Vec2(0.52f, 0.75f), 0.12f, 0.38f);
            b2Body* forearm = add(b2Vec2(0.52f, 0.08f), 0.1f, 0.36f);
            join(chest, upperArm, b2Vec2(0.52f, 1.05f), 0.2f, 2.8f);
            join(upperArm, forearm, b2Vec2(0.52f, 0.41f), 0.0f, 2.2f);
            b2Body* thigh = add(b2Vec2(0.2f, -0.4f), 0.17f, 0.46f);
            b2Body* shin = add(b2Vec2(0.2f, -1.2f), 0.13f, 0.44f);
            join(belly, thigh, b2Vec2(0.2f, 0.0f), 0.3f, 1.2f);
            join(thigh, shin, b2Vec2(0.2f, -0.8f), 1.8f, 0.0f);
        }
        for (b2Body* part : parts)
        {
            SetGroup(*part, group);
            part->SetLinearVelocity(velocity);
        }
        Name(*chest, name);
    }
};

} // namespace

std::unique_ptr<Scene> MakeRagdoll(const SceneSettings& settings)
{
    return std::make_unique<Ragdoll>(settings);
}

} // namespace boxreel
