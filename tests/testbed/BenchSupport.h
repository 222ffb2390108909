// SPDX-License-Identifier: MIT
#pragma once

#include <bench/Benchmark.h>

/// Figures of made-up runs, for tests of what is made of them; nothing is run.
namespace boxreel
{

inline BenchFigures Figures(const std::string& engine, double cpu, double contacts, double height)
{
    BenchFigures figures;
    figures.engine = engine;
    figures.isOurs = engine.rfind("boxreel", 0) == 0;
    figures.mean = figures.median = figures.p99 = figures.cpu = cpu;
    figures.contacts = contacts;
    figures.meanHeight = height;
    figures.bits = "00";
    return figures;
}

inline BenchScene SceneNamed(const std::string& name)
{
    BenchScene scene;
    scene.name = name;
    scene.what = "5000 circles";
    return scene;
}

/// Ours, Box2D five times slower and Chipmunk twice as fast.
inline BenchResult Rain()
{
    BenchResult result{SceneNamed("rain"),
                       {Figures("boxreel 1.0", 0.004, 100, 5),
                        Figures("Box2D 2.4.1", 0.02, 104, 5.1),
                        Figures("Chipmunk 7", 0.002, 97, 5)}};
    result.scene.goalTimesFaster = 8.0;
    Judge(result);
    return result;
}

inline BenchResult Point(const std::string& curve, double count, double ours, double peer)
{
    BenchResult result{SceneNamed(curve + "-" + std::to_string(int(count))),
                       {Figures("boxreel 1.0", ours, 1, 1), Figures("Box2D 2.4.1", peer, 1, 1)}};
    result.scene.curve = curve;
    result.scene.count = count;
    Judge(result);
    return result;
}

} // namespace boxreel
