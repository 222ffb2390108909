// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

#include <algorithm>

namespace boxreel
{

namespace
{

constexpr float32 kHalfLength = 1.0f;     ///< of one of the two parts [m]
constexpr float32 kHalfThickness = 0.5f;  ///< [m]
const b2Vec2 kStart(0.0f, 14.0f);         ///< [m]
constexpr float32 kAngle = 0.25f * b2_pi; ///< it comes down on a corner [rad]
constexpr float32 kHardest = 25.0f;       ///< what it bears, of one contact in a step [N s]
constexpr Material kStone{.density = 1.0f};

/// A beam of two parts in one body. The first hard impact breaks it. Contacts report their impulses
/// during the step. Afterwards one of the parts becomes a separate body, with the speed it had
/// before the impact.
class Breakable : public Scene, private b2ContactListener
{
public:
    explicit Breakable(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-14.0f, 0.0f), b2Vec2(14.0f, 0.0f));
        AddGroundEdge(m_world, b2Vec2(-14.0f, 0.0f), b2Vec2(-14.0f, 3.0f));
        AddGroundEdge(m_world, b2Vec2(14.0f, 0.0f), b2Vec2(14.0f, 3.0f));
        AddGroundBox(m_world, b2Vec2(0.4f, 2.0f), 0.2f, 2.0f);
        m_beam = AddBody(m_world, b2_dynamicBody, kStart, kAngle);
        AttachBox(*m_beam, kHalfLength, kHalfThickness, kStone, b2Vec2(-kHalfLength, 0.0f));
        AttachBox(*m_beam, kHalfLength, kHalfThickness, kStone, b2Vec2(kHalfLength, 0.0f));
        m_world.SetContactListener(this);
    }

    ~Breakable() override { m_world.SetContactListener(nullptr); }

    bool MakesBodiesLater() const override { return true; }

    void Step(const StepSettings& settings) override
    {
        const b2Vec2 velocity = m_beam->GetLinearVelocity();
        const float32 spin = m_beam->GetAngularVelocity();
        m_hardestNow = 0.0f;
        Scene::Step(settings);
        m_hardest = std::max(m_hardest, m_hardestNow);
        if (!m_isBroken && m_hardestNow > kHardest)
        {
            Break(velocity, spin);
        }
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        return {{"beam", m_isBroken ? "broken" : "whole"},
                {"hardest impact", Rounded(m_hardest) + " N s"}};
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 7.5f), .halfSize = b2Vec2(14.5f, 8.5f)};
    }

    void VisitState(SceneState& state) override { state(m_beam, m_isBroken, m_hardest); }

private:
    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override
    {
        const bool isBeam = contact->GetFixtureA()->GetBody() == m_beam ||
                            contact->GetFixtureB()->GetBody() == m_beam;
        for (int32 i = 0; isBeam && i < impulse->count; ++i)
        {
            m_hardestNow = std::max(m_hardestNow, impulse->normalImpulses[i]);
        }
    }

    /// The right part becomes a body; both go on as the beam did before the impact.
    void Break(const b2Vec2& velocity, float32 spin)
    {
        const b2Vec2 center = m_beam->GetWorldCenter();
        m_beam->DestroyFixture(m_beam->GetFixtureList());
        b2Body* part = AddBody(m_world, b2_dynamicBody, m_beam->GetPosition(), m_beam->GetAngle());
        AttachBox(*part, kHalfLength, kHalfThickness, kStone, b2Vec2(kHalfLength, 0.0f));
        for (b2Body* body : {m_beam, part})
        {
            const b2Vec2 arm = body->GetWorldCenter() - center;
            body->SetLinearVelocity(velocity + b2Cross(spin, arm));
            body->SetAngularVelocity(spin);
        }
        m_isBroken = true;
    }

    b2Body* m_beam;
    float32 m_hardestNow = 0.0f; ///< in the last step [N s]
    float32 m_hardest = 0.0f;    ///< so far [N s]
    bool m_isBroken = false;
};

} // namespace

std::unique_ptr<Scene> MakeBreakable(const SceneSettings& settings)
{
    return std::make_unique<Breakable>(settings);
}

} // namespace boxreel
