// SPDX-License-Identifier: MIT
#include "DynamicsInvariants.h"
#include "DynamicsScene.h"

#include <Dynamics/State/ConstraintGraph.h>
#include <Dynamics/State/World.h>

#include <gtest/gtest.h>

#include <bit>

/// Contacts stay in their solver blocks while a colour's contacts and their forms stay. The results
/// are those of rebuilt blocks.
namespace
{

using namespace dynamics;
using box2d::ConstraintGraph;
using Change = ConstraintGraph::Change;

struct Idle : public b2ContactListener
{};

/// Switches every third contact off now and then, from the callback of another.
struct Switcher : public b2ContactListener
{
    void PreSolve(b2Contact* contact, const b2Manifold*) override
    {
        if (last && ++calls % 3 == 0)
        {
            last->SetEnabled(false);
        }
        last = contact;
    }
    void EndContact(b2Contact* contact) override { last = last == contact ? nullptr : last; }
    b2Contact* last = nullptr;
    int calls = 0;
};

/// Boxes, bars and balls that land one after the other and topple.
void FillHeap(Scene& scene)
{
    scene.Ground();
    for (int i = 0; i < 90; ++i)
    {
        const float32 x = -3.0f + 0.7f * float32(i % 9) + 0.013f * float32(i);
        const float32 y = 1.0f + 0.9f * float32(i / 9);
        i % 3 == 0   ? scene.Ball(x, y, 0.3f)
        : i % 3 == 1 ? scene.Box(x, y, 0.3f, 0.3f)
                     : scene.Box(x, y, 0.4f, 0.15f);
    }
}

std::uint64_t HashOf(const b2World& world)
{
    std::uint64_t hash = 14695981039346656037ull; // FNV-1a
    for (const b2Body* b = world.GetBodyList(); b; b = b->GetNext())
    {
        for (const float32 value : {b->GetPosition().x, b->GetPosition().y, b->GetAngle(),
                                    b->GetLinearVelocity().x, b->GetAngularVelocity()})
        {
            hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 1099511628211ull;
        }
    }
    return hash;
}

TEST(DynamicsKeptBlocks, GiveTheBitsOfBlocksRebuiltInEveryStep)
{
    Idle idle; // with a listener they are rebuilt
    Scene kept, fresh;
    FillHeap(kept);
    FillHeap(fresh);
    fresh.world.SetContactListener(&idle);
    for (int i = 0; i < 400; ++i)
    {
        kept.Step();
        fresh.Step();
        ASSERT_EQ(HashOf(kept.world), HashOf(fresh.world)) << "step " << i;
    }
}

TEST(DynamicsKeptBlocks, EnableContactsAgainWithoutListener)
{
    Idle idle;
    Switcher one, another;
    Scene kept, fresh;
    FillHeap(kept);
    FillHeap(fresh);
    for (int i = 0; i < 400; ++i)
    {
        const bool switching = i / 25 % 2 == 1;
        kept.world.SetContactListener(switching ? &one : nullptr);
        fresh.world.SetContactListener(switching ? static_cast<b2ContactListener*>(&another)
                                                 : &idle);
        one.last = another.last = nullptr;
        kept.Step();
        fresh.Step();
        ASSERT_EQ(HashOf(kept.world), HashOf(fresh.world)) << "step " << i;
    }
    EXPECT_EQ(WhyBroken(kept.world, true), "");
}

/// Switches the first contact it is shown off and takes itself away.
struct Leaver : public b2ContactListener
{
    explicit Leaver(b2World& of) : world(of) {}
    void PreSolve(b2Contact* contact, const b2Manifold*) override
    {
        contact->SetEnabled(false);
        world.SetContactListener(nullptr);
    }
    b2World& world;
};

TEST(DynamicsKeptBlocks, SkipContactsDisabledByLeavingListener)
{
    Scene scene;
    scene.Ground();
    b2Body* box = scene.Box(0.0f, 0.5f);
    scene.world.SetAllowSleeping(false);
    scene.Step(60);
    Leaver leaver(scene.world);
    scene.world.SetContactListener(&leaver);
    scene.Step();
    EXPECT_NEAR(box->GetLinearVelocity().y, -10.0f * kStep, 1e-3f);
    scene.Step(60);
    EXPECT_NEAR(box->GetLinearVelocity().y, 0.0f, 1e-3f) << "for one step only";
}

TEST(DynamicsKeptBlocks, AreRebuiltWhenContactsChange)
{
    Scene scene;
    scene.Ground();
    b2Body* box = scene.Box(0.0f, 0.5f);
    scene.world.SetAllowSleeping(false);
    scene.Step(30);
    ConstraintGraph graph;
    b2Contact& contact = *box->GetContactList()->contact;
    box2d::ContactData& c = box2d::Data(contact);
    const std::int8_t color = c.color;
    const int32 index = c.colorIndex;
    c.color = -1; // as if it were not yet in any
    graph.Add(contact);
    const std::int8_t own = c.color;
    EXPECT_EQ(graph.ChangeOf(own), Change::Contacts);
    graph.Settle(own);
    EXPECT_EQ(graph.ChangeOf(own), Change::None);
    c.solvedAs = c.Form();
    graph.NoteForm(c);
    EXPECT_EQ(graph.ChangeOf(own), Change::None);
    contact.SetEnabled(false);
    graph.NoteForm(c);
    EXPECT_EQ(graph.ChangeOf(own), Change::Forms);
    contact.SetEnabled(true);
    graph.Settle(own);
    graph.Remove(contact);
    EXPECT_EQ(graph.ChangeOf(own), Change::Contacts);
    graph.Settle(own);
    graph.NoteForm(c); // of no colour
    EXPECT_EQ(graph.ChangeOf(own), Change::None);
    c.color = color;
    c.colorIndex = index;
}

} // namespace
