// SPDX-License-Identifier: MIT
#include "Drawings.h"
#include "Setup.h"
#include "Sketch.h"

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

using namespace boxreel;

namespace figures
{
namespace
{

struct Leaf
{
    b2AABB box;
    int32 number;
};

/// A node of the hierarchy. b2DynamicTree does not show its own; this one is split by the rule of
/// b2DynamicTree::RebuildEvenly.
struct Node
{
    b2AABB box;
    std::string name;
    int height = 0; ///< 0: a leaf
    std::unique_ptr<Node> child[2];
    bool isTested = false;
    bool isMet = false; ///< by the ray
    b2Vec2 sign;        ///< where the diagram has it
};

struct Ray
{
    b2Vec2 from, to;

    bool Meets(const b2AABB& box) const
    {
        b2RayCastOutput hit;
        return box.RayCast(&hit, {from, to, 1.0f}); // it starts outside of all boxes
    }
};

std::unique_ptr<Node> Build(std::vector<Leaf> leaves)
{
    auto node = std::make_unique<Node>();
    node->box = leaves.front().box;
    if (leaves.size() == 1)
    {
        node->name = std::to_string(leaves.front().number);
        return node;
    }
    b2Vec2 lower = node->box.GetCenter();
    b2Vec2 upper = lower;
    for (const Leaf& leaf : leaves)
    {
        node->box.Combine(leaf.box);
        lower = b2Min(lower, leaf.box.GetCenter());
        upper = b2Max(upper, leaf.box.GetCenter());
    }
    const bool isWide = upper.x - lower.x >= upper.y - lower.y;
    std::ranges::sort(leaves, {}, [isWide](const Leaf& leaf) {
        const b2Vec2 center = leaf.box.GetCenter();
        return isWide ? center.x : center.y;
    });
    const auto middle = leaves.begin() + std::ptrdiff_t(leaves.size() / 2);
    node->child[0] = Build({leaves.begin(), middle});
    node->child[1] = Build({middle, leaves.end()});
    node->height = 1 + std::max(node->child[0]->height, node->child[1]->height);
    return node;
}

/// Marks what a cast looks at: below a box that the ray misses, nothing.
int Cast(Node& node, const Ray& ray)
{
    node.isTested = true;
    node.isMet = ray.Meets(node.box);
    int tested = 1;
    if (node.isMet && node.height > 0)
    {
        tested += Cast(*node.child[0], ray) + Cast(*node.child[1], ray);
    }
    return tested;
}

/// Letters for the inner nodes, level by level, and their places in the diagram.
void Arrange(Node& root, Sketch& sketch)
{
    constexpr double kLeft = 376.0; // [px]
    constexpr double kTop = 44.0;
    constexpr double kWidth = 256.0;
    constexpr double kLevel = 68.0;
    std::vector<Node*> level{&root};
    char letter = 'A';
    for (int depth = 0; !level.empty(); ++depth)
    {
        std::vector<Node*> below;
        for (std::size_t i = 0; i < level.size(); ++i)
        {
            Node& node = *level[i];
            const double share = (double(i) + 0.5) / double(level.size());
            node.sign = sketch.AtPixel(kLeft + kWidth * share, kTop + kLevel * depth);
            if (node.height > 0)
            {
                node.name = std::string(1, letter++);
                below.push_back(node.child[0].get());
                below.push_back(node.child[1].get());
            }
        }
        level = below;
    }
}

Paint ColorOf(const Node& node)
{
    if (!node.isMet)
    {
        return node.isTested ? kBad : kQuiet;
    }
    return node.height == 0 ? kGood : kHelp;
}

void DrawBox(Sketch& sketch, const Node& node)
{
    // Those of parents larger than they are, for their sides lie on those of their children.
    const double margin = 15.0 * node.height;
    const b2Vec2 lower = sketch.Shifted(node.box.lowerBound, -margin, -margin);
    const b2Vec2 upper = sketch.Shifted(node.box.upperBound, margin, margin);
    sketch.Outline({lower, {upper.x, lower.y}, upper, {lower.x, upper.y}}, ColorOf(node));
    const b2Vec2 corner = sketch.Shifted({lower.x, upper.y}, 9.0, -8.0);
    sketch.Label(node.height == 0 ? node.box.GetCenter() : corner, Side::On, node.name,
                 node.height == 0 ? kInk : ColorOf(node));
}

/// Draws the boxes that the ray misses first, below those that it hits.
void DrawBoxes(Sketch& sketch, const Node& node, bool met)
{
    if (node.isMet == met)
    {
        DrawBox(sketch, node);
    }
    for (const auto& child : node.child)
    {
        if (child)
        {
            DrawBoxes(sketch, *child, met);
        }
    }
}

void DrawDiagram(Sketch& sketch, const Node& node)
{
    constexpr double kRadius = 11.0; // [px]
    for (const auto& child : node.child)
    {
        if (child)
        {
            b2Vec2 way = child->sign - node.sign;
            way.Normalize();
            sketch.Line(sketch.Shifted(node.sign, kRadius * way.x, kRadius * way.y),
                        sketch.Shifted(child->sign, -kRadius * way.x, -kRadius * way.y),
                        child->isMet ? kHelp : kQuiet);
            DrawDiagram(sketch, *child);
        }
    }
    sketch.Ring(node.sign, kRadius, ColorOf(node));
    sketch.Label(node.sign, Side::On, node.name, ColorOf(node));
}

/// The proxies that the engine's tree reports to a ray.
struct Reported
{
    float32 RayCastCallback(const b2RayCastInput& input, int32 proxy)
    {
        proxies.insert(proxy);
        return input.maxFraction;
    }
    std::set<int32> proxies;
};

} // namespace

Figure DrawDynamicTree()
{
    Sketch sketch(640, 340, b2Vec2(6.12f, 2.4f), 46.0);
    b2World world(b2Vec2(0.0f, 0.0f));
    const b2Vec2 corners[3] = {{-0.4f, -0.35f}, {0.4f, -0.35f}, {0.0f, 0.45f}};
    b2PolygonShape triangle;
    triangle.Set(corners, 3);
    AddBody(world, b2_dynamicBody, Disc(0.32f), b2Vec2(0.6f, 0.7f));
    AddBody(world, b2_dynamicBody, Box(0.4f, 0.22f), b2Vec2(1.75f, 1.2f), Degrees(20.0f));
    AddBody(world, b2_dynamicBody, triangle, b2Vec2(0.75f, 3.1f));
    AddBody(world, b2_dynamicBody, Box(0.4f, 0.28f), b2Vec2(2.0f, 3.9f), Degrees(-15.0f));
    AddBody(world, b2_dynamicBody, Disc(0.38f), b2Vec2(4.3f, 0.8f));
    AddBody(world, b2_dynamicBody, Box(0.25f, 0.4f), b2Vec2(5.6f, 1.1f), Degrees(10.0f));
    AddBody(world, b2_dynamicBody, Disc(0.3f), b2Vec2(4.5f, 3.3f));
    AddBody(world, b2_dynamicBody, Box(0.3f, 0.3f), b2Vec2(5.75f, 3.9f), Degrees(30.0f));
    sketch.Draw(world);

    b2DynamicTree engine;
    std::vector<Leaf> leaves;
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        b2AABB box;
        body->GetFixtureList()->GetShape()->ComputeAABB(&box, body->GetTransform(), 0);
        leaves.push_back({box, body->GetNumber() + 1});
        engine.CreateProxyExact(box, leaves.back().number);
    }
    const std::unique_ptr<Node> root = Build(leaves);
    const Ray ray{{1.24f, -0.95f}, {2.42f, 5.75f}};
    const int tested = Cast(*root, ray);
    Arrange(*root, sketch);
    DrawBoxes(sketch, *root, false);
    DrawBoxes(sketch, *root, true);
    sketch.Arrow(ray.from, ray.to);
    sketch.Label(ray.from, Side::Left, "ray", kInk, 6.0);
    DrawDiagram(sketch, *root);

    Reported reported;
    engine.RayCast(&reported, {ray.from, ray.to, 1.0f});
    std::string hits;
    for (const int32 proxy : reported.proxies)
    {
        hits = std::to_string(engine.GetUserIndex(proxy)) + (hits.empty() ? "" : " and ") + hits;
    }
    sketch.Caption(504.0, 292.0, Side::On,
                   "The ray tests " + std::to_string(tested) + " of " +
                       std::to_string(2 * leaves.size() - 1) +
                       " boxes,\nnot the grey ones, and reports " + hits + ".");
    return sketch.Finished();
}

} // namespace figures
