// SPDX-License-Identifier: MIT
#include "EnergyGuard.h"

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

/// Of the scale. With less, truncation would slow down what keeps its energy in the long run; with
/// more a body could be seen to speed up by itself.
constexpr double kTolerance = 0.01;
/// The most credit, of the scale. A bridge of planks that boxes fall on gives back up to three
/// times what it moves with; with more, what has been braked for long could burst.
constexpr double kMostCredit = 3.0;
/// The largest debt that is kept, of the scale; what owes so much is bursting and pays at once.
/// With five times as much some random worlds win energy, with a tenth small debts stop what moves.
constexpr double kMaxDebt = 0.1;
/// How fast the scale decays [1/s], and debts with it.
constexpr double kFade = 0.1;
/// What corrections may put into springs although nothing moves [J/kg]: as much as makes 1 m/s.
/// Something at rest on springs that is pushed out of the ground needs a hundredth of it.
constexpr double kMostFromRest = 0.5;
/// The scale is at least that of a fall by so much [m]: joints are closed to within a slop, and
/// lifting something by that, a hundredth of this, is no gain.
constexpr float32 kLeastFall = b2_linearSlop / float32(kTolerance);
/// So that no sum can leave the range of numbers [J].
constexpr float32 kMostScale = 1e30f;

bool MovesByItself(const b2Body& body)
{
    return body.GetType() != b2_dynamicBody &&
           (body.GetLinearVelocity() != b2Vec2_zero || body.GetAngularVelocity() != 0.0f);
}

/// Whether it moves or has been moved, so that what is held by it or touches it is carried along.
bool Carries(const b2Body& body)
{
    return MovesByItself(body) || Data(body).world->IsRecent(Data(body).movedAt);
}

/// Whether something may give the body energy that no account knows of: what moves by itself, and
/// the hand of the program, which puts bodies elsewhere, shortens ropes and shifts limits. What it
/// gives as velocity, force, weight or mass, to springs and to motors, is in the account.
bool IsDriven(const b2Body& body)
{
    if (Carries(body))
    {
        return true;
    }
    for (const b2ContactEdge* edge = body.GetContactList(); edge; edge = edge->next)
    {
        const b2Contact& c = *edge->contact;
        if (c.IsTouching() &&
            (Carries(*edge->other) || c.GetTangentSpeed() != 0.0f || c.GetRestitution() > 1.0f))
        {
            return true;
        }
    }
    for (const b2JointEdge* edge = body.GetJointList(); edge; edge = edge->next)
    {
        if (Carries(*edge->other) ||
            Data(body).world->IsRecent(JointAccess::ChangedAt(*edge->joint)))
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

/// Kinetic, at the start of the step [J].
double EnergyAtStart(const b2Body& first)
{
    double sum = 0.0;
    for (const b2Body* body = &first; body; body = Data(*body).islandNext)
    {
        const BodyData& data = Data(*body);
        SolverBody start;
        start.v = data.linearVelocity;
        start.w = data.angularVelocity;
        sum += KineticEnergy(start, double(data.mass), double(data.inertia));
    }
    return sum;
}

/// The largest kinetic energy of late, when the present one counts.
float32 ScaleOf(float32 past, const BodyData& body, const SolverBody& s)
{
    const auto kinetic = float32(KineticEnergy(s, double(body.mass), double(body.inertia)));
    return kinetic > past ? b2Min(kinetic, kMostScale) : past;
}

/// What impacts have won. A body's credit, what joints took from it, does not pay for that: nothing
/// gives it back. A body that impacts hold back again and again, while a spring speeds it up, would
/// win without end.
void Charge(BodyData& body, float32 won)
{
    const bool counts = won > float32(kTolerance) * body.energyScale; // or it is truncation
    body.energyOwed = (counts ? b2Max(body.energyOwed, 0.0f) : body.energyOwed) + won;
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

void EnergyGuard::Begin(const World& world, const SolverMemory& solver, float32 timeStep)
{
    for (const Account& account : m_accounts)
    {
        m_accountOf[std::size_t(account.island)] = -1;
    }
    m_accounts.clear();
    m_springs.clear();
    m_motors.clear();
    FindRisks(world.graph);
    if (m_risky.empty() && m_sliding.empty())
    {
        return;
    }
    m_timeStep = timeStep;
    m_subSteps = world.subStepCount;
    m_gravity = world.gravity;
    m_leastFall = kLeastFall * m_gravity.Length();
    // Cleared above only where there was an account: most islands may be asleep.
    m_accountOf.resize(b2Max(m_accountOf.size(), std::size_t(world.islands.Size())), -1);
    for (const b2Joint* joint : m_risky)
    {
        Open(*joint);
    }
    for (const b2Joint* joint : m_sliding)
    {
        if (IsAtRisk(*joint))
        {
            Open(*joint);
        }
    }
    if (m_accounts.empty())
    {
        return;
    }
    for (b2Joint* joint : world.graph.Joints())
    {
        if (HasSpring(*joint) && AccountOf(*joint) != -1)
        {
            const SpringState state = SpringOf(*joint, nullptr);
            m_springs.push_back({joint, AccountOf(*joint), state, state});
        }
        if (HasMotor(*joint) && AccountOf(*joint) != -1)
        {
            m_motors.push_back({joint, AccountOf(*joint),
                                MostMotorWork(*joint, solver.bodies.data(), timeStep, m_subSteps)});
        }
    }
}

/// Anew when joints have come, gone or fallen asleep, or masses have changed.
void EnergyGuard::FindRisks(const ConstraintGraph& graph)
{
    if (m_version == graph.JointVersion())
    {
        return;
    }
    m_version = graph.JointVersion();
    m_risky.clear();
    m_sliding.clear();
    for (const b2Joint* joint : graph.Joints())
    {
        if (IsAtRisk(*joint))
        {
            m_risky.push_back(joint);
        }
        else if (HasChangingLevers(*joint))
        {
            m_sliding.push_back(joint);
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
    AddJoints(world, solver);
    for (Account& account : m_accounts)
    {
        if (account.owed > kTolerance * account.scale)
        {
            Collect(world, solver, account);
        }
    }
    ShareOut(world, solver);
}

/// What a body has won above the work of gravity and forces along its way, corrections of its pose
/// included [J]: where these lift something again and again that sinks, nothing is won.
double EnergyGuard::Won(const BodyData& body, const SolverBody& s) const
{
    const b2Vec2 a = body.gravityScale * m_gravity + body.invMass * body.force;
    const float32 alpha = body.invInertia * body.torque;
    const float32 push = b2Dot(a, s.d);
    const float32 twist = alpha * s.angle;
    // Differences first: they are small, and so is their rounding.
    const float32 linear = 0.5f * b2Dot(s.v - body.linearVelocity, s.v + body.linearVelocity);
    const float32 angular = 0.5f * (s.w - body.angularVelocity) * (s.w + body.angularVelocity);
    return double(body.mass) * double(linear - push) +
           double(body.inertia) * double(angular - twist);
}

float32 EnergyGuard::PastOf(const BodyData& body) const
{
    return b2Max(body.energyScale, m_leastFall * body.mass);
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
            double won = Won(data, s);
            if (won != won)
            {
                s = SolverBody(); // as it will be written back
                won = Won(data, s);
            }
            account.owed += double(data.energyOwed) + won;
            const float32 past = PastOf(data);
            account.past += double(past);
            account.scale += double(ScaleOf(past, data, s));
        }
    }
}

void EnergyGuard::AddJoints(const World& world, const SolverMemory& solver)
{
    for (Spring& spring : m_springs)
    {
        spring.after = SpringOf(*spring.joint, solver.bodies.data());
        m_accounts[std::size_t(spring.account)].owed += StoredBetween(spring.before, spring.after);
    }
    for (const Motor& motor : m_motors)
    {
        const double after =
            MostMotorWork(*motor.joint, solver.bodies.data(), m_timeStep, world.subStepCount);
        m_accounts[std::size_t(motor.account)].owed -= std::max(motor.work, after);
    }
}

/// Takes at once what was won in this step. Of the energy that the island had before, it takes the
/// share that the debt is of the largest one: a small debt slows the motion down over many steps,
/// it does not stop it.
void EnergyGuard::Collect(const World& world, SolverMemory& solver, Account& account)
{
    const b2Body& first = *world.islands.At(account.island).first;
    if (IsIslandDriven(first))
    {
        account.owed = 0.0;
        return;
    }
    const double free = kTolerance * account.past; // what it moves with now is not its own
    const IslandMotion found(first, solver.bodies.data());
    const double payable = free + found.Energy() + kMostFromRest * found.Mass();
    for (const float32 time : {m_timeStep, 0.0f}) // without corrections, then not at all
    {
        if (m_subSteps == 1 && account.owed > payable)
        {
            MoveAgain(first, solver, account, time);
        }
    }
    if (account.owed > free)
    {
        IslandMotion motion(first, solver.bodies.data());
        const double debt = account.owed - free;
        const double share = std::min(debt / (kMaxDebt * account.scale), 1.0);
        const double kept = (1.0 - share) * EnergyAtStart(first);
        const double lost = std::min(debt, std::max(motion.Energy() - kept, 0.0));
        motion.Lose(lost);
        account.owed -= lost;
        account.scale = account.past;
    }
}

/// When springs have been wound up: as far as velocities alone bring the island in that time [s].
/// Joints that corrections should have closed stay open. In no time at all where it is velocities
/// that wind springs up, for those velocities are then lost.
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
            SolverBody& s = solver.bodies[std::size_t(Data(*body).SolverIndex())];
            saved += Won(Data(*body), s);
            s.d = time * s.v;
            s.angle = time * s.w;
            s.q.Set(s.angle);
            saved -= Won(Data(*body), s);
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
    account.owed -= saved;
}

/// As shares of the scale. Debts fade with it. Credit does not: where joints have opened under
/// load, it is what closing them gives back, however late; only its largest value falls with the
/// scale.
void EnergyGuard::ShareOut(const World& world, const SolverMemory& solver)
{
    const auto fade = float32(1.0 / (1.0 + kFade * double(m_timeStep)));
    for (Account& account : m_accounts)
    {
        const double share = account.scale > 0.0 ? account.owed / account.scale : 0.0;
        account.owed = b2Clamp(share, -kMostCredit, kMaxDebt);
    }
    for (b2Body* body : world.awakeBodies)
    {
        BodyData& data = Data(*body);
        const int32 account = AccountOf(data);
        if (account != -1)
        {
            const SolverBody& s = solver.bodies[std::size_t(data.SolverIndex())];
            const float32 scale = ScaleOf(PastOf(data), data, s);
            const auto share = float32(m_accounts[std::size_t(account)].owed);
            data.energyScale = fade * scale;
            data.energyOwed = share * (share > 0.0f ? data.energyScale : scale);
        }
    }
}

void EnergyGuard::NoteImpact(BodyData& body, const Way& before) const
{
    // Islands may have merged since, but then both bodies of an impact are in the same.
    if (!body.IsDynamic() || body.island == -1 || std::size_t(body.island) >= m_accountOf.size() ||
        AccountOf(body) == -1)
    {
        return;
    }
    const b2Vec2 a = body.gravityScale * m_gravity + body.invMass * body.force;
    const b2Vec2 way(float32(body.pose.x - before.end.x), float32(body.pose.y - before.end.y));
    const b2Vec2 v = body.linearVelocity;
    const float32 w = body.angularVelocity;
    Charge(body, body.mass * (0.5f * b2Dot(v - before.v, v + before.v) - b2Dot(a, way)) +
                     body.inertia * (0.5f * (w - before.w) * (w + before.w)));
}

void EnergyGuard::ChargeImpacts()
{
    for (const Spring& spring : m_springs)
    {
        BodyData& b = Data(*spring.joint->GetBodyB());
        BodyData& body = b.IsDynamic() ? b : Data(*spring.joint->GetBodyA());
        const SpringState end = SpringOf(*spring.joint, nullptr);
        body.energyOwed +=
            float32(StoredBetween(spring.before, end) - StoredBetween(spring.before, spring.after));
    }
    m_springs.clear(); // a joint may be gone before the next step begins
}

} // namespace box2d
