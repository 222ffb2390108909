// SPDX-License-Identifier: MIT
#include "JointSchedule.h"

#include "../State/Access.h"
#include "../State/ConstraintGraph.h"

#include "../../Common/Prefetch.h"
#include "../../Common/ThreadPool.h"
#include "JointKinds.h"

#include <Box2D/Dynamics/Joints/b2RevoluteJoint.h>
#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>
#include <atomic>

namespace box2d
{

namespace
{

/// Fewer joints of a type are solved one by one. It affects the time only. A step with blocks takes
/// 1.21, 0.99, 0.90 and 0.84 of the instructions for 1, 2, 3 and 4 hinges (one step), and the same
/// time for 3. With welds it takes 1.15, 0.86 and 0.74 of the instructions for 1, 2 and 3.
constexpr std::ptrdiff_t kMinLanes = 3;
/// Blocks per part of a parallel loop, the same as StepSolver's. It affects the time only.
constexpr int32 kBlockGrain = 8;
/// Maximum number of blocks of a run: their numbers stay in the first cache from one kernel to the
/// next.
constexpr std::ptrdiff_t kRunLength = 8;

/// The two or four bodies that a joint moves; some may be equal.
struct JointBodies
{
    explicit JointBodies(b2Joint& joint)
    {
        ForParts(joint, [this](b2Joint& part) { Add(part); });
    }
    b2Body** begin() { return bodies; }
    b2Body** end() { return bodies + count; }

private:
    void Add(b2Joint& joint)
    {
        for (b2Body* body : {joint.GetBodyA(), joint.GetBodyB()})
        {
            if (Data(*body).IsDynamic()) // a body that does not move can be shared
            {
                bodies[count++] = body;
            }
        }
    }

    b2Body* bodies[4];
    int32 count = 0;
};

} // namespace

void JointSchedule::Update(const ConstraintGraph& graph)
{
    if (m_version != graph.JointVersion())
    {
        m_version = graph.JointVersion();
        Build(graph.Joints());
    }
}

void JointSchedule::Update(const Array<b2Joint*>& joints, int32 version)
{
    // A new joint may have the address of a destroyed one.
    if (m_version != version || m_joints != joints)
    {
        m_version = version;
        m_joints = joints;
        Build(joints);
    }
}

Array<Array<b2Joint*>> JointSchedule::Levels() const
{
    Array<Array<b2Joint*>> levels;
    for (std::size_t i = 0; i + 1 < m_levels.size(); ++i)
    {
        Array<b2Joint*>& joints = levels.emplace_back();
        for (int32 k = m_levels[i]; k < m_levels[i + 1]; ++k)
        {
            const JointBlock& block = m_blocks[std::size_t(k)];
            joints.insert(joints.end(), block.joint, block.joint + block.count);
        }
    }
    return levels;
}

void JointSchedule::Build(const Array<b2Joint*>& joints)
{
    for (b2Joint* joint : joints)
    {
        for (b2Body* body : JointBodies(*joint))
        {
            Data(*body).jointLevel = 0; // the first free level
        }
    }
    m_levelOf.clear();
    m_counts.clear();
    for (b2Joint* joint : joints)
    {
        int32 level = 0;
        JointBodies bodies(*joint);
        for (b2Body* body : bodies)
        {
            level = b2Max(level, Data(*body).jointLevel);
        }
        for (b2Body* body : bodies)
        {
            Data(*body).jointLevel = level + 1;
        }
        m_levelOf.push_back(level);
        m_counts.resize(b2Max(m_counts.size(), std::size_t(level) + 1));
        ++m_counts[std::size_t(level)];
    }
    SortInto(joints);
}

/// Sorts by level, then by creation order (counting sort).
void JointSchedule::SortInto(const Array<b2Joint*>& joints)
{
    m_blocks.clear();
    m_numbers.clear();
    m_impulseCount = 0;
    m_levels.clear();
    m_ends.clear();
    int32 end = 0;
    for (const int32 count : m_counts)
    {
        m_ends.push_back(end);
        end += count;
    }
    m_sorted.resize(joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i)
    {
        m_sorted[std::size_t(m_ends[std::size_t(m_levelOf[i])]++)] = joints[i];
    }
    int32 begin = 0;
    for (const int32 count : m_counts)
    {
        AddLevel(m_sorted.data() + begin, m_sorted.data() + begin + count);
        begin += count;
    }
    if (!m_levels.empty())
    {
        m_levels.push_back(int32(m_blocks.size()));
    }
}

void JointSchedule::AddLevel(b2Joint* const* begin, b2Joint* const* end)
{
    m_levels.push_back(int32(m_blocks.size()));
    int32 last = e_unknownJoint;
    for (b2Joint* const* joint = begin; joint != end; ++joint)
    {
        last = b2Max(last, int32((*joint)->GetType()));
    }
    for (int32 type = e_unknownJoint + 1; type <= last; ++type)
    {
        AddKind(b2JointType(type), begin, end);
    }
}

void JointSchedule::AddKind(b2JointType type, b2Joint* const* begin, b2Joint* const* end)
{
    const auto isOfKind = [type](const b2Joint* joint) { return joint->GetType() == type; };
    const bool wide = std::count_if(begin, end, isOfKind) >= kMinLanes;
    JointBlock* block = nullptr;
    for (b2Joint* const* joint = begin; joint != end; ++joint)
    {
        if (!isOfKind(*joint))
        {
            continue;
        }
        if (block == nullptr || block->count == block->width)
        {
            block = &m_blocks.emplace_back();
            block->type = type;
            block->width = wide ? kJointLanes : 1;
            block->numbers = m_numbers.size();
            block->sums = m_impulseCount;
            const JointKernels& kernels = KernelsOf(*block);
            m_numbers.resize(m_numbers.size() + std::size_t(kernels.numberCount * block->width));
            m_impulseCount += std::size_t(kernels.impulseCount * block->width);
        }
        block->joint[block->count++] = *joint;
    }
}

template <class Function>
void JointSchedule::ForBlocks(int32 begin, int32 end, ThreadPool* threads, Function&& some)
{
    ParallelFor(threads, end - begin, kBlockGrain, [&](int32 first, int32 last) {
        some(m_blocks.data() + begin + first, m_blocks.data() + begin + last);
    });
}

/// Calls `one` with runs, in order; on several threads, the runs of a level concurrently.
template <class Function>
void JointSchedule::ForRuns(float32* numbers, ThreadPool* threads, Function&& one)
{
    const auto forRuns = [&](const JointBlock* begin, const JointBlock* end) {
        while (begin != end)
        {
            const JointBlock* last = begin + 1;
            while (last != end && last->kernels == begin->kernels && last - begin < kRunLength)
            {
                ++last;
            }
            one(*begin->kernels, JointRun{begin, last, numbers});
            begin = last;
        }
    };
    if (threads == nullptr)
    {
        forRuns(m_blocks.data(), m_blocks.data() + m_blocks.size());
        return;
    }
    for (std::size_t i = 0; i + 1 < m_levels.size(); ++i)
    {
        ForBlocks(m_levels[i], m_levels[i + 1], threads, forRuns);
    }
}

namespace
{

/// Writes the bodies of a pair into a lane; their masses are its first numbers.
void FillPair(const b2Body& bodyA, const b2Body& bodyB, int lane, int32* a, int32* b, uint8& movesA,
              uint8& movesB, float32 (&masses)[4])
{
    const BodyData& dataA = Data(bodyA);
    const BodyData& dataB = Data(bodyB);
    a[lane] = dataA.SolverIndex();
    b[lane] = dataB.SolverIndex();
    masses[0] = dataA.SolverInvMass();
    masses[1] = dataA.SolverInvInertia();
    masses[2] = dataB.SolverInvMass();
    masses[3] = dataB.SolverInvInertia();
    movesA = uint8(movesA | int(Moves(masses[0], masses[1])) << lane);
    movesB = uint8(movesB | int(Moves(masses[2], masses[3])) << lane);
}

/// Prefetches the joints of a block.
void ReadAhead(const JointBlock& block)
{
    constexpr std::size_t line = 64; // of the cache of x86 and most ARM processors [bytes]
    for (int lane = 0; lane < block.count; ++lane)
    {
        const auto* joint = reinterpret_cast<const char*>(block.joint[lane]);
        for (std::size_t i = 0; i < sizeof(b2RevoluteJoint); i += line) // others are as large
        {
            Prefetch(joint + i);
        }
    }
}

/// Prefetches the bodies of its joints.
void ReadBodiesAhead(const JointBlock& block)
{
    for (int lane = 0; lane < block.count; ++lane)
    {
        Prefetch(&Data(*block.joint[lane]->GetBodyA()));
        Prefetch(&Data(*block.joint[lane]->GetBodyB()));
    }
}

} // namespace

void JointSchedule::Fill(JointBlock& block, const SolverContext& context)
{
    block.kernels = &KernelsOf(block);
    block.features = block.movesA = block.movesB = block.movesC = block.movesD = 0;
    for (int lane = 0; lane < block.count; ++lane)
    {
        b2Joint* joint = block.joint[lane];
        b2Joint* first = joint;
        float32 masses[4];
        if (block.type == e_gearJoint)
        {
            auto* gear = static_cast<b2GearJoint*>(joint);
            first = gear->GetJoint1();
            b2Joint* second = gear->GetJoint2();
            FillPair(*second->GetBodyA(), *second->GetBodyB(), lane, block.bodyC, block.bodyD,
                     block.movesC, block.movesD, masses);
        }
        FillPair(*first->GetBodyA(), *first->GetBodyB(), lane, block.bodyA, block.bodyB,
                 block.movesA, block.movesB, masses);
        JointLane out = {NumbersOf(block) + lane, block.width};
        out.Write(masses);
        out.first += std::size(masses) * std::size_t(block.width);
        JointAccess::FillLane(*joint, context, out);
        block.features = uint8(block.features | out.features);
    }
}

void JointSchedule::Fill(const SolverContext& context, ThreadPool* threads)
{
    ForBlocks(0, int32(m_blocks.size()), threads, [&](JointBlock* begin, JointBlock* end) {
        for (JointBlock* block = begin; block != end; ++block)
        {
            if (end - block > 2)
            {
                ReadAhead(block[2]);
                ReadBodiesAhead(block[1]);
            }
            Fill(*block, context);
        }
    });
}

void JointSchedule::Prepare(const SolverContext& context, ThreadPool* threads)
{
    float32* bodies = reinterpret_cast<float32*>(context.bodies);
    Fill(context, threads);
    ForRuns(m_numbers.data(), threads, [&](const JointKernels& kernels, const JointRun& run) {
        kernels.warmStart(run, bodies);
    });
}

void JointSchedule::SolveVelocities(const SolverContext& context, ThreadPool* threads)
{
    float32* bodies = reinterpret_cast<float32*>(context.bodies);
    ForRuns(m_numbers.data(), threads, [&](const JointKernels& kernels, const JointRun& run) {
        kernels.solveVelocities(run, bodies);
    });
}

void JointSchedule::StoreImpulses(ThreadPool* threads)
{
    ForBlocks(0, int32(m_blocks.size()), threads, [&](JointBlock* begin, JointBlock* end) {
        for (const JointBlock* block = begin; block != end; ++block)
        {
            if (end - block > 1)
            {
                ReadAhead(block[1]);
            }
            Keep(*block);
        }
    });
}

/// Stores the impulses of a block in its joints.
void JointSchedule::Keep(const JointBlock& block)
{
    float32* own = NumbersOf(block) + kMassNumbers * block.width;
    for (int lane = 0; lane < block.count; ++lane)
    {
        JointAccess::KeepImpulses(*block.joint[lane], {own + lane, block.width});
    }
}

bool JointSchedule::SolvePositions(const SolverContext& context, ThreadPool* threads)
{
    return SolvePositions(m_numbers.data(), context, threads);
}

bool JointSchedule::SolvePositions(float32* numbers, const SolverContext& context,
                                   ThreadPool* threads)
{
    float32* bodies = reinterpret_cast<float32*>(context.bodies);
    std::atomic<bool> joined = true;
    ForRuns(numbers, threads, [&](const JointKernels& kernels, const JointRun& run) {
        if (!kernels.solvePositions(run, bodies) && joined.load(std::memory_order_relaxed))
        {
            joined.store(false, std::memory_order_relaxed);
        }
    });
    return joined;
}

void JointSchedule::Begin(const SolverContext& context, ThreadPool* threads)
{
    Fill(context, threads);
    m_atStart = m_numbers;
    m_sums.assign(m_impulseCount, 0.0f);
    m_kicked = false;
}

/// Calls the function with each impulse of a block and its sum.
template <class Function>
void JointSchedule::ForImpulses(const JointBlock& block, Function&& function)
{
    float32* impulses = NumbersOf(block) + kMassNumbers * block.width;
    float32* sums = m_sums.data() + block.sums;
    const int32 count = block.kernels->impulseCount * block.width;
    for (int32 i = 0; i < count; ++i)
    {
        function(impulses[i], sums[i]);
    }
}

/// Adds the impulses of the last kick to the sums, and scales them.
void JointSchedule::PassOn(const JointBlock& block, float32 share)
{
    ForImpulses(block, [share, kicked = m_kicked](float32& impulse, float32& sum) {
        sum += kicked ? impulse : 0.0f;
        impulse *= share;
    });
}

void JointSchedule::Kick(const SolverContext& context, float32 share, ThreadPool* threads)
{
    float32* bodies = reinterpret_cast<float32*>(context.bodies);
    const box2d::Kick kick = {context.timeStep * context.inverseStep, context.inverseStep};
    SolverContext scaled = context; // impulses are scaled already
    scaled.stepRatio = 1.0f;
    scaled.warmStarting = true;
    ForBlocks(0, int32(m_blocks.size()), threads, [&](JointBlock* begin, JointBlock* end) {
        std::for_each(begin, end, [&](JointBlock& block) {
            if (block.kernels->turn == nullptr)
            {
                PassOn(block, share);
                Keep(block);
                Fill(block, scaled);
            }
        });
    });
    ForRuns(m_numbers.data(), threads, [&](const JointKernels& kernels, const JointRun& run) {
        if (kernels.turn != nullptr)
        {
            std::for_each(run.first, run.last,
                          [&](const JointBlock& block) { PassOn(block, share); });
            kernels.turn(run, JointRun{run.first, run.last, m_atStart.data()}, bodies, kick);
        }
        kernels.warmStart(run, bodies);
    });
    m_kicked = true;
}

bool JointSchedule::SolvePositionsInStep(const SolverContext& context, ThreadPool* threads)
{
    return SolvePositions(m_atStart.data(), context, threads);
}

void JointSchedule::End(ThreadPool* threads)
{
    for (const JointBlock& block : m_blocks)
    {
        ForImpulses(block, [](float32& impulse, float32 sum) { impulse = sum + impulse; });
    }
    StoreImpulses(threads);
}

} // namespace box2d
