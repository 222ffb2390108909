// SPDX-License-Identifier: MIT
#include "JointSchedule.h"

#include "Access.h"
#include "ConstraintGraph.h"

#include "../Common/ThreadPool.h"

#include <Box2D/Dynamics/Joints/b2GearJoint.h>
#include <Box2D/Dynamics/Joints/b2RevoluteJoint.h>
#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>
#include <atomic>

namespace box2d
{

namespace
{

/// Fewer hinges than this are solved one by one: a block costs as much as that.
constexpr int32 kLeastLanes = 3;
/// Blocks that one thread takes at a time.
constexpr int32 kBlockGrain = 8;

/// The bodies that a joint moves, two or four; some may be the same.
struct JointBodies
{
    explicit JointBodies(b2Joint& joint)
    {
        if (joint.GetType() == e_gearJoint)
        {
            auto& gear = static_cast<b2GearJoint&>(joint);
            for (b2Joint* part : {gear.GetJoint1(), gear.GetJoint2()})
            {
                Add(*part);
            }
        }
        else
        {
            Add(joint);
        }
    }
    b2Body** begin() { return bodies; }
    b2Body** end() { return bodies + count; }

private:
    void Add(b2Joint& joint)
    {
        for (b2Body* body : {joint.GetBodyA(), joint.GetBodyB()})
        {
            if (Data(*body).IsDynamic()) // whatever stays where it is can be shared
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

Array<Array<b2Joint*>> JointSchedule::Levels() const
{
    Array<Array<b2Joint*>> levels;
    for (std::size_t i = 0; i + 1 < m_levels.size(); ++i)
    {
        Array<b2Joint*>& joints = levels.emplace_back();
        for (int32 k = m_levels[i].firstBlock; k < m_levels[i + 1].firstBlock; ++k)
        {
            const HingeBlock& block = m_blocks[std::size_t(k)];
            joints.insert(joints.end(), block.joint, block.joint + block.count);
        }
        for (int32 k = m_levels[i].firstSingle; k < m_levels[i + 1].firstSingle; ++k)
        {
            joints.push_back(m_singles[std::size_t(k)]);
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
            Data(*body).jointLevel = 0; // the first that is free
        }
    }
    Array<int32> levels; // of each joint
    Array<int32> counts; // of each level
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
        levels.push_back(level);
        counts.resize(b2Max(counts.size(), std::size_t(level) + 1));
        ++counts[std::size_t(level)];
    }
    SortInto(joints, levels, counts);
}

/// Level by level, in each in the order of creation (counting sort).
void JointSchedule::SortInto(const Array<b2Joint*>& joints, const Array<int32>& levels,
                             const Array<int32>& counts)
{
    m_blocks.clear();
    m_singles.clear();
    m_levels.clear();
    Array<int32> ends;
    int32 end = 0;
    for (const int32 count : counts)
    {
        ends.push_back(end);
        end += count;
    }
    Array<b2Joint*> sorted(joints.size());
    for (std::size_t i = 0; i < joints.size(); ++i)
    {
        sorted[std::size_t(ends[std::size_t(levels[i])]++)] = joints[i];
    }
    int32 begin = 0;
    for (const int32 count : counts)
    {
        AddLevel(sorted.data() + begin, sorted.data() + begin + count);
        begin += count;
    }
    if (!m_levels.empty())
    {
        m_levels.push_back({int32(m_blocks.size()), int32(m_singles.size())});
    }
}

void JointSchedule::AddLevel(b2Joint* const* begin, b2Joint* const* end)
{
    m_levels.push_back({int32(m_blocks.size()), int32(m_singles.size())});
    const auto isHinge = [](const b2Joint* joint) { return joint->GetType() == e_revoluteJoint; };
    const auto hinges = std::count_if(begin, end, isHinge);
    const bool wide = hinges >= kLeastLanes;
    HingeBlock* block = nullptr;
    for (b2Joint* const* joint = begin; joint != end; ++joint)
    {
        if (!wide || !isHinge(*joint))
        {
            m_singles.push_back(*joint);
            continue;
        }
        if (block == nullptr || block->count == kHingeLanes)
        {
            block = &m_blocks.emplace_back();
        }
        block->joint[block->count++] = static_cast<b2RevoluteJoint*>(*joint);
    }
}

template <class OneBlock, class OneJoint>
void JointSchedule::ForLevels(ThreadPool* threads, OneBlock&& oneBlock, OneJoint&& oneJoint)
{
    for (std::size_t i = 0; i + 1 < m_levels.size(); ++i)
    {
        const Level& level = m_levels[i];
        const Level& next = m_levels[i + 1];
        ParallelFor(threads, next.firstBlock - level.firstBlock, kBlockGrain,
                    [&](int32 begin, int32 end) {
                        for (int32 k = begin; k < end; ++k)
                        {
                            oneBlock(m_blocks[std::size_t(level.firstBlock + k)]);
                        }
                    });
        for (int32 k = level.firstSingle; k < next.firstSingle; ++k)
        {
            oneJoint(*m_singles[std::size_t(k)]);
        }
    }
}

void JointSchedule::Prepare(const SolverContext& context, ThreadPool* threads)
{
    ParallelFor(threads, int32(m_blocks.size()), kBlockGrain, [&](int32 begin, int32 end) {
        for (int32 i = begin; i < end; ++i)
        {
            PrepareHinges(m_blocks[std::size_t(i)], context);
        }
    });
    ForLevels(
        threads, [&](HingeBlock& block) { WarmStartHinges(block, context.bodies); },
        [&](b2Joint& joint) { JointAccess::Prepare(joint, context); });
}

void JointSchedule::SolveVelocities(const SolverContext& context, ThreadPool* threads)
{
    ForLevels(
        threads, [&](HingeBlock& block) { SolveHingeVelocities(block, context.bodies); },
        [&](b2Joint& joint) { JointAccess::SolveVelocity(joint, context); });
}

void JointSchedule::StoreImpulses(ThreadPool* threads)
{
    ParallelFor(threads, int32(m_blocks.size()), kBlockGrain, [&](int32 begin, int32 end) {
        for (int32 i = begin; i < end; ++i)
        {
            StoreHingeImpulses(m_blocks[std::size_t(i)]);
        }
    });
}

bool JointSchedule::SolvePositions(const SolverContext& context, ThreadPool* threads)
{
    std::atomic<bool> joined = true;
    ForLevels(
        threads,
        [&](HingeBlock& block) {
            if (!SolveHingePositions(block, context.bodies) &&
                joined.load(std::memory_order_relaxed))
            {
                joined.store(false, std::memory_order_relaxed);
            }
        },
        [&](b2Joint& joint) {
            if (!JointAccess::SolvePosition(joint, context))
            {
                joined.store(false, std::memory_order_relaxed);
            }
        });
    return joined;
}

} // namespace box2d
