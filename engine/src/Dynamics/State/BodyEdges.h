// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Internal/BodyData.h>

/// The lists of a body's contacts and joints, whose nodes (b2ContactEdge, b2JointEdge) are in
/// these.
namespace box2d
{

/// Puts a node in front of a list.
template <class Edge>
void PushEdge(Edge*& list, Edge& edge)
{
    edge.next = list;
    if (list)
    {
        list->prev = &edge;
    }
    list = &edge;
}

template <class Edge>
void RemoveEdge(Edge*& list, Edge& edge)
{
    (edge.prev ? edge.prev->next : list) = edge.next;
    if (edge.next)
    {
        edge.next->prev = edge.prev;
    }
}

} // namespace box2d
