// SPDX-License-Identifier: MIT
#include "Format.h"
#include "GoldenBench.h"
#include "JsonFields.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

constexpr int kNameWidth = 34;

/// Of the pairs of a kind: how many there are, and how many are called different.
struct Found
{
    int of = 0;
    int different = 0;
};

Found CountOf(const GoldenBenchResult& result, const GoldenMethod& method, std::size_t kind)
{
    Found found;
    for (std::size_t i = 0; i < result.pairs.size(); ++i)
    {
        if (result.pairs[i].kind == kind)
        {
            ++found.of;
            found.different += method.verdicts[i].isDifferent;
        }
    }
    return found;
}

bool IsWrong(const Found& found, PlantedTruth truth)
{
    return (truth == PlantedTruth::Different && found.different < found.of) ||
           (truth == PlantedTruth::Equal && found.different > 0);
}

std::string Milliseconds(double seconds)
{
    return std::isfinite(seconds) ? Format(" %9.*f", seconds < 0.01 ? 2 : 0, seconds * 1e3)
                                  : Format(" %9s", "-");
}

std::vector<double> TimesOf(const GoldenMethod& method, double PairVerdict::*time)
{
    std::vector<double> times;
    for (const PairVerdict& verdict : method.verdicts)
    {
        if (std::isfinite(verdict.*time))
        {
            times.push_back(verdict.*time);
        }
    }
    return times;
}

double MostOf(const std::vector<double>& values)
{
    return values.empty() ? kNoValue : *std::max_element(values.begin(), values.end());
}

std::string Row(const GoldenBenchResult& result, const GoldenMethod& method)
{
    std::string row = Format("%-*s", kNameWidth, method.name.c_str());
    if (!method.failure.empty())
    {
        return row + "failed: " + method.failure + "\n";
    }
    for (std::size_t kind = 0; kind < PlantedKinds().size(); ++kind)
    {
        const PlantedTruth truth = PlantedKinds()[kind].truth;
        if (truth != PlantedTruth::Either)
        {
            const Found found = CountOf(result, method, kind);
            row +=
                Format(" %5d/%d%s", found.different, found.of, IsWrong(found, truth) ? "!" : " ");
        }
    }
    const std::vector<double> decoded = TimesOf(method, &PairVerdict::decoded);
    const std::vector<double> process = TimesOf(method, &PairVerdict::process);
    row += Milliseconds(MedianOf(decoded)) + Milliseconds(MostOf(decoded)) +
           Milliseconds(MedianOf(process));
    return row + "\n";
}

const char* NameOf(PlantedTruth truth)
{
    return truth == PlantedTruth::Different ? "different"
           : truth == PlantedTruth::Equal   ? "equal"
                                            : "either";
}

Json Seconds(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

} // namespace

std::string GoldenTable(const GoldenBenchResult& result)
{
    std::string scenes;
    for (const std::string& scene : result.scenes)
    {
        scenes += (scenes.empty() ? "" : ", ") + scene;
    }
    std::string text = "Called different, of as many pictures, 1280 x 720, of " + scenes + ":\n";
    std::string heads = Format("%-*s", kNameWidth, "method");
    std::string legend;
    for (const PlantedKind& kind : PlantedKinds())
    {
        legend += Format("%-9s%s%s\n", kind.name.c_str(), kind.what.c_str(),
                         kind.truth == PlantedTruth::Equal ? ": is to pass" : "");
        heads += kind.truth == PlantedTruth::Either ? "" : Format(" %8s", kind.name.c_str());
    }
    text += heads + Format(" %9s %9s %9s\n", "ms", "most ms", "process");
    for (const GoldenMethod& method : result.methods)
    {
        text += Row(result, method);
    }
    text += "A sign (!) marks a change that was missed, or a false alarm.\n\n" + legend;
    for (const std::string& sentence : result.absent)
    {
        text += "\n" + sentence;
    }
    return text + (result.absent.empty() ? "" : "\n");
}

std::string GoldenJson(const GoldenBenchResult& result)
{
    Json json;
    json["scenes"] = result.scenes;
    json["absent"] = result.absent;
    for (const PlantedKind& kind : PlantedKinds())
    {
        json["changes"].push_back(
            {{"change", kind.name}, {"what", kind.what}, {"truth", NameOf(kind.truth)}});
    }
    json["methods"] = Json::array();
    for (const GoldenMethod& method : result.methods)
    {
        Json one{{"method", method.name}, {"ours", method.isOurs}};
        if (!method.failure.empty())
        {
            one["failure"] = method.failure;
        }
        for (std::size_t i = 0; i < method.verdicts.size() && method.failure.empty(); ++i)
        {
            const PairVerdict& verdict = method.verdicts[i];
            one["pictures"].push_back({{"change", PlantedKinds()[result.pairs[i].kind].name},
                                       {"different", verdict.isDifferent},
                                       {"decodedSeconds", Seconds(verdict.decoded)},
                                       {"processSeconds", Seconds(verdict.process)}});
        }
        json["methods"].push_back(std::move(one));
    }
    return LinesOf(json);
}

} // namespace boxreel
