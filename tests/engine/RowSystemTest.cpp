// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <Dynamics/Direct/BoundedSystem.h>

#include <gtest/gtest.h>

#include <cmath>

/// The exact solver by itself: bodies with velocities, and rows that hold their points together.
namespace
{

using namespace box2d;

/// Bodies of which each may be joined to each, in a place of its own.
class Frame
{
public:
    explicit Frame(std::size_t count) : m_data(count), bodies(count + 1)
    {
        for (std::size_t i = 0; i < count; ++i)
        {
            BodyData& data = m_data[i];
            data.mobility = Mobility::Dynamic;
            data.awakeIndex = int32(i);
            data.invMass = 1.0f / (1.0f + 0.3f * float32(i % 5));
            data.invInertia = 4.0f * data.invMass;
            bodies[i + 1].v.Set(std::sin(float32(3 * i)), std::cos(float32(5 * i)));
            bodies[i + 1].w = std::sin(float32(7 * i));
        }
        context.bodies = bodies.data();
    }

    /// A hinge halfway between two bodies that are 1 m apart along a direction; -1: to the ground.
    void Join(int32 a, int32 b, float32 angle)
    {
        const b2Vec2 arm = 0.5f * b2Vec2(std::cos(angle), std::sin(angle));
        RowSides& s = sides.emplace_back();
        JointRows& r = rows.emplace_back();
        r.rows = 2;
        for (const int32 body : {a, b})
        {
            const BodyData& data = body == -1 ? m_ground : m_data[std::size_t(body)];
            const float32 sign = body == b ? 1.0f : -1.0f;
            const b2Vec2 reach = -sign * arm;
            s.Add(data);
            JointRows::Column& column = r.Of(data);
            column.AddTo(0, b2Vec2(sign, 0.0f), -sign * reach.y);
            column.AddTo(1, b2Vec2(0.0f, sign), sign * reach.x);
        }
    }

    void Fill(RowSystem& system)
    {
        for (std::size_t i = 0; i < rows.size(); ++i)
        {
            system.Rows(i) = rows[i];
            const Vector3 speed = SpeedOf(context, rows[i]);
            system.Residual(i) = Vector3{{-speed.at[0], -speed.at[1], 0.0}};
        }
    }

    /// Call before its joints are made.
    void FixRotation(std::size_t body) { m_data[body].invInertia = 0.0f; }
    void SetMass(std::size_t body, float32 mass)
    {
        m_data[body].invMass = 1.0f / mass;
        m_data[body].invInertia = 1.0f / mass;
    }

    b2Vec2 Momentum() const
    {
        b2Vec2 sum(0.0f, 0.0f);
        for (std::size_t i = 0; i < m_data.size(); ++i)
        {
            sum += (1.0f / m_data[i].invMass) * bodies[i + 1].v;
        }
        return sum;
    }

    double Fastest(const RowSystem& system) const
    {
        double fastest = 0.0;
        for (std::size_t i = 0; i < rows.size(); ++i)
        {
            const Vector3 speed = SpeedOf(context, system.Rows(i));
            fastest = std::max({fastest, std::abs(speed.at[0]), std::abs(speed.at[1])});
        }
        return fastest;
    }

private:
    BodyData m_ground;
    std::vector<BodyData> m_data;

public:
    Array<SolverBody> bodies;
    SolverContext context;
    Array<RowSides> sides;
    std::vector<JointRows> rows;
};

void Solve(Frame& frame, RowSystem& system, int32 maxUpdates = 16)
{
    Elimination elimination;
    system.Build(frame.sides, maxUpdates, elimination);
    frame.Fill(system);
    for (int32 i = 0; i < system.Components(); ++i)
    {
        system.Read(i);
        system.Factor(i);
        system.Solve(i);
        system.Apply(i, frame.context);
    }
}

TEST(RowSystem, BringsAChainToRestInItsHinges)
{
    Frame frame(30);
    for (int32 i = 0; i < 29; ++i)
    {
        frame.Join(i, i + 1, 0.4f * float32(i));
    }
    const b2Vec2 before = frame.Momentum();
    RowSystem system;
    Solve(frame, system);
    EXPECT_EQ(system.Components(), 1);
    EXPECT_TRUE(system.IsExact());
    EXPECT_LT(frame.Fastest(system), 1e-6);
    EXPECT_LT((frame.Momentum() - before).Length(), 1e-5f);
}

TEST(RowSystem, HoldsAHeavyBodyByLightOnes)
{
    Frame frame(21);
    frame.Join(-1, 0, 0.0f);
    for (int32 i = 0; i < 20; ++i)
    {
        frame.Join(i, i + 1, 0.1f * float32(i));
    }
    frame.SetMass(20, 10000.0f);
    RowSystem system;
    Solve(frame, system);
    EXPECT_LT(frame.Fastest(system), 1e-6);
}

TEST(RowSystem, FillsInNothingInAChainAStarAndATree)
{
    for (const int shape : {0, 1, 2})
    {
        Array<RowSides> sides;
        std::vector<BodyData> data(100);
        for (std::size_t i = 0; i < data.size(); ++i)
        {
            data[i].mobility = Mobility::Dynamic;
            data[i].awakeIndex = int32(i);
        }
        for (std::size_t i = 1; i < data.size(); ++i)
        {
            RowSides& s = sides.emplace_back();
            s.Add(data[shape == 0 ? i - 1 : shape == 1 ? 0 : (i - 1) / 2]);
            s.Add(data[i]);
        }
        RowPattern pattern;
        Elimination().Run(sides, 16, pattern);
        EXPECT_EQ(pattern.rows.size(), 99u) << shape;
        EXPECT_EQ(pattern.targets.size(), 99u) << shape;
    }
}

TEST(RowSystem, SolvesLoopsAndRedundantRows)
{
    Frame frame(12);
    for (int32 i = 0; i < 12; ++i)
    {
        frame.Join(i, (i + 1) % 12, 0.5f * float32(i));
        frame.Join(i, (i + 1) % 12, 0.5f * float32(i)); // once more
    }
    frame.Join(0, 6, 1.0f);
    frame.Join(-1, 3, 2.0f);
    RowSystem system;
    Solve(frame, system);
    EXPECT_LT(frame.Fastest(system), 1e-6);
}

TEST(RowSystem, SolvesConnectedComponentsSeparately)
{
    Frame frame(9);
    for (const int32 i : {0, 3, 6})
    {
        frame.Join(i, i + 1, 0.3f);
        frame.Join(i + 1, i + 2, 0.9f);
    }
    RowSystem system;
    Solve(frame, system);
    EXPECT_EQ(system.Components(), 3);
    EXPECT_LT(frame.Fastest(system), 1e-6);
}

TEST(RowSystem, LeavesOutRowsThatWouldFillInTooMuch)
{
    const auto net = [](Frame& frame) {
        for (int32 i = 0; i < 20; ++i)
        {
            for (int32 k = 0; k < i; ++k)
            {
                frame.Join(i, k, float32(i + k));
            }
        }
        frame.Join(20, 21, 0.0f);
    };
    Frame cheap(22);
    net(cheap);
    RowSystem system;
    Solve(cheap, system, 4);
    EXPECT_FALSE(system.IsExact());
    EXPECT_EQ(system.Iterative().size(), 190u);
    EXPECT_EQ(system.Components(), 1); // the pair is still solved
    Frame frame(22);
    net(frame);
    Solve(frame, system, 400);
    EXPECT_TRUE(system.IsExact());
    EXPECT_LT(frame.Fastest(system), 1e-5);
}

TEST(RowSystem, DoesNotTouchRowsThatAreNotActive)
{
    Frame frame(2);
    frame.Join(0, 1, 0.7f);
    RowSystem system;
    Elimination elimination;
    system.Build(frame.sides, 16, elimination);
    frame.Fill(system);
    system.SetActive(0, 1);
    const Vector3 before = SpeedOf(frame.context, system.Rows(0));
    for (int32 i = 0; i < system.Components(); ++i)
    {
        system.Read(i);
        system.Factor(i);
        system.Solve(i);
    }
    system.Apply(0, frame.context);
    const Vector3 after = SpeedOf(frame.context, system.Rows(0));
    EXPECT_NEAR(after.at[0], 0.0, 1e-6);
    EXPECT_EQ(system.Found(0).at[1], 0.0);
    EXPECT_GT(std::abs(after.at[1]), 0.01);
    EXPECT_GT(std::abs(before.at[0]), 0.01);
}

/// Balls on each other, each pressing on the one below with a row that can only push.
class Column
{
public:
    explicit Column(std::size_t count) : frame(count)
    {
        for (std::size_t i = 0; i < count; ++i)
        {
            frame.Join(i == 0 ? -1 : int32(i) - 1, int32(i), b2_pi / 2.0f);
            frame.bodies[i + 1].v.Set(0.0f, -1.0f);
            frame.bodies[i + 1].w = 0.0f;
        }
        Elimination elimination;
        system.Build(frame.sides, 16, elimination);
        for (std::size_t i = 0; i < count; ++i)
        {
            system.Rows(i) = frame.rows[i];
            BoundedSystem::Item& item = system.At(i);
            item = BoundedSystem::Item();
            item.maximum.at[1] = BoundedSystem::kUnbounded;
            item.active = 2;
        }
    }
    Frame frame;
    BoundedSystem system;
};

TEST(BoundedSystem, PushesAndNeverPulls)
{
    Column column(8);
    column.frame.bodies[5].v.Set(0.0f, 3.0f); // leaves the rest
    column.system.Begin(column.frame.context);
    column.system.Minimize(column.frame.context, 1e-9);
    for (std::size_t i = 0; i < 8; ++i)
    {
        EXPECT_GE(column.system.At(i).impulse.at[1], 0.0) << i;
        EXPECT_GE(SpeedOf(column.frame.context, column.system.Rows(i)).at[1], -1e-6) << i;
    }
    EXPECT_EQ(column.system.At(4).impulse.at[1], 0.0);
    EXPECT_GT(column.system.At(0).impulse.at[1], 1.0);
    EXPECT_NEAR(column.frame.bodies[4].v.y, 0.0f, 1e-6f); // held by what is below
    EXPECT_GT(column.frame.bodies[5].v.y, 0.1f);          // what lies on it goes with it
    EXPECT_NEAR(column.frame.bodies[8].v.y, column.frame.bodies[5].v.y, 1e-6f);
}

TEST(BoundedSystem, LimitsImpulsesToTheirMaximum)
{
    Column column(3);
    column.system.At(0).maximum.at[1] = 0.5;
    column.system.Begin(column.frame.context);
    column.system.Minimize(column.frame.context, 1e-9);
    EXPECT_EQ(column.system.At(0).impulse.at[1], 0.5);
    EXPECT_LT(column.frame.bodies[1].v.y, -0.5f);
    EXPECT_NEAR(column.frame.bodies[3].v.y, column.frame.bodies[1].v.y, 1e-6f);
}

TEST(BoundedSystem, CountsTheSpinOfABodyThatCannotBeTurned)
{
    Frame frame(1);
    frame.FixRotation(0);
    frame.Join(-1, 0, 0.0f);
    frame.bodies[1].v.Set(0.0f, 0.0f);
    frame.bodies[1].w = 2.0f; // brings its point down on the ground at 1 m/s
    BoundedSystem system;
    Elimination elimination;
    system.Build(frame.sides, 16, elimination);
    system.Rows(0) = frame.rows[0];
    system.At(0) = BoundedSystem::Item();
    system.At(0).maximum.at[1] = BoundedSystem::kUnbounded;
    system.At(0).active = 2;
    ASSERT_NEAR(SpeedOf(frame.context, system.Rows(0)).at[1], -1.0, 1e-6);
    system.Begin(frame.context);
    system.Minimize(frame.context, 1e-9);
    EXPECT_NEAR(SpeedOf(frame.context, system.Rows(0)).at[1], 0.0, 1e-6);
    EXPECT_NEAR(frame.bodies[1].v.y, 1.0f, 1e-6f);
    EXPECT_EQ(frame.bodies[1].w, 2.0f);
}

/// A contact that keeps two balls apart and, where wanted, a limit that brings them together.
void FindWhetherItBursts(bool contradicts, bool& bursts, double& impulse)
{
    Frame frame(2);
    frame.Join(0, 1, b2_pi / 2.0f);
    frame.Join(0, 1, b2_pi / 2.0f);
    frame.bodies[1] = frame.bodies[2] = SolverBody();
    frame.bodies[1].v.Set(0.0f, 1.0f);
    BoundedSystem system;
    Elimination elimination;
    system.Build(frame.sides, 16, elimination);
    for (std::size_t i = 0; i < 2; ++i)
    {
        system.Rows(i) = frame.rows[i];
        system.At(i) = BoundedSystem::Item();
    }
    system.At(0).maximum.at[1] = BoundedSystem::kUnbounded;
    system.At(0).active = contradicts ? 2 : 0;
    system.At(1).minimum.at[1] = -BoundedSystem::kUnbounded;
    system.At(1).speeds.at[1] = -2.0;
    system.At(1).active = 2;
    system.Begin(frame.context);
    system.Mark(frame.context);
    system.Minimize(frame.context, contradicts ? 1e-9 : 1e9);
    bursts = system.HasBurst(frame.context);
    system.KeepIfBetter(frame.context);
    impulse = system.At(1).impulse.at[1];
}

TEST(BoundedSystem, RejectsALimitThatContradictsAContact)
{
    bool bursts = false;
    double impulse = 0.0;
    FindWhetherItBursts(true, bursts, impulse);
    EXPECT_TRUE(bursts);
    EXPECT_EQ(impulse, 0.0);
    FindWhetherItBursts(false, bursts, impulse);
    EXPECT_FALSE(bursts);
    EXPECT_LT(impulse, -0.5); // brings them together
}

} // namespace
