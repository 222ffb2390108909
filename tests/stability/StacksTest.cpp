// SPDX-License-Identifier: MIT
#include "Trial.h"

/// Tall stacks, a card house and an arch. No body sleeps here, so they must be stable by
/// themselves.
namespace
{

using namespace stability;

STABILITY_SUITE(Stacks);

constexpr double kSeconds = 20.0;

/// Distance from its start within which a box of 1 m counts as unmoved [m]: too little to be
/// visible. Within half a box, the stack stands.
constexpr double kUnmoved = 0.05;
constexpr double kStands = 0.5;
/// Maximum sway of a stack after ten seconds to settle [m]: less than is visible in a picture of
/// the whole.
constexpr double kSway = 0.02;

/// Eight sub-steps and more have a single iteration each.
int CalmHeight(int32 subSteps)
{
    return subSteps > kRecommended ? 20 : 30;
}

/// Two sub-steps share the iterations of a whole step, which are too few for such heights. One step
/// holds straight stacks only.
double WayBound(int32 subSteps, int height, bool straight)
{
    if (subSteps >= kRecommended)
    {
        return kUnmoved;
    }
    const bool low = height <= 20;
    return subSteps > 1 || straight ? (low ? kUnmoved : kStands) : kNoBound;
}

/// Unit boxes, by turns `by` to the right and to the left; their skins rest on each other.
void TryStack(int32 subSteps, int height, float32 by)
{
    Trial trial(subSteps);
    trial.world.SetAllowSleeping(false);
    trial.WideGround();
    const std::vector<b2Body*> boxes = Stack(trial, 0.0f, height);
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
        boxes[i]->SetTransform(boxes[i]->GetPosition() + b2Vec2(i % 2 == 0 ? by : -by, 0.0f), 0.0f);
    }
    const Places places(boxes);
    Places settled(boxes);
    double fastest = 0.0, sway = 0.0;
    trial.Run(kSeconds, [&](double time) {
        settled = time < 10.0 ? Places(boxes) : settled;
        sway = Worst(settled.Farthest(), sway);
        fastest = time < 10.0 ? 0.0 : Worst(trial.FastestSpeed(), fastest);
    });
    const std::string name =
        "stack of " + std::to_string(height) + (by == 0.0f ? ", straight" : ", 1 cm off by turns");
    const double bound = WayBound(subSteps, height, by == 0.0f);
    Judge(name + ", way", subSteps, places.Farthest(), "m", bound);
    Judge(name + ", sway after 10 s", subSteps, sway, "m",
          bound == kUnmoved ? (height <= CalmHeight(subSteps) ? kSway : kUnmoved) : kNoBound);
    Judge(name + ", speed after 10 s", subSteps, fastest, "m/s", kNoBound);
}

TEST_P(Stacks, StandStraight)
{
    for (const int height : {16, 20, 30, 50})
    {
        TryStack(GetParam(), height, 0.0f);
    }
}

TEST_P(Stacks, StandWithOffsetsOfACentimetre)
{
    for (const int height : {16, 20, 30, 50})
    {
        TryStack(GetParam(), height, 0.01f);
    }
}

/// Five rows of tents of two cards of 1 m x 0.05 m that lean by 25 degrees. Cards on the tents of a
/// row carry the next. `room`: between two cards that meet [m]; `x`: position of the middle.
class CardHouse
{
public:
    CardHouse(Trial& trial, float32 room, float32 x = 0.0f)
        : m_trial(trial), m_room(room), m_middle(x)
    {
        float32 floor = room;
        for (int tents = 5; tents > 0; --tents)
        {
            const float32 left = -0.5f * kPitch * float32(tents - 1);
            for (int i = 0; i < tents; ++i)
            {
                AddTent(left + kPitch * float32(i), floor);
            }
            floor += 2.0f * kHeight + room;
            for (int i = 0; i + 1 < tents; ++i)
            {
                const float32 from = left + kPitch * float32(i) + (i == 0 ? -0.1f : 0.01f);
                const float32 to =
                    left + kPitch * float32(i + 1) + (i + 2 == tents ? 0.1f : -0.01f);
                AddCard(0.5f * (from + to), floor + kThin, 0.5f * (to - from), kThin, 0.0f);
            }
            floor += 2.0f * kThin + room;
        }
    }

    std::vector<b2Body*> cards;

private:
    static constexpr float32 kHalf = 0.5f, kThin = 0.025f;               // half-sizes of a card [m]
    static constexpr float32 kPitch = 1.02f;                             // from ridge to ridge [m]
    static constexpr float32 kSine = 0.42261826f, kCosine = 0.90630779f; // of 25 degrees
    static constexpr float32 kLean = 0.43633231f;                        // these [rad]
    // Half of what a leaning card takes.
    static constexpr float32 kWidth = kHalf * kSine + kThin * kCosine;
    static constexpr float32 kHeight = kHalf * kCosine + kThin * kSine;

    void AddTent(float32 ridge, float32 floor)
    {
        for (const float32 side : {-1.0f, 1.0f})
        {
            AddCard(ridge + side * (kWidth + 0.5f * m_room), floor + kHeight, kThin, kHalf,
                    side * kLean);
        }
    }
    void AddCard(float32 x, float32 y, float32 hx, float32 hy, float32 angle)
    {
        b2Body* card = m_trial.Body(b2_dynamicBody, m_middle + x, y, angle);
        Scene::AddBox(card, hx, hy, 0.8f);
        cards.push_back(card);
    }

    Trial& m_trial;
    float32 m_room;
    float32 m_middle;
};

TEST_P(Stacks, StandAsACardHouse)
{
    Trial trial(GetParam());
    trial.world.SetAllowSleeping(false);
    trial.WideGround(0.8f);
    const CardHouse house(trial, kRestingGap);
    const Places places(house.cards);
    trial.Run(kSeconds);
    Judge("card house, way", GetParam(), places.Farthest(), "m", Bound(GetParam(), kUnmoved));
}

/// The cards are put as if they had no skins, 2 cm deep in those of each other, at 24 places, a
/// centimetre apart. With sub-steps they stay there.
TEST_P(Stacks, StandAsATightCardHouse)
{
    constexpr int kPlaces = 24;
    int falls = 0;
    double farthest = 0.0;
    for (int i = 0; i < kPlaces; ++i)
    {
        Trial trial(GetParam());
        trial.world.SetAllowSleeping(false);
        trial.WideGround(0.8f);
        const CardHouse house(trial, 0.0f, 0.01f * float32(i));
        const Places places(house.cards);
        trial.Run(kSeconds);
        falls += !(places.Farthest() <= 0.1);
        farthest = Worst(places.Farthest(), farthest);
    }
    Judge("card house too tight, falls in 24 places", GetParam(), falls, "",
          Bound(GetParam(), 0.0)); // with one step in 22
    Judge("card house too tight, way", GetParam(), farthest, "m", Bound(GetParam(), 0.001));
}

/// A half circle of 21 stones that only friction holds, and boxes that fall on its keystone from
/// half a metre. The stones are put up to a millimetre elsewhere.
class Arch
{
public:
    Arch(Trial& trial, float32 elsewhere)
    {
        for (const float32 x : {-9.0f, 9.0f})
        {
            Scene::AddBox(trial.Body(b2_staticBody, x, 0.5f), 2.0f, 0.5f);
        }
        for (int i = 0; i < kStones; ++i)
        {
            AddStone(trial, i, elsewhere * float32(i * 7919 % 13 - 6) / 6.0f);
        }
        for (int i = 0; i < 4; ++i)
        {
            Scene::AddBox(trial.Body(b2_dynamicBody, 0.0f, 12.25f + 1.8f * float32(i)), 0.75f,
                          0.75f);
        }
    }

    std::vector<b2Body*> stones;

private:
    static constexpr int kStones = 21;

    void AddStone(Trial& trial, int index, float32 shift)
    {
        const b2Rot first(b2_pi * float32(index) / float32(kStones));
        const b2Rot last(b2_pi * float32(index + 1) / float32(kStones));
        b2Vec2 corners[] = {8.0f * first.GetXAxis(), 10.0f * first.GetXAxis(),
                            10.0f * last.GetXAxis(), 8.0f * last.GetXAxis()};
        b2Vec2 middle(0.0f, 0.0f);
        for (const b2Vec2& corner : corners)
        {
            middle += 0.25f * corner;
        }
        for (b2Vec2& corner : corners)
        {
            corner -= middle;
        }
        b2PolygonShape shape;
        shape.Set(corners, 4);
        stones.push_back(trial.Body(b2_dynamicBody, middle.x + shift, middle.y + 1.0f));
        Scene::Add(stones.back(), shape, 0.8f, 0.0f);
        Trial::SetDensity(stones.back(), 2.0f);
    }
};

TEST_P(Stacks, StandAsAnArchWithALoad)
{
    double sinks = 0.0;
    double sways = 0.0;
    for (int i = 0; i < 12; ++i)
    {
        Trial trial(GetParam());
        trial.world.SetAllowSleeping(false);
        const Arch arch(trial, 0.001f * float32(i) / 12.0f);
        const Places places(arch.stones);
        Places settled(arch.stones);
        trial.Run(10.0, [&](double time) {
            settled = time < 4.0 ? Places(arch.stones) : settled;
            sways = Worst(settled.Farthest(), sways);
        });
        sinks = Worst(places.Farthest(), sinks);
    }
    // What falls on it moves its stones by 5 to 10 cm, with 64 sub-steps as well.
    Judge("arch, way", GetParam(), sinks, "m", Bound(GetParam(), 0.15));
    Judge("arch, way after 4 s", GetParam(), sways, "m", Bound(GetParam(), 0.001));
}

} // namespace
