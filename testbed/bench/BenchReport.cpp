// SPDX-License-Identifier: MIT
#include "Benchmark.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace boxreel
{
namespace
{

/// Three digits and a unit that fits: 7.26 ms, 350 us, 0.35 us.
std::string TimeText(double seconds)
{
    const bool isLong = seconds >= 0.9995e-3;
    const double value = seconds * (isLong ? 1e3 : 1e6);
    const int decimals = value >= 99.95 ? 0 : value >= 9.995 ? 1 : 2;
    char text[32];
    std::snprintf(text, sizeof text, "%.*f %s", decimals, value, isLong ? "ms" : "us");
    return text;
}

std::string RatioText(double ratio)
{
    char text[32];
    std::snprintf(text, sizeof text, ratio >= 9.95 ? "%.0fx" : "%.1fx", ratio);
    return ratio > 0.0 ? text : "";
}

std::string Row(const std::string& scene, const BenchFigures& figures, const std::string& ratio)
{
    char text[256];
    if (!figures.failure.empty())
    {
        std::snprintf(text, sizeof text, "%-15s %-16s %s\n", scene.c_str(), figures.engine.c_str(),
                      figures.verdict.c_str());
        return text;
    }
    std::snprintf(text, sizeof text, "%-15s %-16s %9s %9s %9s %9s %6s %8ld %6.1f MB  %s\n",
                  scene.c_str(), figures.engine.c_str(), TimeText(figures.mean).c_str(),
                  TimeText(figures.median).c_str(), TimeText(figures.p99).c_str(),
                  TimeText(figures.cpu).c_str(), ratio.c_str(), std::lround(figures.contacts),
                  figures.memory / 1024.0, figures.verdict.c_str());
    return text;
}

} // namespace

Result<BenchFigures> ParseFigures(const std::string& output)
{
    // A library may talk before; the figures are the last line.
    const std::size_t end = output.find_last_not_of('\n');
    const std::size_t start = output.rfind('\n', end);
    const std::string line = output.substr(start == std::string::npos ? 0 : start + 1);
    const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
    const auto number = [&json](const char* name) {
        return json.is_object() && json.contains(name) && json[name].is_number()
                   ? json[name].get<double>()
                   : std::nan("");
    };
    BenchFigures figures;
    figures.mean = number("mean");
    figures.median = number("median");
    figures.p99 = number("p99");
    figures.cpu = number("cpu");
    figures.contacts = number("contacts");
    figures.memory = number("memory");
    figures.escaped = number("escaped");
    figures.meanHeight = number("meanHeight");
    const double sum = figures.mean + figures.median + figures.p99 + figures.cpu +
                       figures.contacts + figures.memory + figures.escaped;
    if (!std::isfinite(sum) || !json.contains("engine") || !json["engine"].is_string())
    {
        return Error{ErrorKind::Failed, "A benchmark program printed no figures: '" + line + "'."};
    }
    figures.engine = json["engine"].get<std::string>();
    figures.finite = json.value("finite", false);
    return figures;
}

std::string BenchTable(const std::vector<BenchResult>& results)
{
    char head[256];
    std::snprintf(head, sizeof head, "%-15s %-16s %9s %9s %9s %9s %6s %8s %9s  %s\n", "scene",
                  "engine", "mean", "median", "p99", "CPU", "ratio", "contacts", "memory",
                  "verdict");
    std::string table = head;
    for (const BenchResult& result : results)
    {
        for (const BenchFigures& engine : result.engines)
        {
            const bool ours = &engine == &result.engines.front();
            table += Row(ours ? result.scene.name : "", engine,
                         ours ? "" : RatioText(RatioTo(result.engines.front(), engine)));
        }
    }
    return table;
}

std::string BenchJson(const std::vector<BenchResult>& results)
{
    nlohmann::ordered_json scenes = nlohmann::ordered_json::array();
    for (const BenchResult& result : results)
    {
        nlohmann::ordered_json engines = nlohmann::ordered_json::array();
        for (const BenchFigures& e : result.engines)
        {
            nlohmann::ordered_json entry{{"engine", e.engine}, {"verdict", e.verdict}};
            if (e.failure.empty())
            {
                entry.update({{"meanSeconds", e.mean},
                              {"medianSeconds", e.median},
                              {"p99Seconds", e.p99},
                              {"cpuSeconds", e.cpu},
                              {"ratio", RatioTo(result.engines.front(), e)},
                              {"contacts", e.contacts},
                              {"memoryKilobytes", e.memory},
                              {"escaped", e.escaped},
                              {"meanHeightMetres", e.meanHeight}});
            }
            engines.push_back(std::move(entry));
        }
        scenes.push_back(
            {{"scene", result.scene.name}, {"what", result.scene.what}, {"engines", engines}});
    }
    return nlohmann::ordered_json{{"scenes", scenes}}.dump(2) + "\n";
}

} // namespace boxreel
