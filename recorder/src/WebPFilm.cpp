// SPDX-License-Identifier: MIT
#include "WebPFilm.h"
#include "SettingTexts.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <base/SharedLibrary.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <webp/encode.h>
#include <webp/mux.h>

namespace boxreel
{

namespace
{

/// The functions of libwebp in use; its headers wrap them in inline functions that check versions.
struct WebPLibrary
{
    decltype(&::WebPConfigInitInternal) configInit = nullptr;
    decltype(&::WebPValidateConfig) validateConfig = nullptr;
    decltype(&::WebPPictureInitInternal) pictureInit = nullptr;
    decltype(&::WebPPictureImportRGBX) pictureImport = nullptr;
    decltype(&::WebPPictureFree) pictureFree = nullptr;
    decltype(&::WebPFree) free = nullptr;
    decltype(&::WebPAnimEncoderOptionsInitInternal) optionsInit = nullptr;
    decltype(&::WebPAnimEncoderNewInternal) encoderNew = nullptr;
    decltype(&::WebPAnimEncoderAdd) encoderAdd = nullptr;
    decltype(&::WebPAnimEncoderAssemble) encoderAssemble = nullptr;
    decltype(&::WebPAnimEncoderGetError) encoderError = nullptr;
    decltype(&::WebPAnimEncoderDelete) encoderDelete = nullptr;
};

Result<WebPLibrary> Load()
{
    ASSIGN_OR_RETURN(SharedLibrary coder, SharedLibrary::Open("libwebp.so.7", "libwebp7"));
    ASSIGN_OR_RETURN(SharedLibrary muxer, SharedLibrary::Open("libwebpmux.so.3", "libwebpmux3"));
    WebPLibrary library;
    const bool isWhole = coder.Bind("WebPConfigInitInternal", library.configInit) &&
                         coder.Bind("WebPValidateConfig", library.validateConfig) &&
                         coder.Bind("WebPPictureInitInternal", library.pictureInit) &&
                         coder.Bind("WebPPictureImportRGBX", library.pictureImport) &&
                         coder.Bind("WebPPictureFree", library.pictureFree) &&
                         coder.Bind("WebPFree", library.free) &&
                         muxer.Bind("WebPAnimEncoderOptionsInitInternal", library.optionsInit) &&
                         muxer.Bind("WebPAnimEncoderNewInternal", library.encoderNew) &&
                         muxer.Bind("WebPAnimEncoderAdd", library.encoderAdd) &&
                         muxer.Bind("WebPAnimEncoderAssemble", library.encoderAssemble) &&
                         muxer.Bind("WebPAnimEncoderGetError", library.encoderError) &&
                         muxer.Bind("WebPAnimEncoderDelete", library.encoderDelete);
    if (!isWhole)
    {
        return muxer.MissingError("functions that make animations");
    }
    return library;
}

/// Lossless at every quality: flat drawings are smaller so, and lines stay clean. Draft searches
/// less for repetitions.
void SetQuality(Quality quality, WebPConfig& config)
{
    config.lossless = 1;
    config.method = quality == Quality::Draft ? 0 : quality == Quality::High ? 4 : 2;
    config.quality = quality == Quality::Draft ? 0.0f : quality == Quality::High ? 75.0f : 50.0f;
}

/// libwebp's names of its options.
struct OptionName
{
    const char* name;
    int WebPConfig::*whole;
};
constexpr OptionName kOptions[] = {
    {"lossless", &WebPConfig::lossless},
    {"method", &WebPConfig::method},
    {"near_lossless", &WebPConfig::near_lossless},
    {"exact", &WebPConfig::exact},
    {"use_sharp_yuv", &WebPConfig::use_sharp_yuv},
    {"segments", &WebPConfig::segments},
    {"sns_strength", &WebPConfig::sns_strength},
    {"filter_strength", &WebPConfig::filter_strength},
    {"pass", &WebPConfig::pass},
};

Result<double> ParseOption(const std::string& name, const std::string& text)
{
    std::size_t read = 0;
    try
    {
        const double value = std::stod(text, &read);
        if (read == text.size())
        {
            return value;
        }
    }
    catch (const std::exception&)
    {
        read = 0;
    }
    return Error{ErrorKind::Unusable, ErrorSetting{kCodecOptions, {name + "=" + text}},
                 "requires a number after the ="};
}

Result<void> SetOption(const std::string& name, const std::string& text, WebPConfig& config)
{
    ASSIGN_OR_RETURN(const double value, ParseOption(name, text));
    if (name == "quality")
    {
        config.quality = float(value);
        return {};
    }
    std::string known = "quality";
    for (const OptionName& option : kOptions)
    {
        if (name == option.name)
        {
            config.*option.whole = int(value);
            return {};
        }
        known += std::string(", ") + option.name;
    }
    return Error{ErrorKind::Unusable, ErrorSetting{kCodecOptions, {name}},
                 "libwebp has no such option", "use one of " + known};
}

/// Returns the number of frames in a film: its chunks ANMF. A film of one frame is a still picture.
std::int64_t CountFrames(std::span<const std::uint8_t> film)
{
    constexpr std::size_t kFileHeader = 12;
    constexpr std::size_t kChunkHeader = 8;
    std::int64_t frames = 0;
    std::size_t at = kFileHeader;
    while (at + kChunkHeader <= film.size())
    {
        const auto chunk = film.subspan(at);
        frames +=
            std::string_view(reinterpret_cast<const char*>(chunk.data()), 4) == "ANMF" ? 1 : 0;
        const std::size_t size = std::size_t(chunk[4]) | std::size_t(chunk[5]) << 8 |
                                 std::size_t(chunk[6]) << 16 | std::size_t(chunk[7]) << 24;
        at += kChunkHeader + size + (size & 1); // chunks begin at even bytes
    }
    return std::max<std::int64_t>(frames, 1);
}

class WebPFilm final : public VideoSink
{
public:
    WebPFilm(std::filesystem::path path, const VideoSettings& settings, const WebPLibrary& library)
        : m_path(std::move(path)), m_settings(settings), m_library(library)
    {}
    ~WebPFilm() override;

    Result<void> Open();
    std::optional<std::int64_t> StoredFrames() const override { return m_stored; }
    Result<void> Append(const Frame& frame, std::span<const PixelBounds> changed) override;
    Result<void> Repeat() override;
    Result<void> TakePlace() override { return m_file->Mark("part"); }
    Result<void> Close() override;
    Result<void> Suspend() override;

private:
    Result<void> Configure();
    int TimeOf(std::int64_t frame) const; ///< [ms]
    Result<void> Write();
    Error EncodeError() const;

    std::filesystem::path m_path;
    VideoSettings m_settings;
    WebPLibrary m_library;
    std::optional<AtomicFile> m_file;
    WebPConfig m_config{};
    WebPAnimEncoder* m_encoder = nullptr;
    std::int64_t m_frames = 0;            // appended or repeated
    std::optional<std::int64_t> m_stored; // known at the end
};

WebPFilm::~WebPFilm()
{
    if (m_encoder != nullptr)
    {
        m_library.encoderDelete(m_encoder);
    }
}

Error WebPFilm::EncodeError() const
{
    return Error{ErrorKind::Failed, m_path.string(),
                 std::string("cannot be encoded: ") + m_library.encoderError(m_encoder),
                 "use a smaller size or another format"};
}

Result<void> WebPFilm::Configure()
{
    if (m_library.configInit(&m_config, WEBP_PRESET_DEFAULT, 75.0f, WEBP_ENCODER_ABI_VERSION) == 0)
    {
        return Error{ErrorKind::Absent, "libwebp", "has an unsupported version",
                     "install Debian's libwebp7"};
    }
    SetQuality(m_settings.quality, m_config);
    for (const auto& [name, value] : m_settings.codecOptions)
    {
        RETURN_IF_ERROR(SetOption(name, value, m_config));
    }
    if (m_library.validateConfig(&m_config) == 0)
    {
        return Error{ErrorKind::Unusable, ErrorSetting{kCodecOptions},
                     "libwebp refuses these values", "`cwebp -longhelp` lists the valid values"};
    }
    return {};
}

Result<void> WebPFilm::Open()
{
    RETURN_IF_ERROR(Configure());
    const bool isResumed = m_settings.resume;
    ASSIGN_OR_RETURN(
        AtomicFile file,
        AtomicFile::Create(m_path, {.overwrite = m_settings.overwrite,
                                    .mark = isResumed ? kResumedMark : "part",
                                    .replacesLeftover = m_settings.overwrite || isResumed,
                                    .leftoverRemedy = LeftoverRemedy()}));
    m_file.emplace(std::move(file));
    WebPAnimEncoderOptions options;
    m_library.optionsInit(&options, WEBP_MUX_ABI_VERSION);
    options.anim_params.loop_count = m_settings.plays;
    m_encoder =
        m_library.encoderNew(m_settings.width, m_settings.height, &options, WEBP_MUX_ABI_VERSION);
    return m_encoder != nullptr ? Result<void>()
                                : Result<void>(Error{ErrorKind::Failed, m_path.string(),
                                                     "cannot be encoded: libwebp did not start",
                                                     "free some memory"});
}

/// Each time is rounded separately, so that errors do not add up.
int WebPFilm::TimeOf(std::int64_t frame) const
{
    const Rational& rate = m_settings.framesPerSecond;
    return int((frame * 2000 * rate.den + rate.num) / (rate.num * 2));
}

Result<void> WebPFilm::Append(const Frame& frame, std::span<const PixelBounds>)
{
    const StageTimer timer(m_settings.stages, Stage::Encode);
    WebPPicture picture;
    m_library.pictureInit(&picture, WEBP_ENCODER_ABI_VERSION);
    picture.width = frame.width;
    picture.height = frame.height;
    picture.use_argb = 1;
    const bool isTaken =
        m_library.pictureImport(&picture, frame.rgba.data(), frame.width * 4) != 0 &&
        m_library.encoderAdd(m_encoder, &picture, TimeOf(m_frames), &m_config) != 0;
    m_library.pictureFree(&picture);
    ++m_frames;
    return isTaken ? Result<void>() : Result<void>(EncodeError());
}

Result<void> WebPFilm::Repeat()
{
    ++m_frames; // the previous frame stays until the next one
    return {};
}

Result<void> WebPFilm::Write()
{
    const StageTimer timer(m_settings.stages, Stage::Encode);
    WebPData data{};
    const bool isWhole = m_library.encoderAdd(m_encoder, nullptr, TimeOf(m_frames), nullptr) != 0 &&
                         m_library.encoderAssemble(m_encoder, &data) != 0;
    if (!isWhole)
    {
        return EncodeError();
    }
    m_stored = CountFrames({data.bytes, data.size});
    Result<void> written = m_file->Write({data.bytes, data.size});
    m_library.free(const_cast<std::uint8_t*>(data.bytes));
    return written;
}

Result<void> WebPFilm::Close()
{
    const Result<void> written = Write();
    return written ? m_file->Commit() : written;
}

Result<void> WebPFilm::Suspend()
{
    const Result<void> written = Write();
    return written ? m_file->Leave() : written;
}

} // namespace

Result<std::unique_ptr<VideoSink>> OpenWebPFilm(const std::filesystem::path& path,
                                                const VideoSettings& settings)
{
    ASSIGN_OR_RETURN(const WebPLibrary library, Load());
    auto film = std::make_unique<WebPFilm>(path, settings, library);
    RETURN_IF_ERROR(film->Open());
    return std::unique_ptr<VideoSink>(std::move(film));
}

} // namespace boxreel
