// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <Common/WideInstructions.h>
#include <Dynamics/Joints/JointSchedule.h>
#include <Dynamics/Solver/ContactBlocks.h>
#include <Dynamics/State/Access.h>
#include <Dynamics/State/ConstraintGraph.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

/// Joints without common bodies are solved in parallel, eight of a kind at once, with equal
/// results.
namespace
{

using namespace dynamics;

/// Bodies that never touch, so that any number can be in one place.
b2Body* Ghost(Scene& scene, b2BodyType type, float32 x, float32 y)
{
    b2Body* body = scene.Body(type, x, y);
    b2Fixture* fixture = Scene::AddBox(body, 0.5f, 0.125f);
    b2Filter filter;
    filter.maskBits = 0;
    fixture->SetFilterData(filter);
    return body;
}

b2RevoluteJoint* Hinge(Scene& scene, b2Body* a, b2Body* b, float32 x, float32 y)
{
    b2RevoluteJointDef def;
    def.Initialize(a, b, b2Vec2(x, y));
    return static_cast<b2RevoluteJoint*>(scene.world.CreateJoint(&def));
}

template <class Definition>
b2Joint* Join(Scene& scene, Definition def, b2Body* a, b2Body* b, const b2Vec2& at)
{
    def.Initialize(a, b, at);
    return scene.world.CreateJoint(&def);
}

/// Adds the i-th joint of a machine between two bodies 1 m apart. Some have limits, motors and
/// springs, and the fourth starts beyond its limit. Not for gears.
b2Joint* AddJoint(Scene& scene, b2JointType type, b2Body* a, b2Body* b, int i)
{
    const b2Vec2 at(float32(i), 0.0f);
    const b2Vec2 axis = i % 2 == 0 ? b2Vec2(0.8f, 0.6f) : b2Vec2(0.0f, 1.0f);
    const bool some = i % 2 == 1;
    const bool others = i % 3 == 0;
    switch (type)
    {
    case e_revoluteJoint: {
        b2RevoluteJointDef def;
        def.enableMotor = some;
        def.motorSpeed = 3.0f - float32(i);
        def.maxMotorTorque = 20.0f;
        def.enableLimit = others;
        def.lowerAngle = i == 3 ? 0.1f : -0.3f;
        def.upperAngle = 0.2f;
        return Join(scene, def, a, b, at);
    }
    case e_prismaticJoint: {
        b2PrismaticJointDef def;
        def.Initialize(a, b, at, axis);
        def.enableMotor = some;
        def.motorSpeed = 2.0f;
        def.maxMotorForce = 30.0f;
        def.enableLimit = others;
        def.lowerTranslation = i == 3 ? 0.1f : -0.2f;
        def.upperTranslation = 0.3f;
        return scene.world.CreateJoint(&def);
    }
    case e_distanceJoint: {
        b2DistanceJointDef def;
        def.Initialize(a, b, at - b2Vec2(0.25f, 0.0f), at + b2Vec2(0.25f, 0.1f));
        def.frequencyHz = some ? 3.0f : 0.0f;
        def.dampingRatio = 0.3f;
        return scene.world.CreateJoint(&def);
    }
    case e_pulleyJoint: {
        b2PulleyJointDef def;
        def.Initialize(a, b, at + b2Vec2(-1.0f, 4.0f), at + b2Vec2(1.0f, 5.0f),
                       at - b2Vec2(0.3f, 0.0f), at + b2Vec2(0.3f, 0.0f), some ? 1.0f : 2.0f);
        return scene.world.CreateJoint(&def);
    }
    case e_mouseJoint: {
        b2MouseJointDef def;
        def.bodyA = a;
        def.bodyB = b;
        def.target = at;
        def.maxForce = some ? 10.0f : 1000.0f;
        b2Joint* joint = scene.world.CreateJoint(&def);
        static_cast<b2MouseJoint*>(joint)->SetTarget(at + b2Vec2(0.5f, 1.0f));
        return joint;
    }
    case e_wheelJoint: {
        b2WheelJointDef def;
        def.Initialize(a, b, at, axis);
        def.enableMotor = some;
        def.motorSpeed = -5.0f;
        def.maxMotorTorque = 10.0f;
        def.frequencyHz = others ? 0.0f : 4.0f;
        return scene.world.CreateJoint(&def);
    }
    case e_weldJoint: {
        b2WeldJointDef def;
        def.frequencyHz = some ? 4.0f : 0.0f;
        def.dampingRatio = 0.3f;
        return Join(scene, def, a, b, at);
    }
    case e_frictionJoint: {
        b2FrictionJointDef def;
        def.maxForce = some ? 5.0f : 500.0f;
        def.maxTorque = others ? 1.0f : 100.0f;
        return Join(scene, def, a, b, at);
    }
    case e_ropeJoint: {
        b2RopeJointDef def;
        def.bodyA = a;
        def.bodyB = b;
        def.localAnchorB.Set(-0.5f, 0.0f);
        def.maxLength = some ? 0.6f : 1.2f;
        return scene.world.CreateJoint(&def);
    }
    case e_motorJoint: {
        b2MotorJointDef def;
        def.Initialize(a, b);
        def.maxForce = some ? 5.0f : 500.0f;
        def.maxTorque = others ? 1.0f : 100.0f;
        def.linearOffset += b2Vec2(0.1f, 0.2f);
        return scene.world.CreateJoint(&def);
    }
    default:
        return nullptr;
    }
}

/// The last two joints of a chain, geared; their frames and bodies are all in the chain, and one is
/// the frame of the one and the body of the other.
void Gear(Scene& scene, b2Joint* one, b2Joint* other)
{
    b2GearJointDef def;
    def.joint1 = one;
    def.joint2 = other;
    def.bodyA = one->GetBodyB();
    def.bodyB = other->GetBodyB();
    def.ratio = -1.5f;
    ASSERT_NE(scene.world.CreateJoint(&def), nullptr);
}

enum class Variety
{
    Plain,
    Stiff,    ///< a body that cannot turn
    Platform, ///< hung on something that turns by itself
};

/// A chain of one kind of joints, from the ground; for gears one of hinges and sliders, geared.
std::vector<b2Body*> AddMachine(Scene& scene, b2Body* ground, b2JointType type, Variety variety)
{
    std::vector<b2Body*> bodies;
    b2Body* last = ground;
    if (variety == Variety::Platform)
    {
        last = Ghost(scene, b2_kinematicBody, 0.0f, 0.0f);
        last->SetAngularVelocity(2.0f);
        bodies.push_back(last);
    }
    b2Joint* lastJoint = nullptr;
    for (int i = 0; i < 5; ++i)
    {
        b2Body* body = Ghost(scene, b2_dynamicBody, 0.5f + float32(i), 0.0f);
        body->SetFixedRotation(variety == Variety::Stiff && i == 2);
        const b2JointType inGear = i % 3 == 1 ? e_prismaticJoint : e_revoluteJoint;
        b2Joint* joint = AddJoint(scene, type == e_gearJoint ? inGear : type, last, body, i);
        EXPECT_NE(joint, nullptr);
        if (type == e_gearJoint && lastJoint != nullptr)
        {
            Gear(scene, lastJoint, joint);
        }
        lastJoint = joint;
        bodies.push_back(body);
        last = body;
    }
    return bodies;
}

std::vector<float32> StateOf(const std::vector<b2Body*>& bodies)
{
    std::vector<float32> state;
    for (const b2Body* b : bodies)
    {
        state.insert(state.end(),
                     {b->GetPosition().x, b->GetPosition().y, b->GetAngle(),
                      b->GetLinearVelocity().x, b->GetLinearVelocity().y, b->GetAngularVelocity()});
        for (const b2JointEdge* edge = b->GetJointList(); edge; edge = edge->next)
        {
            const b2Vec2 force = edge->joint->GetReactionForce(60.0f);
            state.insert(state.end(), {force.x, force.y, edge->joint->GetReactionTorque(60.0f)});
        }
    }
    return state;
}

std::vector<float32> StatesOfMachines(b2JointType type, Variety variety, int copies, int32 threads)
{
    Scene scene;
    scene.world.SetThreadCount(threads);
    b2Body* ground = scene.Body(b2_staticBody, 0.0f, 0.0f);
    std::vector<std::vector<b2Body*>> machines;
    for (int i = 0; i < copies; ++i)
    {
        machines.push_back(AddMachine(scene, ground, type, variety));
    }
    scene.Step(120);
    const std::vector<float32> state = StateOf(machines.front());
    for (const std::vector<b2Body*>& machine : machines)
    {
        EXPECT_EQ(StateOf(machine), state) << "one of " << copies;
    }
    return state;
}

class JointsOfAKind : public testing::TestWithParam<b2JointType>
{};

TEST_P(JointsOfAKind, MoveTheSameAloneAndEightAtATime)
{
    for (const Variety variety : {Variety::Plain, Variety::Stiff, Variety::Platform})
    {
        const std::vector<float32> alone = StatesOfMachines(GetParam(), variety, 1, 1);
        for (const int lanes : {4, 8, 16})
        {
            box2d::UseLanes(lanes);
            for (const int copies : {2, 3, 8, 13})
            {
                EXPECT_EQ(StatesOfMachines(GetParam(), variety, copies, 1), alone)
                    << copies << " copies, lanes: " << lanes << ", variety " << int(variety);
            }
            EXPECT_EQ(StatesOfMachines(GetParam(), variety, 150, 3), alone)
                << "three threads, lanes: " << lanes << ", variety " << int(variety);
        }
        box2d::UseLanes(16);
    }
}

std::string NameOf(const testing::TestParamInfo<b2JointType>& info)
{
    static const char* const names[] = {"Unknown", "Revolute", "Prismatic", "Distance",
                                        "Pulley",  "Mouse",    "Gear",      "Wheel",
                                        "Weld",    "Friction", "Rope",      "Motor"};
    return names[info.param];
}

INSTANTIATE_TEST_SUITE_P(All, JointsOfAKind,
                         testing::Values(e_revoluteJoint, e_prismaticJoint, e_distanceJoint,
                                         e_pulleyJoint, e_mouseJoint, e_gearJoint, e_wheelJoint,
                                         e_weldJoint, e_frictionJoint, e_ropeJoint, e_motorJoint),
                         NameOf);

/// Hinges between random bodies, some of them gears and distance joints.
class RandomMesh
{
public:
    explicit RandomMesh(unsigned seed)
    {
        std::mt19937 random(seed);
        b2Body* ground = scene.Body(b2_staticBody, 0.0f, 0.0f);
        for (int i = 0; i < 60; ++i)
        {
            bodies.push_back(Ghost(scene, b2_dynamicBody, float32(i % 10), float32(i / 10)));
        }
        const auto any = [&] { return bodies[random() % bodies.size()]; };
        for (int i = 0; i < 90; ++i)
        {
            b2Body* a = any();
            b2Body* b = any();
            if (a == b)
            {
                continue;
            }
            if (i % 5 == 0)
            {
                b2DistanceJointDef def;
                def.Initialize(a, b, a->GetPosition(), b->GetPosition());
                joints.push_back(scene.world.CreateJoint(&def));
            }
            else
            {
                joints.push_back(Hinge(scene, i % 7 == 0 ? ground : a, b, 0.0f, 0.0f));
            }
        }
        for (int i = 0; i < 10; ++i) // the joints of a gear turn against bodies that move as well
        {
            std::shuffle(bodies.begin(), bodies.end(), random);
            AddGear(Hinge(scene, bodies[0], bodies[1], 1.0f, 1.0f),
                    Hinge(scene, bodies[2], bodies[3], 2.0f, 1.0f));
        }
    }

    std::vector<b2Body*> MovedBy(b2Joint* joint) const
    {
        std::vector<b2Body*> moved = {joint->GetBodyA(), joint->GetBodyB()};
        if (joint->GetType() == e_gearJoint)
        {
            auto* gear = static_cast<b2GearJoint*>(joint);
            moved.push_back(gear->GetJoint1()->GetBodyA());
            moved.push_back(gear->GetJoint2()->GetBodyA());
        }
        std::erase_if(moved, [](b2Body* body) { return body->GetType() != b2_dynamicBody; });
        return moved;
    }

    Scene scene;
    std::vector<b2Body*> bodies;
    std::vector<b2Joint*> joints; ///< in the order of creation

private:
    void AddGear(b2Joint* one, b2Joint* another)
    {
        joints.push_back(one);
        joints.push_back(another);
        b2GearJointDef def;
        def.bodyA = one->GetBodyB();
        def.bodyB = another->GetBodyB();
        def.joint1 = one;
        def.joint2 = another;
        joints.push_back(scene.world.CreateJoint(&def));
    }
};

TEST(JointSchedule, KeepsCreationOrderOfJointsSharingBody)
{
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        RandomMesh mesh(seed);
        box2d::ConstraintGraph graph;
        for (b2Joint* joint : mesh.joints)
        {
            box2d::JointAccess::SolverIndex(*joint) = -1; // this graph's instead of the world's
            graph.Add(*joint);
        }
        box2d::JointSchedule schedule;
        schedule.Update(graph);
        std::map<b2Joint*, std::size_t> levelOf;
        const auto levels = schedule.Levels();
        for (std::size_t level = 0; level < levels.size(); ++level)
        {
            std::set<b2Body*> busy;
            for (b2Joint* joint : levels[level])
            {
                EXPECT_TRUE(levelOf.emplace(joint, level).second) << "solved twice";
                std::set<b2Body*> own;
                for (b2Body* body : mesh.MovedBy(joint))
                {
                    own.insert(body);
                }
                for (b2Body* body : own)
                {
                    EXPECT_TRUE(busy.insert(body).second) << "two joints of a level share a body";
                }
            }
        }
        EXPECT_EQ(levelOf.size(), mesh.joints.size());
        std::map<b2Body*, std::size_t> last;
        for (b2Joint* joint : mesh.joints)
        {
            for (b2Body* body : mesh.MovedBy(joint))
            {
                const auto before = last.find(body);
                EXPECT_TRUE(before == last.end() || before->second <= levelOf[joint]);
                last[body] = levelOf[joint];
            }
        }
    }
}

TEST(JointSchedule, LeavesASingleHingeExact)
{
    Scene scene;
    b2Body* ground = scene.Body(b2_staticBody, 0.0f, 0.0f);
    b2Body* rod = Ghost(scene, b2_dynamicBody, 0.5f, 0.0f);
    const b2RevoluteJoint* joint = Hinge(scene, ground, rod, 0.0f, 0.0f);
    for (int step = 0; step < 300; ++step)
    {
        scene.Step(1);
        EXPECT_LT(b2Distance(joint->GetAnchorA(), joint->GetAnchorB()), 1e-4f);
    }
}

/// Watches the energy of a scene. Joints can only remove it [J/kg, above the start].
class Watch
{
public:
    explicit Watch(Scene& scene, const std::vector<b2Body*>& bodies)
        : m_scene(scene), m_bodies(bodies), m_first(Energy())
    {}

    void Run(int steps, int32 velocityIterations = 8)
    {
        for (int i = 0; i < steps; ++i)
        {
            m_scene.world.Step(kStep, velocityIterations, 3);
            gained = b2Max(gained, Energy() - m_first);
            for (const b2Joint* j = m_scene.world.GetJointList(); j; j = j->GetNext())
            {
                widest = b2Max(widest, b2Distance(j->GetAnchorA(), j->GetAnchorB()));
            }
            for (const b2Body* body : m_bodies)
            {
                fastest = b2Max(fastest, body->GetLinearVelocity().Length());
            }
        }
    }

    float32 gained = 0.0f;
    float32 widest = 0.0f;  ///< gap of a joint [m]
    float32 fastest = 0.0f; ///< [m/s]

private:
    float32 Energy() const
    {
        const float32 gravity = m_scene.world.GetGravity().y;
        float32 energy = 0.0f;
        float32 mass = 0.0f;
        for (const b2Body* b : m_bodies)
        {
            const float32 inertia =
                b->GetInertia() - b->GetMass() * b->GetLocalCenter().LengthSquared();
            energy += 0.5f * b->GetMass() * b->GetLinearVelocity().LengthSquared() +
                      0.5f * inertia * b->GetAngularVelocity() * b->GetAngularVelocity() -
                      gravity * b->GetMass() * b->GetWorldCenter().y;
            mass += b->GetMass();
        }
        return energy / mass;
    }

    Scene& m_scene;
    const std::vector<b2Body*>& m_bodies;
    float32 m_first;
};

/// Ten bodies, as those of the benchmark.
std::vector<b2Body*> AddRagdoll(Scene& scene, float32 x, float32 y)
{
    std::vector<b2Body*> limbs;
    const auto limb = [&](float32 dx, float32 dy, float32 hx, float32 hy) {
        limbs.push_back(scene.Body(b2_dynamicBody, x + dx, y + dy));
        Scene::AddBox(limbs.back(), hx, hy, 0.6f);
        return limbs.back();
    };
    const auto hinge = [&](b2Body* a, b2Body* b, float32 dx, float32 dy, float32 maximum) {
        b2RevoluteJoint* joint = Hinge(scene, a, b, x + dx, y + dy);
        joint->SetLimits(-maximum, maximum);
        joint->EnableLimit(true);
    };
    b2Body* torso = limb(0.0f, 0.0f, 0.2f, 0.35f);
    hinge(torso, limb(0.0f, 0.55f, 0.15f, 0.15f), 0.0f, 0.35f, 0.5f);
    for (const float32 side : {-1.0f, 1.0f})
    {
        b2Body* upperArm = limb(side * 0.4f, 0.25f, 0.2f, 0.08f);
        hinge(torso, upperArm, side * 0.2f, 0.25f, 1.2f);
        hinge(upperArm, limb(side * 0.8f, 0.25f, 0.2f, 0.07f), side * 0.6f, 0.25f, 2.0f);
        b2Body* thigh = limb(side * 0.11f, -0.57f, 0.09f, 0.22f);
        hinge(torso, thigh, side * 0.11f, -0.35f, 0.7f);
        hinge(thigh, limb(side * 0.11f, -1.01f, 0.08f, 0.22f), side * 0.11f, -0.79f, 1.5f);
    }
    return limbs;
}

TEST(JointSchedule, LetsRagdollsWithLimitsComeToRest)
{
    Scene scene;
    scene.Ground();
    std::vector<b2Body*> limbs;
    for (int i = 0; i < 6; ++i)
    {
        const std::vector<b2Body*> some = AddRagdoll(
            scene, 0.5f * float32(i % 2) + 2.5f * float32(i % 3), 2.0f + 2.5f * float32(i / 3));
        limbs.insert(limbs.end(), some.begin(), some.end());
    }
    Watch watch(scene, limbs);
    watch.Run(1800);
    EXPECT_LT(watch.gained, 0.1f);
    EXPECT_LT(watch.widest, 0.3f);
    EXPECT_TRUE(AllAwake(limbs, false));
}

/// Balls 1 m apart, each hinged to its neighbours half way, some of the first row to the ground.
std::vector<b2Body*> AddGrid(Scene& scene, int size)
{
    std::vector<b2Body*> balls;
    b2Body* ground = scene.Body(b2_staticBody, 0.0f, 0.0f);
    for (int k = 0; k < size; ++k)
    {
        for (int i = 0; i < size; ++i)
        {
            const b2Vec2 at(float32(k), -float32(i));
            b2Body* ball = scene.Ball(at.x, at.y, 0.4f); // a gap of 0.2 m between them
            ball->GetFixtureList()->SetSensor(true);
            if (i == 0 && k % 9 == 0)
            {
                Hinge(scene, ground, ball, at.x, 0.5f);
            }
            if (i > 0)
            {
                Hinge(scene, balls.back(), ball, at.x, at.y + 0.5f);
            }
            if (k > 0)
            {
                Hinge(scene, balls[balls.size() - std::size_t(size)], ball, at.x - 0.5f, at.y);
            }
            balls.push_back(ball);
        }
    }
    return balls;
}

TEST(JointSchedule, LimitsTheEnergyGainOfAGrid)
{
    for (const int size : {10, 20})
    {
        Scene scene;
        const std::vector<b2Body*> balls = AddGrid(scene, size);
        Watch watch(scene, balls);
        watch.Run(600);
        EXPECT_LT(watch.gained, 20.0f) << size; // 1.5 and 4; over-relaxed 7600
    }
}

} // namespace
