// SPDX-License-Identifier: MIT
#include "../../base/Errors.h"

#include <base/Quoting.h>
#include <session/Condition.h>

#include <gmock/gmock.h>

#include <limits>

namespace boxreel
{
namespace
{

TEST(Condition, RefusesInvalidText)
{
    for (const std::string text :
         {"", "17.y", "17.y = 3", "17.y ! 3", "17.y < low", "17.y <", "17.y < 1 2", "17.y < nan",
          "17.y < 1e999", "17.z < 3", "17.time < 3", "y < 3", ".y < 3"})
    {
        const Result<Condition> condition = Condition::Parse("--until", text);
        ASSERT_FALSE(condition) << text;
        EXPECT_THAT(condition, Refuses(AsTyped("--until", text)));
        EXPECT_NE(condition.GetError().remedy, "") << text;
    }
}

TEST(Condition, IgnoresSpacesAndKeepsText)
{
    for (const char* text : {"time>=2", " time >= 2 ", "time\t>=2"})
    {
        const Result<Condition> condition = Condition::Parse("--until", text);
        ASSERT_TRUE(condition) << condition.GetError().Text();
        EXPECT_EQ(condition->Text().front(), 't');
        EXPECT_EQ(condition->Text().back(), '2');
        const b2World world(b2Vec2(0.0f, 0.0f));
        EXPECT_FALSE(condition->Holds(world, {}, 1.9));
        EXPECT_TRUE(condition->Holds(world, {}, 2.0));
    }
}

/// Bodies 0 (static), 1 at (2, -3) and 2 at (5, 7), the latter called "ball".
class ConditionInWorld : public testing::Test
{
protected:
    ConditionInWorld()
    {
        b2BodyDef definition;
        m_world.CreateBody(&definition);
        definition.type = b2_dynamicBody;
        definition.position.Set(2.0f, -3.0f);
        definition.angle = 0.5f;
        definition.linearVelocity.Set(3.0f, -4.0f);
        definition.angularVelocity = 1.5f;
        m_world.CreateBody(&definition);
        definition.position.Set(5.0f, 7.0f);
        definition.linearVelocity.SetZero();
        m_ball = m_world.CreateBody(&definition);
    }

    bool Holds(const std::string& text, double seconds = 0.0) const
    {
        const Result<Condition> condition = Condition::Parse("--until", text);
        EXPECT_TRUE(condition) << condition.GetError().Text();
        return condition && condition->Holds(m_world, {{2, "ball"}, {0, "v 1.5"}}, seconds);
    }

    b2World m_world{b2Vec2(0.0f, -10.0f)};
    b2Body* m_ball = nullptr;
};

TEST_F(ConditionInWorld, ReadsEachQuantityOfABody)
{
    const std::pair<const char*, double> values[] = {
        {"1.x", 2.0},   {"1.y", -3.0},    {"1.angle", 0.5}, {"1.vx", 3.0},
        {"1.vy", -4.0}, {"1.speed", 5.0}, {"1.spin", 1.5},  {"1.awake", 1.0},
    };
    for (const auto& [what, value] : values)
    {
        EXPECT_TRUE(Holds(what + std::string(" == ") + std::to_string(value))) << what;
        EXPECT_FALSE(Holds(what + std::string(" != ") + std::to_string(value))) << what;
        EXPECT_TRUE(Holds(what + std::string(" < ") + std::to_string(value + 0.25))) << what;
        EXPECT_FALSE(Holds(what + std::string(" <= ") + std::to_string(value - 0.25))) << what;
        EXPECT_TRUE(Holds(what + std::string(" > ") + std::to_string(value - 0.25))) << what;
        EXPECT_FALSE(Holds(what + std::string(" >= ") + std::to_string(value + 0.25))) << what;
    }
}

TEST_F(ConditionInWorld, ReadsEachQuantityOfTheWorld)
{
    EXPECT_TRUE(Holds("bodies == 3"));
    EXPECT_TRUE(Holds("contacts == 0"));
    EXPECT_TRUE(Holds("awake == 2")) << "without the static one";
    m_ball->SetAwake(false);
    EXPECT_TRUE(Holds("awake == 1"));
    EXPECT_TRUE(Holds("time == 2.5", 2.5));
}

TEST_F(ConditionInWorld, CountsOnlyTouchingContacts)
{
    b2CircleShape circle;
    circle.m_radius = 1.0f;
    for (b2Body* body = m_world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        body->CreateFixture(&circle, 1.0f);
        body->SetTransform(b2Vec2(body == m_ball ? 1.5f : 90.0f * float(body->GetNumber()), 0.0f),
                           0.0f);
    }
    m_world.Step(1.0f / 60.0f, 8, 3);
    EXPECT_TRUE(Holds("contacts == 1"));
}

TEST_F(ConditionInWorld, AppliesAnyAndAllToMovableBodies)
{
    EXPECT_TRUE(Holds("any.y > 6"));
    EXPECT_FALSE(Holds("all.y > 6"));
    EXPECT_TRUE(Holds("all.y > -4"));
    EXPECT_FALSE(Holds("any.y > 7"));
    EXPECT_FALSE(Holds("any.x == 0")) << "that is the static one";
    EXPECT_TRUE(Holds("all.x > 1")) << "that is not the static one";
}

TEST_F(ConditionInWorld, DoesNotHoldForAllWithoutBodies)
{
    b2World empty(b2Vec2(0.0f, 0.0f));
    const Condition condition = *Condition::Parse("--until", "all.speed < 1");
    EXPECT_FALSE(condition.Holds(empty, {}, 0.0));
}

TEST_F(ConditionInWorld, FindsBodyByNumberOrName)
{
    EXPECT_TRUE(Holds("ball.y == 7"));
    EXPECT_TRUE(Holds("2.y == 7"));
    EXPECT_TRUE(Holds("body 2.y == 7"));
    EXPECT_TRUE(Holds("v 1.5.y == 0")) << "a name may have a dot";
}

TEST_F(ConditionInWorld, DoesNotHoldForMissingBody)
{
    for (const char* text : {"99.y < 3", "99.y >= 3", "99.y != 3", "bell.y != 3"})
    {
        EXPECT_FALSE(Holds(text)) << text;
    }
}

TEST_F(ConditionInWorld, DoesNotHoldForNan)
{
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    for (const char* sign : {"<", "<=", ">", ">=", "==", "!="})
    {
        EXPECT_FALSE(Holds(std::string("time ") + sign + " 3", kNone)) << sign;
    }
    EXPECT_TRUE(Holds("time != 3", std::numeric_limits<double>::infinity()));
}

} // namespace
} // namespace boxreel
