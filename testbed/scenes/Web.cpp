// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/Random.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

#include <algorithm>
#include <iterator>

namespace boxreel
{

namespace
{

constexpr int32 kSpokes = 12;
constexpr int32 kRings = 5;
constexpr float32 kRingStep = 1.4f;  ///< from ring to ring [m]
constexpr float32 kAnchors = 9.0f;   ///< from the middle to where the spokes are fixed [m]
const b2Vec2 kMiddle(0.0f, 10.0f);   ///< [m]
constexpr float32 kKnot = 0.12f;     ///< radius of a knot [m]
constexpr float32 kHertz = 6.0f;     ///< of a thread
constexpr float32 kDamping = 0.3f;   ///< of a thread
constexpr float32 kStrength = 30.0f; ///< a thread tears beyond this force [N]

constexpr int32 kPebbles = 6;
constexpr float32 kPebbleEvery = 1.4f; ///< [s]
constexpr Material kSilk{.density = 2.0f};

constexpr KeyBinding kKeys[] = {{'b', "takes a knot out of the web"}, {'j', "tears a thread"}};

/// A spider's web of soft threads. A thread whose force becomes too large tears: by pebbles
/// that are hung up in it, each heavier than the one before, by the mouse, or by keys.
class Web : public Scene
{
public:
    explicit Web(const SceneSettings& settings) : Scene(settings), m_random(settings.seed)
    {
        AddGroundEdge(m_world, b2Vec2(-10.0f, -0.5f), b2Vec2(10.0f, -0.5f));
        m_frame = AddBody(m_world, b2_staticBody, kMiddle);
        for (int32 spoke = 0; spoke < kSpokes; ++spoke)
        {
            AttachCircle(*m_frame, 2.0f * kKnot, {}, kAnchors * Direction(spoke));
        }
        b2Body* hub = AddKnot(b2Vec2(0.0f, 0.0f));
        b2Body* inner[kSpokes];
        std::fill(std::begin(inner), std::end(inner), hub);
        for (int32 ring = 1; ring <= kRings; ++ring)
        {
            b2Body* knots[kSpokes];
            for (int32 spoke = 0; spoke < kSpokes; ++spoke)
            {
                knots[spoke] = AddKnot(kRingStep * static_cast<float32>(ring) * Direction(spoke));
                Tie(inner[spoke], knots[spoke], knots[spoke]->GetPosition());
            }
            for (int32 spoke = 0; spoke < kSpokes; ++spoke)
            {
                b2Body* next = knots[(spoke + 1) % kSpokes];
                Tie(knots[spoke], next, next->GetPosition());
            }
            std::copy(std::begin(knots), std::end(knots), std::begin(inner));
        }
        for (int32 spoke = 0; spoke < kSpokes; ++spoke)
        {
            Tie(inner[spoke], m_frame, kMiddle + kAnchors * Direction(spoke));
        }
    }

    bool MakesBodiesLater() const override { return true; }

    void Step(const StepSettings& settings) override
    {
        if (m_pebbles < kPebbles && m_time >= 1.0f + kPebbleEvery * static_cast<float32>(m_pebbles))
        {
            HangPebble();
        }
        Scene::Step(settings);
        m_time += settings.timeStep;
        TearOverloaded(1.0f / settings.timeStep);
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        if (key == 'j' && ThreadCount() > 0)
        {
            Tear(Thread(m_random.Below(ThreadCount())));
        }
        if (key == 'b' && ThreadCount() > 0)
        {
            // All that is at one end of a thread: a knot, for B may be the frame.
            m_world.DestroyBody(Thread(m_random.Below(ThreadCount()))->GetBodyA());
        }
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        return {{"threads", std::to_string(ThreadCount())}, {"torn", std::to_string(m_torn)}};
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 9.5f), .halfSize = b2Vec2(10.5f, 10.5f)};
    }

    void VisitState(SceneState& state) override
    {
        state(m_frame, m_random, m_pebbles, m_torn, m_time);
    }

private:
    static b2Vec2 Direction(int32 spoke)
    {
        const float32 share = static_cast<float32>(spoke) / static_cast<float32>(kSpokes);
        return b2Rot(2.0f * b2_pi * share).GetXAxis();
    }

    b2Body* AddKnot(const b2Vec2& fromMiddle)
    {
        b2Body* knot = AddBall(m_world, kMiddle + fromMiddle, kKnot, kSilk);
        knot->SetAngularDamping(2.0f);
        SetGroup(*knot, -1); // only the ground stops what falls
        return knot;
    }

    void Tie(b2Body* from, b2Body* to, const b2Vec2& end)
    {
        AddRod(m_world, from, to, from->GetPosition(), end, kHertz, kDamping);
    }

    /// On any knot that still has a thread.
    void HangPebble()
    {
        if (ThreadCount() == 0)
        {
            return;
        }
        b2Body* knot = Thread(m_random.Below(ThreadCount()))->GetBodyA();
        const float32 radius = 0.3f + 0.15f * static_cast<float32>(m_pebbles);
        const b2Vec2 below(0.0f, -radius);
        b2Body* pebble = AddBall(m_world, knot->GetPosition() + below, radius, {.density = 2.0f});
        SetGroup(*pebble, -1);
        AddHinge(m_world, knot, pebble, knot->GetPosition());
        ++m_pebbles;
    }

    static bool IsThread(const b2Joint& joint) { return joint.GetType() == e_distanceJoint; }

    /// Returns the number of threads, without other joints such as the mouse's.
    int32 ThreadCount() const
    {
        int32 count = 0;
        for (const b2Joint* joint = m_world.GetJointList(); joint; joint = joint->GetNext())
        {
            count += IsThread(*joint) ? 1 : 0;
        }
        return count;
    }

    /// `number` is below ThreadCount.
    b2Joint* Thread(int32 number)
    {
        b2Joint* joint = m_world.GetJointList();
        while (!IsThread(*joint) || number-- > 0)
        {
            joint = joint->GetNext();
        }
        return joint;
    }

    void Tear(b2Joint* thread)
    {
        m_world.DestroyJoint(thread);
        ++m_torn;
    }

    void TearOverloaded(float32 stepsPerSecond)
    {
        for (b2Joint* joint = m_world.GetJointList(); joint != nullptr;)
        {
            b2Joint* next = joint->GetNext();
            if (IsThread(*joint) && joint->GetReactionForce(stepsPerSecond).Length() > kStrength)
            {
                Tear(joint);
            }
            joint = next;
        }
    }

    b2Body* m_frame; ///< its origin is the middle of the web
    Random m_random;
    int32 m_pebbles = 0;
    int32 m_torn = 0;
    float32 m_time = 0.0f; ///< [s]
};

} // namespace

std::unique_ptr<Scene> MakeWeb(const SceneSettings& settings)
{
    return std::make_unique<Web>(settings);
}

} // namespace boxreel
