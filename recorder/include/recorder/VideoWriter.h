// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <recorder/FrameClock.h>
#include <recorder/FrameRange.h>
#include <recorder/StageTimes.h>
#include <render/Frame.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// @file
/// Frames into a film: Open, Append each, Close. The format follows from the name:
///
/// | name            | what is written                                                          |
/// | --------------- | ------------------------------------------------------------------------ |
/// | .mp4            | H.264; AV1                                                               |
/// | .mkv            | H.264; VP9, AV1; FFV1 when lossless                                      |
/// | .webm           | VP9; AV1                                                                 |
/// | .gif            | a palette of at most 256 colours a frame, exact where they suffice       |
/// | .apng, .webp    | every pixel survives, whatever the quality                               |
/// | frames-####.png | a picture each                                                           |
/// | .y4m, .nut      | YUV 4:2:0 or 4:4:4, and RGB, not compressed: for other programs          |
/// | -               | the standard output, as VideoSettings::format says                       |
///
/// The film is written as NAME.part.EXT in the same folder and renamed by Close; a writer that is
/// destroyed before Close or Suspend removes what it wrote. libav is loaded by Open, not before,
/// and not at all for pictures. Same frames and settings, same bytes, on any machine with the same
/// libraries.
///
/// - Films have no transparency: the frame's premultiplied colours are taken as they are, so what
///   is see-through lies on black.
/// - YUV has the matrix, primaries and transfer of bt709, limited range, and says so; only y4m
///   cannot, and has the matrix of bt601 below 720 lines, as others read it. The transfer
///   is tagged bt709 although frames are sRGB: it is what players expect of HD and show unchanged,
///   while the sRGB tag makes some of them convert or give up their fast path.
/// - Lossless stores RGB: .mkv FFV1, .mp4 H.264 of the profile High 4:4:4 Predictive (mpv, VLC and
///   ffmpeg play it, browsers do not), .webm VP9 4:4:4, .gif when no frame has more than 256
///   colours.
/// - A frame that is equal to the one before is not encoded again where the format can show one for
///   longer, but at the beginning and end of a group (below) and of the film.
/// - Films are encoded in groups of frames that know nothing of each other, so that parts of a film
///   made by themselves can be joined to the very film that is made in one go, and a film that was
///   interrupted be continued.
/// - A GIF stores times in 1/100 s: each is rounded by itself and never drifts. Frames shorter than
///   1/50 s are not shown by browsers, so above 50 frames a second every n-th frame is kept
///   (StoredFrameRate says what is left: 60 becomes 30).
/// - Gif, apng and webp lose nothing when they are read and written again, which is how these are
///   continued and joined.
/// - Matroska and WebM store times in 1/1000 s, rounded in the same way; MP4 stores them exactly.
/// - Pictures are numbered as VideoSettings::frames says, with as many digits as there are # (more
///   when the number needs them), and each is there whole or not at all.
namespace boxreel
{

/// How much of a frame survives.
enum class Quality
{
    Draft,    ///< fastest to encode
    Standard, ///< lines look clean, files are small
    High,     ///< hard to tell from the frames
    Lossless, ///< every pixel survives; a format that cannot is an Error
};

/// How much of the colours' resolution YUV keeps; brightness is always whole.
enum class Chroma
{
    Half, ///< 4:2:0, which everything plays
    Full, ///< 4:4:4: coloured lines stay sharp, browsers do not play it as H.264
};

/// What a film is to be like.
struct VideoSettings
{
    int width = 1280;                    ///< 1 to 8192, even where colours are halved [px]
    int height = 720;                    ///< 1 to 8192, even where colours are halved [px]
    Rational framesPerSecond{60, 1};     ///< above 0, at most 1000
    Quality quality = Quality::Standard; ///< how much survives
    Chroma chroma = Chroma::Half;        ///< how much colour survives
    std::string codec{};                 ///< one of CodecChoices; empty: the first of the format's
    std::string format{}; ///< of the standard output: y4m, nut, mkv or webm; empty for files
    /// Options of libav's encoder, by its names, over those that the quality sets.
    std::vector<std::pair<std::string, std::string>> codecOptions{};
    int plays = 0;   ///< how often a gif, apng or webp plays, up to 65535; 0: for ever
    int threads = 0; ///< of the encoder, 0 to 64; 0: two. H.264's bytes depend on it, the film's
                     ///< look does not.
    bool constantRate = false; ///< every frame is encoded, also one that shows the same; webp
                               ///< cannot
    int groupFrames = 100;     ///< length of a group; at least 1 [frames that are kept]
    /// The numbers of the frames that are appended, in the film of which this one may be a part:
    /// groups begin at multiples of their length, and pictures are called by them.
    FrameRange frames{};
    bool overwrite = false;       ///< false: an existing film, or what is left of one, is an Error
    bool resume = false;          ///< true: what is left of one is continued, from ResumedFrames on
    StageTimes* stages = nullptr; ///< what each stage of the film takes; null: not timed
};

/// What the names of films end in, but for pictures and the standard output: ".mp4" and so on.
std::vector<std::string> VideoEnds();

/// A codec that films can be asked to have.
struct CodecChoice
{
    std::string name;              ///< "h264"
    std::vector<std::string> ends; ///< of the names of films that can have it: ".mp4", ".mkv"
};

/// Of formats that can have more than one.
std::vector<CodecChoice> CodecChoices();

/// Whether `path` names a format that can be written with these settings, without opening anything.
/// An Error (Unusable) says why not: unknown extension, a size the format cannot hold (with the
/// nearest that it can), a codec or a quality that it does not have.
Result<void> CheckVideoPath(const std::filesystem::path& path, const VideoSettings& settings);

/// From one frame that a part of such a film may begin with to the next, at multiples; 0: it has no
/// parts. `settings` must have passed CheckVideoPath.
std::int64_t PartLength(const std::filesystem::path& path, const VideoSettings& settings);

/// How many frames a second the film at `path` will hold: as asked, but for a GIF above 50.
Rational StoredFrameRate(const std::filesystem::path& path, const Rational& framesPerSecond);

class VideoSink;

/// Frames into a film.
class VideoWriter
{
public:
    /// Starts the film; an Error when settings and format contradict, the file exists, or libav is
    /// absent.
    static Result<VideoWriter> Open(const std::filesystem::path& path,
                                    const VideoSettings& settings);
    /// The other may only be assigned to or destroyed.
    VideoWriter(VideoWriter&&) noexcept;
    /// The other may only be assigned to or destroyed.
    VideoWriter& operator=(VideoWriter&&) noexcept;
    ~VideoWriter();

    /// How many frames of an interrupted film were found whole and are kept; the next one to append
    /// comes after them. 0 unless `resume` was set.
    std::int64_t ResumedFrames() const;

    /// What its settings name to time its stages with; null: nothing.
    StageTimes* Stages() const;

    /// Appends a frame, whose size must be that of the settings. Its time is its number among those
    /// appended divided by framesPerSecond. An Error (Failed) when it has another size, or what
    /// encodes or the disk fails; after one nothing more can be appended.
    Result<void> Append(const Frame& frame);

    /// Appends a frame that differs from the last one inside of `changed` only. Errors as above.
    Result<void> Append(const Frame& frame, std::span<const PixelBounds> changed);

    /// Appends the last frame once more. Errors as above, and (Failed) when there is none yet.
    Result<void> Repeat();

    /// Flushes the encoder, syncs, gives the file its name. Nothing may follow. An Error (Unusable)
    /// when no frame was appended, (Failed) after an earlier Error or end, or when the disk is
    /// full; then the name is left as it was.
    Result<void> Close();

    /// Ends early: what was appended becomes a film that can be played, and stays as NAME.part.EXT,
    /// to be continued by a writer with `resume`. Nothing may follow. Errors as of Close.
    Result<void> Suspend();

private:
    struct Impl;
    explicit VideoWriter(std::unique_ptr<Impl> impl);
    Result<void> Resume(const std::filesystem::path& left, const VideoSettings& settings);
    Result<void> End(Result<void> (VideoSink::*end)());
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
