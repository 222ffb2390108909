// SPDX-License-Identifier: MIT
#include "FFmpegFilm.h"
#include "FFmpegCodec.h"
#include "FFmpegCopy.h"
#include "FFmpegMuxer.h"
#include "FFmpegOutput.h"
#include "FFmpegPackets.h"
#include "FFmpegPicture.h"
#include "FFmpegRepeat.h"
#include "SettingTexts.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <optional>
#include <utility>

namespace boxreel
{

namespace
{

/// Returns the longest distance of frames from which a decoder can start [frames]. The encoder
/// cannot keep it, because it does not see repeated frames. The default is that of x264.
std::int64_t KeyframeDistance(const EncoderPlan& plan, const AVCodecContext& context)
{
    constexpr std::int64_t kDefault = 250;
    const bool isAsked = plan.needsGroups && context.gop_size >= 0; // `g` of the user
    return isAsked ? std::max<std::int64_t>(context.gop_size, 1) : kDefault;
}

class FFmpegFilm final : public VideoSink
{
public:
    FFmpegFilm(std::filesystem::path path, VideoFormat format, EncoderPlan plan,
               const VideoSettings& settings)
        : m_path(std::move(path)), m_format(format), m_settings(settings), m_plan(std::move(plan)),
          m_frameTimes(format, settings)
    {}

    Result<void> Open();
    std::int64_t ResumedFrames() const override { return m_resumed; }
    std::optional<std::int64_t> StoredFrames() const override
    {
        return IsConstantRate() ? std::nullopt : std::optional(m_stored);
    }
    Result<void> Append(const Frame& frame, std::span<const PixelBounds> changed) override;
    Result<void> Repeat() override;
    Result<void> TakePlace() override { return m_file->Mark("part"); }
    Result<void> Close() override;
    Result<void> Suspend() override;

private:
    std::int64_t Last() const { return m_frames - 1; }
    std::string Name() const { return m_path.string(); }

    Result<void> OpenFile();
    Result<void> OpenMuxer();
    Result<void> OpenPicture();
    Result<void> Resume();
    Result<void> Fill(const Frame& frame, std::span<const PixelBounds> changed);
    bool IsConstantRate() const;
    bool MustShow(std::int64_t index) const;
    bool MustEncode(std::int64_t index) const;
    Result<void> ShowHeld(AVPictureType type);
    Result<void> Show(std::int64_t index);
    Result<void> StartGroup(std::int64_t group);
    Result<void> EndGroup();
    Result<void> Encode(const AVFrame* picture);
    Result<Packets> Take(const AVFrame* picture);
    Result<void> Write(const Packets& packets);
    Result<void> Finish();
    Result<void> CommitWithIndexInFront();
    Error EncodeError(int status) const;

    std::filesystem::path m_path;
    VideoFormat m_format;
    VideoSettings m_settings;
    EncoderPlan m_plan;
    FrameTimes m_frameTimes;
    AVRational m_tick{1, 60};         // time unit [s]
    int m_delay = 0;                  // maximum number of packets by which decoding precedes
                                      // display
    std::optional<AtomicFile> m_file; // none for the standard output
    std::unique_ptr<FFmpegOutput> m_output;
    std::optional<FFmpegMuxer> m_muxer;
    std::optional<DecodingTimes> m_decodingTimes;
    std::optional<FFmpegCodec> m_codec; // of the current group
    FFmpegOwner<AVFrame> m_picture;     // contains the last frame
    bool m_isPictureWhole = false;
    std::optional<FrameToPicture> m_converter; // set while the film is open
    std::optional<FFmpegRepeat> m_repeat;      // none: frames are encoded as they come
    std::int64_t m_held = -1; // with m_repeat, the frame of m_picture that is not encoded yet; its
                              // type depends on the next one
    bool m_isAfterRepeat = false; // the frame before the held one was repeated
    std::int64_t m_keyframeDistance = 1;
    std::int64_t m_resumed = 0;
    std::int64_t m_frames = 0;      // resumed, appended or repeated
    std::int64_t m_group = -1;      // group that m_codec encodes
    std::int64_t m_shown = -1;      // index of the last encoded frame
    std::int64_t m_stored = 0;      // packets in the file
    std::int64_t m_changed = 0;     // index of the last appended frame
    std::int64_t m_lastWritten = 0; // start of the frame whose packet was written last [ticks]
};

Error FFmpegFilm::EncodeError(int status) const
{
    return Error{ErrorKind::Failed, Name(),
                 "cannot be encoded: " + m_plan.encoder + " failed (" + FFmpegText(status) + ")",
                 "try another quality or format"};
}

Result<void> FFmpegFilm::Open()
{
    ASSIGN_OR_RETURN(FFmpegCodec codec, FFmpegCodec::Open(m_plan, m_settings, Name()));
    m_codec.emplace(std::move(codec));
    m_tick = m_codec->Context().time_base;
    m_delay = m_codec->Context().has_b_frames;
    m_keyframeDistance = KeyframeDistance(m_plan, m_codec->Context());
    m_decodingTimes.emplace(m_delay);
    RETURN_IF_ERROR(OpenPicture());
    RETURN_IF_ERROR(OpenFile());
    return m_settings.resume && !IsAnimation(m_format) ? Resume() : OpenMuxer();
}

/// Opens the file. The interrupted film is kept until its complete groups have been copied.
Result<void> FFmpegFilm::OpenFile()
{
    if (IsPipe(m_path))
    {
        m_output = std::make_unique<FFmpegOutput>(nullptr);
        return {};
    }
    const bool isFresh = m_settings.overwrite && !m_settings.resume;
    ASSIGN_OR_RETURN(AtomicFile file,
                     AtomicFile::Create(m_path, {.overwrite = m_settings.overwrite,
                                                 .mark = m_settings.resume ? kResumedMark : "part",
                                                 .replacesLeftover = isFresh || m_settings.resume,
                                                 .leftoverRemedy = LeftoverRemedy()}));
    m_file.emplace(std::move(file));
    m_output = std::make_unique<FFmpegOutput>(&*m_file);
    return {};
}

Result<void> FFmpegFilm::OpenMuxer()
{
    ASSIGN_OR_RETURN(const FFmpegOwner<AVCodecParameters> parameters,
                     m_codec->MakeParameters(m_plan, m_settings, Name()));
    if (IsConstantRate())
    {
        m_repeat = FFmpegRepeat::Create(m_plan, *parameters);
    }
    const MuxerStream stream{parameters.get(), m_tick, m_codec->Context().framerate};
    ASSIGN_OR_RETURN(FFmpegMuxer muxer, FFmpegMuxer::Open(*m_output, m_plan.muxer,
                                                          m_plan.muxerOptions, stream, Name()));
    m_muxer.emplace(std::move(muxer));
    return {};
}

Result<void> FFmpegFilm::OpenPicture()
{
    ASSIGN_OR_RETURN(FrameToPicture converter,
                     FrameToPicture::Create(m_settings.width, m_settings.height,
                                            m_codec->Context().pix_fmt,
                                            m_codec->Context().colorspace));
    m_converter.emplace(converter);
    ASSIGN_OR_RETURN(FFmpegOwner<AVFrame> picture, m_codec->MakePicture());
    m_picture = std::move(picture);
    m_isPictureWhole = false;
    return {};
}

/// Copies the complete groups of the interrupted film; the new file then replaces it.
Result<void> FFmpegFilm::Resume()
{
    const std::filesystem::path left = PartPath(m_path);
    m_resumed = m_frames = CountWholeFrames(left, m_frameTimes, m_tick);
    RETURN_IF_ERROR(OpenMuxer());
    if (m_resumed > 0)
    {
        const CopiedPart kept{
            .from = left, .tick = m_tick, .before = m_frameTimes.TimeOf(Last() + 1)};
        RETURN_IF_ERROR(CopyBeginning(kept, *m_muxer, *m_decodingTimes));
        ASSIGN_OR_RETURN(const std::vector<std::int64_t> times, TimesIn(kept));
        m_stored = std::int64_t(times.size());
    }
    m_output->Flush();
    return m_file->Mark("part");
}

Result<void> FFmpegFilm::Append(const Frame& frame, std::span<const PixelBounds> changed)
{
    if (m_repeat)
    {
        RETURN_IF_ERROR(ShowHeld(AV_PICTURE_TYPE_NONE));
    }
    ++m_frames;
    RETURN_IF_ERROR(Fill(frame, changed));
    m_changed = Last();
    if (m_repeat)
    {
        m_held = Last();
        return {};
    }
    return Show(Last());
}

Result<void> FFmpegFilm::Repeat()
{
    const std::int64_t index = m_frames;
    const bool isEncoded = m_repeat ? MustEncode(index) : MustShow(index);
    if (m_repeat)
    {
        RETURN_IF_ERROR(ShowHeld(isEncoded ? AV_PICTURE_TYPE_NONE : AV_PICTURE_TYPE_P));
    }
    ++m_frames;
    if (!m_repeat)
    {
        return isEncoded ? Show(index) : Result<void>();
    }
    if (isEncoded)
    {
        m_held = index;
        return {};
    }
    if (m_plan.needsGroups)
    {
        m_decodingTimes->Show(m_frameTimes.TimeOf(index));
    }
    m_repeat->Add(m_frameTimes.TimeOf(index), m_frameTimes.TimeOf(m_shown));
    m_isAfterRepeat = true;
    return {};
}

/// True if an equal frame must be given to the encoder although it can be repeated. Reasons: it
/// begins a group, a decoder should be able to start there, or the picture has long been still.
/// x264 improves a still picture with each frame that it encodes.
bool FFmpegFilm::MustEncode(std::int64_t index) const
{
    constexpr std::int64_t kFirstImproved = 8; // then 16, 32, …; smaller costs slow motion time
    const std::int64_t still = index - m_changed;
    const bool isImproved =
        still >= kFirstImproved && std::has_single_bit(static_cast<std::uint64_t>(still));
    return m_frameTimes.GroupOf(index) != m_frameTimes.GroupOf(index - 1) ||
           index % m_keyframeDistance == 0 || isImproved;
}

/// Encodes the frame that waits. Frames before and after repeated ones are P, so that no other
/// frame refers to frames on both sides. `type`: of the frame otherwise.
Result<void> FFmpegFilm::ShowHeld(AVPictureType type)
{
    if (m_held < 0)
    {
        return {};
    }
    const bool isKeyframe =
        m_isAfterRepeat && m_shown / m_keyframeDistance != m_held / m_keyframeDistance;
    m_picture->pict_type = isKeyframe        ? AV_PICTURE_TYPE_I
                           : m_isAfterRepeat ? AV_PICTURE_TYPE_P
                                             : type;
    m_isAfterRepeat = false;
    return Show(std::exchange(m_held, -1));
}

Result<void> FFmpegFilm::Fill(const Frame& frame, std::span<const PixelBounds> changed)
{
    const StageTimer timer(m_settings.stages, Stage::Convert);
    // The encoder may still use the last picture; a new one comes from a pool.
    if (FFmpeg().av_frame_is_writable(m_picture.get()) == 0)
    {
        ASSIGN_OR_RETURN(FFmpegOwner<AVFrame> picture, m_codec->MakePicture());
        m_picture = std::move(picture);
        m_isPictureWhole = false;
    }
    if (m_isPictureWhole)
    {
        m_converter->Convert(frame, changed, *m_picture);
    }
    else
    {
        m_converter->Convert(frame, *m_picture);
    }
    m_isPictureWhole = true;
    return {};
}

/// True if a frame equal to the previous one must be encoded. The first and last of a group are, so
/// that a group does not depend on its neighbours. The second of the film is, because most programs
/// derive the rate from the first two frames.
bool FFmpegFilm::MustShow(std::int64_t index) const
{
    const std::int64_t group = m_frameTimes.GroupOf(index);
    const bool isFirst = group != m_group;
    const bool isLast = group != m_frameTimes.GroupOf(index + 1);
    const bool isSecond = m_shown == 0 && m_frameTimes.NumberOf(0) == 0;
    return IsConstantRate() || isSecond || isFirst || isLast;
}

bool FFmpegFilm::IsConstantRate() const
{
    return m_plan.isConstantRate || IsConstant(m_settings.timing, m_format);
}

/// Encodes the picture as frame `index`.
Result<void> FFmpegFilm::Show(std::int64_t index)
{
    RETURN_IF_ERROR(StartGroup(m_frameTimes.GroupOf(index)));
    m_shown = index;
    m_picture->pts = m_frameTimes.TimeOf(index);
    if (m_plan.needsGroups)
    {
        m_decodingTimes->Show(m_picture->pts);
    }
    return Encode(m_picture.get());
}

Result<void> FFmpegFilm::StartGroup(std::int64_t group)
{
    const bool isNew = group != m_group && m_group >= 0 && m_plan.needsGroups;
    m_group = group;
    if (!isNew)
    {
        return {};
    }
    RETURN_IF_ERROR(EndGroup());
    const StageTimer timer(m_settings.stages, Stage::Encode);
    ASSIGN_OR_RETURN(FFmpegCodec codec, FFmpegCodec::Open(m_plan, m_settings, Name()));
    m_codec.emplace(std::move(codec));
    return {};
}

/// Flushes and closes the encoder before the next one starts: two at once need twice the memory and
/// were not faster.
Result<void> FFmpegFilm::EndGroup()
{
    Result<void> written = Encode(nullptr);
    m_codec.reset();
    return written;
}

/// Sends the picture and writes all available packets; null flushes the encoder.
Result<void> FFmpegFilm::Encode(const AVFrame* picture)
{
    const Result<Packets> packets = Take(picture);
    return packets ? Write(*packets) : Result<void>(packets.GetError());
}

Result<Packets> FFmpegFilm::Take(const AVFrame* picture)
{
    const StageTimer timer(m_settings.stages, Stage::Encode);
    Packets packets;
    int status = m_codec->Send(picture);
    while (status >= 0)
    {
        FFmpegOwner<AVPacket> packet(FFmpeg().av_packet_alloc());
        status = m_codec->Receive(*packet);
        if (status >= 0)
        {
            packets.push_back(std::move(packet));
        }
    }
    if (m_repeat)
    {
        Packets passed;
        for (FFmpegOwner<AVPacket>& packet : packets)
        {
            ASSIGN_OR_RETURN(Packets more, m_repeat->Pass(std::move(packet)));
            std::move(more.begin(), more.end(), std::back_inserter(passed));
        }
        if (picture == nullptr)
        {
            ASSIGN_OR_RETURN(Packets more, m_repeat->Pass(nullptr));
            std::move(more.begin(), more.end(), std::back_inserter(passed));
        }
        packets = std::move(passed);
    }
    const bool isDone = status == AVERROR_EOF || (picture != nullptr && status == AVERROR(EAGAIN));
    return isDone ? Result<Packets>(std::move(packets)) : Result<Packets>(EncodeError(status));
}

Result<void> FFmpegFilm::Write(const Packets& packets)
{
    const StageTimer timer(m_settings.stages, Stage::Write);
    for (const FFmpegOwner<AVPacket>& packet : packets)
    {
        packet->dts = m_plan.needsGroups ? m_decodingTimes->Next() : packet->pts;
        m_lastWritten = packet->pts;
        ++m_stored;
        packet->duration = 1;
        RETURN_IF_ERROR(m_muxer->Write(*packet));
    }
    return {};
}

/// Flushes the encoder and writes the end of the container.
Result<void> FFmpegFilm::Finish()
{
    if (m_frames == m_resumed) // no frame was added to the resumed ones
    {
        return m_muxer->Finish();
    }
    RETURN_IF_ERROR(ShowHeld(AV_PICTURE_TYPE_NONE));
    const bool isLastShown = m_shown == Last();
    if (!m_repeat && !isLastShown && !IsAnimation(m_format))
    {
        if (Result<void> shown = Show(Last()); !shown) // it defines the duration of the previous
                                                       // frame
        {
            return shown;
        }
    }
    RETURN_IF_ERROR(EndGroup());
    if (m_format == VideoFormat::Apng)
    {
        m_muxer->SetFinalDelay(m_frameTimes.TimeOf(Last() + 1) - m_lastWritten);
    }
    const StageTimer timer(m_settings.stages, Stage::Write);
    return m_muxer->Finish();
}

Result<void> FFmpegFilm::Close()
{
    RETURN_IF_ERROR(Finish());
    if (!m_file)
    {
        return {};
    }
    const StageTimer timer(m_settings.stages, Stage::Write);
    return m_format == VideoFormat::Mp4 ? CommitWithIndexInFront() : m_file->Commit();
}

Result<void> FFmpegFilm::Suspend()
{
    RETURN_IF_ERROR(Finish());
    return m_file ? m_file->Leave() : Result<void>();
}

/// While it is recorded, an MP4 consists of fragments, each of which can be played. Now they are
/// copied behind a common index.
Result<void> FFmpegFilm::CommitWithIndexInFront()
{
    return WriteWithIndexInFront(m_path, m_settings.overwrite, m_file->PartPath(), m_tick, m_delay);
}

} // namespace

Result<std::unique_ptr<VideoSink>> OpenFFmpegFilm(const std::filesystem::path& path,
                                                  VideoFormat format, const VideoSettings& settings)
{
    RETURN_IF_ERROR(LoadFFmpeg());
    ASSIGN_OR_RETURN(EncoderPlan plan, PlanFor(format, settings));
    auto film = std::make_unique<FFmpegFilm>(path, format, std::move(plan), settings);
    RETURN_IF_ERROR(film->Open());
    return std::unique_ptr<VideoSink>(std::move(film));
}

} // namespace boxreel
