// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

class b2Contact;
class b2Joint;

/// The awake constraints, coloured so that no two of one colour share a body that can move.
/// Constraints of a colour can be solved in any order, side by side, with the same result. Colours
/// are given greedily when a constraint becomes active and kept while it lasts (graph colouring for
/// parallel solvers: Fratarcangeli and Pellacini, "Scalable Partitioning for Parallel Position
/// Based Dynamics", 2015).
namespace box2d
{

class ConstraintGraph
{
public:
    /// What does not fit into a colour is solved one by one, before the others.
    static constexpr int32 kOverflow = 24;
    static constexpr int32 kColorCount = kOverflow + 1;

    struct Color
    {
        Array<b2Contact*> contacts;
        Array<b2Joint*> joints;
    };

    void Add(b2Contact& contact);
    void Remove(b2Contact& contact);
    void Add(b2Joint& joint);
    void Remove(b2Joint& joint);

    const Color& At(int32 color) const { return m_colors[color]; }

private:
    static int32 Claim(BodyData& a, BodyData& b);
    static void Release(BodyData& a, BodyData& b, int32 color);

    Color m_colors[kColorCount];
};

} // namespace box2d
