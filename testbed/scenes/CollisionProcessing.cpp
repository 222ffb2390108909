// SPDX-License-Identifier: MIT
#include <scenes/Notes.h>
#include <scenes/Parts.h>
#include <scenes/Random.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

#include <map>
#include <set>

namespace boxreel
{

namespace
{

constexpr int32 kPerSide = 6;         ///< balls, in rows and columns at the start
constexpr float32 kBallStep = 2.5f;   ///< [m]
constexpr float32 kHalfExtent = 9.0f; ///< of the room [m]
constexpr float32 kMaxSpeed = 8.0f;   ///< along each axis [m/s]
constexpr Material kBall{.density = 1.0f, .friction = 0.0f, .restitution = 1.0f};

struct ByNumber
{
    bool operator()(const b2Body* a, const b2Body* b) const
    {
        return a->GetNumber() < b->GetNumber();
    }
};

/// Contacts are gathered after the step, when the world may be changed: of two balls that touch the
/// bigger eats the smaller, with its mass and its momentum.
class CollisionProcessing : public Scene
{
public:
    explicit CollisionProcessing(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetGravity(b2Vec2(0.0f, 0.0f));
        const float32 e = kHalfExtent;
        AddGroundEdge(m_world, b2Vec2(-e, -e), b2Vec2(e, -e));
        AddGroundEdge(m_world, b2Vec2(e, -e), b2Vec2(e, e));
        AddGroundEdge(m_world, b2Vec2(e, e), b2Vec2(-e, e));
        AddGroundEdge(m_world, b2Vec2(-e, e), b2Vec2(-e, -e));
        Random random(settings.seed);
        for (int32 i = 0; i < kPerSide * kPerSide; ++i)
        {
            const float32 x = static_cast<float32>(2 * (i % kPerSide) - kPerSide + 1);
            const float32 y = static_cast<float32>(2 * (i / kPerSide) - kPerSide + 1);
            const float32 radius = random.Between(0.3f, 0.7f);
            b2Body* ball = AddBall(m_world, 0.5f * kBallStep * b2Vec2(x, y), radius, kBall);
            const float32 vx = random.Between(-kMaxSpeed, kMaxSpeed);
            const float32 vy = random.Between(-kMaxSpeed, kMaxSpeed);
            ball->SetLinearVelocity(b2Vec2(vx, vy));
        }
        m_lastBall = m_world.GetBodyList()->GetNumber();
    }

    void Step(const StepSettings& settings) override
    {
        Scene::Step(settings);
        const Meals meals = GatherMeals();
        std::set<b2Body*, ByNumber> eaten;
        for (const auto& [smaller, bigger] : meals)
        {
            // Who is eaten in this step does not eat.
            if (!meals.contains(bigger))
            {
                Grow(*bigger, *smaller);
                eaten.insert(smaller);
            }
        }
        for (b2Body* body : eaten)
        {
            m_world.DestroyBody(body);
        }
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        int32 balls = 0;
        for (const b2Body* body = m_world.GetBodyList(); body != nullptr; body = body->GetNext())
        {
            balls += IsBall(*body) ? 1 : 0;
        }
        return {{"balls", std::to_string(balls)}};
    }

private:
    using Meals = std::map<b2Body*, b2Body*, ByNumber>; ///< from the smaller to the bigger

    /// Not a wall and not a bomb.
    bool IsBall(const b2Body& body) const
    {
        return body.GetType() == b2_dynamicBody && body.GetNumber() <= m_lastBall;
    }

    /// The biggest body that touches a ball gets it; of two equal ones, the older.
    static bool IsBigger(const b2Body& a, const b2Body& b)
    {
        return a.GetMass() > b.GetMass() ||
               (a.GetMass() == b.GetMass() && a.GetNumber() < b.GetNumber());
    }

    Meals GatherMeals()
    {
        Meals meals;
        for (b2Contact* contact = m_world.GetContactList(); contact; contact = contact->GetNext())
        {
            b2Body* smaller = contact->GetFixtureA()->GetBody();
            b2Body* bigger = contact->GetFixtureB()->GetBody();
            if (!contact->IsTouching() || !IsBall(*smaller) || !IsBall(*bigger))
            {
                continue;
            }
            if (IsBigger(*smaller, *bigger))
            {
                std::swap(smaller, bigger);
            }
            const auto [meal, isNew] = meals.emplace(smaller, bigger);
            if (!isNew && IsBigger(*bigger, *meal->second))
            {
                meal->second = bigger;
            }
        }
        return meals;
    }

    static void Grow(b2Body& bigger, const b2Body& smaller)
    {
        const b2Vec2 momentum = bigger.GetMass() * bigger.GetLinearVelocity() +
                                smaller.GetMass() * smaller.GetLinearVelocity();
        const float32 mass = bigger.GetMass() + smaller.GetMass();
        bigger.DestroyFixture(bigger.GetFixtureList());
        AttachCircle(bigger, b2Sqrt(mass / (b2_pi * kBall.density)), kBall);
        bigger.SetLinearVelocity((1.0f / mass) * momentum);
    }

    int32 m_lastBall; ///< its number
};

} // namespace

std::unique_ptr<Scene> MakeCollisionProcessing(const SceneSettings& settings)
{
    return std::make_unique<CollisionProcessing>(settings);
}

} // namespace boxreel
