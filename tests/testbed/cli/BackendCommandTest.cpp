// SPDX-License-Identifier: MIT
// The real program on machines that lack a library to draw with, or have several.
#include "Refusals.h"
#include "Subprocess.h"

#include <render/Png.h>
#include <render/Renderer.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>

namespace boxreel
{
namespace
{

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

bool Works(Backend backend)
{
    return bool(Renderer::Create({.width = 1, .height = 1, .backend = backend}));
}

/// Variables for the programs that a test runs, as they were afterwards.
class Variables
{
public:
    Variables() { Set("BOXREEL_BACKEND", ""); }
    ~Variables()
    {
        for (const auto& [name, value] : m_before)
        {
            value ? setenv(name.c_str(), value->c_str(), 1) : unsetenv(name.c_str());
        }
    }
    Variables(const Variables&) = delete;
    Variables& operator=(const Variables&) = delete;

    void Set(const std::string& name, const std::string& value)
    {
        const char* const before = std::getenv(name.c_str());
        m_before.try_emplace(name, before ? std::optional<std::string>(before) : std::nullopt);
        setenv(name.c_str(), value.c_str(), 1);
    }

private:
    std::map<std::string, std::optional<std::string>> m_before;
};

class BackendCommand : public testing::Test
{
protected:
    Outcome Run(const std::vector<std::string>& arguments) const
    {
        return RunBoxreel(arguments, folder.Path());
    }

    /// The loader finds a file of this name first, which is no library.
    void Break(const std::string& library)
    {
        std::ofstream(broken / library) << "This is not a library, however long it may be; it only "
                                           "stands where one would be looked for.";
        variables.Set("LD_LIBRARY_PATH", broken.Path().string());
    }

    /// Returns the bytes of a small picture; empty if there is none.
    std::string Shot(const std::vector<std::string>& options = {}) const
    {
        std::vector<std::string> arguments{"shot",   "bridge",  "--step",   "9",
                                           "--size", "240x160", "--labels", "--hud",
                                           "-o",     "a.png",   "--force"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Outcome outcome = Run(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        return outcome.code == 0 ? ReadBytes(folder / "a.png") : "";
    }

    /// The shared libraries that the program loads, by what the loader reports.
    std::string LoadedBy(const std::vector<std::string>& arguments, int code = 0)
    {
        const TemporaryFolder reports;
        Variables own;
        own.Set("LD_DEBUG", "files");
        own.Set("LD_DEBUG_OUTPUT", (reports / "report").string());
        const Outcome outcome = Run(arguments);
        EXPECT_EQ(outcome.code, code) << outcome.errors;
        std::string loaded;
        for (const std::string& file : reports.Names())
        {
            loaded += ReadBytes(reports / file);
        }
        return loaded;
    }

    TemporaryFolder folder;
    TemporaryFolder broken;
    Variables variables;
};

TEST_F(BackendCommand, RefusesMissingBackendsBeforeSimulation)
{
    Break("libOSMesa.so.8");
    Break("libEGL.so.1");
    // A simulation of this length would outlast the test's time limit.
    const std::vector<std::string> commands[] = {
        {"shot", "pyramid", "--step", "1000000000", "-o", "a.png"},
        {"record", "pyramid", "--frames", "10000000", "-o", "a.mkv"},
        {"golden", "accept", "--references", "r"}};
    for (const std::vector<std::string>& command : commands)
    {
        const Outcome outcome = Run(command);
        ExpectRefused(outcome, "back end auto", 3);
        EXPECT_EQ(outcome.output, "");
        EXPECT_THAT(outcome.errors,
                    ContainsRegex("osmesa: libOSMesa.so.8.*egl: libEGL.so.1.*apt install"));
        EXPECT_THAT(folder.Names(), IsEmpty()) << command[0];
    }
}

TEST_F(BackendCommand, RunsCommandsWithoutPixelsWithoutGl)
{
    Break("libOSMesa.so.8");
    Break("libEGL.so.1");
    EXPECT_TRUE(WritePng(folder / "a.png", Frame(4, 4)));
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"list"},
                                                      {"--help"},
                                                      {"record", "--help"},
                                                      {"completion", "bash"},
                                                      {"man"},
                                                      {"--version"},
                                                      {"diff", "a.png", "a.png"}})
    {
        EXPECT_EQ(Run(arguments).code, 0) << testing::PrintToString(arguments);
    }
}

TEST_F(BackendCommand, PassesDoctorWithOneWorkingBackend)
{
    if (!Works(Backend::Egl))
    {
        GTEST_SKIP() << "EGL is not on this machine";
    }
    Break("libOSMesa.so.8");
    const Outcome one = Run({"doctor"});
    EXPECT_EQ(one.code, 0) << one.output;
    EXPECT_THAT(one.output, AllOf(HasSubstr("none  OSMesa "), HasSubstr("ok    EGL "),
                                  Not(HasSubstr("FAIL")), Not(HasSubstr("libosmesa6"))));
    Break("libEGL.so.1");
    const Outcome none = Run({"doctor"});
    EXPECT_EQ(none.code, 3) << none.output;
    EXPECT_THAT(none.output, AllOf(HasSubstr("FAIL  OSMesa "), HasSubstr("FAIL  EGL "),
                                   HasSubstr("ok    mp4"), HasSubstr("ok    engine")));
}

TEST_F(BackendCommand, FailsDoctorWhenVariableSelectsBrokenBackend)
{
    const std::vector<std::string> shot{"shot", "bridge", "--step", "0", "-o", "b.png"};
    for (const auto& [name, code] : {std::pair{"foo", 1}, {"osmesa", 3}, {"egl-gpu", 3}})
    {
        variables.Set("BOXREEL_BACKEND", name);
        Break("libOSMesa.so.8");
        const Outcome drawn = Run(shot);
        if (drawn.code == 0)
        {
            continue; // a machine with a GPU
        }
        ExpectRefused(drawn, "BOXREEL_BACKEND " + std::string(name), code);
        const Outcome doctor = Run({"doctor"});
        EXPECT_EQ(doctor.code, code) << doctor.output;
        const std::string sentence = drawn.errors.substr(std::string("boxreel: ").size());
        EXPECT_THAT(doctor.output, HasSubstr("FAIL  BOXREEL_BACKEND " + sentence));
        EXPECT_THAT(doctor.output,
                    AllOf(Not(HasSubstr("FAIL  OSMesa")), HasSubstr("none  OSMesa")));
    }
}

TEST_F(BackendCommand, ReportsBackendOfVariableInDoctor)
{
    if (!Works(Backend::Egl))
    {
        GTEST_SKIP() << "EGL is not on this machine";
    }
    variables.Set("BOXREEL_BACKEND", "egl");
    const Outcome doctor = Run({"doctor"});
    EXPECT_EQ(doctor.code, 0) << doctor.output;
    EXPECT_THAT(doctor.output, HasSubstr("ok    BOXREEL_BACKEND egl, so EGL, "));
}

TEST_F(BackendCommand, LoadsOnlyTheLibraryThatDraws)
{
    EXPECT_TRUE(WritePng(folder / "a.png", Frame(4, 4)));
    const std::string forPicture = LoadedBy({"diff", "a.png", "a.png"});
    if (forPicture.find("libpng") == std::string::npos)
    {
        GTEST_SKIP() << "the loader of this system does not report what it loads";
    }
    const auto noGl = AllOf(Not(HasSubstr("libOSMesa")), Not(HasSubstr("libEGL")),
                            Not(HasSubstr("libGL")), Not(HasSubstr("libavcodec")));
    EXPECT_THAT(forPicture, noGl);
    EXPECT_THAT(LoadedBy({"list"}), noGl);
    EXPECT_THAT(LoadedBy({"record", "--help"}), noGl);
    EXPECT_THAT(LoadedBy({"completion", "zsh"}), noGl);
    EXPECT_THAT(LoadedBy({"man"}), noGl);
    EXPECT_THAT(LoadedBy({"shot", "pyrmid", "--at", "1s", "-o", "b.png"}, 1), noGl);
    const std::vector<std::string> shot{"shot", "bridge", "--step",  "0",
                                        "-o",   "b.png",  "--force", "--backend"};
    for (const auto& [backend, library, other] :
         {std::tuple{"osmesa", "libOSMesa", "libEGL"}, {"egl", "libEGL", "libOSMesa"}})
    {
        if (Works(*ParseBackend("", backend)))
        {
            std::vector<std::string> arguments = shot;
            arguments.emplace_back(backend);
            EXPECT_THAT(LoadedBy(arguments), AllOf(HasSubstr(library), Not(HasSubstr(other))));
        }
    }
}

TEST_F(BackendCommand, WritesEqualBytesWithEveryBackend)
{
    if (!Works(Backend::OSMesa) || !Works(Backend::Egl))
    {
        GTEST_SKIP() << "one of OSMesa and EGL is not on this machine";
    }
    const std::string picture = Shot({"--backend", "osmesa"});
    EXPECT_EQ(Shot({"--backend", "egl"}), picture);
    EXPECT_EQ(Shot({"--backend", "auto"}), picture);
    const std::vector<std::string> film{"record", "bridge", "--frames", "5", "--size", "160x90"};
    const auto record = [&](const std::string& name, const std::string& backend) {
        std::vector<std::string> arguments = film;
        arguments.insert(arguments.end(), {"-o", name, "--backend", backend});
        EXPECT_EQ(Run(arguments).code, 0) << backend;
        return ReadBytes(folder / name);
    };
    EXPECT_EQ(record("a.gif", "osmesa"), record("b.gif", "egl"));
    EXPECT_EQ(
        Run({"golden", "accept", "bridge/0.5s", "--references", "r", "--backend", "osmesa"}).code,
        0);
    EXPECT_EQ(Run({"golden", "verify", "bridge/0.5s", "--references", "r", "--output", "o",
                   "--backend", "egl"})
                  .code,
              0);
}

// Mesa keeps compiled shaders without saying for which width of vectors they are; those of another
// width write beyond their memory.
TEST_F(BackendCommand, UsesNoShadersOfOtherVectorWidths)
{
    if (!Works(Backend::Auto))
    {
        GTEST_SKIP() << "nothing to draw with is on this machine";
    }
    const TemporaryFolder cache;
    variables.Set("MESA_SHADER_CACHE_DIR", cache.Path().string());
    variables.Set("LP_NATIVE_VECTOR_WIDTH", "128");
    const std::string narrow = Shot();
    EXPECT_THAT(cache.Names(), IsEmpty());
    unsetenv("LP_NATIVE_VECTOR_WIDTH");
    EXPECT_EQ(Shot(), narrow);
}

TEST_F(BackendCommand, RefusesVectorWidthsThatMesaCrashesWith)
{
    if (!Works(Backend::Auto))
    {
        GTEST_SKIP() << "nothing to draw with is on this machine";
    }
    const std::string picture = Shot();
    for (const char* width : {"0", "64", "512", "wide"})
    {
        variables.Set("LP_NATIVE_VECTOR_WIDTH", width);
        const Outcome shot = Run({"shot", "bridge", "--step", "0", "-o", "b.png"});
        EXPECT_EQ(shot.code, 1) << width;
        EXPECT_THAT(shot.errors, HasSubstr(std::string("LP_NATIVE_VECTOR_WIDTH '") + width + "'"));
        EXPECT_EQ(std::count(shot.errors.begin(), shot.errors.end(), '\n'), 1) << shot.errors;
    }
    const Outcome doctor = Run({"doctor"});
    EXPECT_EQ(doctor.code, 1);
    EXPECT_THAT(doctor.output, ContainsRegex("FAIL  OSMesa +LP_NATIVE_VECTOR_WIDTH 'wide'"));
    EXPECT_THAT(doctor.output, ContainsRegex("FAIL  EGL +LP_NATIVE_VECTOR_WIDTH 'wide'"));
    variables.Set("LP_NATIVE_VECTOR_WIDTH", "");
    EXPECT_EQ(Shot(), picture) << "an empty one asks for nothing";
}

TEST_F(BackendCommand, PrefersOptionToVariableToDefaultOrder)
{
    if (!Works(Backend::OSMesa) || !Works(Backend::Egl))
    {
        GTEST_SKIP() << "one of OSMesa and EGL is not on this machine";
    }
    const std::string picture = Shot();
    Break("libOSMesa.so.8");
    EXPECT_EQ(Shot(), picture) << "the next one draws";
    variables.Set("BOXREEL_BACKEND", "osmesa");
    const Outcome forced = Run({"shot", "bridge", "--step", "0", "-o", "b.png"});
    ExpectRefused(forced, "BOXREEL_BACKEND osmesa", 3);
    EXPECT_THAT(forced.errors, AllOf(HasSubstr("libOSMesa.so.8"), Not(HasSubstr("libEGL"))));
    EXPECT_EQ(Shot({"--backend", "egl"}), picture);
    variables.Set("BOXREEL_BACKEND", "egl");
    EXPECT_EQ(Shot(), picture);
    const std::vector<std::string> commands[] = {
        {"shot", "bridge", "--step", "0", "-o", "b.png"},
        {"record", "bridge", "--frames", "1", "-o", "b.gif"},
        {"golden", "accept", "bridge/0.5s", "--references", "r"},
        {"golden", "verify", "bridge/0.5s", "--references", "."}};
    for (std::vector<std::string> command : commands)
    {
        command.insert(command.end(), {"--backend", "osmesa"});
        const Outcome named = Run(command);
        ExpectRefused(named, "back end osmesa", 3);
        EXPECT_THAT(named.errors, HasSubstr("libOSMesa.so.8")) << testing::PrintToString(command);
    }
}

TEST_F(BackendCommand, RefusesUnknownBackends)
{
    const std::vector<std::string> shot{"shot", "pyramid", "--step", "1000000000", "-o", "a.png"};
    std::vector<std::string> option = shot;
    option.insert(option.end(), {"--backend", "glx"});
    const Outcome byOption = Run(option);
    EXPECT_EQ(byOption.code, 1);
    EXPECT_THAT(byOption.errors, StartsWith("boxreel: --backend glx: "));
    variables.Set("BOXREEL_BACKEND", "glx");
    const Outcome byVariable = Run(shot);
    EXPECT_EQ(byVariable.code, 1);
    EXPECT_THAT(byVariable.errors, StartsWith("boxreel: BOXREEL_BACKEND glx: "));
    EXPECT_EQ(Run({"list"}).code, 0) << "which draws nothing";
}

} // namespace
} // namespace boxreel
