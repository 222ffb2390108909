// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/Internal/BodyData.h>
#include <Box2D/Dynamics/Internal/ContactData.h>

#include <atomic>

class b2Contact;
class b2Joint;

/// The awake constraints, coloured so that no two of one colour share a moving body. Constraints of
/// a colour can be solved in any order or in parallel, with the same result. Colours are assigned
/// greedily when a constraint becomes active and kept while it lasts (graph colouring for parallel
/// solvers: Fratarcangeli and Pellacini, "Scalable Partitioning for Parallel Position Based
/// Dynamics", 2015).
namespace box2d
{

struct SnapshotAccess;

class ConstraintGraph
{
public:
    /// Constraints without a free colour are solved sequentially, before the others. At most
    /// 31 are possible, because a body's colours are the bits of an uint32. Six equal circles fit
    /// around another one, so only a body much larger than its neighbours has more than 24
    /// constraints.
    static constexpr int32 kOverflow = 24;
    static constexpr int32 kColorCount = kOverflow + 1;

    /// Contacts with bodies that are not dynamic take the highest free colour, others the lowest.
    /// From this one on, a colour therefore has few others. Half, so that both have as many.
    static constexpr int32 kFirstOfGround = kOverflow / 2;
    /// True if the colour is the second one, from the highest, of a body that has no colour below
    /// kFirstOfGround. Such a body usually touches two or more bodies that are not dynamic.
    static bool IsSecondOfGround(uint32 colorMask, int32 color)
    {
        const uint32 above = colorMask >> (color + 1);
        const uint32 below = colorMask & ((1u << kFirstOfGround) - 1u);
        return below == 0 && above != 0 && (above & (above - 1u)) == 0;
    }

    void Add(b2Contact& contact);
    void Remove(b2Contact& contact);
    void Add(b2Joint& joint);
    void Remove(b2Joint& joint);

    const Array<b2Contact*>& Contacts(int32 color) const { return m_contacts[color]; }
    /// Returns the colours that have contacts, one bit each.
    uint32 UsedColors() const { return m_usedColors; }

    /// The change of a colour since the last call of Settle.
    enum class Change : uint8
    {
        None,
        Forms,    ///< the form of a contact changed
        Contacts, ///< contacts were added or removed
    };
    Change ChangeOf(int32 color) const;
    void Settle(int32 color);
    /// Records that any contact may have changed its form.
    void NoteAllForms();
    /// Records that a contact has changed its form; thread-safe.
    void NoteForm(const ContactData& c)
    {
        if (c.color != -1 && c.Form() != c.solvedAs)
        {
            m_formsChanged[c.color].store(true, std::memory_order_relaxed);
        }
    }

    /// Joints are solved as if one by one, in the order of their creation. For a chain that is
    /// usually the order of its links, so an impulse runs the length of the chain in one iteration.
    /// With colours it would travel two links. Adding and removing may change the order until
    /// SortJoints.
    const Array<b2Joint*>& Joints() const { return m_joints; }
    void SortJoints();
    /// Changes with the list, and with the masses of jointed bodies.
    int32 JointVersion() const { return m_jointVersion; }
    void NoteMasses() { ++m_jointVersion; }

private:
    friend struct SnapshotAccess;
    static int32 Claim(BodyData& a, BodyData& b);
    static void Release(BodyData& a, BodyData& b, int32 color);

    Array<b2Contact*> m_contacts[kColorCount];
    uint32 m_usedColors = 0;
    bool m_contactsChanged[kColorCount] = {};
    std::atomic<bool> m_formsChanged[kColorCount] = {};
    Array<b2Joint*> m_joints;
    int32 m_jointVersion = 0;
    bool m_sorted = true;
};

} // namespace box2d
