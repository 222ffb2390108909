// SPDX-License-Identifier: MIT
#include "Stage.h"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

namespace
{

TEST(FixturesListing, MakesACompoundBody)
{
    manual::Stage stage(b2Vec2_zero);
    b2Body* hammer = stage.Body(b2_dynamicBody, 0.0f, 0.0f);
    // [compound]
    b2PolygonShape handle, head;
    handle.SetAsBox(1.0f, 0.1f);
    head.SetAsBox(0.2f, 0.5f, b2Vec2(1.2f, 0.0f), 0.0f);

    b2FixtureDef part;
    part.shape = &handle;
    part.density = 1.0f; // [kg/m^2]: 0.4 kg
    part.friction = 0.5f;
    hammer->CreateFixture(&part);
    part.shape = &head;
    part.density = 5.0f; // 2 kg
    b2Fixture* headFixture = hammer->CreateFixture(&part);
    // [/compound]
    EXPECT_FLOAT_EQ(hammer->GetMass(), 2.4f);
    EXPECT_NEAR(hammer->GetLocalCenter().x, 1.0f, 1e-5f);
    // [destroy]
    hammer->DestroyFixture(headFixture); // it breaks off; the mass follows
    // [/destroy]
    EXPECT_FLOAT_EQ(hammer->GetMass(), 0.4f);
}

TEST(FixturesListing, HasTheDefaultsOfTheTable)
{
    const std::string section = manual::SectionText("06-fixtures.md", "## Definition");
    const b2FixtureDef def;
    EXPECT_DEFAULT(section, def, friction);
    EXPECT_DEFAULT(section, def, restitution);
    EXPECT_DEFAULT(section, def, density);
    EXPECT_DEFAULT(section, def, isSensor);
    const std::string filter = manual::SectionText("06-fixtures.md", "## Filters");
    EXPECT_EQ(def.filter.categoryBits, 0x0001);
    EXPECT_EQ(def.filter.maskBits, 0xFFFF);
    EXPECT_EQ(def.filter.groupIndex, 0);
    EXPECT_THAT(filter, testing::HasSubstr("| `categoryBits` | 0x0001 |"));
    EXPECT_THAT(filter, testing::HasSubstr("| `maskBits` | 0xFFFF |"));
    EXPECT_THAT(filter, testing::HasSubstr("| `groupIndex` | 0 |"));
}

TEST(FixturesListing, ChangesADensity)
{
    manual::Stage stage;
    b2Body* body = stage.Box(0.0f, 3.0f);
    b2Fixture* fixture = body->GetFixtureList();
    // [density]
    fixture->SetDensity(5.0f);
    body->ResetMassData(); // without this the mass stays what it was
    // [/density]
    EXPECT_FLOAT_EQ(body->GetMass(), 5.0f);
}

/// Whether a box stays on a slope of this angle [degrees].
bool Sticks(float32 slope, float32 ofGround, float32 ofBox)
{
    manual::Stage stage;
    const float32 angle = slope * b2_pi / 180.0f;
    b2Body* ground = stage.Ground();
    ground->SetTransform(b2Vec2_zero, angle);
    ground->GetFixtureList()->SetFriction(ofGround);
    const b2Vec2 start = ground->GetWorldPoint(b2Vec2(0.0f, 1.515f));
    b2Body* box = stage.Box(start.x, start.y);
    box->SetTransform(start, angle);
    box->GetFixtureList()->SetFriction(ofBox);
    stage.Run(1.0f);
    return b2Distance(box->GetPosition(), start) < 0.05f;
}

TEST(FixturesListing, StaysOnSlopesUpToTheAngleOfFriction)
{
    // The geometric mean of 0.9 and 0.4 is 0.6, and atan 0.6 is 31 degrees.
    EXPECT_TRUE(Sticks(30.0f, 0.9f, 0.4f));
    EXPECT_FALSE(Sticks(32.0f, 0.9f, 0.4f));
    EXPECT_FALSE(Sticks(1.0f, 0.0f, 5.0f));
}

TEST(FixturesListing, KeepsTheFrictionOfContactsThatAreThere)
{
    manual::Stage stage;
    stage.Ground();
    b2Body* box = stage.Box(0.0f, 0.515f);
    stage.Run(0.1f);
    // [reset-friction]
    box->GetFixtureList()->SetFriction(0.8f); // for contacts to come
    for (b2ContactEdge* e = box->GetContactList(); e; e = e->next)
    {
        e->contact->ResetFriction(); // and for those that are there
    }
    // [/reset-friction]
    EXPECT_FLOAT_EQ(stage.world.GetContactList()->GetFriction(), std::sqrt(0.8f * 0.2f));
}

struct Hits : public b2ContactListener
{
    void BeginContact(b2Contact* contact) override
    {
        for (b2Fixture* fixture : {contact->GetFixtureA(), contact->GetFixtureB()})
        {
            touched.insert(fixture);
        }
    }
    std::set<b2Fixture*> touched;
};

TEST(FixturesListing, FiltersByCategoryAndGroup)
{
    manual::Stage stage(b2Vec2_zero);
    Hits hits;
    stage.world.SetContactListener(&hits);
    b2Fixture* player = stage.Box(0.0f, 0.0f)->GetFixtureList();
    b2Fixture* other = stage.Box(0.5f, 0.0f)->GetFixtureList();
    b2Fixture* monster = stage.Box(5.0f, 0.0f)->GetFixtureList();
    // [filter]
    enum : uint16
    {
        kGround = 0x0001, // what it is unless said
        kPlayer = 0x0002,
        kMonster = 0x0004,
    };
    b2Filter filter;
    filter.categoryBits = kPlayer;
    filter.maskBits = kGround | kMonster; // players go through each other
    player->SetFilterData(filter);
    other->SetFilterData(filter);
    filter.categoryBits = kMonster;
    filter.maskBits = kGround | kPlayer;
    monster->SetFilterData(filter);
    // [/filter]
    stage.Run(0.1f);
    EXPECT_TRUE(hits.touched.empty());
    monster->GetBody()->SetTransform(b2Vec2(0.2f, 0.5f), 0.0f);
    stage.Run(0.1f);
    EXPECT_EQ(hits.touched.size(), 3u);
    stage.world.SetContactListener(nullptr);
}

TEST(FixturesListing, NeverCollidesWithinANegativeGroup)
{
    manual::Stage stage(b2Vec2_zero);
    Hits hits;
    stage.world.SetContactListener(&hits);
    b2Fixture* wheel = stage.Ball(0.0f, 0.0f)->GetFixtureList();
    b2Fixture* frame = stage.Box(0.3f, 0.0f)->GetFixtureList();
    // [group]
    b2Filter bicycle;
    bicycle.groupIndex = -1; // never with another of group -1; a positive group: always
    wheel->SetFilterData(bicycle);
    frame->SetFilterData(bicycle);
    // [/group]
    stage.Run(0.1f);
    EXPECT_TRUE(hits.touched.empty());
    // [get-filter]
    b2Filter solid = wheel->GetFilterData();
    solid.groupIndex = 0; // category and mask stay
    wheel->SetFilterData(solid);
    // [/get-filter]
    stage.Run(0.1f);
    EXPECT_FALSE(hits.touched.empty()) << "they collide now";
    stage.world.SetContactListener(nullptr);
}

// [door]
/// Keeps a count of what is in the doorway.
class Doorway : public b2ContactListener
{
public:
    explicit Doorway(const b2Fixture* sensor) : m_sensor(sensor) {}
    int Inside() const { return m_inside; }

private:
    void BeginContact(b2Contact* contact) override { m_inside += Concerns(*contact) ? 1 : 0; }
    void EndContact(b2Contact* contact) override { m_inside -= Concerns(*contact) ? 1 : 0; }
    bool Concerns(b2Contact& contact) const
    {
        return contact.GetFixtureA() == m_sensor || contact.GetFixtureB() == m_sensor;
    }

    const b2Fixture* m_sensor;
    int m_inside = 0;
};
// [/door]

TEST(FixturesListing, SensesWhatPasses)
{
    manual::Stage stage(b2Vec2_zero);
    b2World& world = stage.world;
    b2Body* wall = stage.Body(b2_staticBody, 0.0f, 0.0f);
    // [sensor]
    b2PolygonShape opening;
    opening.SetAsBox(0.5f, 1.0f);
    b2FixtureDef def;
    def.shape = &opening;
    def.isSensor = true;
    Doorway doorway(wall->CreateFixture(&def));
    world.SetContactListener(&doorway); // has to live as long as the world, or be taken away
    // [/sensor]
    b2Body* ball = stage.Ball(-3.0f, 0.0f);
    ball->SetLinearVelocity(b2Vec2(3.0f, 0.0f));
    stage.Run(1.0f);
    EXPECT_EQ(doorway.Inside(), 1);
    EXPECT_EQ(ball->GetLinearVelocity().x, 3.0f);
    stage.Run(1.0f);
    EXPECT_EQ(doorway.Inside(), 0);

    // What is too fast is never seen in it.
    b2Body* shot = stage.Ball(-4.6f, 0.0f, 0.05f);
    shot->SetBullet(true);
    shot->SetLinearVelocity(b2Vec2(110.0f, 0.0f));
    int seen = 0;
    for (int i = 0; i < 6; ++i)
    {
        stage.Run(1.0f / 60.0f);
        seen += doorway.Inside();
    }
    EXPECT_GT(shot->GetPosition().x, 1.0f);
    EXPECT_EQ(seen, 0);
    world.SetContactListener(nullptr);
}

} // namespace
