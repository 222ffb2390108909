// SPDX-License-Identifier: MIT
#include "WebPReader.h"

#include <base/ErrorMacros.h>
#include <base/ReadWhole.h>
#include <base/SharedLibrary.h>

#include <cstdint>
#include <cstring>
#include <utility>

#include <webp/demux.h>

namespace boxreel
{

namespace
{

constexpr std::uintmax_t kLargestFile = 0xFFFFFFFE; // limit of a RIFF container [bytes]

struct WebPLibrary
{
    decltype(&::WebPAnimDecoderOptionsInitInternal) optionsInit = nullptr;
    decltype(&::WebPAnimDecoderNewInternal) decoderNew = nullptr;
    decltype(&::WebPAnimDecoderGetInfo) getInfo = nullptr;
    decltype(&::WebPAnimDecoderGetNext) getNext = nullptr;
    decltype(&::WebPAnimDecoderHasMoreFrames) hasMore = nullptr;
    decltype(&::WebPAnimDecoderDelete) decoderDelete = nullptr;
};

Result<WebPLibrary> Load()
{
    ASSIGN_OR_RETURN(SharedLibrary opened,
                     SharedLibrary::Open("libwebpdemux.so.2", "libwebpdemux2"));
    WebPLibrary library;
    const bool isWhole = opened.Bind("WebPAnimDecoderOptionsInitInternal", library.optionsInit) &&
                         opened.Bind("WebPAnimDecoderNewInternal", library.decoderNew) &&
                         opened.Bind("WebPAnimDecoderGetInfo", library.getInfo) &&
                         opened.Bind("WebPAnimDecoderGetNext", library.getNext) &&
                         opened.Bind("WebPAnimDecoderHasMoreFrames", library.hasMore) &&
                         opened.Bind("WebPAnimDecoderDelete", library.decoderDelete);
    if (!isWhole)
    {
        return opened.MissingError("functions that read animations");
    }
    return library;
}

class WebPReader final : public VideoSource
{
public:
    WebPReader(std::filesystem::path path, const WebPLibrary& library)
        : m_path(std::move(path)), m_library(library)
    {}
    ~WebPReader() override;

    Result<void> Open();
    Result<bool> Next(StoredFrame& stored) override;

private:
    std::filesystem::path m_path;
    WebPLibrary m_library;
    std::string m_bytes;
    WebPAnimDecoder* m_decoder = nullptr;
    WebPAnimInfo m_info{};
    int m_end = 0; // end of the last frame [ms]
};

WebPReader::~WebPReader()
{
    if (m_decoder != nullptr)
    {
        m_library.decoderDelete(m_decoder);
    }
}

Result<void> WebPReader::Open()
{
    ASSIGN_OR_RETURN(m_bytes, ReadWhole(m_path, kLargestFile));
    const WebPData data{reinterpret_cast<const std::uint8_t*>(m_bytes.data()), m_bytes.size()};
    WebPAnimDecoderOptions options;
    m_library.optionsInit(&options, WEBP_DEMUX_ABI_VERSION);
    m_decoder = m_library.decoderNew(&data, &options, WEBP_DEMUX_ABI_VERSION);
    if (m_decoder == nullptr || m_library.getInfo(m_decoder, &m_info) == 0)
    {
        return Error{ErrorKind::Unusable, m_path.string(),
                     "is not a WebP, or is damaged or truncated", "record it again"};
    }
    const Rational unknown{1000, 1}; // the time unit is not stored
    info = RgbInfo(int(m_info.canvas_width), int(m_info.canvas_height), unknown, "webp", "webp");
    return {};
}

Result<bool> WebPReader::Next(StoredFrame& stored)
{
    if (m_library.hasMore(m_decoder) == 0)
    {
        return false;
    }
    std::uint8_t* pixels = nullptr;
    int end = 0;
    if (m_library.getNext(m_decoder, &pixels, &end) == 0)
    {
        return Error{ErrorKind::Failed, m_path.string(), "is damaged", "record it again"};
    }
    stored.frame = Frame(info.width, info.height);
    std::memcpy(stored.frame.rgba.data(), pixels, stored.frame.rgba.size());
    stored.seconds = double(m_end) / 1000.0;
    stored.length = double(end - m_end) / 1000.0;
    m_end = end;
    return true;
}

} // namespace

Result<std::unique_ptr<VideoSource>> OpenWebPReader(const std::filesystem::path& path)
{
    ASSIGN_OR_RETURN(const WebPLibrary library, Load());
    auto reader = std::make_unique<WebPReader>(path, library);
    RETURN_IF_ERROR(reader->Open());
    return std::unique_ptr<VideoSource>(std::move(reader));
}

} // namespace boxreel
