// SPDX-License-Identifier: MIT
#include "WebPReader.h"

#include <base/SharedLibrary.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include <webp/demux.h>

namespace boxreel
{

namespace
{

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
    Result<SharedLibrary> opened = SharedLibrary::Open("libwebpdemux.so.2", "libwebpdemux2");
    if (!opened)
    {
        return opened.GetError();
    }
    WebPLibrary library;
    const bool isWhole = opened->Bind("WebPAnimDecoderOptionsInitInternal", library.optionsInit) &&
                         opened->Bind("WebPAnimDecoderNewInternal", library.decoderNew) &&
                         opened->Bind("WebPAnimDecoderGetInfo", library.getInfo) &&
                         opened->Bind("WebPAnimDecoderGetNext", library.getNext) &&
                         opened->Bind("WebPAnimDecoderHasMoreFrames", library.hasMore) &&
                         opened->Bind("WebPAnimDecoderDelete", library.decoderDelete);
    if (!isWhole)
    {
        return Error{ErrorKind::Absent, "This libwebp cannot read animations; install Debian's "
                                        "libwebpdemux2."};
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
    std::vector<std::uint8_t> m_bytes;
    WebPAnimDecoder* m_decoder = nullptr;
    WebPAnimInfo m_info{};
    int m_end = 0; // of the last frame [ms]
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
    std::ifstream file(m_path, std::ios::binary);
    if (!file)
    {
        return Error{ErrorKind::Unusable,
                     m_path.string() + " cannot be read; check the name and its permissions."};
    }
    m_bytes.assign(std::istreambuf_iterator<char>(file), {});
    const WebPData data{m_bytes.data(), m_bytes.size()};
    WebPAnimDecoderOptions options;
    m_library.optionsInit(&options, WEBP_DEMUX_ABI_VERSION);
    m_decoder = m_library.decoderNew(&data, &options, WEBP_DEMUX_ABI_VERSION);
    if (m_decoder == nullptr || m_library.getInfo(m_decoder, &m_info) == 0)
    {
        return Error{ErrorKind::Unusable, m_path.string() + " is not a WebP that can be read; it "
                                                            "is damaged, cut short or of another "
                                                            "kind."};
    }
    const Rational unknown{1000, 1}; // what its times are multiples of is not stored
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
        return Error{ErrorKind::Failed, m_path.string() + " is damaged; record it again."};
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
    const Result<WebPLibrary> library = Load();
    if (!library)
    {
        return library.GetError();
    }
    auto reader = std::make_unique<WebPReader>(path, *library);
    if (Result<void> opened = reader->Open(); !opened)
    {
        return opened.GetError();
    }
    return std::unique_ptr<VideoSource>(std::move(reader));
}

} // namespace boxreel
