// SPDX-License-Identifier: MIT
#include "SourceTree.h"
#include "../base/TemporaryFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace fs = std::filesystem;
using namespace architecture;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

namespace
{

const fs::path kCheckout = BOXREEL_SOURCE_DIR;

std::string Lines(const Findings& findings)
{
    std::string text;
    for (const std::string& finding : findings)
    {
        text += finding + "\n";
    }
    return text;
}

/// A small source tree with planted violations, which test that each rule finds them.
class Checks : public testing::Test
{
protected:
    void Plant(const std::string& path, const std::string& text)
    {
        fs::create_directories((m_root / path).parent_path());
        std::ofstream(m_root / path) << text;
    }

private:
    TemporaryFolder m_folder;

protected:
    const fs::path& m_root = m_folder.Path();
};

} // namespace

// ------------------------------------------------------------------------------ the checkout

TEST(Checkout, IncludesOnlyLowerLayers)
{
    const Findings findings = CheckLayers(kCheckout);
    EXPECT_TRUE(findings.empty()) << Lines(findings);
}

TEST(Checkout, IncludesForeignLibrariesOnlyInTheirWrappers)
{
    const Findings findings = CheckForeignLibraries(kCheckout);
    EXPECT_TRUE(findings.empty()) << Lines(findings);
}

TEST(Checkout, HasALicenceLineShortFilesAndNoMachinePaths)
{
    const Findings findings = CheckFiles(kCheckout);
    EXPECT_TRUE(findings.empty()) << Lines(findings);
}

TEST(Checkout, HasNoTestNameOverSixtyCharacters)
{
    const Findings findings = CheckTestNames(kCheckout);
    EXPECT_TRUE(findings.empty()) << Lines(findings);
}

TEST(Checkout, IsCompiledWithExactArithmetic)
{
    const Findings findings = CheckExactArithmetic(kCheckout, BOXREEL_COMPILE_COMMANDS);
    EXPECT_TRUE(findings.empty()) << Lines(findings);
}

TEST(Checkout, HasNoFolderThatTheBoxreelScriptMisses)
{
    const Findings findings = CheckWatchedFolders(kCheckout);
    EXPECT_TRUE(findings.empty()) << Lines(findings);
}

TEST(Checkout, NamesOnlyFilesThatExist)
{
    const Findings findings = CheckDocumentPaths(kCheckout);
    EXPECT_TRUE(findings.empty()) << Lines(findings);
}

// ------------------------------------------------------------------------------ planted errors

TEST_F(Checks, FindUpwardIncludes)
{
    Plant("engine/include/Box2D/Common/b2Math.h", "#include <Box2D/Collision/b2Shape.h>\n");
    Plant("engine/src/Collision/Tree.cpp", "#include \"Dynamics/State/Island.h\"\n");
    Plant("engine/src/Rope/b2Rope.cpp", "#include <Box2D/Dynamics/b2World.h>\n");
    Plant("engine/include/Box2D/Dynamics/b2World.h", "");
    Plant("engine/src/Dynamics/State/Island.h",
          "#pragma once\n#  include <debugdraw/DrawList.h>\n");
    Plant("engine/src/Dynamics/Joints/Lanes.h", "#include \"../Solver/Blocks.h\"\n");
    Plant("engine/src/Dynamics/Solver/Blocks.h", "#include \"../Joints/Lanes.h\"\n");
    Plant("debugdraw/src/Camera.cpp", "#include <Box2D/Box2D.h>\n");
    Plant("debugdraw/src/Theme.cpp", "#include <debugdraw/DrawCollector.h>\n");
    Plant("render/src/Png.cpp", "#include <recorder/VideoWriter.h>\n");
    Plant("golden/src/Compare.cpp", "#include <golden/StateHash.h>\n");
    Plant("testbed/scenes/Pyramid.cpp", "#include <render/Frame.h>\n");
    Plant("testbed/cli/Main.cpp", "#include \"../../tests/Helper.h\"\n");
    Plant("testbed/session/Condition.cpp", "#include <film/FilmRun.h>\n");
    Plant("testbed/film/FilmRun.h", "");
    Plant("testbed/other/Thing.cpp", "");
    Plant("tests/Helper.h", "");
    EXPECT_THAT(
        CheckLayers(m_root),
        ElementsAre(
            StartsWith("debugdraw/src/Camera.cpp:1: drawlist must not include Box2D/Box2D.h"),
            StartsWith("debugdraw/src/Theme.cpp:1: drawlist must not include"),
            StartsWith("engine/include/Box2D/Common/b2Math.h:1: engine/Common must not include"),
            StartsWith("engine/src/Collision/Tree.cpp:1: engine/Collision must not include"),
            StartsWith("engine/src/Dynamics/Joints/Lanes.h:1: engine/src/Dynamics/Joints must not"),
            StartsWith("engine/src/Dynamics/State/Island.h:2: engine/src/Dynamics/State must not"),
            StartsWith("engine/src/Rope/b2Rope.cpp:1: engine/Rope must not include"),
            StartsWith("golden/src/Compare.cpp:1: golden must not include golden/StateHash.h"),
            StartsWith("render/src/Png.cpp:1: render must not include recorder/VideoWriter.h"),
            StartsWith("testbed/cli/Main.cpp:1: testbed/cli must not include ../../tests/Helper.h"),
            StartsWith("testbed/other/Thing.cpp:1: lies in no layer"),
            StartsWith("testbed/scenes/Pyramid.cpp:1: testbed/scenes must not include render"),
            StartsWith("testbed/session/Condition.cpp:1: testbed/session must not include film")));
}

TEST_F(Checks, AllowDownwardIncludes)
{
    Plant("engine/include/Box2D/Box2D.h", "#include <Box2D/Dynamics/b2World.h>\n");
    Plant("engine/include/Box2D/Dynamics/b2World.h",
          "#include <Box2D/Common/b2Math.h>\n#include <vector>\n");
    Plant("debugdraw/src/DrawCollector.cpp", "#include <Box2D/Box2D.h>\n");
    Plant("golden/src/StateHash.cpp", "#include <Box2D/Box2D.h>\n#include <golden/StateHash.h>\n");
    Plant("testbed/cli/Main.cpp", "#include \"scenes/Scene.h\"\n#include <recorder/Recording.h>\n");
    Plant("testbed/scenes/Scene.h", "#include <Box2D/Box2D.h>\n");
    Plant("tests/render/PngTest.cpp",
          "#include \"Png.h\"\n#include <render/Frame.h>\n#include <png.h>\n");
    EXPECT_THAT(CheckLayers(m_root), IsEmpty());
    EXPECT_THAT(CheckForeignLibraries(m_root), IsEmpty());
}

TEST_F(Checks, FindAFileOutsideEveryLayer)
{
    Plant("engine/src/Misc/Odd.cpp", "");
    Plant("utils/Odd.h", "");
    EXPECT_THAT(CheckLayers(m_root),
                ElementsAre(StartsWith("engine/src/Misc/Odd.cpp:1: lies in no layer"),
                            StartsWith("utils/Odd.h:1: lies in no layer")));
}

TEST_F(Checks, FindAForeignLibraryOutsideItsHome)
{
    Plant("render/src/Png.cpp", "#include <png.h>\n");
    Plant("render/src/Renderer.cpp",
          "#include <png.h>\n#include <GL/osmesa.h>\n#include <unistd.h>\n");
    Plant("recorder/src/FFmpegEncoder.cpp", "extern \"C\" {\n#include <libavcodec/avcodec.h>\n}\n");
    Plant("recorder/src/Recording.cpp", "#include <libavcodec/avcodec.h>\n#include <SDL2/SDL.h>\n");
    Plant("engine/src/Common/Math.cpp",
          "#include <cmath>\n#include <unistd.h>\n#include <immintrin.h>\n");
    EXPECT_THAT(
        CheckForeignLibraries(m_root),
        ElementsAre(StartsWith("engine/src/Common/Math.cpp:2: unistd.h is not of the C++ standard"),
                    StartsWith("recorder/src/Recording.cpp:1: libavcodec/avcodec.h is wrapped"),
                    StartsWith("recorder/src/Recording.cpp:2: SDL2/SDL.h belongs to no known"),
                    StartsWith("render/src/Renderer.cpp:1: png.h is wrapped elsewhere"),
                    StartsWith("render/src/Renderer.cpp:2: GL/osmesa.h is wrapped elsewhere")));
}

TEST_F(Checks, FindMissingLicencesLongFilesAndMachinePaths)
{
    const std::string licence = "// SPDX-License-Identifier: MIT\n";
    std::string blank(701, '\n');
    Plant("render/src/Good.cpp",
          licence + "// see build/ho" + "me/x and https://host/ho" + "me/\n");
    Plant("render/src/Bare.cpp", "#include <vector>\n");
    Plant("render/src/Long.cpp", licence + blank);
    Plant("tests/run.cmake", "set(x \"/ho" + std::string("me/somebody/boxreel\")\n"));
    EXPECT_THAT(CheckFiles(m_root),
                ElementsAre(StartsWith("render/src/Bare.cpp:1: does not open"),
                            StartsWith("render/src/Long.cpp:701: is longer than"),
                            StartsWith("tests/run.cmake:1: names a folder")));
}

TEST_F(Checks, FindTestNamesOverSixtyCharacters)
{
    const std::string kept(54, 'a'); // with "Suite." 60
    // Put together here so as not to find themselves.
    Plant("tests/base/NameTest.cpp", "TE" + ("ST(Suite, " + kept + ")\n") + "TE" +
                                         ("ST_F(Suite, " + kept + "b)\n") + "TE" +
                                         ("ST_P(\n    Suite,\n    " + kept + "c)\n"));
    EXPECT_THAT(CheckTestNames(m_root),
                ElementsAre(StartsWith("tests/base/NameTest.cpp:2: Suite." + kept + "b has 61"),
                            StartsWith("tests/base/NameTest.cpp:3: Suite." + kept + "c has 61")));
}

TEST_F(Checks, FindPythonTestNamesOverSixtyCharacters)
{
    const std::string kept = "test_" + std::string(49, 'a'); // with "Suite." 60
    Plant("tests/python/name_test.py", "class Suite(TestCase):\n    def " + kept +
                                           "(self):\n    def " + kept + "b(self):\ndef " + kept +
                                           "abcdefg():\n");
    EXPECT_THAT(CheckTestNames(m_root),
                ElementsAre(StartsWith("tests/python/name_test.py:3: Suite." + kept + "b has 61"),
                            StartsWith("tests/python/name_test.py:4: " + kept + "abcdefg has 61")));
}

TEST_F(Checks, FindInexactCompileCommands)
{
    const auto entry = [&](const std::string& flags, const std::string& file) {
        return "{\n  \"directory\": \"/b\",\n  \"command\": \"c++ " + flags +
               " -c x\",\n  \"file\": \"" + (m_root / file).string() + "\"\n},\n";
    };
    Plant("compile_commands.json",
          entry("-ffp-contract=off", "engine/Good.cpp") + entry("-O2", "engine/Plain.cpp") +
              entry("-ffp-contract=off -ffp-contract=fast", "render/Undone.cpp") +
              entry("-ffp-contract=off -Ofast", "render/Fast.cpp"));
    EXPECT_THAT(
        CheckExactArithmetic(m_root, m_root / "compile_commands.json"),
        ElementsAre(StartsWith("engine/Plain.cpp: is compiled without -ffp-contract=off"),
                    StartsWith("render/Fast.cpp: is compiled with -Ofast"),
                    StartsWith("render/Undone.cpp: is compiled without -ffp-contract=off")));
    EXPECT_THAT(CheckExactArithmetic(m_root, m_root / "absent.json"),
                Contains(HasSubstr("configure with a preset")));
}

TEST_F(Checks, FindAFolderTheScriptDoesNotWatch)
{
    Plant("boxreel", "#!/bin/sh\nprogramSources='CMakeLists.txt engine'\n");
    Plant("CMakeLists.txt",
          "add_subdirectory(engine)\nadd_subdirectory(render)\nadd_subdirectory(tests)\n");
    EXPECT_THAT(CheckWatchedFolders(m_root),
                ElementsAre(StartsWith("CMakeLists.txt:2: render is missing")));
}

TEST_F(Checks, FindPathsThatDoNotExist)
{
    Plant("engine/src/Solver.cpp", "");
    Plant("ARCHITECTURE.md", "`Solver.cpp`, `src/Solver.cpp`, `engine/src`, `engine/src/S*.cpp`,\n"
                             "`Solver.h`, `engine/include`, `engine/src/T*.cpp`\n"
                             "[code](engine/src) [gone](engine/old) [web](https://a.org/b)\n");
    Plant("docs/notes/solver.md", "[up](../../engine/src/Solver.cpp#top)\n`YourSolver.cpp`\n"
                                  "[gone](engine/src/Solver.cpp)\n");
    Plant("docs/guide.md", "`Absent.cpp`\n");
    EXPECT_THAT(CheckDocumentPaths(m_root),
                ElementsAre(StartsWith("ARCHITECTURE.md:2: names Solver.h"),
                            StartsWith("ARCHITECTURE.md:2: names engine/include"),
                            StartsWith("ARCHITECTURE.md:2: names engine/src/T*.cpp"),
                            StartsWith("ARCHITECTURE.md:3: links to engine/old"),
                            StartsWith("docs/notes/solver.md:3: links to engine/src/Solver.cpp")));
}
