// SPDX-License-Identifier: MIT
#include "GoldenBench.h"

#include "ChildProcess.h"
#include "JsonFields.h"

#include <algorithm>
#include <cstdint>
#include <fstream>

namespace boxreel
{
namespace
{

namespace fs = std::filesystem;

// The peers' defaults forgive what a person hardly sees in a photograph; the stricter settings are
// the ones that their manuals name for exactness and that still let a rounding pass.
constexpr const char* kStrict = "0.01"; // threshold of odiff and pixelmatch, which have 0.1
constexpr const char* kFuzz = "1%";     // of ImageMagick, which has 0

constexpr int kOdiffDifferent = 22;
constexpr int kPixelmatchDifferent = 66;
constexpr int kCompareDifferent = 1;

// Times pixelmatch without starting node anew, on pictures that were read before.
constexpr const char* kPixelmatchTimer = R"js(import fs from 'fs';
import { createRequire } from 'module';
import { pathToFileURL } from 'url';
const [folder, rounds, options, ...files] = process.argv.slice(2);
const match = (await import(pathToFileURL(folder + '/index.js'))).default;
const { PNG } = createRequire(folder + '/package.json')('pngjs');
const read = (file) => PNG.sync.read(fs.readFileSync(file));
const seconds = [];
for (let i = 0; i < files.length; i += 2) {
  const [a, b] = [read(files[i]), read(files[i + 1])];
  const times = [];
  for (let round = 0; round < Number(rounds) + 2; ++round) {
    const start = process.hrtime.bigint();
    match(a.data, b.data, null, a.width, a.height, JSON.parse(options));
    times.push(Number(process.hrtime.bigint() - start) * 1e-9);
  }
  times.splice(0, 2); // it is compiled while it runs
  times.sort((x, y) => x - y);
  seconds.push(times[times.length >> 1]);
}
console.log(JSON.stringify({ seconds }));
)js";

/// The package's version; empty when it is not there.
std::string VersionOf(const fs::path& package)
{
    std::ifstream file(package / "package.json");
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const Json json = ParseJson(text);
    return json.is_discarded() ? "" : Text(json, "version");
}

/// The program itself: the package's script would start node first.
fs::path OdiffProgram(const fs::path& modules)
{
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(modules / "@odiff", ignored))
    {
        if (fs::exists(entry.path() / "odiff", ignored))
        {
            return entry.path() / "odiff";
        }
    }
    return {};
}

/// "6.9.11" of "Version: ImageMagick 6.9.11-60 …"; empty when it does not run.
std::string CompareVersion()
{
    const Result<ChildRun> run = RunMeasured("compare", {"-version"});
    const std::string word = "ImageMagick ";
    const std::size_t found = run ? run->output.find(word) : std::string::npos;
    return found == std::string::npos
               ? ""
               : run->output.substr(found + word.size(),
                                    run->output.find_first_of(" -\n", found + word.size()) - found -
                                        word.size());
}

struct Peer
{
    std::string name;
    PairProgram program;
    std::string timed; ///< pixelmatch's options, as JSON, to be timed without a process
};

std::vector<Peer> PeersOf(const GoldenPeers& peers)
{
    std::vector<Peer> all;
    if (!peers.odiff.empty())
    {
        const std::string name = "odiff " + peers.odiffVersion;
        all.push_back({name, {peers.odiff, {}, {}, kOdiffDifferent}, ""});
        all.push_back({name + ", " + kStrict,
                       {peers.odiff, {}, {"--threshold", kStrict}, kOdiffDifferent},
                       ""});
    }
    if (!peers.pixelmatch.empty())
    {
        const std::string name = "pixelmatch " + peers.pixelmatchVersion;
        const std::string script = (peers.pixelmatch / "bin" / "pixelmatch").string();
        all.push_back({name, {"node", {script}, {}, kPixelmatchDifferent}, "{}"});
        all.push_back({name + ", " + kStrict + ", AA counts",
                       {"node", {script}, {"", kStrict, "true"}, kPixelmatchDifferent},
                       std::string("{\"threshold\":") + kStrict + ",\"includeAA\":true}"});
    }
    if (!peers.compare.empty())
    {
        const std::string name = "ImageMagick " + peers.compareVersion;
        const auto program = [&](std::vector<std::string> words) {
            return PairProgram{peers.compare, std::move(words), {"null:"}, kCompareDifferent};
        };
        all.push_back({name, program({"-metric", "AE"}), ""});
        all.push_back({name + ", fuzz " + kFuzz, program({"-metric", "AE", "-fuzz", kFuzz}), ""});
    }
    return all;
}

/// The seconds of each pair into the method.
Result<void> TimeDecoded(const GoldenPeers& peers, const Peer& peer,
                         const std::vector<PlantedPair>& pairs, int rounds, const fs::path& work,
                         GoldenMethod& method)
{
    const fs::path script = work / "pixelmatch.mjs";
    std::ofstream(script) << kPixelmatchTimer;
    std::vector<std::string> words{script.string(), fs::absolute(peers.pixelmatch).string(),
                                   std::to_string(rounds), peer.timed};
    for (const PlantedPair& pair : pairs)
    {
        words.push_back(pair.expected.string());
        words.push_back(pair.actual.string());
    }
    const Result<ChildRun> run = RunMeasured("node", words);
    if (!run)
    {
        return run.GetError();
    }
    const Json json = ParseJson(run->output);
    const bool isWhole = json.is_object() && json.contains("seconds") &&
                         json["seconds"].is_array() && json["seconds"].size() == pairs.size();
    for (std::size_t i = 0; isWhole && i < pairs.size(); ++i)
    {
        const Json& seconds = json["seconds"][i];
        method.verdicts[i].decoded = seconds.is_number() ? seconds.get<double>() : kNoValue;
    }
    return {};
}

} // namespace

const std::vector<PlantedKind>& PlantedKinds()
{
    static const std::vector<PlantedKind> kinds{
        {"body", "a body moved by 1 cm", PlantedTruth::Different},
        {"line", "a joint's line is missing", PlantedTruth::Different},
        {"fill", "a fill off by 4 of 255", PlantedTruth::Different},
        {"label", "a label misspelt", PlantedTruth::Different},
        {"outline", "an outline one pixel thicker", PlantedTruth::Different},
        {"order", "two bodies drawn the other way round", PlantedTruth::Different},
        {"equal", "the same drawn again", PlantedTruth::Equal},
        {"stray", "a single stray pixel", PlantedTruth::Equal},
        {"shift", "all edges 0.1 px elsewhere", PlantedTruth::Equal},
        {"noise", "every channel up to 1 off, for the time", PlantedTruth::Either}};
    return kinds;
}

double MedianOf(std::vector<double> values)
{
    if (values.empty())
    {
        return kNoValue;
    }
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

Result<GoldenPeers> FindGoldenPeers(const fs::path& folder)
{
    GoldenPeers peers;
    const fs::path modules = folder / "node_modules";
    if (!folder.empty())
    {
        peers.odiff = OdiffProgram(modules);
        peers.odiffVersion = VersionOf(modules / "odiff-bin");
        peers.pixelmatchVersion = VersionOf(modules / "pixelmatch");
        peers.pixelmatch = peers.pixelmatchVersion.empty() ? fs::path() : modules / "pixelmatch";
        if (peers.odiff.empty() && peers.pixelmatch.empty())
        {
            return Error{ErrorKind::Unusable, "'" + folder.string() +
                                                  "' holds no peers; run `npm install odiff-bin "
                                                  "pixelmatch` in it, or name another folder."};
        }
    }
    if (!peers.pixelmatch.empty() && !RunMeasured("node", {"--version"}))
    {
        peers.pixelmatch.clear();
        peers.absent.push_back("pixelmatch is not compared: node does not run here; install "
                               "Debian's nodejs.");
    }
    else if (peers.pixelmatch.empty())
    {
        peers.absent.push_back("pixelmatch is not compared; run `npm install pixelmatch` in a "
                               "folder and name it by --peers.");
    }
    if (peers.odiff.empty())
    {
        peers.absent.push_back("odiff is not compared; run `npm install odiff-bin` in a folder and "
                               "name it by --peers.");
    }
    peers.compareVersion = CompareVersion();
    peers.compare = peers.compareVersion.empty() ? "" : "compare";
    if (peers.compare.empty())
    {
        peers.absent.push_back("ImageMagick is not compared: its `compare` does not run here; "
                               "install Debian's imagemagick.");
    }
    return peers;
}

Result<void> TimeProgram(const PairProgram& program, const std::vector<PlantedPair>& pairs,
                         int rounds, const std::function<bool()>& isStopped, GoldenMethod& method)
{
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
        std::vector<std::string> words = program.before;
        words.push_back(pairs[i].expected.string());
        words.push_back(pairs[i].actual.string());
        words.insert(words.end(), program.after.begin(), program.after.end());
        std::vector<double> times;
        for (int round = 0; round < rounds; ++round)
        {
            if (isStopped())
            {
                return Error{ErrorKind::Failed, "Stopped before the comparisons were done."};
            }
            const Result<ChildRun> run = RunMeasured(program.program, words, program.differentCode);
            if (!run)
            {
                return run.GetError();
            }
            times.push_back(run->wall);
            method.verdicts[i].isDifferent = run->code != 0;
        }
        method.verdicts[i].process = MedianOf(std::move(times));
    }
    return {};
}

Result<std::vector<GoldenMethod>> RunGoldenPeers(const GoldenPeers& peers,
                                                 const std::vector<PlantedPair>& pairs, int rounds,
                                                 const fs::path& work,
                                                 const std::function<bool()>& isStopped)
{
    std::vector<GoldenMethod> methods;
    for (const Peer& peer : PeersOf(peers))
    {
        GoldenMethod method;
        method.name = peer.name;
        method.verdicts.resize(pairs.size());
        Result<void> done = TimeProgram(peer.program, pairs, rounds, isStopped, method);
        if (isStopped())
        {
            return done.GetError();
        }
        if (done && !peer.timed.empty())
        {
            done = TimeDecoded(peers, peer, pairs, rounds, work, method);
        }
        method.failure = done ? "" : done.GetError().message;
        methods.push_back(std::move(method));
    }
    return methods;
}

} // namespace boxreel
