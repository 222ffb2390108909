// SPDX-License-Identifier: MIT
// The helper of the film benchmark. `list` prints the cases, `films` the films of one with their
// arguments. `raw` draws the frames of a film as bare pixels. `encode` becomes ffmpeg, which
// encodes them. `immediate` draws the classic way and pipes the pixels to ffmpeg. `check` compares
// a film with the raw frames. Output is JSON, one object per line.
#include "ImmediateDraw.h"
#include "RecordCases.h"

#include <base/Result.h>
#include <options/Values.h>
#include <recorder/VideoReader.h>
#include <render/Renderer.h>
#include <session/SceneSession.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bench
{
namespace
{

using namespace boxreel;

/// A part of a scene that is recorded, at 60 frames a second.
struct Take
{
    std::string scene;
    std::int64_t frames = 0;
    int width = 0;   ///< [px]
    int height = 0;  ///< [px]
    Duration from{}; ///< simulated before the first frame
    std::size_t FrameBytes() const { return std::size_t(width) * std::size_t(height) * 4; }
};

Error Failed(const std::string& sentence)
{
    return Error{ErrorKind::Failed, sentence};
}

Error SystemError(const std::string& what)
{
    return Failed(what + ": " + std::strerror(errno) + ".");
}

/// Owns a file or the end of a pipe and closes it.
class Descriptor
{
public:
    explicit Descriptor(int number) : m_number(number) {}
    ~Descriptor() { Close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int Number() const { return m_number; }
    void Close()
    {
        if (m_number >= 0)
        {
            close(m_number);
        }
        m_number = -1;
    }

private:
    int m_number;
};

Result<void> WriteAll(int file, const std::uint8_t* bytes, std::size_t count)
{
    while (count > 0)
    {
        const ssize_t written = write(file, bytes, count);
        if (written < 0 && errno != EINTR)
        {
            return SystemError("The pixels of a frame cannot be written");
        }
        bytes += std::max<ssize_t>(written, 0);
        count -= std::size_t(std::max<ssize_t>(written, 0));
    }
    return {};
}

/// The scene as `boxreel record` has it, at its frames one after the other.
class Shooting
{
public:
    static Result<Shooting> Open(const Take& take)
    {
        Result<SceneSource> source = OpenScene(take.scene);
        if (!source)
        {
            return source.GetError();
        }
        SceneLook look;
        look.width = take.width;
        look.height = take.height;
        Result<SceneSession> session = SceneSession::Open(std::move(*source), look);
        return session ? Result<Shooting>(Shooting(std::move(*session), take))
                       : Result<Shooting>(session.GetError());
    }

    SceneSession& AtFrame(std::int64_t frame)
    {
        m_session.AdvanceTo(StepAt(m_from, m_session.StepsPerSecond()) +
                            m_clock.StepOfFrame(frame));
        return m_session;
    }

private:
    Shooting(SceneSession session, const Take& take)
        : m_session(std::move(session)), m_from(take.from)
    {
        m_clock.stepsPerSecond = m_session.StepsPerSecond();
    }

    SceneSession m_session;
    Duration m_from;
    FrameClock m_clock;
};

/// Returns the fraction of a file in the page cache, after it has been read once.
double CachedShare(int file, std::size_t size)
{
    std::vector<std::uint8_t> buffer(1 << 20);
    for (std::size_t at = 0; at < size; at += buffer.size())
    {
        if (pread(file, buffer.data(), buffer.size(), off_t(at)) <= 0)
        {
            return 0.0;
        }
    }
    const std::size_t page = std::size_t(sysconf(_SC_PAGESIZE));
    std::vector<unsigned char> present((size + page - 1) / page);
    void* const address = mmap(nullptr, size, PROT_READ, MAP_SHARED, file, 0);
    if (address == MAP_FAILED)
    {
        return 0.0;
    }
    const bool known = mincore(address, size, present.data()) == 0;
    munmap(address, size);
    const auto pages = std::count_if(present.begin(), present.end(),
                                     [](unsigned char flags) { return (flags & 1) != 0; });
    return known ? double(pages) / double(present.size()) : 0.0;
}

Result<void> DrawRaw(const Take& take, int file)
{
    Result<Renderer> renderer = Renderer::Create({.width = take.width, .height = take.height});
    if (!renderer)
    {
        return renderer.GetError();
    }
    Result<Shooting> shooting = Shooting::Open(take);
    if (!shooting)
    {
        return shooting.GetError();
    }
    Frame frame;
    for (std::int64_t number = 0; number < take.frames; ++number)
    {
        FrameContent content;
        shooting->AtFrame(number).Fill(content);
        Result<void> done = renderer->Submit(content.list, content.camera);
        done = done ? renderer->Read(frame) : done;
        done = done ? WriteAll(file, frame.rgba.data(), frame.rgba.size()) : done;
        if (!done)
        {
            return done;
        }
    }
    return {};
}

/// Written through to the disk, so that nothing of it is written while others are timed.
Result<void> MakeRaw(const Take& take, const std::string& path)
{
    const Descriptor file(open(path.c_str(), O_CREAT | O_TRUNC | O_RDWR | O_CLOEXEC, 0600));
    if (file.Number() < 0)
    {
        return SystemError("'" + path + "' cannot be written");
    }
    if (Result<void> drawn = DrawRaw(take, file.Number()); !drawn)
    {
        return drawn;
    }
    if (fsync(file.Number()) != 0)
    {
        return SystemError("'" + path + "' cannot be written");
    }
    const std::size_t size = take.FrameBytes() * std::size_t(take.frames);
    std::printf("{\"bytes\":%zu,\"cached\":%.4f}\n", size, CachedShare(file.Number(), size));
    return {};
}

/// For the calls that start programs; points into `words`.
std::vector<char*> ArgumentsOf(std::vector<std::string>& words)
{
    std::vector<char*> arguments;
    for (std::string& word : words)
    {
        arguments.push_back(word.data());
    }
    arguments.push_back(nullptr);
    return arguments;
}

Error CannotRun(const std::string& program, int failure)
{
    return Failed("Running '" + program + "' failed: " + std::strerror(failure) + ".");
}

/// An encoder that reads pixels from its standard input.
Result<pid_t> StartEncoder(std::vector<std::string> words, int input)
{
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    pid_t child = 0;
    const int failure = posix_spawnp(&child, words[0].c_str(), &actions, nullptr,
                                     ArgumentsOf(words).data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return failure == 0 ? Result<pid_t>(child) : Result<pid_t>(CannotRun(words[0], failure));
}

Result<void> DrawImmediately(const Take& take, int pipe)
{
    Result<std::unique_ptr<ImmediateDraw>> draw = ImmediateDraw::Create(take.width, take.height);
    if (!draw)
    {
        return draw.GetError();
    }
    Result<Shooting> shooting = Shooting::Open(take);
    if (!shooting)
    {
        return shooting.GetError();
    }
    for (std::int64_t number = 0; number < take.frames; ++number)
    {
        SceneSession& session = shooting->AtFrame(number);
        (*draw)->Begin(session.CurrentCamera());
        session.World().SetDebugDraw(draw->get());
        session.World().DrawDebugData();
        const std::vector<std::uint8_t>& pixels = (*draw)->Read();
        if (Result<void> written = WriteAll(pipe, pixels.data(), pixels.size()); !written)
        {
            return written;
        }
    }
    return {};
}

/// The encoder is started before anything is loaded, for a process counts what its parent had.
Result<void> FilmImmediately(const Take& take, const std::string& film)
{
    signal(SIGPIPE, SIG_IGN); // an encoder that ends early is reported by its exit code
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
    {
        return SystemError("There is no pipe to the encoder");
    }
    Descriptor reading(ends[0]), writing(ends[1]);
    const Result<pid_t> child =
        StartEncoder(EncoderWords(take.width, take.height, "pipe:0", true, film), reading.Number());
    if (!child)
    {
        return child.GetError();
    }
    reading.Close();
    const Result<void> drawn = DrawImmediately(take, writing.Number());
    writing.Close();
    int status = 0;
    while (waitpid(*child, &status, 0) < 0 && errno == EINTR)
    {}
    if (!drawn)
    {
        return drawn;
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    {
        return Failed("The encoder of the frames did not end well.");
    }
    rusage own{}, others{};
    getrusage(RUSAGE_SELF, &own);
    getrusage(RUSAGE_CHILDREN, &others);
    std::printf("{\"kilobytes\":%ld}\n", own.ru_maxrss + others.ru_maxrss);
    return {};
}

/// The difference of colours in steps of 8 bits.
struct Difference
{
    double sum = 0.0;
    double count = 0.0;
    double Mean() const { return count > 0.0 ? sum / count : 0.0; }
};

/// Squares of this many pixels are compared by their mean colours. Within them an encoder may blur
/// colours, and a line may be smooth or jagged.
constexpr int kSquare = 16;

/// The mean colours of one square.
struct Means
{
    double film[3] = {};
    double raw[3] = {};
    bool isGround = true; ///< `raw` shows nothing but the colour of its first pixel
};

Means MeansOf(const Frame& film, const std::vector<std::uint8_t>& raw, int left, int top)
{
    Means means;
    const int right = std::min(left + kSquare, film.width);
    const int bottom = std::min(top + kSquare, film.height);
    const double share = 1.0 / double((right - left) * (bottom - top));
    for (int y = top; y < bottom; ++y)
    {
        for (int x = left; x < right; ++x)
        {
            const std::size_t at = 4 * (std::size_t(y) * std::size_t(film.width) + std::size_t(x));
            means.isGround = means.isGround && std::memcmp(&raw[at], raw.data(), 3) == 0;
            for (std::size_t channel = 0; channel < 3; ++channel)
            {
                means.film[channel] += share * double(film.rgba[at + channel]);
                means.raw[channel] += share * double(raw[at + channel]);
            }
        }
    }
    return means;
}

/// Ground counts by itself: drawings are mostly ground, and a film without anything would be off by
/// little.
void Compare(const Frame& film, const std::vector<std::uint8_t>& raw, Difference& drawn,
             Difference& ground)
{
    for (int top = 0; top < film.height; top += kSquare)
    {
        for (int left = 0; left < film.width; left += kSquare)
        {
            const Means means = MeansOf(film, raw, left, top);
            Difference& part = means.isGround ? ground : drawn;
            for (std::size_t channel = 0; channel < 3; ++channel)
            {
                part.sum += std::abs(means.film[channel] - means.raw[channel]);
                part.count += 1.0;
            }
        }
    }
}

/// The first and the last frame are compared, and every n-th between.
constexpr std::int64_t kCompareEvery = 20;

/// The content of a film.
struct Seen
{
    std::int64_t frames = 0;
    int width = 0;  ///< [px]
    int height = 0; ///< [px]
    Difference drawn, ground;
};

Result<Seen> Look(const std::string& film, const std::string& rawPath)
{
    Result<VideoReader> reader = VideoReader::Open(film);
    if (!reader)
    {
        return reader.GetError();
    }
    const Descriptor raw(open(rawPath.c_str(), O_RDONLY | O_CLOEXEC));
    const VideoInfo info = reader->Info();
    const std::size_t bytes = std::size_t(info.width) * std::size_t(info.height) * 4;
    std::vector<std::uint8_t> pixels(bytes);
    Seen seen{0, info.width, info.height, {}, {}};
    for (Frame frame;; ++seen.frames)
    {
        const Result<bool> next = reader->Next(frame);
        if (!next)
        {
            return next.GetError();
        }
        if (!*next)
        {
            return seen;
        }
        // Beyond the raw frames there is nothing to compare with.
        if (seen.frames % kCompareEvery == 0 &&
            pread(raw.Number(), pixels.data(), bytes, off_t(bytes) * seen.frames) == ssize_t(bytes))
        {
            Compare(frame, pixels, seen.drawn, seen.ground);
        }
    }
}

// Maximum differences of a film, of 255. At crf 20 the squares of these drawings are off by 0.5
// where an item is drawn. With jagged lines they are off by 2, or up to 9 in small pictures. In
// grey it is 7, and 13 with red and blue exchanged.
constexpr double kMaxOnGround = 1.0;
constexpr double kMaxDrawn = 4.0;
constexpr double kMaxDrawnImmediately = 9.0;

/// Returns "sound", or the error of a film that must have the frames and the size of the take.
std::string Judge(const Seen& seen, const Take& take, bool isImmediate)
{
    if (seen.frames != take.frames)
    {
        return std::to_string(seen.frames) + " frames";
    }
    if (seen.width != take.width || seen.height != take.height)
    {
        return std::to_string(seen.width) + "x" + std::to_string(seen.height);
    }
    const bool isGround = seen.ground.Mean() <= kMaxOnGround;
    if (isGround && seen.drawn.Mean() <= (isImmediate ? kMaxDrawnImmediately : kMaxDrawn))
    {
        return "sound";
    }
    char text[64];
    std::snprintf(text, sizeof text, "colours off by %.1f of 255",
                  isGround ? seen.drawn.Mean() : seen.ground.Mean());
    return text;
}

/// `raw`: a file that is not there holds no frames to compare with.
Result<void> Check(const Take& take, const std::string& film, const std::string& raw,
                   bool isImmediate)
{
    const Result<Seen> seen = Look(film, raw);
    if (!seen)
    {
        return seen.GetError();
    }
    std::printf("{\"verdict\":\"%s\",\"drawnError\":%.3f,\"groundError\":%.3f}\n",
                Judge(*seen, take, isImmediate).c_str(), seen->drawn.Mean(), seen->ground.Mean());
    return {};
}

void List()
{
    for (const RecordCase& one : AllRecordCases())
    {
        std::printf("{\"case\":\"%s\",\"what\":\"%s\",\"onlyNamed\":%s}\n", one.name, one.what,
                    one.onlyNamed ? "true" : "false");
    }
}

/// Returns the words as JSON. They are names of scenes and paths.
std::string Quoted(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words)
    {
        text += text.empty() ? "\"" : ",\"";
        for (const char letter : word)
        {
            text += letter == '"' || letter == '\\' ? std::string("\\") + letter
                                                    : std::string(1, letter);
        }
        text += '"';
    }
    return "[" + text + "]";
}

/// Prints one line per film.
Result<void> PrintFilms(const std::string& helper, char** words)
{
    const Result<std::int64_t> frames = ParseWhole("FRAMES", words[1], 0, 100'000);
    const Result<std::int64_t> width = ParseWhole("WIDTH", words[2], 0, 8192);
    const Result<std::int64_t> height = ParseWhole("HEIGHT", words[3], 0, 8192);
    for (const Result<std::int64_t>* number : {&frames, &width, &height})
    {
        if (!*number)
        {
            return number->GetError();
        }
    }
    for (const RecordCase& one : AllRecordCases())
    {
        if (std::string(one.name) == words[0])
        {
            const RecordCase info = Resized(one, *frames, int(*width), int(*height));
            std::printf("{\"frames\":%lld,\"width\":%d,\"height\":%d,\"from\":%g,\"take\":%s}\n",
                        static_cast<long long>(info.frames), info.width, info.height, info.from,
                        Quoted(TakeWords(info, info.frames)).c_str());
            for (const Film& film : FilmsOf(info, words[4], helper, words[5]))
            {
                std::printf("{\"role\":\"%s\",\"method\":\"%s\",\"frames\":%lld,\"words\":%s,"
                            "\"check\":%s}\n",
                            film.role, film.method, static_cast<long long>(film.frames),
                            Quoted(film.words).c_str(),
                            Quoted(CheckWords(info, film, helper, words[5])).c_str());
            }
            return {};
        }
    }
    return Error{ErrorKind::Unusable, "No case of recording is called '" + std::string(words[0]) +
                                          "'; `list` shows them."};
}

/// Replaces this process by ffmpeg, so the parent process measures only ffmpeg.
Result<void> Encode(const Take& take, const std::string& raw, const std::string& film)
{
    std::vector<std::string> words = EncoderWords(take.width, take.height, raw, false, film);
    execvp(words[0].c_str(), ArgumentsOf(words).data());
    return CannotRun(words[0], errno);
}

Result<Take> ParseTake(char** words)
{
    const Result<std::int64_t> frames = ParseWhole("FRAMES", words[1], 1, 10'000'000);
    const Result<std::int64_t> width = ParseWhole("WIDTH", words[2], 1, 8192);
    const Result<std::int64_t> height = ParseWhole("HEIGHT", words[3], 1, 8192);
    const Result<Duration> from = ParseDuration("FROM", words[4]);
    for (const Result<std::int64_t>* number : {&frames, &width, &height})
    {
        if (!*number)
        {
            return number->GetError();
        }
    }
    return from ? Result<Take>(Take{words[0], *frames, int(*width), int(*height), *from})
                : Result<Take>(from.GetError());
}

Result<void> Run(int count, char** words)
{
    const std::string command = count > 1 ? words[1] : "";
    if (command == "list" && count == 2)
    {
        List();
        return {};
    }
    if (command == "films" && count == 8)
    {
        return PrintFilms(words[0], words + 2);
    }
    const bool isCheck = (command == "check" || command == "check-immediate") && count == 9;
    const bool isMade = (command == "raw" || command == "immediate") && count == 8;
    if (!isCheck && !isMade && !(command == "encode" && count == 9))
    {
        return Error{ErrorKind::Unusable,
                     "Usage: " + std::string(words[0]) +
                         " list | films CASE FRAMES WIDTH HEIGHT BOXREEL FOLDER | raw TAKE FILE | "
                         "immediate TAKE FILM | encode TAKE RAW FILM | "
                         "check[-immediate] TAKE FILM RAW, TAKE is SCENE FRAMES WIDTH HEIGHT FROM"};
    }
    const Result<Take> take = ParseTake(words + 2);
    if (!take)
    {
        return take.GetError();
    }
    return isCheck               ? Check(*take, words[7], words[8], command != "check")
           : command == "encode" ? Encode(*take, words[7], words[8])
           : command == "raw"    ? MakeRaw(*take, words[7])
                                 : FilmImmediately(*take, words[7]);
}

} // namespace
} // namespace bench

int main(int count, char** words)
try
{
    const boxreel::Result<void> done = bench::Run(count, words);
    if (!done)
    {
        std::fprintf(stderr, "%s\n", done.GetError().Text().c_str());
        return int(done.GetError().kind);
    }
    return 0;
}
catch (const std::exception& thrown) // such as memory that is not there
{
    std::fprintf(stderr, "%s\n", thrown.what());
    return int(boxreel::ErrorKind::Failed);
}
