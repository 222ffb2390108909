// SPDX-License-Identifier: MIT
#include "../../base/ReadBytes.h"
#include "ParseLine.h"

#include <cli/CommandTree.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

namespace boxreel
{
namespace
{

using testing::HasSubstr;

template <class Options>
Options Parsed(const std::string& line)
{
    Result<Request> request = Parse(line);
    if (!request)
    {
        ADD_FAILURE() << line << ": " << request.GetError().Text();
        return {};
    }
    return std::get<Options>(*request);
}

/// The culprit of a line that is refused.
std::string Refusal(const std::string& line)
{
    const Result<Request> request = Parse(line);
    if (request)
    {
        return "accepted: " + line;
    }
    EXPECT_EQ(request.GetError().kind, ErrorKind::Unusable) << line;
    return request.GetError().culprit;
}

TEST(CommandLine, GivesRecordTheDefaultsOfTheManual)
{
    const RecordOptions options = Parsed<RecordOptions>("record pyramid -o pyramid.mp4");
    EXPECT_EQ(options.scene, "pyramid");
    EXPECT_EQ(options.output, "pyramid.mp4");
    EXPECT_FALSE(options.length.seconds || options.length.frames) << "ten seconds, unless said";
    EXPECT_EQ(options.film.framesPerSecond, (Rational{60, 1}));
    EXPECT_EQ(options.pace.speed, (Rational{1, 1}));
    EXPECT_EQ(options.film.quality, Quality::Standard);
    EXPECT_EQ(options.messages.progress, ProgressMode::Auto);
    EXPECT_FALSE(options.film.overwrite);
    EXPECT_EQ(options.look.width, 1280);
    EXPECT_EQ(options.look.height, 720);
    EXPECT_FALSE(options.look.simulation.stepsPerSecond ||
                 options.look.simulation.velocityIterations ||
                 options.look.simulation.positionIterations)
        << "as the scene prefers";
    EXPECT_EQ(options.look.simulation.seed, 1u);
    EXPECT_EQ(options.look.view, ViewChoice(SceneView{}))
        << "the camera looks as the scene prefers";
    EXPECT_FALSE(options.look.panels.hud);
}

TEST(CommandLine, ReadsOptionsOfRecord)
{
    const RecordOptions options =
        Parsed<RecordOptions>("record --seconds 2.5 --fps 29.97 --hz 240 --size 640x480 --speed "
                              "0.25 --seed 7 --quality lossless --force "
                              "--progress json --velocity-iterations 10 --position-iterations 4 "
                              "--camera -5,2.5,20 --draw shapes,aabbs "
                              "--labels --hud -o film.mkv bridge");
    EXPECT_EQ(options.scene, "bridge");
    EXPECT_EQ(options.length.seconds, Duration{2'500'000'000});
    EXPECT_EQ(options.film.framesPerSecond, (Rational{2997, 100}));
    EXPECT_EQ(options.pace.speed, (Rational{1, 4}));
    EXPECT_EQ(options.film.quality, Quality::Lossless);
    EXPECT_EQ(options.messages.progress, ProgressMode::Json);
    EXPECT_TRUE(options.film.overwrite);
    EXPECT_EQ(options.look.width, 640);
    EXPECT_EQ(options.look.height, 480);
    EXPECT_EQ(options.look.simulation.stepsPerSecond, (Rational{240, 1}));
    EXPECT_EQ(options.look.simulation.seed, 7u);
    EXPECT_EQ(options.look.simulation.velocityIterations, 10);
    EXPECT_EQ(options.look.simulation.positionIterations, 4);
    EXPECT_EQ(options.look.view, ViewChoice(FixedView{-5.0, 2.5, 20.0}));
    LayerSet layers;
    layers[DrawLayer::Joints] = false;
    layers[DrawLayer::Aabbs] = true;
    EXPECT_EQ(options.look.layers, layers);
    EXPECT_TRUE(options.look.labels);
    EXPECT_TRUE(options.look.panels.hud);
}

TEST(CommandLine, ReadsScalesOfArrows)
{
    const SceneLook plain = Parsed<ShotOptions>("shot bridge --at 1s -o a.png").look;
    EXPECT_EQ(plain.arrows.velocitySeconds, 0.2);
    EXPECT_EQ(plain.arrows.metersPerNewton, std::nullopt) << "what suits the scene";
    const SceneLook look = Parsed<RecordOptions>("record bridge -o a.mp4 --draw forces,velocities "
                                                 "--velocity-scale 0.5 --force-scale 0.001")
                               .look;
    EXPECT_EQ(look.arrows.velocitySeconds, 0.5);
    EXPECT_EQ(look.arrows.metersPerNewton, 0.001);
    EXPECT_TRUE(look.layers[DrawLayer::JointForces] && look.layers[DrawLayer::Velocities] &&
                !look.layers[DrawLayer::Shapes]);
}

TEST(CommandLine, ShowsPanelForHudMilliseconds)
{
    EXPECT_TRUE(Parsed<ShotOptions>("shot bridge --at 1s -o a.png --hud-ms").look.panels.hud);
}

TEST(CommandLine, ReadsTimeOrStepOfShot)
{
    EXPECT_EQ(Parsed<ShotOptions>("shot bridge --at 500ms -o a.png").at,
              std::vector<Duration>{{500'000'000}});
    EXPECT_EQ(Parsed<ShotOptions>("shot bridge --step 180 -o a.png").steps,
              std::vector<std::int64_t>{180});
    EXPECT_EQ(Parsed<ShotOptions>("shot bridge --step 0 -o a.png").steps,
              std::vector<std::int64_t>{0});
}

TEST(CommandLine, ReadsNamesAndFoldersOfGolden)
{
    const GoldenOptions verify =
        Parsed<GoldenOptions>("golden verify pyramid bridge --references r --output o");
    EXPECT_FALSE(verify.accept);
    EXPECT_THAT(verify.names, testing::ElementsAre("pyramid", "bridge"));
    EXPECT_EQ(verify.references, "r");
    EXPECT_EQ(verify.output, "o");
    EXPECT_TRUE(Parsed<GoldenOptions>("golden accept").accept);
}

TEST(CommandLine, ReadsFoldersAndFileOfGoldenReport)
{
    EXPECT_TRUE(Parsed<GoldenReportOptions>("golden report").folders.empty());
    const GoldenReportOptions report = Parsed<GoldenReportOptions>(
        "golden report a b -o page.html --against ../other --backend osmesa --force");
    EXPECT_THAT(report.folders, testing::ElementsAre("a", "b"));
    EXPECT_EQ(report.output, "page.html");
    EXPECT_EQ(report.against, "../other");
    EXPECT_EQ(report.backend, Backend::OSMesa);
    EXPECT_TRUE(report.force);
    EXPECT_EQ(Parsed<GoldenOptions>("golden verify --report page.html").report, "page.html");
    EXPECT_EQ(Refusal("golden accept --report page.html"), "--report");
}

TEST(CommandLine, AcceptsBackendNamesInEveryDrawingCommand)
{
    EXPECT_EQ(Parsed<ShotOptions>("shot a --step 0 -o a.png").backend, Backend::Auto);
    EXPECT_EQ(Parsed<ShotOptions>("shot a --step 0 -o a.png --backend egl").backend, Backend::Egl);
    EXPECT_EQ(Parsed<RecordOptions>("record a -o a.mp4 --backend egl-gpu").backend,
              Backend::EglGpu);
    EXPECT_EQ(Parsed<GoldenOptions>("golden verify --backend osmesa").backend, Backend::OSMesa);
    EXPECT_EQ(Parsed<GoldenOptions>("golden accept a --backend auto").backend, Backend::Auto);
    EXPECT_EQ(Refusal("record a -o a.mp4 --backend gpu"), "--backend gpu");
}

TEST(CommandLine, ReadsPicturesAndPresetOfDiff)
{
    const DiffOptions diff = Parsed<DiffOptions>("diff a.png b.png --preset exact -o d.png");
    EXPECT_EQ(diff.expected, "a.png");
    EXPECT_EQ(diff.actual, "b.png");
    EXPECT_EQ(diff.output, "d.png");
    EXPECT_EQ(diff.compare.preset.preset, "exact");
    EXPECT_EQ(Parsed<DiffOptions>("diff a.png b.png").compare.preset.preset, "same-machine");
}

TEST(CommandLine, RefusesValuesOutOfRange)
{
    const std::string record = "record pyramid -o a.mp4 ";
    for (const char* bad : {"--seconds 0",
                            "--seconds -1",
                            "--seconds nan",
                            "--seconds 10x",
                            "--frames 0",
                            "--frames 1000000000000",
                            "--frames 1.5",
                            "--fps 0",
                            "--fps -60",
                            "--fps inf",
                            "--fps 100000",
                            "--hz 0",
                            "--hz 60hz",
                            "--speed 0",
                            "--speed -1",
                            "--size 0x720",
                            "--size 9999x720",
                            "--size 1280",
                            "--seed -1",
                            "--seed 4294967296",
                            "--quality best",
                            "--progress fancy",
                            "--velocity-iterations 0",
                            "--position-iterations 9999",
                            "--camera 1,2",
                            "--camera 1,2,0",
                            "--camera 1,2,-5",
                            "--camera 1,2,nan",
                            "--camera 1e9,0,5",
                            "--camera fot",
                            "--camera follow:",
                            "--camera path:0s=0,0,5",
                            "--draw",
                            "--draw everything",
                            "--velocity-scale 0",
                            "--velocity-scale -1",
                            "--velocity-scale fast",
                            "--force-scale 0",
                            "--force-scale nan",
                            "--force-scale 1N"})
    {
        EXPECT_EQ(Refusal(record + bad), bad);
    }
    EXPECT_EQ(Refusal(record + "--draw shapes,,joints"), "--draw ''");
    EXPECT_EQ(Refusal("shot pyramid -o a.png --at -3s"), "--at -3s");
    EXPECT_EQ(Refusal("shot pyramid -o a.png --step -1"), "--step -1");
    EXPECT_EQ(Refusal("diff a.png b.png --preset sloppy"), "--preset sloppy");
}

/// A command line that is refused, its culprit, and a word that the remedy must contain, if any.
struct BadLine
{
    const char* line;
    const char* culprit;
    const char* hint = "";
};

class RefusedLine : public testing::TestWithParam<BadLine>
{};

TEST_P(RefusedLine, NamesCulpritAndHint)
{
    const Result<Request> request = Parse(GetParam().line);
    ASSERT_FALSE(request);
    EXPECT_EQ(request.GetError().kind, ErrorKind::Unusable);
    EXPECT_EQ(request.GetError().culprit, GetParam().culprit);
    EXPECT_THAT(request.GetError().remedy, HasSubstr(GetParam().hint));
    EXPECT_EQ(request.GetError().Text().find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Words, RefusedLine,
                         testing::ValuesIn(std::vector<BadLine>{
                             {"recrod pyramid", "'recrod'", "record"},
                             {"record pyramid --secnds 5", "--secnds", "--seconds"},
                             {"golden verfy", "'verfy'", "verify"},
                             {"shot --sise=3x3", "--sise", "--size"},
                             {"list --xylophone", "--xylophone", "boxreel list --help"},
                             {"list -x", "-x", "boxreel list --help"},
                             {"nonsense --help", "'nonsense'", "boxreel --help"},
                             {"help nonsense", "'nonsense'", "boxreel --help"},
                             {"golden nonsense --help", "'nonsense'", "boxreel golden --help"},
                             {"shot a b --at 1s -o x.png", "'b'", "boxreel shot --help"},
                             {"bench", "'bench'", "./boxreel bench"},
                             {"bnech", "'bnech'"},
                             {"bench --accuracy", "'bench'", "./boxreel bench"},
                             {"pictur Pyramid -o x.png", "'pictur'"},
                             {"golden verfy --every 3", "'verfy'", "verify"},
                             {"--sise 3x3 shot", "--sise"}, // before a known one
                             {"golden accept --report page.html", "--report"},
                         }));

TEST(EmptyArgument, IsNamedByEveryCommand)
{
    const std::vector<std::string> lines[] = {{"diff", "", "v.png"},
                                              {"diff", "v.png", ""},
                                              {"shot", "", "--at", "1s", "-o", "a.png"},
                                              {"record", "", "-o", "a.mp4"},
                                              {"check", ""},
                                              {"play", ""},
                                              {"export", "", "-o", "a.json"},
                                              {"golden", "state", ""},
                                              {"golden", "report", ""},
                                              {"merge", "a.mkv", "", "-o", "b.mkv"}};
    for (const std::vector<std::string>& line : lines)
    {
        const Result<Request> request = ParseCommandLine(line);
        ASSERT_FALSE(request) << line.front();
        EXPECT_EQ(request.GetError().kind, ErrorKind::Unusable);
        EXPECT_EQ(request.GetError().culprit, "\"\"") << testing::PrintToString(line);
        EXPECT_NE(request.GetError().remedy, "");
    }
}

INSTANTIATE_TEST_SUITE_P(Missing, RefusedLine,
                         testing::ValuesIn(std::vector<BadLine>{
                             {"record", "record", "boxreel record"},
                             {"record pyramid", "record", "-o"},
                             {"record pyramid -o", "-o"},
                             {"record pyramid --seed=", "--seed"},
                             {"shot", "shot", "boxreel shot"},
                             {"shot pyramid -o a.png", "shot", "--at"},
                             {"shot pyramid --at 3s", "shot", "-o"},
                             {"diff a.png", "diff", "boxreel diff"},
                             {"merge", "merge", "boxreel merge"},
                             {"export pyramid", "export", "-o"},
                             {"check", "check", "boxreel check"},
                             {"play", "play", "boxreel play"},
                             {"golden", "golden", "verify"},
                             {"golden state", "golden state", "pyramid"},
                             {"completion", "completion", "zsh"},
                         }));

INSTANTIATE_TEST_SUITE_P(Conflicts, RefusedLine,
                         testing::ValuesIn(std::vector<BadLine>{
                             {"record a -o a.mp4 --seconds 3 --frames 10", "--seconds"},
                             {"record a -o a.mp4 --resume --force", "--resume"},
                             {"record a -o a.mp4 --skip-done", "--skip-done"},
                             {"record a -o a.mp4 --snapshot-every 5", "--snapshot-every"},
                             {"record a -o a.mp4 --thumbnail-at 1s", "--thumbnail-at"},
                             {"record a -o a.mp4 --fps 5 --fps 6", "--fps"},
                             {"record a -o a.part.mp4", "-o a.part.mp4"},
                             {"shot a -o a.png --at 3s --step 10", "--at"},
                             {"shot a -o a.png --at 3s --at 4s", "--at"},
                             {"shot a -o a.svg --at 3s --stats", "--stats"},
                             {"shot a -o a.svg --at 3s --hud", "--hud"},
                             {"shot a -o a.png --at 1s --hud --size 199x200", "--hud", "--size"},
                             {"record a -o a.mp4 --hud --size 400x128", "--hud", "--size"},
                             {"record a -o a.mp4 --hud-ms --size 400x140", "--hud", "--size"},
                             {"export a -o a.txt", "-o a.txt", ".json"},
                             {"play a.play --resume --force", "--resume"},
                             {"golden verify --every 3", "--every"},
                         }));

INSTANTIATE_TEST_SUITE_P(
    Values, RefusedLine,
    testing::ValuesIn(std::vector<BadLine>{
        {"shot a --at 3s -o a.png --velocity-scale 1e300", "--velocity-scale 1e300"},
        {"shot a --at 3s -o a.png --velocity-scale 1e-9", "--velocity-scale 1e-9"},
        {"shot a --at 3s -o a.png --force-scale 1e300", "--force-scale 1e300"},
        {"shot a --at 3s -o a.png --camera 0,0,1e-5", "--camera 0,0,1e-5"},
        {"shot a --at 3s -o a.png --camera 1234567.5,0,0.1", "--camera 1234567.5,0,0.1"},
        {"shot a --at 3s -o a.png --camera follow:3:1e-5", "--camera follow:3:1e-5"},
        {"shot a --at 3s -o a.png --camera path:0s=0,0,5;3s=0,0,1e9", "--camera path: 3s=0,0,1e9"},
        {"shot a --at 1e6 -o a.png", "--at 1e6"},
        {"shot a --at 1s -o a.png --draw shapes,joint", "--draw joint", "joints"},
        {"shot a --at 1s -o a.png --camera folow:3", "--camera folow:3", "follow"},
        {"record a -o a.mp4 --until 3.sped<1", "--until 3.sped<1", "speed"},
        {"record a -o a.mp4 --until awak==0", "--until awak==0", "awake"},
    }));

INSTANTIATE_TEST_SUITE_P(Mistyped, RefusedLine,
                         testing::ValuesIn(std::vector<BadLine>{
                             {"record a -o a.mp4 --quality hihg", "--quality hihg", "'high'"},
                             {"record a -o a.mp4 --codec h246", "--codec h246", "'h264'"},
                             {"record a -o - --format y5m", "--format y5m", "'y4m'"},
                             {"record a -o a.mp4 --progress jsn", "--progress jsn", "'json'"},
                             {"record a -o a.mp4 --backend OSMESSA", "--backend OSMESSA",
                              "'osmesa'"},
                             {"record a -o a.mp4 --theme darc", "--theme darc", "'dark'"},
                             {"shot a --at 1s -o a.png --theme boht", "--theme boht", "'both'"},
                             {"diff a.png b.png --preset exat", "--preset exat", "'exact'"},
                             {"completion bahs", "SHELL bahs", "'bash'"},
                         }));

TEST(CommandLine, AcceptsThePanelInTheSmallestPicture)
{
    EXPECT_TRUE(
        Parsed<ShotOptions>("shot pyramid --at 1s -o a.png --hud --size 200x130").look.panels.hud);
}

TEST(CommandLine, ShowsHelpWithoutArguments)
{
    EXPECT_THAT(Parsed<TextRequest>("").text, HasSubstr("record"));
}

// A test runs docs/golden.md, so its build path exists.
TEST(CommandLine, NamesOtherBuildInHelpAsInDocumentation)
{
    const std::string text = ReadBytes(BOXREEL_GOLDEN_PAGE);
    for (const char* command : {"golden verify --help", "golden report --help"})
    {
        const std::string help = Parsed<TextRequest>(command).text;
        const std::size_t at = help.find("--against ../");
        ASSERT_NE(at, std::string::npos) << command;
        EXPECT_THAT(text, HasSubstr(help.substr(at, help.find('\n', at) - at))) << command;
    }
}

TEST(CommandLine, PrintsEqualHelpForCommandAndOption)
{
    for (const std::string command : {"record", "golden verify"})
    {
        EXPECT_EQ(Parsed<TextRequest>("help " + command).text,
                  Parsed<TextRequest>(command + " --help").text);
    }
}

TEST(CommandLine, NamesRequiredArgumentsInUsage)
{
    EXPECT_THAT(Parsed<TextRequest>("--help").text, HasSubstr("Usage: boxreel COMMAND\n"));
    EXPECT_THAT(Parsed<TextRequest>("record --help").text,
                HasSubstr("Usage: boxreel record SCENE [OPTIONS]\n"));
    EXPECT_THAT(Parsed<TextRequest>("diff --help").text,
                HasSubstr("Usage: boxreel diff A B [OPTIONS]\n"));
    EXPECT_THAT(Parsed<TextRequest>("golden verify --help").text,
                HasSubstr("Usage: boxreel golden verify [NAMES...] [OPTIONS]\n"));
    EXPECT_THAT(Parsed<TextRequest>("ui --help").text,
                HasSubstr("Usage: boxreel ui [SCENE] [OPTIONS]\n"));
}

TEST(CommandLine, FitsHelpIntoHundredColumns)
{
    const CommandText program = DescribeProgram();
    for (const CommandText* command : AllCommands(program))
    {
        const std::string name = command->path.substr(std::string("boxreel").size());
        std::istringstream help(Parsed<TextRequest>(name + " --help").text);
        for (std::string line; std::getline(help, line);)
        {
            EXPECT_LE(line.size(), 100u) << line;
            EXPECT_TRUE(std::all_of(line.begin(), line.end(), [](char c) { return c > 0; }))
                << "terminals and roff have ASCII all: " << line;
        }
    }
}

TEST(CommandLine, PrintsVersionInOneLine)
{
    EXPECT_EQ(Parsed<TextRequest>("--version").text, "boxreel " BOXREEL_VERSION "\n");
}

} // namespace
} // namespace boxreel
