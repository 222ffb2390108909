// SPDX-License-Identifier: MIT
#include "RecordBench.h"

#include "Benchmark.h"
#include "ChildProcess.h"
#include "Format.h"
#include "JsonFields.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr const char* kEncoder = "ffmpeg";
constexpr double kRoomForFilms = 500e6; // beside the raw frames [bytes]

// Differences that a film may have, of 255. Encoded at crf 20 the squares of these drawings are off
// by 0.5 where something is drawn, by 2 with jagged lines; in grey by 7, with red and blue
// exchanged by 13.
constexpr double kMostOnGround = 1.0;
constexpr double kMostDrawn = 4.0;
constexpr double kMostDrawnImmediately = 9.0; // lines of one pixel in small pictures

/// A film to be made, and how.
struct Entry
{
    RecordFigures figures;
    fs::path program;
    Words words;
    fs::path film;
    std::vector<ChildRun> rounds;
};

/// Runs one case in its folder.
class RecordRun
{
public:
    RecordRun(const RecordPrograms& programs, const RecordCase& info, fs::path folder,
              const std::function<bool()>& isStopped)
        : m_programs(programs), m_info(info), m_folder(std::move(folder)), m_isStopped(isStopped)
    {}

    Result<RecordResult> Run(int rounds);

private:
    bool HasPeers() const { return !m_programs.encoder.empty(); }
    fs::path RawPath() const { return m_folder / "frames.raw"; }
    fs::path FilmPath(RecordRole role, const char* number) const;
    Words TakeWords() const;
    Result<void> CheckRoom() const;
    Result<void> MakeRaw();
    void AddOurs(RecordRole role, const char* method, std::int64_t frames, double from);
    void AddPeers();
    void AddAll();
    Result<void> Make(Entry& entry);
    Result<void> MakeAll();
    void Check(Entry& entry);
    void Sum(Entry& entry);
    Result<std::vector<RecordStage>> FindStages();

    const RecordPrograms& m_programs;
    const RecordCase& m_info;
    fs::path m_folder;
    const std::function<bool()>& m_isStopped;
    std::vector<Entry> m_entries;
    RecordResult m_result;
};

/// `number`: what stands for a picture's number.
fs::path RecordRun::FilmPath(RecordRole role, const char* number) const
{
    const std::string name =
        m_info.isPictures ? std::string("frame-") + number + ".png" : std::string("film.mp4");
    return m_folder / RoleName(role) / name;
}

Words RecordRun::TakeWords() const
{
    return {m_info.scene, std::to_string(m_info.frames), std::to_string(m_info.width),
            std::to_string(m_info.height), Format("%gs", m_info.from)};
}

Result<void> RecordRun::CheckRoom() const
{
    const double need =
        4.0 * double(m_info.width) * double(m_info.height) * double(m_info.frames) + kRoomForFilms;
    std::error_code error;
    const fs::space_info space = fs::space(m_folder, error);
    if (!error && double(space.available) < need)
    {
        return Error{ErrorKind::Failed,
                     Format("The raw frames of '%s' need %.1f GB in %s, which has %.1f; name "
                            "another folder by TMPDIR.",
                            m_info.name.c_str(), need / 1e9, m_folder.parent_path().c_str(),
                            double(space.available) / 1e9)};
    }
    return {};
}

/// The frames to check films by, and to encode.
Result<void> RecordRun::MakeRaw()
{
    Words words{"raw"};
    const Words take = TakeWords();
    words.insert(words.end(), take.begin(), take.end());
    words.push_back(RawPath().string());
    const Result<ChildRun> run = RunMeasured(m_programs.helper, words);
    if (!run)
    {
        return run.GetError();
    }
    const Json json = ParseJson(run->output);
    m_result.cached = HasPeers() ? Number(json, "cached", kNoValue) : kNoValue;
    return {};
}

void RecordRun::AddOurs(RecordRole role, const char* method, std::int64_t frames, double from)
{
    Entry entry;
    entry.figures.role = role;
    entry.figures.method = method;
    entry.figures.frames = frames;
    entry.program = m_programs.boxreel;
    entry.film = FilmPath(role, "####");
    entry.words = OursWords(m_info, frames, from, entry.film);
    m_entries.push_back(std::move(entry));
}

void RecordRun::AddPeers()
{
    Entry encoding;
    encoding.figures.role = RecordRole::Encoding;
    encoding.figures.method = m_programs.encoder + ", raw file";
    encoding.figures.frames = m_info.frames;
    encoding.program = kEncoder;
    encoding.film = FilmPath(RecordRole::Encoding, "####");
    encoding.words =
        EncoderWords(m_info, RawPath().string(), false, FilmPath(RecordRole::Encoding, "%04d"));
    m_entries.push_back(encoding);
    if (m_info.isPictures)
    {
        return;
    }
    Entry immediate = encoding;
    immediate.figures.role = RecordRole::Immediate;
    immediate.figures.method = "immediate mode | ffmpeg";
    immediate.program = m_programs.helper;
    immediate.film = FilmPath(RecordRole::Immediate, "");
    immediate.words = {"immediate"};
    const Words take = TakeWords();
    const Words encoder = EncoderWords(m_info, "pipe:0", true, immediate.film);
    immediate.words.insert(immediate.words.end(), take.begin(), take.end());
    immediate.words.emplace_back(kEncoder);
    immediate.words.insert(immediate.words.end(), encoder.begin(), encoder.end());
    m_entries.push_back(immediate);
}

void RecordRun::AddAll()
{
    AddOurs(RecordRole::Ours, "boxreel record", m_info.frames, m_info.from);
    AddOurs(RecordRole::Start, "  its first frame", 1, m_info.from);
    if (m_info.movingFrames > 0)
    {
        AddOurs(RecordRole::Moving, "  while it moves", m_info.movingFrames, 0.0);
        AddOurs(RecordRole::MovingStart, "  the first of these", 1, 0.0);
    }
    if (m_info.longFrames > 0)
    {
        AddOurs(RecordRole::Long, "  a longer film", m_info.longFrames, m_info.from);
    }
    if (HasPeers())
    {
        AddPeers();
    }
}

/// Once, into an empty folder.
Result<void> RecordRun::Make(Entry& entry)
{
    std::error_code ignored;
    fs::remove_all(entry.film.parent_path(), ignored);
    fs::create_directories(entry.film.parent_path(), ignored);
    Words words = entry.words;
    if (entry.program == m_programs.boxreel)
    {
        words.insert(words.end(), {"--progress", "none"});
    }
    Result<ChildRun> run = RunMeasured(entry.program, words);
    if (!run)
    {
        entry.figures.failure = run.GetError().message;
        return run.GetError();
    }
    if (entry.figures.role == RecordRole::Immediate) // of the two processes together
    {
        const Json json = ParseJson(run->output);
        run->memory = 1024.0 * Number(json, "kilobytes", kNoValue);
    }
    entry.rounds.push_back(std::move(*run));
    return {};
}

/// The film of the last round.
void RecordRun::Check(Entry& entry)
{
    const Result<ChildRun> run =
        RunMeasured(m_programs.helper, {"check", entry.film.string(), RawPath().string()});
    const Result<FilmCheck> check =
        run ? ParseFilmCheck(run->output) : Result<FilmCheck>(run.GetError());
    const bool isOfRaw =
        entry.figures.role != RecordRole::Moving && entry.figures.role != RecordRole::MovingStart;
    FilmCheck seen = check ? *check : FilmCheck();
    if (!isOfRaw) // it shows another time than the raw frames
    {
        seen.drawnError = seen.groundError = 0.0;
    }
    entry.figures.verdict =
        check ? JudgeFilm(m_info, entry.figures, seen) : "the film cannot be read";
    entry.figures.bytes = 0.0;
    std::error_code ignored;
    for (const auto& file : fs::directory_iterator(entry.film.parent_path(), ignored))
    {
        entry.figures.bytes += double(file.file_size(ignored));
    }
}

void RecordRun::Sum(Entry& entry)
{
    const auto median = [&entry](double ChildRun::*field) {
        std::vector<double> values;
        for (const ChildRun& run : entry.rounds)
        {
            values.push_back(run.*field);
        }
        return Median(std::move(values));
    };
    entry.figures.wall = median(&ChildRun::wall);
    entry.figures.cpu = median(&ChildRun::cpu);
    entry.figures.memory = median(&ChildRun::memory);
}

/// Of a run of its own: looking at clocks takes time, too.
Result<std::vector<RecordStage>> RecordRun::FindStages()
{
    Words words = m_entries.front().words;
    words.insert(words.end(), {"--progress", "json", "--stats", "--force"});
    const Result<ChildRun> run = RunMeasured(m_programs.boxreel, words);
    return run ? ParseStages(run->output) : Result<std::vector<RecordStage>>(run.GetError());
}

/// One round. Peers may fail, ours may not.
Result<void> RecordRun::MakeAll()
{
    for (Entry& entry : m_entries)
    {
        if (!entry.figures.failure.empty())
        {
            continue; // once is enough to be told why
        }
        const Result<void> made = Make(entry);
        if (m_isStopped())
        {
            return Error{ErrorKind::Failed, "Stopped."};
        }
        if (!made && &entry == &m_entries.front())
        {
            return made.GetError();
        }
    }
    return {};
}

Result<RecordResult> RecordRun::Run(int rounds)
{
    m_result.info = m_info;
    Result<void> ready = CheckRoom();
    ready = ready ? MakeRaw() : ready;
    if (!ready)
    {
        return ready.GetError();
    }
    AddAll();
    for (int round = 0; round < rounds; ++round)
    {
        if (const Result<void> made = MakeAll(); !made)
        {
            return made.GetError();
        }
    }
    for (Entry& entry : m_entries)
    {
        if (entry.figures.failure.empty())
        {
            Sum(entry);
            Check(entry);
        }
        m_result.methods.push_back(entry.figures);
    }
    Result<std::vector<RecordStage>> stages = FindStages();
    if (!stages)
    {
        return stages.GetError();
    }
    m_result.stages = std::move(*stages);
    return m_result;
}

/// "ffmpeg 5.1.9": the third word of what it says of itself, without what the packager added.
std::string EncoderName()
{
    const Result<ChildRun> run = RunMeasured(kEncoder, {"-hide_banner", "-version"});
    if (!run)
    {
        return "";
    }
    const std::string before = "version ";
    const std::size_t at = run->output.find(before);
    const std::size_t begin = at == std::string::npos ? run->output.size() : at + before.size();
    const std::size_t end = run->output.find_first_of(" -\n", begin);
    return std::string(kEncoder) + " " + run->output.substr(begin, end - begin);
}

bool IsSound(const RecordFigures* figures)
{
    return figures != nullptr && figures->verdict == "sound";
}

/// Of a frame, without what starting and closing takes; kNoValue when it was not measured.
double FrameTime(const RecordResult& result, RecordRole film, RecordRole start)
{
    const RecordFigures* const all = FindRole(result, film);
    const RecordFigures* const one = FindRole(result, start);
    return IsSound(all) && IsSound(one) && all->frames > one->frames
               ? (all->wall - one->wall) / double(all->frames - one->frames)
               : kNoValue;
}

/// Of two sound films, `field` of the one over that of the other.
double Ratio(const RecordFigures* one, const RecordFigures* other, double RecordFigures::*field)
{
    return IsSound(one) && IsSound(other) ? one->*field / other->*field : kNoValue;
}

double Difference(const RecordFigures* one, const RecordFigures* other,
                  double RecordFigures::*field)
{
    return IsSound(one) && IsSound(other) ? one->*field - other->*field : kNoValue;
}

} // namespace

Result<RecordPrograms> FindRecordPrograms()
{
    std::error_code error;
    const fs::path self = fs::read_symlink("/proc/self/exe", error);
    const std::vector<fs::path> found = FindPrograms({"boxreel_record_bench"});
    if (error || found.empty())
    {
        return Error{ErrorKind::Absent, "The benchmark programs are not beside this program; run "
                                        "`./boxreel bench` in a checkout, which builds them."};
    }
    return RecordPrograms{self, found.front(), EncoderName()};
}

Result<RecordResult> RunRecordCase(const RecordPrograms& programs, const RecordCase& info,
                                   int rounds, const fs::path& folder,
                                   const std::function<bool()>& isStopped)
{
    return RecordRun(programs, info, folder, isStopped).Run(rounds);
}

std::string JudgeFilm(const RecordCase& info, const RecordFigures& figures, const FilmCheck& check)
{
    if (check.frames != figures.frames)
    {
        return Format("%lld frames", static_cast<long long>(check.frames));
    }
    if (check.width != info.width || check.height != info.height)
    {
        return Format("%dx%d", check.width, check.height);
    }
    const double mostDrawn =
        figures.role == RecordRole::Immediate ? kMostDrawnImmediately : kMostDrawn;
    const bool isGround = check.groundError <= kMostOnGround;
    if (!isGround || !(check.drawnError <= mostDrawn))
    {
        return Format("colours off by %.1f of 255",
                      isGround ? check.drawnError : check.groundError);
    }
    return "sound";
}

const RecordFigures* FindRole(const RecordResult& result, RecordRole role)
{
    for (const RecordFigures& figures : result.methods)
    {
        if (figures.role == role && figures.failure.empty())
        {
            return &figures;
        }
    }
    return nullptr;
}

std::vector<RecordGoal> RecordGoals(const RecordResult& result)
{
    const RecordCase& info = result.info;
    const RecordFigures* const ours = FindRole(result, RecordRole::Ours);
    const RecordFigures* const encoding = FindRole(result, RecordRole::Encoding);
    const RecordFigures* const immediate = FindRole(result, RecordRole::Immediate);
    const RecordFigures* const longer = FindRole(result, RecordRole::Long);
    std::vector<RecordGoal> goals;
    const auto add = [&goals](RecordRole role, const char* what, const char* unit, double goal,
                              double reached, bool isAtLeast = false) {
        if (goal > 0.0)
        {
            goals.push_back({role, what, unit, goal, reached, isAtLeast});
        }
    };
    add(RecordRole::Ours, "frames a second", "", info.goalRate,
        IsSound(ours) ? double(ours->frames) / ours->wall : kNoValue, true);
    if (encoding != nullptr)
    {
        add(RecordRole::Ours, "wall time over encoding only", "", info.goalOverEncoding,
            Ratio(ours, encoding, &RecordFigures::wall));
    }
    if (immediate != nullptr)
    {
        add(RecordRole::Ours, "wall time over immediate mode", "", info.goalOverImmediate,
            Ratio(ours, immediate, &RecordFigures::wall));
    }
    add(RecordRole::Ours, "times faster than moving", "", info.goalTimesFaster,
        FrameTime(result, RecordRole::Moving, RecordRole::MovingStart) /
            FrameTime(result, RecordRole::Ours, RecordRole::Start),
        true);
    if (encoding != nullptr)
    {
        add(RecordRole::Ours, "memory over the encoder's", " MB", info.goalMemory / 1e6,
            Difference(ours, encoding, &RecordFigures::memory) / 1e6);
    }
    add(RecordRole::Long, "memory of the longer film", " MB more", info.goalGrowth / 1e6,
        Difference(longer, ours, &RecordFigures::memory) / 1e6);
    return goals;
}

} // namespace boxreel
