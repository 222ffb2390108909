// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

#include <cmath>
#include <vector>

namespace boxreel
{

namespace
{

/// A part of the piste: over its length [m] it turns evenly from the slope of the one before to
/// its own [rad], up is positive.
struct Stretch
{
    float32 length;
    float32 slope;
};
constexpr Stretch kPiste[] = {{3.0f, 0.0f},                                   // start
                              {4.0f, -0.45f}, {6.0f, -0.45f},                 // downhill
                              {1.5f, -0.15f}, {1.5f, -0.6f},  {1.5f, -0.15f}, // bumps
                              {1.5f, -0.6f},  {2.0f, -0.35f}, {4.0f, -0.35f},
                              {5.0f, 0.05f}}; // the jump
constexpr Stretch kLanding[] = {{16.0f, -0.5f}, {10.0f, 0.0f}, {4.0f, 0.1f}};
constexpr Stretch kRunOut = {36.0f, 0.12f}; ///< in deep snow
constexpr float32 kLandingSlope = -0.45f;   ///< where it begins [rad]
constexpr float32 kDrop = 0.8f;             ///< from the jump to the landing [m]
constexpr float32 kPiece = 0.5f;            ///< of the line that the piste is [m]
const b2Vec2 kTop(-38.0f, 22.0f);           ///< [m]
constexpr float32 kPush = 3.0f;             ///< speed at the start [m/s]
// Friction; a contact's is the root of the product: 0.04 on the firm snow, 0.4 in the deep one.
constexpr float32 kSnow = 0.04f;
constexpr float32 kDeepSnow = 4.0f;
constexpr Material kSki{.density = 3.0f, .friction = 0.04f};
constexpr Material kBody{.density = 1.0f, .friction = 0.5f};

/// A figure with spring joints slides on a ski.
class Skier : public Scene
{
public:
    explicit Skier(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // what slides keeps its energy
        AddPiste();
        AddSkier(kTop + b2Vec2(2.0f, 0.0f));
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{
            .center = b2Vec2(0.0f, 0.0f), .halfSize = b2Vec2(10.0f, 5.5f), .followed = m_ski};
    }

    void VisitState(SceneState& state) override { state(m_ski); }

private:
    void AddPiste()
    {
        std::vector<b2Vec2> line{kTop + b2Vec2(0.0f, 2.0f), kTop};
        float32 slope = 0.0f;
        for (const Stretch& stretch : kPiste)
        {
            Follow(line, slope, stretch);
        }
        line.push_back(line.back() - b2Vec2(0.0f, kDrop));
        slope = kLandingSlope;
        for (const Stretch& stretch : kLanding)
        {
            Follow(line, slope, stretch);
        }
        const std::size_t deep = line.size() - 1;
        Follow(line, slope, kRunOut);

        b2Body* piste = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, 0.0f));
        b2ChainShape firm;
        firm.CreateChain(line.data(), static_cast<int32>(deep + 1));
        firm.SetNextVertex(line[deep + 1]);
        piste->CreateFixture(&firm, 0.0f)->SetFriction(kSnow);
        b2ChainShape soft;
        soft.CreateChain(&line[deep], static_cast<int32>(line.size() - deep));
        soft.SetPrevVertex(line[deep - 1]);
        piste->CreateFixture(&soft, 0.0f)->SetFriction(kDeepSnow);
    }

    static void Follow(std::vector<b2Vec2>& line, float32& slope, const Stretch& stretch)
    {
        const int32 pieces = static_cast<int32>(std::lround(stretch.length / kPiece));
        const float32 turn = (stretch.slope - slope) / static_cast<float32>(pieces);
        for (int32 i = 0; i < pieces; ++i)
        {
            slope += turn;
            line.push_back(line.back() + kPiece * b2Rot(slope).GetXAxis());
        }
    }

    /// A part of the body from joint to joint.
    b2Body* AddLimb(const b2Vec2& from, const b2Vec2& to, float32 halfThickness)
    {
        const b2Vec2 along = to - from;
        b2Body* limb = AddBox(m_world, 0.5f * (from + to), 0.5f * along.Length(), halfThickness,
                              kBody, b2Atan2(along.y, along.x));
        SetGroup(*limb, -1);
        return limb;
    }

    /// Crouching a little, seen from the side, over the middle of the ski [m].
    void AddSkier(const b2Vec2& snow)
    {
        m_ski = AddBody(m_world, b2_dynamicBody, snow + b2Vec2(0.0f, 0.06f));
        AttachBox(*m_ski, 1.1f, 0.05f, kSki);
        AttachPolygon(*m_ski, {{1.1f, -0.05f}, {1.5f, 0.2f}, {1.46f, 0.25f}, {1.1f, 0.05f}}, kSki);
        SetGroup(*m_ski, -1);
        Name(*m_ski, "ski");
        const auto at = [&](float32 x, float32 y) { return snow + b2Vec2(x, y); };
        const b2Vec2 ankle = at(-0.1f, 0.15f), knee = at(0.3f, 0.65f), hip = at(-0.2f, 1.1f),
                     shoulder = at(0.35f, 1.75f), neck = at(0.42f, 1.85f), elbow = at(0.35f, 1.2f),
                     hand = at(0.8f, 1.15f);
        b2Body* shin = AddLimb(ankle, knee, 0.12f);
        b2Body* thigh = AddLimb(knee, hip, 0.15f);
        b2Body* torso = AddLimb(hip, shoulder, 0.2f);
        b2Body* upperArm = AddLimb(shoulder, elbow, 0.08f);
        b2Body* forearm = AddLimb(elbow, hand, 0.07f);
        b2Body* pole = AddLimb(at(0.95f, 1.3f), at(-0.5f, 0.4f), 0.03f);
        b2Body* head = AddBall(m_world, neck + b2Vec2(0.1f, 0.2f), 0.22f, kBody);
        SetGroup(*head, -1);
        Name(*torso, "torso");
        Name(*head, "head");
        const auto join = [&](b2Body* a, b2Body* b, const b2Vec2& point, float32 hertz) {
            AddWeld(m_world, a, b, point, hertz, 1.0f);
        };
        join(m_ski, shin, ankle, 25.0f);
        join(shin, thigh, knee, 25.0f);
        join(thigh, torso, hip, 25.0f);
        join(torso, head, neck, 15.0f);
        join(torso, upperArm, shoulder, 12.0f);
        join(upperArm, forearm, elbow, 12.0f);
        join(forearm, pole, hand, 12.0f);
        for (b2Body* body : {m_ski, shin, thigh, torso, upperArm, forearm, pole, head})
        {
            body->SetLinearVelocity(b2Vec2(kPush, 0.0f));
        }
    }

    b2Body* m_ski = nullptr;
};

} // namespace

std::unique_ptr<Scene> MakeSkier(const SceneSettings& settings)
{
    return std::make_unique<Skier>(settings);
}

} // namespace boxreel
