// SPDX-License-Identifier: MIT
//
// The cost of a box in a query is proportional to its perimeter (the surface area heuristic of
// Goldsmith and Salmon 1987, in two dimensions). Insertion and rotation therefore keep the sum of
// perimeters small (Catto, "Dynamic Bounding Volume Hierarchies", GDC 2019; rotations by Kensler,
// 2008). A large box among small ones may unbalance the tree. Height has priority over perimeter
// only beyond BalanceLimit.
#include <Box2D/Collision/b2DynamicTree.h>

#include <bit>
#include <cstring>

namespace
{
constexpr int32 kFirstCapacity = 16;
constexpr int32 kFreeHeight = -1;

float32 HalfPerimeter(const b2AABB& box)
{
    return (box.upperBound.x - box.lowerBound.x) + (box.upperBound.y - box.lowerBound.y);
}

b2AABB Union(const b2AABB& a, const b2AABB& b)
{
    b2AABB box;
    box.Combine(a, b);
    return box;
}

bool IsSame(const b2AABB& a, const b2AABB& b)
{
    return a.lowerBound == b.lowerBound && a.upperBound == b.upperBound;
}

b2AABB Fatten(const b2AABB& aabb)
{
    constexpr b2Vec2 margin(b2_aabbExtension, b2_aabbExtension);
    b2AABB fat;
    fat.lowerBound = aabb.lowerBound - margin;
    fat.upperBound = aabb.upperBound + margin;
    return fat;
}
} // namespace

b2DynamicTree::~b2DynamicTree()
{
    if (m_nodes != nullptr)
    {
        b2Free(m_nodes);
    }
}

int32 b2DynamicTree::AllocateNode()
{
    if (m_freeList == b2_nullNode)
    {
        const int32 capacity = m_nodeCapacity > 0 ? 2 * m_nodeCapacity : kFirstCapacity;
        Node* nodes = static_cast<Node*>(b2Alloc(capacity * static_cast<int32>(sizeof(Node))));
        if (m_nodes != nullptr)
        {
            std::memcpy(static_cast<void*>(nodes), m_nodes,
                        static_cast<std::size_t>(m_nodeCapacity) * sizeof(Node));
            b2Free(m_nodes);
        }
        m_nodes = nodes;
        for (int32 i = capacity - 1; i >= m_nodeCapacity; --i)
        {
            m_nodes[i].height = kFreeHeight;
            m_nodes[i].parent = m_freeList;
            m_freeList = i;
        }
        m_nodeCapacity = capacity;
    }
    const int32 node = m_freeList;
    m_freeList = m_nodes[node].parent;
    m_nodes[node].parent = b2_nullNode;
    m_nodes[node].height = 0;
    ++m_nodeCount;
    return node;
}

void b2DynamicTree::FreeNode(int32 node)
{
    m_nodes[node].height = kFreeHeight;
    m_nodes[node].parent = m_freeList;
    m_freeList = node;
    --m_nodeCount;
}

int32 b2DynamicTree::AllocateLeaf(const b2AABB& aabb)
{
    B2_REQUIRE(aabb.IsValid(), "A proxy's box must be finite, its lower bound below the upper.");
    const int32 leaf = AllocateNode();
    m_nodes[leaf].aabb = aabb;
    ++m_proxyCount;
    InsertLeaf(leaf);
    return leaf;
}

int32 b2DynamicTree::CreateProxy(const b2AABB& aabb, void* userData)
{
    return CreateProxyExact(Fatten(aabb), userData);
}

int32 b2DynamicTree::CreateProxyExact(const b2AABB& fatAABB, void* userData)
{
    const int32 leaf = AllocateLeaf(fatAABB);
    m_nodes[leaf].link.userData = userData;
    return leaf;
}

int32 b2DynamicTree::CreateProxyExact(const b2AABB& fatAABB, int32 userIndex)
{
    const int32 leaf = AllocateLeaf(fatAABB);
    m_nodes[leaf].link.userIndex = userIndex;
    return leaf;
}

void b2DynamicTree::DestroyProxy(int32 proxyId)
{
    if (!B2_REQUIRE(IsProxy(proxyId), "b2DynamicTree::DestroyProxy: not a proxy."))
    {
        return;
    }
    RemoveLeaf(proxyId);
    FreeNode(proxyId);
    --m_proxyCount;
}

bool b2DynamicTree::MoveProxy(int32 proxyId, const b2AABB& aabb, const b2Vec2& displacement)
{
    if (GetFatAABB(proxyId).Contains(aabb))
    {
        return false;
    }
    b2AABB fat = Fatten(aabb);
    const b2Vec2 ahead = b2_aabbMultiplier * displacement;
    fat.lowerBound += b2Min(ahead, b2Vec2_zero);
    fat.upperBound += b2Max(ahead, b2Vec2_zero);
    SetProxyAABB(proxyId, fat);
    return true;
}

void b2DynamicTree::SetProxyAABB(int32 proxyId, const b2AABB& fatAABB)
{
    if (!B2_REQUIRE(IsProxy(proxyId), "b2DynamicTree::SetProxyAABB: not a proxy.") ||
        !B2_REQUIRE(fatAABB.IsValid(),
                    "A proxy's box must be finite, its lower bound below the upper."))
    {
        return;
    }
    RemoveLeaf(proxyId);
    m_nodes[proxyId].aabb = fatAABB;
    InsertLeaf(proxyId);
}

void b2DynamicTree::EnlargeProxy(int32 proxyId, const b2AABB& fatAABB)
{
    if (!B2_REQUIRE(IsProxy(proxyId) && fatAABB.Contains(m_nodes[proxyId].aabb),
                    "EnlargeProxy takes a proxy and a box that contains its present one."))
    {
        return;
    }
    m_nodes[proxyId].aabb = fatAABB;
    for (int32 i = m_nodes[proxyId].parent; i != b2_nullNode; i = m_nodes[i].parent)
    {
        if (m_nodes[i].aabb.Contains(fatAABB))
        {
            return;
        }
        m_nodes[i].aabb.Combine(fatAABB);
    }
}

// Descends to the sibling with the smallest added perimeter. At each node there are two choices.
// The node becomes the sibling, at the cost of the perimeter of both. Or the search continues in a
// child, at the cost of its growth plus at least the leaf's own perimeter. The growth of the nodes
// above is common to all choices.
int32 b2DynamicTree::FindSibling(const b2AABB& aabb) const
{
    const float32 own = HalfPerimeter(aabb);
    int32 node = m_root;
    float32 alone = HalfPerimeter(m_nodes[node].aabb);
    float32 together = HalfPerimeter(Union(m_nodes[node].aabb, aabb));
    while (!m_nodes[node].IsLeaf())
    {
        const int32* children = m_nodes[node].link.child;
        const float32 growth = together - alone;
        float32 childAlone[2];
        float32 childTogether[2];
        float32 cost[2];
        for (int32 i = 0; i < 2; ++i)
        {
            const Node& child = m_nodes[children[i]];
            childAlone[i] = HalfPerimeter(child.aabb);
            childTogether[i] = HalfPerimeter(Union(child.aabb, aabb));
            cost[i] = growth +
                      (child.IsLeaf() ? childTogether[i] : childTogether[i] - childAlone[i] + own);
        }
        // Of equal children take the lower one, so that many equal boxes do not form a list.
        const bool isEqual = cost[0] == cost[1];
        const bool isSecond =
            isEqual ? m_nodes[children[1]].height < m_nodes[children[0]].height : cost[1] < cost[0];
        const int32 chosen = isSecond ? 1 : 0;
        if (together < cost[chosen])
        {
            break;
        }
        node = children[chosen];
        alone = childAlone[chosen];
        together = childTogether[chosen];
    }
    return node;
}

void b2DynamicTree::InsertLeaf(int32 leaf)
{
    if (m_root == b2_nullNode)
    {
        m_root = leaf;
        m_nodes[leaf].parent = b2_nullNode;
        return;
    }
    const int32 sibling = FindSibling(m_nodes[leaf].aabb);
    const int32 oldParent = m_nodes[sibling].parent;
    const int32 newParent = AllocateNode();
    m_nodes[newParent].parent = oldParent;
    m_nodes[newParent].link.child[0] = sibling;
    m_nodes[newParent].link.child[1] = leaf;
    ReplaceChild(oldParent, sibling, newParent);
    m_nodes[sibling].parent = newParent;
    m_nodes[leaf].parent = newParent;
    Refit(newParent);
    Rotate(newParent);
    RepairFrom(oldParent);
}

void b2DynamicTree::RemoveLeaf(int32 leaf)
{
    const int32 parent = m_nodes[leaf].parent;
    if (parent == b2_nullNode)
    {
        m_root = b2_nullNode;
        return;
    }
    const int32* child = m_nodes[parent].link.child;
    const int32 sibling = child[child[0] == leaf ? 1 : 0];
    const int32 grandparent = m_nodes[parent].parent;
    ReplaceChild(grandparent, parent, sibling);
    m_nodes[sibling].parent = grandparent;
    FreeNode(parent);
    RepairFrom(grandparent);
}

void b2DynamicTree::ReplaceChild(int32 parent, int32 oldChild, int32 newChild)
{
    if (parent == b2_nullNode)
    {
        m_root = newChild;
        return;
    }
    int32* child = m_nodes[parent].link.child;
    child[child[0] == oldChild ? 0 : 1] = newChild;
}

void b2DynamicTree::Refit(int32 node)
{
    const Node& a = m_nodes[m_nodes[node].link.child[0]];
    const Node& b = m_nodes[m_nodes[node].link.child[1]];
    m_nodes[node].aabb = Union(a.aabb, b.aabb);
    m_nodes[node].height = 1 + b2Max(a.height, b.height);
}

// Updates boxes and heights from the node upwards, until no ancestor changes.
void b2DynamicTree::RepairFrom(int32 node)
{
    while (node != b2_nullNode)
    {
        const b2AABB box = m_nodes[node].aabb;
        const int32 height = m_nodes[node].height;
        Refit(node);
        Rotate(node);
        if (m_nodes[node].height == height && IsSame(m_nodes[node].aabb, box))
        {
            return;
        }
        node = m_nodes[node].parent;
    }
}

// Returns the maximum height difference of siblings: that of a perfect tree beside a single large
// box, which is best left at the top. For any order of insertion it limits the height to a few
// times the logarithm of the number of proxies. In an AVL tree the limit is 1.
int32 b2DynamicTree::BalanceLimit() const
{
    return std::bit_width(static_cast<uint32>(m_proxyCount));
}

// Exchanges a child with a child of its sibling. The node keeps its box; a good exchange reduces
// the sibling's box. An unbalanced node must become lower even if the perimeter grows.
void b2DynamicTree::Rotate(int32 node)
{
    const int32 limit = BalanceLimit();
    const int32* children = m_nodes[node].link.child;
    const bool mustSink = b2Abs(m_nodes[children[0]].height - m_nodes[children[1]].height) > limit;
    int32 bestHeight = m_nodes[node].height;
    float32 bestChange = 0.0f;
    int32 bestSide = -1;
    int32 bestNephewSide = -1;
    for (int32 side = 0; side < 2; ++side)
    {
        const Node& child = m_nodes[children[side]];
        const Node& sibling = m_nodes[children[1 - side]];
        const float32 before = HalfPerimeter(sibling.aabb);
        for (int32 nephewSide = 0; nephewSide < 2 && !sibling.IsLeaf(); ++nephewSide)
        {
            const Node& staying = m_nodes[sibling.link.child[1 - nephewSide]];
            const float32 change = HalfPerimeter(Union(child.aabb, staying.aabb)) - before;
            if (!mustSink && !(change < bestChange))
            {
                continue; // the usual case
            }
            const Node& nephew = m_nodes[sibling.link.child[nephewSide]];
            const int32 siblingHeight = 1 + b2Max(child.height, staying.height);
            const int32 height = 1 + b2Max(nephew.height, siblingHeight);
            const bool isBalanced = b2Abs(child.height - staying.height) <= limit &&
                                    b2Abs(nephew.height - siblingHeight) <= limit;
            const bool isLower = height < bestHeight ||
                                 (bestSide >= 0 && height == bestHeight && change < bestChange);
            if (mustSink ? isLower : isBalanced && height <= m_nodes[node].height)
            {
                bestHeight = height;
                bestChange = change;
                bestSide = side;
                bestNephewSide = nephewSide;
            }
        }
    }
    if (bestSide >= 0)
    {
        SwapWithNephew(node, bestSide, bestNephewSide);
    }
}

void b2DynamicTree::SwapWithNephew(int32 node, int32 side, int32 nephewSide)
{
    const int32 child = m_nodes[node].link.child[side];
    const int32 sibling = m_nodes[node].link.child[1 - side];
    const int32 nephew = m_nodes[sibling].link.child[nephewSide];
    m_nodes[node].link.child[side] = nephew;
    m_nodes[nephew].parent = node;
    m_nodes[sibling].link.child[nephewSide] = child;
    m_nodes[child].parent = sibling;
    Refit(sibling);
    m_nodes[node].height = 1 + b2Max(m_nodes[nephew].height, m_nodes[sibling].height);
}

int32 b2DynamicTree::GetHeight() const
{
    return m_root == b2_nullNode ? 0 : m_nodes[m_root].height;
}

int32 b2DynamicTree::GetMaxBalance() const
{
    int32 maximum = 0;
    for (int32 i = 0; i < m_nodeCapacity; ++i)
    {
        if (m_nodes[i].height > 0)
        {
            const int32* child = m_nodes[i].link.child;
            maximum = b2Max(maximum, b2Abs(m_nodes[child[0]].height - m_nodes[child[1]].height));
        }
    }
    return maximum;
}

float32 b2DynamicTree::GetAreaRatio() const
{
    if (m_root == b2_nullNode)
    {
        return 0.0f;
    }
    double sum = 0.0;
    for (int32 i = 0; i < m_nodeCapacity; ++i)
    {
        sum += m_nodes[i].height >= 0 ? HalfPerimeter(m_nodes[i].aabb) : 0.0f;
    }
    const double root = HalfPerimeter(m_nodes[m_root].aabb);
    return root > 0.0 ? static_cast<float32>(sum / root) : 1.0f;
}

void b2DynamicTree::ShiftOrigin(const b2Vec2& newOrigin)
{
    for (int32 i = 0; i < m_nodeCapacity; ++i)
    {
        if (m_nodes[i].height >= 0)
        {
            m_nodes[i].aabb.lowerBound -= newOrigin;
            m_nodes[i].aabb.upperBound -= newOrigin;
        }
    }
}

void b2DynamicTree::Validate() const
{
    const char* why = WhyInvalid();
    B2_REQUIRE(why == nullptr, why);
}

const char* b2DynamicTree::WhyInvalid() const
{
    int32 proxies = 0;
    if (m_root != b2_nullNode)
    {
        if (const char* why = WhyInvalid(m_root, b2_nullNode, &proxies))
        {
            return why;
        }
    }
    if (proxies != m_proxyCount)
    {
        return "The tree does not reach all of its proxies.";
    }
    int32 freeNodes = 0;
    for (int32 i = m_freeList; i != b2_nullNode; i = m_nodes[i].parent)
    {
        ++freeNodes;
    }
    const int32 expected = m_proxyCount > 0 ? 2 * m_proxyCount - 1 : 0;
    return m_nodeCount != expected || m_nodeCount + freeNodes != m_nodeCapacity
               ? "The tree has lost or leaked a node."
               : nullptr;
}

const char* b2DynamicTree::WhyInvalid(int32 node, int32 parent, int32* proxies) const
{
    const Node& n = m_nodes[node];
    if (n.parent != parent)
    {
        return "A node of the tree does not know its parent.";
    }
    if (n.IsLeaf())
    {
        ++*proxies;
        return nullptr;
    }
    const Node& a = m_nodes[n.link.child[0]];
    const Node& b = m_nodes[n.link.child[1]];
    if (n.height != 1 + b2Max(a.height, b.height))
    {
        return "A node of the tree has the wrong height.";
    }
    if (!n.aabb.Contains(a.aabb) || !n.aabb.Contains(b.aabb))
    {
        return "A node of the tree does not contain its children.";
    }
    const char* why = WhyInvalid(n.link.child[0], node, proxies);
    return why != nullptr ? why : WhyInvalid(n.link.child[1], node, proxies);
}
