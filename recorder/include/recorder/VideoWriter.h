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
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// @file
/// Writes frames to a film: Open, Append each, Close. The name selects the format:
///
/// | name            | what is written                                                          |
/// | --------------- | ------------------------------------------------------------------------ |
/// | .mp4            | H.264; AV1                                                               |
/// | .mkv            | H.264; VP9, AV1; FFV1 when lossless                                      |
/// | .webm           | VP9; AV1                                                                 |
/// | .gif            | a palette of up to 256 colours per frame, exact if they suffice          |
/// | .apng, .webp    | lossless at every quality                                                |
/// | frames-####.png | one picture per frame                                                    |
/// | .y4m, .nut      | uncompressed YUV 4:2:0 or 4:4:4, and RGB, for other programs             |
/// | -               | standard output, in the format of VideoSettings::format                  |
///
/// The film is written as NAME.part.EXT in the same folder and renamed by Close. A writer that is
/// destroyed before Close or Suspend removes its files. Open loads libav, except for pictures. Same
/// frames and settings, same bytes, on any machine with the same libraries.
///
/// - Films have no transparency: premultiplied colours are stored unchanged, so transparent areas
///   are black.
/// - YUV uses the matrix, primaries and transfer of bt709, limited range, and is tagged so. Y4m has
///   no tags; it uses the matrix of bt601 below 720 lines, as other programs expect.
/// - The transfer is tagged bt709 although frames are sRGB. Players expect bt709 for HD and show it
///   unchanged. With the sRGB tag some of them convert or lose their fast path.
/// - Lossless stores RGB. It is .mkv FFV1, .webm VP9 4:4:4, or .gif if no frame has more than 256
///   colours. For .mp4 it is H.264 High 4:4:4 Predictive, which mpv, VLC and ffmpeg play and
///   browsers do not.
/// - .mp4, .mkv and .webm have a constant frame rate: each frame is stored, at its time. A frame
///   equal to the previous one is not given to the encoder. H.264 and VP9 store a few bytes for it,
///   FFV1 the same packet again; only AV1 encodes it.
/// - With FrameTiming::Variable, and in animations, such a frame is not stored; the previous one
///   has a longer duration. Exceptions are the first and last frame of a group (below) and of the
///   film.
/// - With VideoSettings::groupFrames, films are encoded in independent groups of frames. Parts
///   recorded separately can then be joined to the same film as a single recording, and an
///   interrupted film resumed to it. Without, a film is smaller, and resumed at its last keyframe.
/// - A GIF stores times in 1/100 s; each is rounded separately, so there is no drift. Browsers do
///   not show frames shorter than 1/50 s, so above 50 frames a second every n-th frame is kept.
///   StoredFrameRate returns the resulting rate: 60 becomes 30.
/// - Gif, apng and webp are resumed and joined by decoding and encoding again, which is lossless
///   for them.
/// - Matroska and WebM store times in 1/1000 s, rounded in the same way; MP4 stores them exactly.
/// - Pictures are numbered by VideoSettings::frames, with at least as many digits as there are #.
///   Each is written completely or not at all.
namespace boxreel
{

/// Quality of the encoding.
enum class Quality
{
    Draft,    ///< fastest to encode
    Standard, ///< clean lines, small files
    High,     ///< almost identical to the frames
    Lossless, ///< every pixel is preserved; an Error for a format that cannot
};

/// Resolution of the colours in YUV; brightness always has full resolution.
enum class Chroma
{
    Half, ///< 4:2:0, playable everywhere
    Full, ///< 4:4:4: sharp coloured lines; browsers do not play it as H.264
};

/// Whether every frame is stored.
enum class FrameTiming
{
    Automatic, ///< Constant for .mp4, .mkv and .webm, Variable for .gif, .apng and .webp
    Constant,  ///< every frame is stored; an Error for .webp
    Variable,  ///< a frame is shown for longer instead of stored again; an Error for .y4m, .nut and
               ///< pictures
};

/// Format and quality of a film.
struct VideoSettings
{
    int width = 1280;                    ///< 1 to 8192, even with Chroma::Half [px]
    int height = 720;                    ///< 1 to 8192, even with Chroma::Half [px]
    Rational framesPerSecond{60, 1};     ///< above 0, at most 1000
    Quality quality = Quality::Standard; ///< quality of the encoding
    Chroma chroma = Chroma::Half;        ///< resolution of the colour planes
    std::string codec{};                 ///< one of CodecChoices; empty: the first of the format's
    std::string format{}; ///< of the standard output: y4m, nut, mkv or webm; empty for files
    /// Options of libav's encoder, by its names, over those that the quality sets.
    std::vector<std::pair<std::string, std::string>> codecOptions{};
    int plays = 0;   ///< how often a gif, apng or webp plays, up to 65535; 0: forever
    int threads = 0; ///< threads of the encoder, 0 to 64; 0: two. H.264's bytes depend on it, not
                     ///< its quality.
    FrameTiming timing = FrameTiming::Automatic; ///< whether identical frames are stored
    /// Length of a group, at least 0 [stored frames]. 0: films have no groups, animations have
    /// groups of kPartFrames.
    int groupFrames = 0;
    /// Numbers of the appended frames in the whole film, of which this may be a part. Groups start
    /// at multiples of their length; picture files have these numbers.
    FrameRange frames{};
    bool overwrite = false;       ///< false: an existing or interrupted film is an Error
    bool resume = false;          ///< true: continue an interrupted film from ResumedFrames on
    StageTimes* stages = nullptr; ///< receives the stage times; null: not timed
};

/// Returns the file with a frame: of "frames-####.png" its picture, of other films the film.
std::filesystem::path FileOfFrame(const std::filesystem::path& film, std::int64_t number);

/// Returns the extensions of films, without pictures and standard output: ".mp4" and so on.
std::vector<std::string> VideoEnds();

/// A codec that a film can have.
struct CodecChoice
{
    std::string name;              ///< "h264"
    std::vector<std::string> ends; ///< of the names of films that can have it: ".mp4", ".mkv"
};

/// Returns the codecs of the formats that have more than one.
std::vector<CodecChoice> CodecChoices();

/// Checks that `path` names a format that can be written with these settings, without opening
/// anything. Otherwise returns an Error (Unusable) with the reason. Examples are an unknown
/// extension, a codec or quality that the format does not have, and a size that it cannot hold. For
/// a size, the Error contains the nearest valid one.
Result<void> CheckVideoPath(const std::filesystem::path& path, const VideoSettings& settings);

/// Length of the groups of films that are made in parts, if no other is asked for [stored frames].
inline constexpr int kPartFrames = 100;

/// Returns the frame count between possible starts of a part; parts start at multiples. 0: the film
/// cannot be split. It is that of groups of kPartFrames if the settings have none. `settings` must
/// have passed CheckVideoPath.
std::int64_t PartLength(const std::filesystem::path& path, const VideoSettings& settings);

/// Returns the frame rate of the film at `path`: as requested, except for a GIF above 50.
Rational StoredFrameRate(const std::filesystem::path& path, const Rational& framesPerSecond);

class VideoSink;

/// Writes frames to a film.
class VideoWriter
{
public:
    /// Starts the film. An Error when settings and format contradict, the file exists, or libav is
    /// missing.
    static Result<VideoWriter> Open(const std::filesystem::path& path,
                                    const VideoSettings& settings);
    /// Leaves the source in a moved-from state.
    VideoWriter(VideoWriter&&) noexcept;
    /// Leaves the source in a moved-from state.
    VideoWriter& operator=(VideoWriter&&) noexcept;
    ~VideoWriter();

    /// Returns the number of frames kept from an interrupted film; the next appended frame follows
    /// them. 0 unless `resume` is set.
    std::int64_t ResumedFrames() const;

    /// Returns the number of stored frames after Close, if FrameTiming::Variable has left some out.
    std::optional<std::int64_t> StoredFrames() const;

    /// Returns the StageTimes of the settings; may be null.
    StageTimes* Stages() const;

    /// Appends a frame of the size in the settings. Its time is its index divided by
    /// framesPerSecond. An Error (Failed) for a different size, or when the encoder or the disk
    /// fails. After an Error nothing more can be appended.
    Result<void> Append(const Frame& frame);

    /// Appends a frame that differs from the last one only inside `changed`. Errors as above.
    Result<void> Append(const Frame& frame, std::span<const PixelBounds> changed);

    /// Appends the last frame again. Errors as above, and (Failed) without a frame.
    Result<void> Repeat();

    /// Flushes the encoder, syncs to disk and renames the file. The object cannot be used
    /// afterwards. An Error (Unusable) if no frame was appended; (Failed) after an earlier Error or
    /// end, or when the disk is full. An existing file is then unchanged.
    Result<void> Close();

    /// Ends early: the appended frames become a playable film NAME.part.EXT, which a writer with
    /// `resume` can continue. The object cannot be used afterwards. Errors as in Close.
    Result<void> Suspend();

private:
    struct Impl;
    explicit VideoWriter(std::unique_ptr<Impl> impl);
    Result<void> Resume(const std::filesystem::path& left, const VideoSettings& settings);
    Result<void> End(Result<void> (VideoSink::*end)());
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
