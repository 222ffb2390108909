// SPDX-License-Identifier: MIT
#include "PngSequence.h"
#include "PngStream.h"
#include "SequenceName.h"
#include "SettingTexts.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <render/Png.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <span>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace boxreel
{

namespace
{

namespace fs = std::filesystem;

constexpr int kDefaultThreads = 2;
constexpr int kFastest = 1; // of transparent frames; 5 % larger than level 3, and 20 % faster

/// A frame and its positions in the sequence.
struct Job
{
    std::int64_t first = 0;
    std::int64_t count = 1;
    Frame frame;
};

class PngSequenceWriter final : public VideoSink
{
public:
    PngSequenceWriter(SequenceName name, const VideoSettings& settings, std::int64_t resumed);
    ~PngSequenceWriter() override;

    std::int64_t ResumedFrames() const override { return m_resumed; }
    Result<void> Append(const Frame& frame, std::span<const PixelBounds> changed) override;
    Result<void> Repeat() override;
    Result<void> Close() override;
    Result<void> Suspend() override;

private:
    Result<void> Flush();
    void Join();
    void Work();
    Result<void> Write(const Job& job, PngStream& stream);
    Result<void> WriteFiles(const Job& job, std::span<const std::uint8_t> bytes);

    SequenceName m_name;
    FrameRange m_numbers;
    bool m_overwrite;
    StageTimes* m_stages;
    std::size_t m_depth; // maximum number of waiting jobs
    Job m_pending;       // the last frame, to which a Repeat may still be added
    std::int64_t m_resumed;
    std::int64_t m_frames; // including existing pictures
    bool m_isClosed = false;

    std::mutex m_mutex; // guards the members below, except the threads
    std::condition_variable m_changed;
    std::deque<Job> m_jobs;
    std::vector<Frame> m_spare; // buffers of written frames, for reuse
    std::vector<fs::path> m_written;
    std::optional<std::pair<std::int64_t, Error>> m_error; // of the earliest frame
    bool m_isEnding = false;
    std::vector<std::thread> m_threads;
};

PngSequenceWriter::PngSequenceWriter(SequenceName name, const VideoSettings& settings,
                                     std::int64_t resumed)
    : m_name(std::move(name)), m_numbers(settings.frames),
      m_overwrite(settings.overwrite || settings.resume), m_stages(settings.stages),
      m_resumed(resumed), m_frames(resumed)
{
    const int threads = settings.threads > 0 ? settings.threads : kDefaultThreads;
    m_depth = std::size_t(threads);
    for (int i = 0; i < threads; ++i)
    {
        m_threads.emplace_back([this] { Work(); });
    }
}

PngSequenceWriter::~PngSequenceWriter()
{
    Join();
    if (!m_isClosed)
    {
        std::error_code ignored;
        for (const fs::path& path : m_written)
        {
            fs::remove(path, ignored);
        }
    }
}

void PngSequenceWriter::Join()
{
    {
        const std::lock_guard lock(m_mutex);
        m_isEnding = true;
    }
    m_changed.notify_all();
    for (std::thread& thread : m_threads)
    {
        thread.join();
    }
    m_threads.clear();
}

Result<void> PngSequenceWriter::Append(const Frame& frame, std::span<const PixelBounds>)
{
    if (m_frames > m_resumed)
    {
        RETURN_IF_ERROR(Flush());
    }
    const StageTimer timer(m_stages, Stage::Copy);
    m_pending.first = m_frames++;
    m_pending.count = 1;
    m_pending.frame = frame; // into a reused buffer
    return {};
}

Result<void> PngSequenceWriter::Repeat()
{
    ++m_frames;
    ++m_pending.count;
    return {};
}

/// Passes the pending frame to the threads; waits while the queue is full.
Result<void> PngSequenceWriter::Flush()
{
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return m_jobs.size() < m_depth || m_error; });
    if (m_error)
    {
        return m_error->second;
    }
    m_jobs.push_back(std::move(m_pending));
    if (!m_spare.empty())
    {
        m_pending.frame = std::move(m_spare.back());
        m_spare.pop_back();
    }
    lock.unlock();
    m_changed.notify_all();
    return {};
}

void PngSequenceWriter::Work()
{
    PngStream stream;
    std::unique_lock lock(m_mutex);
    while (true)
    {
        m_changed.wait(lock, [this] { return !m_jobs.empty() || m_isEnding; });
        if (m_jobs.empty() || m_error)
        {
            return;
        }
        Job job = std::move(m_jobs.front());
        m_jobs.pop_front();
        lock.unlock();
        m_changed.notify_all();
        const Result<void> done = Write(job, stream);
        lock.lock();
        m_spare.push_back(std::move(job.frame));
        if (!done && (!m_error || job.first < m_error->first))
        {
            m_error.emplace(job.first, done.GetError());
            m_changed.notify_all();
        }
    }
}

Result<void> PngSequenceWriter::Write(const Job& job, PngStream& stream)
{
    std::optional<StageTimer> timer(std::in_place, m_stages, Stage::Encode);
    const std::span<const std::uint8_t> opaque = stream.Encode(job.frame);
    if (!opaque.empty())
    {
        timer.reset();
        return WriteFiles(job, opaque);
    }
    ASSIGN_OR_RETURN(const std::vector<std::uint8_t> bytes, EncodePng(job.frame, kFastest));
    timer.reset();
    return WriteFiles(job, bytes);
}

Result<void> PngSequenceWriter::WriteFiles(const Job& job, std::span<const std::uint8_t> bytes)
{
    const StageTimer timer(m_stages, Stage::Write);
    for (std::int64_t i = 0; i < job.count; ++i)
    {
        const fs::path path = m_name.PathOf(m_numbers.At(job.first + i));
        RETURN_IF_ERROR(WriteWhole(path, bytes, m_overwrite));
        const std::lock_guard lock(m_mutex);
        m_written.push_back(path);
    }
    return {};
}

Result<void> PngSequenceWriter::Close()
{
    if (m_frames > m_resumed) // otherwise all pictures existed already
    {
        RETURN_IF_ERROR(Flush());
    }
    Join();
    if (m_error)
    {
        return m_error->second;
    }
    m_isClosed = true;
    return {};
}

/// Every written picture is complete.
Result<void> PngSequenceWriter::Suspend()
{
    return Close();
}

/// Returns the numbers of the sequence in its folder, sorted; empty when the folder cannot be read.
std::vector<std::int64_t> NumbersPresent(const SequenceName& name)
{
    std::vector<std::int64_t> numbers;
    std::error_code error;
    const fs::path folder = name.folder.empty() ? fs::path(".") : name.folder;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    {
        if (const std::optional<std::int64_t> number =
                name.NumberIn(it->path().filename().string()))
        {
            numbers.push_back(*number);
        }
    }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

bool IsAmong(std::int64_t number, const FrameRange& numbers)
{
    return number >= numbers.First() && number <= numbers.Last();
}

/// Returns how many of the requested pictures exist, counted from the first.
std::int64_t CountLeading(const SequenceName& name, const FrameRange& numbers)
{
    std::error_code ignored;
    std::int64_t count = 0;
    while (count < numbers.Count() && fs::exists(name.PathOf(numbers.At(count)), ignored))
    {
        ++count;
    }
    return count;
}

class PngSequenceReader final : public VideoSource
{
public:
    PngSequenceReader(SequenceName name, std::vector<std::int64_t> numbers)
        : m_name(std::move(name)), m_numbers(std::move(numbers))
    {}

    Result<void> Open()
    {
        ASSIGN_OR_RETURN(Frame first, ReadPng(m_name.PathOf(m_numbers.front())));
        info = RgbInfo(first.width, first.height, Rational{60, 1}, "png sequence", "png");
        return {};
    }

    Result<bool> Next(StoredFrame& stored) override
    {
        if (m_next == m_numbers.size())
        {
            return false;
        }
        const fs::path path = m_name.PathOf(m_numbers[m_next]);
        if (m_numbers[m_next] != m_numbers.front() + std::int64_t(m_next))
        {
            const std::int64_t missing = m_numbers.front() + std::int64_t(m_next);
            return Error{ErrorKind::Unusable, m_name.PathOf(missing).string(),
                         "is missing in the sequence", "render it again"};
        }
        ASSIGN_OR_RETURN(Frame read, ReadPng(path));
        if (read.width != info.width || read.height != info.height)
        {
            return Error{ErrorKind::Unusable, path.string(), "size differs from the first picture",
                         "render it again"};
        }
        stored.frame = std::move(read);
        stored.seconds = double(std::int64_t(m_next) * info.framesPerSecond.den) /
                         double(info.framesPerSecond.num);
        ++m_next;
        return true;
    }

private:
    SequenceName m_name;
    std::vector<std::int64_t> m_numbers;
    std::size_t m_next = 0;
};

} // namespace

Result<std::unique_ptr<VideoSink>> OpenPngSequence(const std::filesystem::path& path,
                                                   const VideoSettings& settings)
{
    const SequenceName name = *ParseSequenceName(path);
    const std::int64_t resumed = settings.resume ? CountLeading(name, settings.frames) : 0;
    for (const std::int64_t number : NumbersPresent(name))
    {
        if (!settings.overwrite && !settings.resume && IsAmong(number, settings.frames))
        {
            return Error{ErrorKind::Unusable, name.PathOf(number).string(), "already exists",
                         ErrorText::AnyOf({"choose another name",
                                           "continue a stopped film (" + kResumed + ")",
                                           "overwrite it (" + kOverwritten + ")"})};
        }
    }
    // Checks that the folder is writable before the simulation starts.
    const std::int64_t first = settings.frames.First();
    RETURN_IF_ERROR(AtomicFile::Create(name.PathOf(first), settings.overwrite || settings.resume));
    return std::unique_ptr<VideoSink>(std::make_unique<PngSequenceWriter>(name, settings, resumed));
}

Result<std::unique_ptr<VideoSource>> OpenPngSequenceSource(const std::filesystem::path& path)
{
    const SequenceName name = *ParseSequenceName(path);
    std::vector<std::int64_t> numbers = NumbersPresent(name);
    if (numbers.empty())
    {
        return Error{ErrorKind::Unusable, path.string(),
                     "matches no picture such as " + name.PathOf(0).string(), "check the name"};
    }
    auto reader = std::make_unique<PngSequenceReader>(name, std::move(numbers));
    RETURN_IF_ERROR(reader->Open());
    return std::unique_ptr<VideoSource>(std::move(reader));
}

} // namespace boxreel
