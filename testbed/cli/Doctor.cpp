// SPDX-License-Identifier: MIT
#include "Doctor.h"
// `boxreel doctor`: tests which parts of the program work on this machine. Each part is really run.
#include "Declare.h"
#include "SelfTest.h"

#include <base/Bytes.h>
#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <base/WorkFolder.h>
#include <options/OptionNames.h>
#include <page/PageWriter.h>
#include <recorder/VideoWriter.h>
#include <render/Backend.h>
#include <render/Figure.h>
#include <render/Renderer.h>
#include <render/Window.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <thread>
#include <unistd.h>

namespace boxreel
{
namespace
{

namespace fs = std::filesystem;

constexpr std::uintmax_t kLittleRoom = 1'000'000'000; ///< a film of some minutes, lossless [bytes]

/// The text of a line, or an error with its remedy.
using Finding = Result<std::string>;

struct Trial
{
    std::string name;
    std::function<Finding()> look;
};

std::string WideInstructions()
{
#if defined(__x86_64__) && defined(__GNUC__)
    const bool has512 =
        __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0;
    return has512                                ? "x86-64 with AVX-512"
           : __builtin_cpu_supports("avx2") != 0 ? "x86-64 with AVX2"
                                                 : "x86-64 without AVX2";
#elif defined(__aarch64__)
    return "ARM with NEON";
#else
    return "a processor without wide instructions";
#endif
}

Finding LookAtEngine()
{
    const std::uint64_t state = RunSelfTest();
    if (state != kSelfTestState)
    {
        return Error{ErrorKind::Different, "self-test",
                     "ends in state " + HexText(state) + " instead of " + HexText(kSelfTestState),
                     "build again without custom compiler options"};
    }
    return "self-test " + HexText(state) + ", " + WideInstructions() + ", " +
           std::to_string(std::max(1u, std::thread::hardware_concurrency())) + " processors";
}

Finding LookAtBackend(Backend backend)
{
    ASSIGN_OR_RETURN(Renderer renderer,
                     Renderer::Create({.width = 64, .height = 64, .backend = backend}));
    DrawList list;
    list.AddSegment({-1.0f, 0.0f}, {1.0f, 0.0f}, Color{255, 255, 255, 255});
    Frame frame;
    const Camera camera{.width = 64, .height = 64};
    RETURN_IF_ERROR(renderer.Draw(list, camera, frame));
    return renderer.Description();
}

Finding LookAtFilm(const fs::path& folder, const std::string& name, const std::string& codec,
                   Quality quality)
{
    VideoSettings settings;
    settings.width = settings.height = 64;
    settings.codec = codec;
    settings.overwrite = true;
    settings.quality = quality;
    ASSIGN_OR_RETURN(VideoWriter writer, VideoWriter::Open(folder / name, settings));
    Frame frame;
    frame.width = frame.height = 64;
    frame.rgba.assign(std::size_t(4) * 64 * 64, 255);
    for (int i = 0; i < 3; ++i)
    {
        frame.rgba[std::size_t(4 * i)] = 0;
        RETURN_IF_ERROR(writer.Append(frame));
    }
    const Result<void> closed = writer.Close();
    return closed ? Finding("a film of three frames") : closed.GetError();
}

Finding LookAtPage(const fs::path& folder)
{
    ASSIGN_OR_RETURN(PageWriter page,
                     PageWriter::Open(folder / "a.html", {.width = 64, .height = 64}));
    const Camera camera{.width = 64, .height = 64};
    for (int i = 0; i < 3; ++i)
    {
        DrawList list;
        list.AddSegment({-1.0f, 0.0f}, {1.0f, float(i)}, Color{255, 255, 255, 255});
        RETURN_IF_ERROR(page.Append(list, camera));
    }
    const Result<void> closed = page.Close();
    return closed ? Finding("a page of three frames") : closed.GetError();
}

Finding LookAtFigures()
{
    const Result<void> prepared = PreparePdf();
    return prepared ? Finding("Cairo and the font DejaVu Sans") : prepared.GetError();
}

Finding LookAtDisk()
{
    std::error_code error;
    const fs::path folder = fs::current_path(error);
    const fs::space_info space = error ? fs::space_info{} : fs::space(folder, error);
    if (error)
    {
        return Error{ErrorKind::Failed, "current folder", error.message(),
                     "change to another folder"};
    }
    char room[40];
    std::snprintf(room, sizeof room, "%.1f GB", double(space.available) / 1e9);
    if (::access(folder.c_str(), W_OK) != 0)
    {
        return Error{ErrorKind::Failed, folder.string(), "is not writable",
                     "change to another folder or name one with -o"};
    }
    if (space.available < kLittleRoom)
    {
        return Error{ErrorKind::Failed, folder.string(), std::string("only ") + room + " free",
                     "free some space or name another folder with -o"};
    }
    return std::string(room) + " free in " + folder.string();
}

/// Only the window needs one; one that is named must be there.
Finding LookAtDisplay()
{
    const char* const name = std::getenv("DISPLAY");
    if (name == nullptr || *name == '\0')
    {
        return std::string("no screen is named; only `boxreel ui` needs one");
    }
    const Result<void> display = CheckDisplay();
    return display ? Finding(std::string("DISPLAY is ") + name)
                   : Error{ErrorKind::Absent, TextInOptions(display.GetError()), "",
                           "start it, or unset DISPLAY; record, shot and play need no display"};
}

/// Writes a line for each thing, and keeps the exit code of the first that does not work.
class Report
{
public:
    void Add(const std::string& name, const Finding& finding)
    {
        Write(finding ? "ok  " : Red("FAIL", stdout), name,
              finding ? *finding : TextInOptions(finding.GetError()));
        if (!finding && m_code == 0)
        {
            m_code = static_cast<int>(finding.GetError().kind);
        }
    }

    /// Adds a part that is neither available nor needed.
    void AddNone(const std::string& name, const std::string& why) { Write("none", name, why); }

    /// An Error when the lines could not be written.
    Result<int> Code() const { return m_written ? Result<int>(m_code) : m_written.GetError(); }

private:
    void Write(const std::string& status, std::string name, std::string text)
    {
        name.resize(std::max<std::size_t>(name.size(), 12), ' ');
        std::replace(text.begin(), text.end(), '\n', ' ');
        if (m_written)
        {
            m_written = WriteOutput(status + "  " + name + " " + text + "\n");
        }
    }

    Result<void> m_written;
    int m_code = 0;
};

/// One back end is sufficient. Mesa 25.1 and later have no OSMesa, so its package is not required
/// where EGL works. If the variable names a back end, only that one is required.
void AddBackends(Report& report)
{
    const Finding osMesa = LookAtBackend(Backend::OSMesa);
    const Finding egl = LookAtBackend(Backend::Egl);
    const char* const variable = std::getenv(kBackendVariable);
    const bool isNamed = variable != nullptr && *variable != '\0';
    const auto add = [&report, isNamed](const char* name, const Finding& finding,
                                        const std::string& otherName, const Finding& other) {
        if (!finding && (other || isNamed))
        {
            report.AddNone(name, isNamed ? std::string("see ") + kBackendVariable
                                         : otherName + " is used instead");
            return;
        }
        report.Add(name, finding);
    };
    add("OSMesa", osMesa, "EGL", egl);
    add("EGL", egl, "OSMesa", osMesa);
    if (isNamed)
    {
        const Finding drawn = LookAtBackend(Backend::Auto);
        report.Add(kBackendVariable,
                   drawn ? Finding(std::string(variable) + ", so " + *drawn) : drawn);
    }
}

} // namespace

Result<int> Run(const DoctorOptions&)
{
    const Result<WorkFolder> scratch = WorkFolder::Create();
    const auto film = [&scratch](const char* name, const char* codec,
                                 Quality quality = Quality::Draft) {
        return [&scratch, name, codec, quality] {
            return scratch ? LookAtFilm(scratch->Path(), name, codec, quality)
                           : Finding(scratch.GetError());
        };
    };
    const Trial trials[] = {
        {"mp4, H.264", film("h264.mp4", "h264")},
        {"webm, VP9", film("vp9.webm", "vp9")},
        {"webm, AV1", film("av1.webm", "av1")},
        {"mkv, FFV1", film("ffv1.mkv", "ffv1", Quality::Lossless)},
        {"gif", film("a.gif", "")},
        {"apng", film("a.apng", "")},
        {"webp", film("a.webp", "")},
        {"png", film("a-#.png", "")},
        {"html",
         [&scratch] {
             return scratch ? LookAtPage(scratch->Path()) : Finding(scratch.GetError());
         }},
        {"pdf", LookAtFigures},
        {"disk", LookAtDisk},
        {"display", LookAtDisplay},
    };
    Report report;
    report.Add("engine", LookAtEngine());
    AddBackends(report);
    for (const Trial& trial : trials)
    {
        report.Add(trial.name, trial.look());
    }
    return report.Code();
}

Command& Declare(Command& program, DoctorOptions&)
{
    Command& command = AddCommand(program, "doctor", "Test what works on this machine");
    command.notes = {
        {"Tries every back end, format and library. A line that fails shows the remedy.\n"
         "Exit code 0: all works (one of the back ends is enough), 1: an environment variable is\n"
         "invalid, 2: the engine's self-test has another result, 3: something is not installed,\n"
         "4: no space or no permission to write here."}};
    command.examples = {"boxreel doctor"};
    return command;
}

} // namespace boxreel
