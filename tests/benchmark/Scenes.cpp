// SPDX-License-Identifier: MIT
#include "Scenes.h"

#include <algorithm>
#include <cmath>

namespace bench
{
namespace
{

constexpr double kPi = 3.14159265358979323846;
const Material kPlain;

BodyId AddStatic(Sim& sim, double x = 0.0, double y = 0.0)
{
    BodySpec spec;
    spec.kind = Kind::Static;
    spec.x = x;
    spec.y = y;
    return sim.AddBody(spec);
}

BodyId AddAt(Sim& sim, double x, double y)
{
    BodySpec spec;
    spec.x = x;
    spec.y = y;
    return sim.AddBody(spec);
}

void AddBoxAt(Sim& sim, double x, double y, double half)
{
    sim.AddBox(AddAt(sim, x, y), half, half, 0.0, 0.0, kPlain);
}

/// Rows of boxes that touch, each shifted by half a box against the one below.
void AddPyramid(Sim& sim, int base, double half, double centerX, double floor)
{
    for (int row = 0; row < base; ++row)
    {
        const int count = base - row;
        for (int i = 0; i < count; ++i)
        {
            const double x = centerX + half * (2.0 * i - (count - 1));
            AddBoxAt(sim, x, floor + half * (2.0 * row + 1.0), half);
        }
    }
}

void BuildLargePyramid(Sim& sim)
{
    sim.AddBox(AddStatic(sim, 0.0, -1.0), 100.0, 1.0, 0.0, 0.0, kPlain);
    AddPyramid(sim, 100, 0.5, 0.0, 0.0);
}

void BuildPyramids(Sim& sim)
{
    for (int row = 0; row < 10; ++row)
    {
        const double floor = 12.0 * row;
        sim.AddEdge(AddStatic(sim), -80.0, floor, 80.0, floor, kPlain);
        for (int c = 0; c < 10; ++c)
        {
            AddPyramid(sim, 10, 0.5, -67.5 + 15.0 * c, floor);
        }
    }
}

void BuildTumbler(Sim& sim)
{
    BodySpec spec;
    spec.kind = Kind::Kinematic;
    spec.y = 10.0;
    spec.angularVelocity = 25.0 * kPi / 180.0;
    const BodyId drum = sim.AddBody(spec);
    Material wall;
    wall.density = 50.0;
    sim.AddBox(drum, 0.5, 10.0, 10.0, 0.0, wall);
    sim.AddBox(drum, 0.5, 10.0, -10.0, 0.0, wall);
    sim.AddBox(drum, 10.0, 0.5, 0.0, 10.0, wall);
    sim.AddBox(drum, 10.0, 0.5, 0.0, -10.0, wall);
    for (int i = 0; i < 2000; ++i)
    {
        AddBoxAt(sim, -9.0 + 0.4 * (i % 45), 1.0 + 0.4 * (i / 45), 0.125);
    }
}

void BuildJointGrid(Sim& sim)
{
    constexpr int size = 100;
    Material apart;
    apart.category = 2;
    apart.mask = std::uint16_t(0xFFFF & ~2);
    std::vector<BodyId> bodies;
    for (int k = 0; k < size; ++k)
    {
        for (int i = 0; i < size; ++i)
        {
            BodySpec spec;
            spec.kind = i == 0 && std::abs(k - size / 2) <= 3 ? Kind::Static : Kind::Dynamic;
            spec.x = k;
            spec.y = -i;
            const BodyId body = sim.AddBody(spec);
            sim.AddCircle(body, 0.4, apart);
            const bool moves = spec.kind == Kind::Dynamic;
            if (i > 0)
            {
                sim.AddRevolute(bodies.back(), body, k, -i + 0.5);
            }
            // Not between two static ones: that joint would hold nothing.
            if (k > 0 && (moves || std::abs(k - 1 - size / 2) > 3))
            {
                sim.AddRevolute(bodies[bodies.size() - size], body, k - 0.5, -i);
            }
            bodies.push_back(body);
        }
    }
}

void BuildContainer(Sim& sim, double height)
{
    const BodyId container = AddStatic(sim);
    sim.AddEdge(container, -20.0, 0.0, 20.0, 0.0, kPlain);
    sim.AddEdge(container, -20.0, 0.0, -20.0, height, kPlain);
    sim.AddEdge(container, 20.0, 0.0, 20.0, height, kPlain);
}

void BuildRain(Sim& sim)
{
    BuildContainer(sim, 200.0);
    for (int i = 0; i < 5000; ++i)
    {
        const int row = i / 50;
        const double x = -19.4 + 0.78 * (i % 50) + (row % 2 == 1 ? 0.2 : 0.0);
        sim.AddCircle(AddAt(sim, x, 1.0 + 0.6 * row), 0.25, kPlain);
    }
}

BodyId AddLimb(Sim& sim, double x, double y, double hx, double hy)
{
    const BodyId limb = AddAt(sim, x, y);
    sim.AddBox(limb, hx, hy, 0.0, 0.0, kPlain);
    return limb;
}

/// Around the middle of the torso at (x, y).
void AddRagdoll(Sim& sim, double x, double y)
{
    const BodyId torso = AddLimb(sim, x, y, 0.2, 0.35);
    const BodyId head = AddAt(sim, x, y + 0.55);
    sim.AddCircle(head, 0.2, kPlain);
    sim.AddRevolute(torso, head, x, y + 0.35);
    for (const double side : {-1.0, 1.0})
    {
        const BodyId upperArm = AddLimb(sim, x + side * 0.4, y + 0.25, 0.2, 0.08);
        sim.AddRevolute(torso, upperArm, x + side * 0.2, y + 0.25);
        const BodyId lowerArm = AddLimb(sim, x + side * 0.8, y + 0.25, 0.2, 0.07);
        sim.AddRevolute(upperArm, lowerArm, x + side * 0.6, y + 0.25);
        const BodyId thigh = AddLimb(sim, x + side * 0.11, y - 0.57, 0.09, 0.22);
        sim.AddRevolute(torso, thigh, x + side * 0.11, y - 0.35);
        const BodyId shin = AddLimb(sim, x + side * 0.11, y - 1.01, 0.08, 0.22);
        sim.AddRevolute(thigh, shin, x + side * 0.11, y - 0.79);
    }
}

void BuildRagdolls(Sim& sim)
{
    BuildContainer(sim, 300.0);
    for (int i = 0; i < 300; ++i)
    {
        AddRagdoll(sim, -17.5 + 2.5 * (i % 15), 2.0 + 3.0 * (i / 15));
    }
}

/// From 0 to 1, the same for every engine.
double Random(std::uint32_t& state)
{
    state = state * 1664525u + 1013904223u;
    return double(state >> 8) / double(1 << 24);
}

void BuildBullets(Sim& sim)
{
    Material slick;
    slick.friction = 0.0;
    slick.restitution = 1.0;
    const BodyId box = AddStatic(sim);
    sim.AddEdge(box, -20.0, -20.0, 20.0, -20.0, slick);
    sim.AddEdge(box, -20.0, 20.0, 20.0, 20.0, slick);
    sim.AddEdge(box, -20.0, -20.0, -20.0, 20.0, slick);
    sim.AddEdge(box, 20.0, -20.0, 20.0, 20.0, slick);
    std::uint32_t seed = 1;
    for (int i = 0; i < 500; ++i)
    {
        const double direction = 2.0 * kPi * Random(seed);
        BodySpec spec;
        spec.x = 1.5 * (i % 25 - 12);
        spec.y = 1.5 * (i / 25 - 10) + 0.75;
        spec.vx = 100.0 * std::cos(direction);
        spec.vy = 100.0 * std::sin(direction);
        spec.bullet = true;
        sim.AddCircle(sim.AddBody(spec), 0.1, slick);
    }
}

/// 200 boxes of half-size 0.5 in 40 stacks of 5, on a ground whose top is at 0.
void AddStacks(Sim& sim, double speed)
{
    for (int i = 0; i < 200; ++i)
    {
        BodySpec spec;
        spec.x = 2.0 * (i / 5 - 20);
        spec.y = 0.5 + i % 5;
        spec.vx = speed;
        sim.AddBox(sim.AddBody(spec), 0.5, 0.5, 0.0, 0.0, kPlain);
    }
}

void BuildStatic(Sim& sim, int count)
{
    sim.AddBox(AddStatic(sim, 0.0, -1.0), 100.0, 1.0, 0.0, 0.0, kPlain);
    for (int i = 0; i < count; ++i)
    {
        const BodyId body = AddStatic(sim, 3.0 * (i % 500 - 250), -10.0 - 3.0 * (i / 500));
        sim.AddBox(body, 1.0, 1.0, 0.0, 0.0, kPlain);
    }
    AddStacks(sim, 0.0);
}

/// Boxes of half-size 1 on an edge, 3 m apart. They begin as far above it as Box2D keeps them.
std::vector<BodyId> AddRow(Sim& sim, int count, double y)
{
    sim.AddEdge(AddStatic(sim), -755.0, y - 1.0, 755.0, y - 1.0, kPlain);
    std::vector<BodyId> row;
    for (int i = 0; i < count; ++i)
    {
        row.push_back(AddAt(sim, 3.0 * (i - 250), y + 0.015));
        sim.AddBox(row.back(), 1.0, 1.0, 0.0, 0.0, kPlain);
    }
    return row;
}

/// The sleeping bodies are rows of 500 boxes 3 m apart, from y = -10 down. The moving ones are
/// stacks on a moving ground. Nothing else would keep them awake in a world with sleeping.
void BuildAsleep(Sim& sim, int count)
{
    // Chipmunk's time to put n awake bodies to sleep grows with n * n, so never all at once.
    constexpr int rowsAtOnce = 20;
    std::vector<BodyId> settling;
    for (int row = 0; row * 500 < count; ++row)
    {
        const int left = count - row * 500;
        const std::vector<BodyId> added = AddRow(sim, std::min(500, left), -10.0 - 3.0 * row);
        settling.insert(settling.end(), added.begin(), added.end());
        if (left > 500 && (row + 1) % rowsAtOnce != 0)
        {
            continue;
        }
        for (int step = 0; step < 10; ++step) // until they touch what they lie on
        {
            sim.Step();
        }
        for (const BodyId sleeper : settling)
        {
            sim.PutToSleep(sleeper);
        }
        settling.clear();
    }
    BodySpec ground;
    ground.kind = Kind::Kinematic;
    ground.y = -1.0;
    ground.vx = 1.0;
    sim.AddBox(sim.AddBody(ground), 100.0, 1.0, 0.0, 0.0, kPlain);
    AddStacks(sim, ground.vx);
}

void BuildOneBox(Sim& sim)
{
    sim.AddBox(AddStatic(sim, 0.0, -1.0), 50.0, 1.0, 0.0, 0.0, kPlain);
    AddBoxAt(sim, 0.0, 0.51, 0.5);
}

void BuildTargets(Sim& sim)
{
    for (int i = 0; i < 20000; ++i)
    {
        sim.AddBox(AddStatic(sim, 3.0 * (i % 200), 3.0 * (i / 200)), 1.0, 1.0, 0.0, 0.0, kPlain);
    }
}

/// Rays of 50 m, all over the field and in all directions. They start between two columns of boxes,
/// for engines differ about rays that start in a box or on its edge. Finds hits, and at which
/// fractions.
Found CastOneRay(Sim& sim, int call)
{
    const double x = 10.5 + 3.0 * ((call * 37) % 193);
    const double y = 10.0 + (call * 53) % 280;
    const double angle = 0.61803398875 * 2.0 * kPi * call;
    const double at = sim.CastRay(x, y, x + 50.0 * std::cos(angle), y + 50.0 * std::sin(angle));
    return at < 1.0 ? Found{1.0, at} : Found{};
}

/// Finds bodies that were in the world and are so no more, and how fast some of them fell [m/s].
Found CreateAndDestroy(Sim& sim, int call)
{
    const int before = sim.BodyCount();
    AddBoxAt(sim, 0.01 * (call % 100), 5.0, 0.5);
    const int between = sim.BodyCount();
    double speed = 0.0;
    if (call % 500 == 499)
    {
        sim.Step(); // or what an engine notes for its next step would only grow
        speed = -sim.State(between - 1).vy;
    }
    sim.RemoveLastBody();
    return {between == before + 1 && sim.BodyCount() == before ? 1.0 : 0.0, speed};
}

/// Nothing can be seen of steps of an empty world; but a body put into it must fall in the next.
Found DropOne(Sim& sim)
{
    AddBoxAt(sim, 0.0, 0.0, 0.5);
    sim.Step();
    return {double(sim.BodyCount()), -sim.State(0).vy};
}

Scene Make(const char* name, const char* what, std::function<void(Sim&)> build, int steps)
{
    Scene scene;
    scene.name = name;
    scene.what = what;
    scene.build = std::move(build);
    scene.steps = steps;
    return scene;
}

using Scenes = std::vector<Scene>;

Scene& Append(Scenes& scenes, Scene scene)
{
    scenes.push_back(std::move(scene));
    return scenes.back();
}

void AddLargeScenes(Scenes& scenes)
{
    Scene& pyramid = Append(
        scenes, Make("large-pyramid", "pyramid of base 100, 5050 boxes", BuildLargePyramid, 300));
    pyramid.bounds = {-110.0, -0.2, 110.0, 110.0};
    Append(scenes, Make("pyramids", "100 pyramids of base 10", BuildPyramids, 300)).bounds = {
        -81.0, -0.2, 81.0, 130.0};
    Scene& tumbler =
        Append(scenes, Make("tumbler", "2000 boxes in a turning drum", BuildTumbler, 600));
    tumbler.bounds = {-15.0, -5.0, 15.0, 25.0};
    Append(scenes,
           Make("joint-grid", "10,000 circles on 19,794 revolute joints", BuildJointGrid, 300))
        .bounds = {-200.0, -300.0, 300.0, 200.0};
    Scene& rain = Append(scenes, Make("rain", "5000 circles into a container", BuildRain, 600));
    rain.bounds = {-20.0, -0.1, 20.0, 200.0};
    Append(scenes, Make("ragdolls", "300 ragdolls of 10 bodies", BuildRagdolls, 600)).bounds = {
        -20.1, -0.2, 20.1, 300.0};
    Scene& bullets =
        Append(scenes, Make("bullets", "500 bullets at 100 m/s in a box", BuildBullets, 600));
    bullets.settings.gravity = 0.0;
    bullets.bounds = {-20.0, -20.0, 20.0, 20.0};
    bullets.likeness = Likeness::Speeds;
}

/// 20,000
std::string Words(int count)
{
    const std::string digits = std::to_string(count);
    const std::size_t ending = digits.size() - 3;
    return count < 10000 ? digits : digits.substr(0, ending) + "," + digits.substr(ending);
}

void AddCurves(Scenes& scenes)
{
    constexpr int counts[] = {200, 2000, 20000, 200000};
    for (const int count : counts)
    {
        Scene& scene =
            Append(scenes, Make(
                               "", "", [count](Sim& sim) { BuildStatic(sim, count); }, 300));
        scene.name = "static-" + std::to_string(count);
        scene.what = Words(count) + " static boxes beside 200 that move";
        scene.warmup = 60;
        scene.curve = "static";
        scene.count = count;
        scene.onlyForCurve = count < 20000;
    }
    for (const bool small : {false, true}) // sub-steps, in engines that have them
    {
        for (const int count : counts)
        {
            Scene& scene =
                Append(scenes, Make(
                                   "", "", [count](Sim& sim) { BuildAsleep(sim, count); }, 300));
            scene.name = (small ? "asleep4-" : "asleep-") + std::to_string(count);
            scene.what = Words(count) + " boxes asleep beside 200 that move" +
                         (small ? ", 4 sub-steps where there are any" : "");
            scene.settings.sleep = true;
            scene.settings.subSteps = small ? std::min(4, MostSubSteps()) : 1;
            scene.warmup = 60;
            scene.sleepers = count;
            scene.curve = small ? "asleep4" : "asleep";
            scene.count = count;
            scene.onlyForCurve = true;
        }
    }
}

void AddSmallScenes(Scenes& scenes)
{
    Scene& asleep = Append(scenes, Make("asleep", "the 100 pyramids, asleep", BuildPyramids, 2000));
    asleep.settings.sleep = true;
    asleep.untilAsleep = true;
    asleep.sleepers = 5500;
    asleep.block = asleep.steps; // a look at the clock takes longer than a step
    Scene& empty = Append(scenes, Make(
                                      "empty", "an empty world", [](Sim&) {}, 200000));
    empty.block = 1000;
    empty.afterwards = DropOne;
    empty.found = "bodies";
    Scene& oneBox = Append(scenes, Make("one-box", "one box on the ground", BuildOneBox, 100000));
    oneBox.warmup = 120;
    oneBox.block = 500;
    Scene& rays =
        Append(scenes, Make("ray-casts", "a ray of 50 m in 20,000 boxes", BuildTargets, 100000));
    rays.warmup = 1;
    rays.block = 500;
    rays.action = CastOneRay;
    rays.found = "hits";
    Scene& bodies =
        Append(scenes, Make("create-destroy", "a body made and destroyed", BuildOneBox, 100000));
    bodies.block = 500;
    bodies.action = CreateAndDestroy;
    bodies.found = "bodies";
}

} // namespace

const std::vector<Scene>& AllScenes()
{
    static const Scenes all = [] {
        Scenes scenes;
        AddLargeScenes(scenes);
        AddCurves(scenes);
        AddSmallScenes(scenes);
        return scenes;
    }();
    return all;
}

} // namespace bench
