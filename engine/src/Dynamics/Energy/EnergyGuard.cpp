// SPDX-License-Identifier: MIT
#include "EnergyGuard.h"

#include "../Islands/Sleep.h"
#include "../Solver/SolverMemory.h"
#include "../State/Access.h"
#include "../State/World.h"
#include "IslandMotion.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>

namespace box2d
{

namespace
{

/// Gains up to this fraction of the scale count as truncation errors: as much as tests of random
/// worlds allow. Smaller: such errors would slow down motions that conserve energy in the long run.
/// Larger: a body could visibly speed up by itself. With 0.04 one of 80 random worlds gains 4.8 %
/// of energy (one step). With 0.005 all tests pass. With 0.0025 a pair gains 24 % by a fall that is
/// undone, where the test allows 20.
constexpr double kTolerance = 0.01;
/// Maximum credit as a multiple of the scale. A tree of posts that reaches 6 m loses nine times its
/// kinetic energy while its hinges open; with 3 it comes to rest when they close. Without a bound a
/// long deceleration could pay for a later gain. With 30 the random worlds end as with 10.
constexpr double kMaxCredit = 10.0;
/// Maximum debt that waits, as a fraction of the scale. What is beyond it is paid at once from what
/// velocities gained in the step. With 0.03 trees of posts lose up to 90 % of their energy in a
/// step.
constexpr double kMaxDebt = 0.1;
/// Maximum debt that is stored, as a fraction of the scale. With 0.1 a chain of welds (200:1) gains
/// 64 % of energy instead of 22 %; the random worlds end alike (docs/notes/energy-guard.md).
constexpr double kMaxOwed = 1.0;
/// Maximum fraction of its kinetic energy that an island pays of older debts in a step. With 0.03
/// the random worlds end alike; with 1 trees of posts are stopped (docs/notes/energy-guard.md).
constexpr double kMaxShare = 0.1;
/// Decay rate of the scale and of debts [1/s]. Half of them is left after 7 s, in which a pendulum
/// of 10 m swings once. With 1 small gains add up unnoticed; with 0.01 half of a debt is
/// left after a minute (docs/notes/tuned-constants.md).
constexpr double kFade = 0.1;
/// Energy that corrections may store in springs of bodies at rest [J/kg], equivalent to 0.7 m/s. A
/// body on springs that is pushed out of the ground needs a fiftieth of it. With 0.5 random world 5
/// gains 3.2 % in 12 s, with 0.1 2.0 % (docs/notes/random-worlds.md).
constexpr double kMaxFromRest = 0.25;
/// Minimum scale, as the energy of a fall by this distance [m]. Joints are closed to within a slop;
/// lifting a body by that, a hundredth of this energy, is not a gain.
constexpr float32 kMinFall = b2_linearSlop / float32(kTolerance);
/// Keeps all sums in the range of float [J]: those of 1e8 bodies stay below its maximum of 3e38.
constexpr float32 kMaxScale = 1e30f;

/// True if it moves or was moved by the user, so that bodies that it holds or touches move too.
bool MovesOthers(const b2Body& body)
{
    const BodyData& data = Data(body);
    return IsMovingPlatform(data) || data.world->IsRecentUserChange(data.userMovedAt);
}

/// True if energy may enter that the account does not include: kinematic bodies, and user changes
/// of poses, rope lengths and limits. User changes of velocity, force, gravity scale and mass, and
/// of springs and motors, are included.
bool IsDriven(const b2Body& body)
{
    if (MovesOthers(body))
    {
        return true;
    }
    for (const b2ContactEdge* edge = body.GetContactList(); edge; edge = edge->next)
    {
        const b2Contact& c = *edge->contact;
        if (c.IsTouching() &&
            (MovesOthers(*edge->other) || c.GetTangentSpeed() != 0.0f || c.GetRestitution() > 1.0f))
        {
            return true;
        }
    }
    for (const b2JointEdge* edge = body.GetJointList(); edge; edge = edge->next)
    {
        if (MovesOthers(*edge->other) ||
            Data(body).world->IsRecentUserChange(JointAccess::ChangedAt(*edge->joint)))
        {
            return true;
        }
    }
    return false;
}

bool IsIslandDriven(const b2Body& first)
{
    for (const b2Body* body = &first; body; body = Data(*body).islandNext)
    {
        if (IsDriven(*body))
        {
            return true;
        }
    }
    return false;
}

/// Returns the decaying maximum of the kinetic energy, including the current one.
float32 ScaleOf(float32 past, const BodyData& body, const SolverBody& s)
{
    const auto kinetic = float32(KineticEnergy(s, double(body.mass), double(body.inertia)));
    return kinetic > past ? b2Min(kinetic, kMaxScale) : past;
}

/// Charges the energy gained by impacts. A body's credit, which joints took from it, does not pay
/// for that, because nothing returns it. Otherwise a body that a spring accelerates and impacts
/// stop again and again would gain energy without bound.
void Charge(BodyData& body, float32 gained)
{
    const bool counts = gained > float32(kTolerance) * body.energyScale; // or it is truncation
    body.energyDebt = (counts ? b2Max(body.energyDebt, 0.0f) : body.energyDebt) + gained;
}

} // namespace

int32 EnergyGuard::AccountOf(const BodyData& body) const
{
    return body.island == -1 ? -1 : m_accountOf[std::size_t(body.island)];
}

int32 EnergyGuard::AccountOf(const b2Joint& joint) const
{
    const int32 a = AccountOf(Data(*joint.GetBodyA()));
    return a != -1 ? a : AccountOf(Data(*joint.GetBodyB()));
}

void EnergyGuard::Begin(const World& world, SolverMemory& solver, float32 timeStep)
{
    for (const Account& account : m_accounts)
    {
        m_accountOf[std::size_t(account.island)] = -1;
    }
    m_accounts.clear();
    m_springs.clear();
    m_motors.clear();
    solver.pushed.clear();
    FindRisks(world.graph);
    if (m_risky.empty() && m_changing.empty())
    {
        return;
    }
    m_timeStep = timeStep;
    m_subSteps = world.settings.subStepCount;
    m_gravity = world.settings.gravity;
    m_minFall = kMinFall * m_gravity.Length();
    // Cleared above only for islands with an account: most islands may be asleep.
    m_accountOf.resize(b2Max(m_accountOf.size(), std::size_t(world.islands.Size())), -1);
    for (const b2Joint* joint : m_risky)
    {
        Open(*joint);
    }
    for (const b2Joint* joint : m_changing)
    {
        if (IsAtRisk(*joint) || TurnsFar(*joint, timeStep / float32(m_subSteps)))
        {
            Open(*joint);
        }
    }
    if (m_accounts.empty())
    {
        return;
    }
    solver.pushed.assign(solver.bodies.size(), b2Vec2_zero);
    for (b2Joint* joint : world.graph.Joints())
    {
        if (HasSpring(*joint) && AccountOf(*joint) != -1)
        {
            const SpringState state = SpringOf(*joint, nullptr);
            m_springs.push_back({joint, AccountOf(*joint), state, state});
        }
        if (HasMotor(*joint) && AccountOf(*joint) != -1)
        {
            m_motors.push_back(
                {joint, AccountOf(*joint), MaxMotorWork(*joint, solver.bodies.data(), timeStep)});
        }
    }
}

/// Repeated when joints were added, removed or fell asleep, or masses changed.
void EnergyGuard::FindRisks(const ConstraintGraph& graph)
{
    if (m_version == graph.JointVersion())
    {
        return;
    }
    m_version = graph.JointVersion();
    m_risky.clear();
    m_changing.clear();
    for (const b2Joint* joint : graph.Joints())
    {
        if (IsAtRisk(*joint))
        {
            m_risky.push_back(joint);
        }
        else if (HasChangingLevers(*joint) || IsLine(*joint))
        {
            m_changing.push_back(joint);
        }
    }
}

void EnergyGuard::Open(const b2Joint& joint)
{
    for (const b2Body* body : {joint.GetBodyA(), joint.GetBodyB()})
    {
        const int32 island = Data(*body).island;
        if (island != -1 && AccountOf(Data(*body)) == -1)
        {
            m_accountOf[std::size_t(island)] = int32(m_accounts.size());
            m_accounts.emplace_back().island = island;
        }
    }
}

void EnergyGuard::Balance(const World& world, SolverMemory& solver)
{
    if (m_accounts.empty())
    {
        return;
    }
    AddBodies(world, solver);
    AddJoints(solver);
    for (Account& account : m_accounts)
    {
        if (account.Debt() > kTolerance * account.scale)
        {
            Collect(world, solver, account);
        }
    }
    ShareOut(world, solver);
}

/// Returns the work of an acceleration along pushes [J/kg]. Without sub-steps joints are closed
/// after each of them, and what they take back is no push.
float32 EnergyGuard::WorkOfPushes(const b2Vec2& a, const SolverBody& s, const b2Vec2& pushed) const
{
    if (m_subSteps > 1)
    {
        return b2Dot(a, pushed);
    }
    const float32 corrected = b2Dot(a, s.d - m_timeStep * s.v);
    return b2Clamp(b2Dot(a, pushed), b2Min(corrected, 0.0f), b2Max(corrected, 0.0f));
}

/// Returns the energy that a body gained beyond the work of gravity and forces along its path,
/// including corrections of its pose [J]. A correction that lifts a body which keeps sinking is
/// therefore no gain. Nor is a push out of an overlap. Bodies that start in one would owe the
/// energy of the lift, and could not move until it is paid.
double EnergyGuard::Gained(const BodyData& body, const SolverBody& s, const b2Vec2& pushed) const
{
    const b2Vec2 a = body.gravityScale * m_gravity + body.invMass * body.force;
    const float32 alpha = body.invInertia * body.torque;
    const float32 push = b2Dot(a, s.d) - WorkOfPushes(a, s, pushed);
    const float32 twist = alpha * s.angle;
    // Differences first: they are small, and so are their rounding errors.
    const float32 linear = 0.5f * b2Dot(s.v - body.linearVelocity, s.v + body.linearVelocity);
    const float32 angular = 0.5f * (s.w - body.angularVelocity) * (s.w + body.angularVelocity);
    return double(body.mass) * double(linear - push) +
           double(body.inertia) * double(angular - twist);
}

float32 EnergyGuard::PastOf(const BodyData& body) const
{
    return b2Max(body.energyScale, m_minFall * body.mass);
}

void EnergyGuard::AddBodies(const World& world, SolverMemory& solver)
{
    for (const b2Body* body : world.awakeBodies)
    {
        const BodyData& data = Data(*body);
        const int32 index = AccountOf(data);
        if (index != -1)
        {
            Account& account = m_accounts[std::size_t(index)];
            SolverBody& s = solver.bodies[std::size_t(data.SolverIndex())];
            const b2Vec2 pushed = solver.pushed[std::size_t(data.SolverIndex())];
            double gained = Gained(data, s, pushed);
            if (gained != gained)
            {
                s = SolverBody(); // as it will be written back
                gained = Gained(data, s, b2Vec2_zero);
            }
            account.owed += double(data.energyDebt);
            account.gained += gained;
            SolverBody moved = s; // by its velocity alone
            moved.d = m_timeStep * s.v;
            moved.angle = m_timeStep * s.w;
            account.gainedByVelocity += Gained(data, moved, b2Vec2_zero);
            const float32 past = PastOf(data);
            account.past += double(past);
            account.scale += double(ScaleOf(past, data, s));
        }
    }
}

void EnergyGuard::AddJoints(const SolverMemory& solver)
{
    for (Spring& spring : m_springs)
    {
        spring.after = SpringOf(*spring.joint, solver.bodies.data());
        m_accounts[std::size_t(spring.account)].gained +=
            StoredBetween(spring.before, spring.after);
    }
    for (const Motor& motor : m_motors)
    {
        const double after = MaxMotorWork(*motor.joint, solver.bodies.data(), m_timeStep);
        m_accounts[std::size_t(motor.account)].gained -= std::max(motor.work, after);
    }
}

/// A small debt slows the motion down over many steps and does not stop it. A large one, as of a
/// chain whose iterations diverge, is removed in the step in which velocities gain it.
void EnergyGuard::Collect(const World& world, SolverMemory& solver, Account& account)
{
    const b2Body& first = *world.islands.At(account.island).first;
    if (IsIslandDriven(first))
    {
        account.owed = account.gained = 0.0;
        return;
    }
    const double free = kTolerance * account.past; // from the energy before, because the current
                                                   // one contains the gain
    const IslandMotion found(first, solver.bodies.data());
    const auto isPayable = [&](double share) {
        const double payable = free + share * found.Energy() + kMaxFromRest * found.Mass();
        return m_subSteps > 1 || account.Debt() <= payable;
    };
    if (!isPayable(kMaxShare))
    {
        MoveAgain(first, solver, account, m_timeStep); // without corrections
    }
    if (!isPayable(1.0))
    {
        MoveAgain(first, solver, account, 0.0f); // without motion
    }
    const double debt = account.Debt() - free;
    if (debt > 0.0)
    {
        IslandMotion motion(first, solver.bodies.data());
        const double maximum = kMaxDebt * account.past;
        const double grown = std::min(account.gained, account.gainedByVelocity);
        const double share = std::min(debt / maximum, kMaxShare);
        const double due = std::max(std::min(debt - maximum, grown), 0.0) + share * motion.Energy();
        const double lost = std::min({due, debt, motion.Energy()});
        motion.Lose(lost);
        account.owed -= lost;
        account.scale = account.past;
    }
}

/// For springs that gained energy: moves the island by its velocities only, for that time [s].
/// Joints that corrections should have closed stay open. The time is 0 if velocities store the
/// energy in springs; those velocities are then lost.
void EnergyGuard::MoveAgain(const b2Body& first, SolverMemory& solver, Account& account,
                            float32 time)
{
    const auto isOurs = [&](const Spring& spring) {
        return m_accounts[std::size_t(spring.account)].island == account.island;
    };
    double saved = 0.0;
    for (const Spring& spring : m_springs)
    {
        saved += isOurs(spring) ? StoredBetween(spring.before, spring.after) : 0.0;
    }
    if (!(saved > 0.0))
    {
        return;
    }
    for (const b2Body* body = &first; body; body = Data(*body).islandNext)
    {
        if (Data(*body).awakeIndex != -1)
        {
            const auto index = std::size_t(Data(*body).SolverIndex());
            SolverBody& s = solver.bodies[index];
            saved += Gained(Data(*body), s, solver.pushed[index]);
            s.d = time * s.v;
            s.angle = time * s.w;
            s.q.Set(s.angle);
            saved -= Gained(Data(*body), s, b2Vec2_zero);
        }
    }
    for (Spring& spring : m_springs)
    {
        if (isOurs(spring))
        {
            spring.after = SpringOf(*spring.joint, solver.bodies.data());
            saved -= StoredBetween(spring.before, spring.after);
        }
    }
    account.gained -= saved;
}

/// Stores the account in shares of the bodies, relative to the scale. Debts decay with the scale.
/// Credit does not: it is what closing loaded joints returns, at any later time. Only its maximum
/// decreases with the scale.
void EnergyGuard::ShareOut(const World& world, const SolverMemory& solver)
{
    const auto fade = float32(1.0 / (1.0 + kFade * double(m_timeStep)));
    for (Account& account : m_accounts)
    {
        const double share = account.scale > 0.0 ? account.Debt() / account.scale : 0.0;
        account.share = b2Clamp(share, -kMaxCredit, kMaxOwed);
    }
    for (b2Body* body : world.awakeBodies)
    {
        BodyData& data = Data(*body);
        const int32 account = AccountOf(data);
        if (account != -1)
        {
            const SolverBody& s = solver.bodies[std::size_t(data.SolverIndex())];
            const float32 scale = ScaleOf(PastOf(data), data, s);
            const auto share = float32(m_accounts[std::size_t(account)].share);
            data.energyScale = fade * scale;
            data.energyDebt = share * (share > 0.0f ? data.energyScale : scale);
        }
    }
}

void EnergyGuard::NoteImpact(BodyData& body, const Path& before) const
{
    // Islands may have merged since, but both bodies of an impact are then in the same one.
    if (!body.IsDynamic() || body.island == -1 || std::size_t(body.island) >= m_accountOf.size() ||
        AccountOf(body) == -1)
    {
        return;
    }
    const b2Vec2 a = body.gravityScale * m_gravity + body.invMass * body.force;
    const b2Vec2 path(float32(body.pose.x - before.end.x), float32(body.pose.y - before.end.y));
    const b2Vec2 v = body.linearVelocity;
    const float32 w = body.angularVelocity;
    Charge(body, body.mass * (0.5f * b2Dot(v - before.v, v + before.v) - b2Dot(a, path)) +
                     body.inertia * (0.5f * (w - before.w) * (w + before.w)));
}

void EnergyGuard::ChargeImpacts()
{
    for (const Spring& spring : m_springs)
    {
        BodyData& b = Data(*spring.joint->GetBodyB());
        BodyData& body = b.IsDynamic() ? b : Data(*spring.joint->GetBodyA());
        const SpringState end = SpringOf(*spring.joint, nullptr);
        body.energyDebt +=
            float32(StoredBetween(spring.before, end) - StoredBetween(spring.before, spring.after));
    }
    m_springs.clear(); // a joint may be destroyed before the next step
}

} // namespace box2d
