// SPDX-License-Identifier: MIT
// One renderer's program: `list`; `error CASE`, how far its edges are from the truth; `time CASE
// THREADS`, what its frames take. Output is JSON: one line a case, or a method. The
// runner (bench.py) runs the programs in turn.
#include "Painter.h"
#include "RenderScene.h"

#include "../render/Truth.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace bench
{
namespace
{

using namespace boxreel;

constexpr double kMinTimed = 0.3; ///< of a work: long enough for a median [s]
constexpr std::size_t kMinFrames = 10;
constexpr std::size_t kMaxFrames = 400;

/// One view of one list.
struct Shown
{
    DrawList list;
    Camera camera;
};

/// Frames of one kind: the two are drawn in turn, so each frame has the same to do.
struct Work
{
    const char* name;
    Shown before, after;
};

/// The times of a frame [s].
struct Times
{
    double cpu = 0.0; ///< of the whole process, the library's threads included
    double wall = 0.0;
    double submit = 0.0; ///< share of `wall`
    double read = 0.0;   ///< share of `wall`
};

double CpuTime()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

double WallTime()
{
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

Camera MovedAside(Camera camera)
{
    camera.centerX += 1.0; // m
    return camera;
}

/// An empty list changes by its camera, so that it is drawn at all.
std::vector<Work> WorksOf(const RenderCase& one, bool drawsOnlyWhatChanged)
{
    const Camera camera = CameraOf(one);
    const auto shown = [&](Change change) { return Shown{MakeRenderScene(one, change), camera}; };
    const Shown still = shown(Change::None);
    std::vector<Work> works{{"full", still, shown(Change::All)},
                            {"empty", {{}, camera}, {{}, MovedAside(camera)}}};
    if (drawsOnlyWhatChanged)
    {
        works.push_back({"together", still, shown(Change::Together)});
        works.push_back({"apart", still, shown(Change::Apart)});
        works.push_back({"none", still, still});
    }
    return works;
}

Result<void> Draw(Painter& painter, const Shown& shown)
{
    Result<void> done = painter.Submit(shown.list, shown.camera);
    return done ? painter.Read() : done;
}

/// The picture when everything before it was another one.
Result<Frame> FromScratch(Painter& painter, const Shown& shown)
{
    Result<void> done = Draw(painter, {{}, MovedAside(MovedAside(shown.camera))});
    done = done ? Draw(painter, shown) : done;
    return done ? Result<Frame>(painter.Picture()) : Result<Frame>(done.GetError());
}

/// True if the incremental picture equals the one drawn from scratch.
Result<bool> IsSameAsFromScratch(Painter& painter, const Work& work)
{
    const Result<Frame> expected = FromScratch(painter, work.after);
    const Result<Frame> before = expected ? FromScratch(painter, work.before) : expected;
    const Result<void> done = before ? Draw(painter, work.after) : Result<void>(before.GetError());
    return done ? Result<bool>(painter.Picture() == *expected) : Result<bool>(done.GetError());
}

double Median(std::vector<double> values)
{
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

Times MedianOf(const std::vector<Times>& frames)
{
    Times result;
    for (double Times::*number : {&Times::cpu, &Times::wall, &Times::submit, &Times::read})
    {
        std::vector<double> values;
        for (const Times& frame : frames)
        {
            values.push_back(frame.*number);
        }
        result.*number = Median(std::move(values));
    }
    return result;
}

Result<Times> TimeWork(Painter& painter, const Work& work)
{
    std::vector<Times> frames;
    const double begin = WallTime();
    while (frames.size() < kMinFrames ||
           (frames.size() < kMaxFrames && WallTime() - begin < kMinTimed))
    {
        const Shown& shown = frames.size() % 2 == 0 ? work.before : work.after;
        const double cpu = CpuTime();
        const double start = WallTime();
        if (const Result<void> done = painter.Submit(shown.list, shown.camera); !done)
        {
            return done.GetError();
        }
        const double submitted = WallTime();
        if (const Result<void> done = painter.Read(); !done)
        {
            return done.GetError();
        }
        const double end = WallTime();
        frames.push_back({CpuTime() - cpu, end - start, submitted - start, end - submitted});
    }
    return MedianOf(frames);
}

std::string Json(const char* name, const Times& times)
{
    char text[200];
    std::snprintf(text, sizeof text,
                  "\"%s\":{\"cpu\":%.4g,\"wall\":%.4g,\"submit\":%.4g,\"read\":%.4g}", name,
                  times.cpu, times.wall, times.submit, times.read);
    return text;
}

/// Prints the error and returns the exit code.
int Fail(const Error& error)
{
    std::fprintf(stderr, "%s\n", error.Text().c_str());
    return int(error.kind);
}

Result<void> TimeMethod(const RenderCase& one, const Method& method)
{
    const Result<std::unique_ptr<Painter>> painter = method.make(one.width, one.height);
    if (!painter)
    {
        return painter.GetError();
    }
    std::string works, wrong;
    for (const Work& work : WorksOf(one, method.drawsOnlyWhatChanged))
    {
        const Result<bool> same = IsSameAsFromScratch(**painter, work);
        if (!same)
        {
            return same.GetError();
        }
        wrong = *same || !wrong.empty() ? wrong : work.name;
        const Result<Times> times = TimeWork(**painter, work);
        if (!times)
        {
            return times.GetError();
        }
        works += works.empty() ? "" : ",";
        works += Json(work.name, *times);
    }
    if (method.makeFloor)
    {
        const Result<std::unique_ptr<Painter>> floor = method.makeFloor(one.width, one.height);
        const Result<Times> times = floor ? TimeWork(**floor, {"floor", {{}, CameraOf(one)}, {}})
                                          : Result<Times>(floor.GetError());
        if (!times)
        {
            return times.GetError();
        }
        works += ",";
        works += Json("floor", *times);
    }
    std::printf("{\"method\":\"%s\",\"by\":\"%s\",\"works\":{%s},\"wrong\":\"%s\"}\n",
                method.name.c_str(), (*painter)->Description().c_str(), works.c_str(),
                wrong.c_str());
    return {};
}

/// `threads` is for Mesa, which reads it when it is loaded; "own": as whoever started us has it.
int TimeAll(const RenderCase& one, const std::string& threads)
{
    if (threads != "own" && (threads.empty() || threads.size() > 3 ||
                             threads.find_first_not_of("0123456789") != std::string::npos))
    {
        return Fail({ErrorKind::Unusable,
                     "'" + threads + "' is no number of threads from 0 to 999; or say own."});
    }
    if (threads != "own")
    {
        setenv("LP_NUM_THREADS", threads.c_str(), 1);
    }
    for (const Method& method : Methods())
    {
        if (const Result<void> done = TimeMethod(one, method); !done)
        {
            return Fail(done.GetError());
        }
    }
    return 0;
}

int PrintErrors(const RenderCase& one)
{
    const Shown shown{MakeRenderScene(one, Change::None), CameraOf(one)};
    const TruthPicture truth = Supersample(shown.list, shown.camera, Theme::Classic());
    for (const Method& method : Methods())
    {
        const Result<std::unique_ptr<Painter>> painter = method.make(one.width, one.height);
        const Result<void> drawn =
            painter ? Draw(**painter, shown) : Result<void>(painter.GetError());
        if (!drawn)
        {
            return Fail(drawn.GetError());
        }
        const EdgeError error = Compare((*painter)->Picture(), truth);
        std::printf("{\"method\":\"%s\",\"usual\":%s,\"rms\":%.4g,\"most\":%.4g,"
                    "\"edgePixels\":%zu}\n",
                    method.name.c_str(), method.isUsual ? "true" : "false", error.rms,
                    error.maximum, error.edgePixels);
    }
    return 0;
}

int List()
{
    for (const RenderCase& one : AllRenderCases())
    {
        std::printf("{\"case\":\"%s\",\"what\":\"%d shapes at %d x %d\",\"shapes\":%d,\"width\":%d,"
                    "\"height\":%d}\n",
                    one.name.c_str(), one.count, one.width, one.height, one.count, one.width,
                    one.height);
    }
    return 0;
}

const RenderCase* FindCase(const std::string& name)
{
    for (const RenderCase& one : AllRenderCases())
    {
        if (one.name == name)
        {
            return &one;
        }
    }
    std::fprintf(stderr, "No case of drawing is called '%s'; `list` names them all.\n",
                 name.c_str());
    return nullptr;
}

} // namespace
} // namespace bench

int main(int count, char** words)
{
    const std::string command = count > 1 ? words[1] : "";
    if (command == "list" && count == 2)
    {
        return bench::List();
    }
    if ((command == "error" && count == 3) || (command == "time" && count == 4))
    {
        const bench::RenderCase* const one = bench::FindCase(words[2]);
        return one == nullptr      ? 1
               : command == "time" ? bench::TimeAll(*one, words[3])
                                   : bench::PrintErrors(*one);
    }
    std::fprintf(stderr, "Usage: %s list | error CASE | time CASE THREADS\n", words[0]);
    return 1;
}
