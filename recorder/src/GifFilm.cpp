// SPDX-License-Identifier: MIT
#include "GifFilm.h"
#include "FrameTimes.h"
#include "GifLzw.h"
#include "GifPalette.h"
#include "SettingTexts.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>

#include <algorithm>
#include <array>
#include <bit>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace boxreel
{

namespace
{

using Bytes = std::vector<std::uint8_t>;
using Colors = std::vector<std::uint32_t>; // 0xffRRGGBB

constexpr std::int64_t kShortest = 2;      // minimum that browsers respect [1/100 s]
constexpr std::int64_t kLongest = 65535;   // maximum delay of a frame [1/100 s]
constexpr std::int64_t kLongPiece = 60000; // piece of a longer delay; the rest stays above
                                           // kShortest
constexpr std::size_t kDelayAt = 4;        // offset in the result of FrameBytes

void Append16(Bytes& out, int value)
{
    out.push_back(std::uint8_t(value & 0xff));
    out.push_back(std::uint8_t(value >> 8));
}

void Append(Bytes& out, std::initializer_list<int> bytes)
{
    for (const int byte : bytes)
    {
        out.push_back(std::uint8_t(byte));
    }
}

void Append(Bytes& out, std::string_view text)
{
    out.insert(out.end(), text.begin(), text.end());
}

/// `plays`: 0 is forever.
Bytes Header(int width, int height, int plays)
{
    Bytes out;
    Append(out, "GIF89a");
    Append16(out, width);
    Append16(out, height);
    Append(out, {0x70, 0, 0}); // 8 bits per colour, no global table, square pixels
    if (plays != 1)
    {
        Append(out, {0x21, 0xff, 11});
        Append(out, "NETSCAPE2.0");
        Append(out, {3, 1});
        Append16(out, plays == 0 ? 0 : plays - 1); // number of repetitions
        out.push_back(0);
    }
    return out;
}

/// A stored rectangle of a frame: indices into a colour table. The last index may stand for pixels
/// that do not change.
struct Picture
{
    PixelBounds part;
    Colors table; ///< without the index for unchanged pixels
    bool hasKept = false;
    std::vector<std::uint8_t> indices;
};

/// Returns the header, table and data of one frame, with a delay of 0.
Bytes FrameBytes(const Picture& picture)
{
    Bytes out;
    const std::size_t count = picture.table.size() + (picture.hasKept ? 1 : 0);
    const int bits = std::max(2, int(std::bit_width(count - 1)));
    const int kept = picture.hasKept ? int(picture.table.size()) : 0;
    const int flags = 1 << 2 | (picture.hasKept ? 1 : 0); // do not dispose; one index is
                                                          // transparent
    Append(out, {0x21, 0xf9, 4, flags, 0, 0, kept, 0, 0x2c});
    Append16(out, picture.part.x0);
    Append16(out, picture.part.y0);
    Append16(out, picture.part.x1 - picture.part.x0);
    Append16(out, picture.part.y1 - picture.part.y0);
    out.push_back(std::uint8_t(0x80 | (bits - 1)));
    for (std::size_t i = 0; i < std::size_t(1) << bits; ++i)
    {
        const std::uint32_t color = i < picture.table.size() ? picture.table[i] : 0;
        Append(out, {int(color >> 16 & 0xff), int(color >> 8 & 0xff), int(color & 0xff)});
    }
    AppendGifLzw(picture.indices, bits, out);
    return out;
}

/// Returns the rectangle of different pixels; both have this width.
PixelBounds Difference(const Colors& a, const Colors& b, int width)
{
    PixelBounds bounds{width, 0, 0, 0};
    const int height = int(a.size() / std::size_t(width));
    for (int y = 0; y < height; ++y)
    {
        const auto rowA = a.begin() + std::ptrdiff_t(y) * width;
        const auto rowB = b.begin() + std::ptrdiff_t(y) * width;
        const int first = int(std::mismatch(rowA, rowA + width, rowB).first - rowA);
        if (first == width)
        {
            continue;
        }
        int last = width;
        while (rowA[last - 1] == rowB[last - 1])
        {
            --last;
        }
        bounds.y0 = bounds.y1 == 0 ? y : bounds.y0;
        bounds.y1 = y + 1;
        bounds.x0 = std::min(bounds.x0, first);
        bounds.x1 = std::max(bounds.x1, last);
    }
    return bounds;
}

class GifFilm final : public VideoSink
{
public:
    GifFilm(std::filesystem::path path, const VideoSettings& settings)
        : m_path(std::move(path)), m_settings(settings), m_times(VideoFormat::Gif, settings)
    {}

    Result<void> Open();
    std::optional<std::int64_t> StoredFrames() const override { return m_stored; }
    Result<void> Append(const Frame& frame, std::span<const PixelBounds> changed) override;
    Result<void> Repeat() override;
    Result<void> TakePlace() override { return m_file->Mark("part"); }
    Result<void> Close() override;
    Result<void> Suspend() override;

private:
    std::int64_t Last() const { return m_frames - 1; }
    bool MustShow() const;
    Result<void> Show();
    Result<void> Map();
    Picture PictureOf(const PixelBounds& part, bool isWhole) const;
    Result<void> WriteWaiting(std::int64_t until);
    Result<void> Finish();

    std::filesystem::path m_path;
    VideoSettings m_settings;
    FrameTimes m_times;
    std::optional<AtomicFile> m_file;
    GifPalette m_palette;
    std::int64_t m_frames = 0; // appended or repeated
    std::int64_t m_stored = 0;
    Frame m_last;
    bool m_isDue = false;                // the last frame is not stored yet
    std::int64_t m_group = -1;           // of the last stored frame
    std::vector<std::uint8_t> m_indices; // palette indices of the last frame
    Colors m_colors;                     // colours of the last frame in the film
    Colors m_before;                     // colours of the previous frame in the film
    Bytes m_waiting;                     // bytes of the last frame, until its delay is known
    std::int64_t m_waitingSince = 0;     // start of the last frame [1/100 s]
};

Result<void> GifFilm::Open()
{
    const bool isResumed = m_settings.resume;
    ASSIGN_OR_RETURN(
        AtomicFile file,
        AtomicFile::Create(m_path, {.overwrite = m_settings.overwrite,
                                    .mark = isResumed ? kResumedMark : "part",
                                    .replacesLeftover = m_settings.overwrite || isResumed,
                                    .leftoverRemedy = LeftoverRemedy()}));
    m_file.emplace(std::move(file));
    return m_file->Write(Header(m_settings.width, m_settings.height, m_settings.plays));
}

Result<void> GifFilm::Append(const Frame& frame, std::span<const PixelBounds>)
{
    ++m_frames;
    m_last = frame;
    m_isDue = true;
    return m_times.IsKept(Last()) ? Show() : Result<void>();
}

Result<void> GifFilm::Repeat()
{
    ++m_frames;
    const bool isDue = m_isDue || MustShow();
    return m_times.IsKept(Last()) && isDue ? Show() : Result<void>();
}

/// True if the last frame must be stored although it equals the previous one. The first of a group
/// is, so that groups can be parts. The second of the film is, because most programs derive the
/// rate from the first two frames.
bool GifFilm::MustShow() const
{
    const bool isSecond = m_times.NumberOf(Last()) == GifFrameStep(m_settings.framesPerSecond);
    return m_settings.timing == FrameTiming::Constant || isSecond ||
           m_times.GroupOf(Last()) != m_group;
}

/// Stores the last frame.
Result<void> GifFilm::Show()
{
    m_isDue = false;
    ++m_stored;
    const bool isWhole = m_times.GroupOf(Last()) != m_group;
    if (isWhole)
    {
        m_group = m_times.GroupOf(Last());
        m_palette = GifPalette(); // groups are independent
    }
    RETURN_IF_ERROR(Map());
    PixelBounds part{0, 0, m_last.width, m_last.height};
    if (!isWhole)
    {
        part = Difference(m_colors, m_before, m_last.width);
    }
    if (part.IsEmpty())
    {
        part = {0, 0, 1, 1}; // minimum size
    }
    const std::int64_t now = m_times.TimeOf(Last());
    RETURN_IF_ERROR(WriteWaiting(now));
    m_waiting = FrameBytes(PictureOf(part, true));
    if (!isWhole) // transparent pixels help unless they are few among many changes
    {
        Bytes sparse = FrameBytes(PictureOf(part, false));
        if (sparse.size() < m_waiting.size())
        {
            m_waiting = std::move(sparse);
        }
    }
    m_waitingSince = now;
    return {};
}

/// Maps the last frame to the palette.
Result<void> GifFilm::Map()
{
    m_colors.swap(m_before);
    m_indices.resize(std::size_t(m_last.width) * std::size_t(m_last.height));
    const bool isExact = m_palette.Map(m_last, m_indices.data(), std::size_t(m_last.width));
    if (!isExact && m_settings.quality == Quality::Lossless)
    {
        return Error{ErrorKind::Unusable, m_path.string(),
                     "cannot be lossless: frame " + std::to_string(m_times.NumberOf(Last())) +
                         " has more than 256 colours",
                     "use .mkv or frames-####.png"};
    }
    m_colors.resize(m_indices.size());
    std::transform(m_indices.begin(), m_indices.end(), m_colors.begin(),
                   [this](std::uint8_t index) { return m_palette.Colors()[index]; });
    return {};
}

/// Returns this part of the last frame; unchanged pixels are transparent unless `isWhole`.
Picture GifFilm::PictureOf(const PixelBounds& part, bool isWhole) const
{
    Picture picture{part, {}, !isWhole, {}};
    const auto rowAt = [&](int y) { return std::size_t(y) * std::size_t(m_last.width); };
    std::array<bool, GifPalette::kSize> isUsed{};
    for (int y = part.y0; y < part.y1; ++y)
    {
        for (std::size_t i = rowAt(y) + std::size_t(part.x0); i < rowAt(y) + std::size_t(part.x1);
             ++i)
        {
            isUsed[m_indices[i]] |= isWhole || m_colors[i] != m_before[i];
        }
    }
    if (std::count(isUsed.begin(), isUsed.end(), true) == std::ptrdiff_t(isUsed.size()))
    {
        picture.hasKept = false; // no index left for unchanged pixels
    }
    std::array<std::uint8_t, GifPalette::kSize> places{};
    for (std::size_t i = 0; i < isUsed.size(); ++i)
    {
        if (isUsed[i])
        {
            places[i] = std::uint8_t(picture.table.size());
            picture.table.push_back(m_palette.Colors()[i]);
        }
    }
    picture.indices.reserve(std::size_t(part.Area()));
    for (int y = part.y0; y < part.y1; ++y)
    {
        for (std::size_t i = rowAt(y) + std::size_t(part.x0); i < rowAt(y) + std::size_t(part.x1);
             ++i)
        {
            const bool isKept = picture.hasKept && m_colors[i] == m_before[i];
            picture.indices.push_back(isKept ? std::uint8_t(picture.table.size())
                                             : places[m_indices[i]]);
        }
    }
    return picture;
}

/// Writes the last stored frame with its delay. A delay above the maximum is continued by frames
/// without changes.
Result<void> GifFilm::WriteWaiting(std::int64_t until)
{
    const auto write = [this](Bytes& bytes, std::int64_t delay) {
        bytes[kDelayAt] = std::uint8_t(delay & 0xff);
        bytes[kDelayAt + 1] = std::uint8_t(delay >> 8);
        return m_file->Write(bytes);
    };
    std::int64_t delay = std::max(until - m_waitingSince, kShortest);
    Result<void> written;
    while (written && !m_waiting.empty())
    {
        const std::int64_t piece = delay > kLongest ? kLongPiece : delay;
        delay -= piece;
        written = write(m_waiting, piece);
        m_waiting = delay > 0 ? FrameBytes(Picture{{0, 0, 1, 1}, {}, true, {0}}) : Bytes();
    }
    return written;
}

Result<void> GifFilm::Finish()
{
    const std::uint8_t trailer = 0x3b;
    const Result<void> written = WriteWaiting(m_times.TimeOf(Last() + 1));
    return written ? m_file->Write({&trailer, 1}) : written;
}

Result<void> GifFilm::Close()
{
    const Result<void> finished = Finish();
    return finished ? m_file->Commit() : finished;
}

Result<void> GifFilm::Suspend()
{
    const Result<void> finished = Finish();
    return finished ? m_file->Leave() : finished;
}

} // namespace

Result<std::unique_ptr<VideoSink>> OpenGifFilm(const std::filesystem::path& path,
                                               const VideoSettings& settings)
{
    auto film = std::make_unique<GifFilm>(path, settings);
    RETURN_IF_ERROR(film->Open());
    return std::unique_ptr<VideoSink>(std::move(film));
}

} // namespace boxreel
