// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

class b2Body;

/// Dynamic bodies that are connected through touching contacts and joints, and so fall asleep and
/// wake together. Islands persist from step to step. A new link merges two of them at once. A
/// removed link is only counted. The island is split when one of its bodies is ready to sleep.
/// Static and kinematic bodies belong to no island.
namespace box2d
{

struct SnapshotAccess;

class Islands
{
public:
    struct Island
    {
        b2Body* first = nullptr; // nullptr: free
        b2Body* last = nullptr;
        int32 count = 0;
        int32 lostLinks = 0;         // since the last split
        float32 minSleepTime = 0.0f; // minimum over its bodies in the current step
        float32 maxSleepTime = 0.0f;
        bool seen = false; // a body of it was reported in the current step
    };

    void Add(b2Body& body);    // one that is in none, as a separate island
    void Remove(b2Body& body); // counts as lost links of the rest
    void Link(b2Body& a, b2Body& b);
    void Unlink(b2Body& a, b2Body& b);

    /// Call once per awake body and step.
    void ReportSleepTime(const BodyData& body);
    /// Ends the reports of the step and returns the connected islands that have been slow for
    /// `timeToSleep`. The order depends only on the sequence of calls. Valid until the next call.
    const Array<int32>& FindSleepy(float32 timeToSleep);

    /// Changes when a body comes into another island.
    std::uint32_t Version() const { return m_version; }
    int32 Size() const { return int32(m_islands.size()); } ///< upper bound of island numbers
    const Island& At(int32 island) const { return m_islands[std::size_t(island)]; }

private:
    friend struct SnapshotAccess;
    int32 Create();
    void Append(int32 island, b2Body& body);
    void Split(int32 island, float32 timeToSleep);
    void Gather(b2Body& seed, int32 island);

    Array<Island> m_islands;
    Array<int32> m_free;
    Array<int32> m_seen;
    Array<int32> m_sleepy;
    Array<b2Body*> m_members; // scratch of Split
    Array<b2Body*> m_stack;   // scratch of Gather
    std::uint32_t m_version = 0;
};

} // namespace box2d
