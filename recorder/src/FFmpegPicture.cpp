// SPDX-License-Identifier: MIT
#include "FFmpegPicture.h"

#include <utility>

namespace boxreel
{

namespace
{

// Exact rounding and chroma for each pixel; BITEXACT keeps SIMD paths of different machines equal.
constexpr int kFlags =
    SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP | SWS_FULL_CHR_H_INT | SWS_BITEXACT;

constexpr int kOne = 1 << 16; // swscale's 1.0 for contrast and saturation

void SetColours(SwsContext* context, int sourceSpace, bool sourceFull, int targetSpace,
                bool targetFull)
{
    // Fails for RGB on both sides, where there is nothing to set.
    FFmpeg().sws_setColorspaceDetails(context, FFmpeg().sws_getCoefficients(sourceSpace),
                                      sourceFull ? 1 : 0, FFmpeg().sws_getCoefficients(targetSpace),
                                      targetFull ? 1 : 0, 0, kOne, kOne);
}

/// swscale's number for the matrix of a picture.
int MatrixOf(const AVFrame& picture)
{
    switch (picture.colorspace)
    {
    case AVCOL_SPC_BT709:
        return SWS_CS_ITU709;
    case AVCOL_SPC_BT470BG:
    case AVCOL_SPC_SMPTE170M:
        return SWS_CS_ITU601;
    case AVCOL_SPC_FCC:
        return SWS_CS_FCC;
    case AVCOL_SPC_SMPTE240M:
        return SWS_CS_SMPTE240M;
    case AVCOL_SPC_BT2020_NCL:
    case AVCOL_SPC_BT2020_CL:
        return SWS_CS_BT2020;
    default:
        return picture.height >= 720 ? SWS_CS_ITU709 : SWS_CS_ITU601;
    }
}

bool IsFullRange(const AVFrame& picture)
{
    const AVPixFmtDescriptor* description =
        FFmpeg().av_pix_fmt_desc_get(AVPixelFormat(picture.format));
    const bool isRgb = description != nullptr && (description->flags & AV_PIX_FMT_FLAG_RGB) != 0;
    const bool isFullRangeFormat = picture.format == AV_PIX_FMT_YUVJ420P ||
                                   picture.format == AV_PIX_FMT_YUVJ422P ||
                                   picture.format == AV_PIX_FMT_YUVJ444P;
    return isRgb || isFullRangeFormat || picture.color_range == AVCOL_RANGE_JPEG;
}

} // namespace

Result<FrameToPicture> FrameToPicture::Create(int width, int height, AVPixelFormat format)
{
    FFmpegOwner<SwsContext> context(FFmpeg().sws_getContext(
        width, height, AV_PIX_FMT_RGB0, width, height, format, kFlags, nullptr, nullptr, nullptr));
    if (!context)
    {
        return Error{ErrorKind::Absent,
                     "This libswscale cannot make the pictures a film needs; install Debian's "
                     "libswscale" +
                         std::to_string(LIBSWSCALE_VERSION_MAJOR) + "."};
    }
    SetColours(context.get(), SWS_CS_ITU709, true, SWS_CS_ITU709, false);
    return FrameToPicture(std::move(context));
}

FrameToPicture::FrameToPicture(FFmpegOwner<SwsContext> context) : m_context(std::move(context)) {}

void FrameToPicture::Convert(const Frame& frame, std::span<const PixelBounds>,
                             AVFrame& picture) const
{
    Convert(frame, picture);
}

void FrameToPicture::Convert(const Frame& frame, AVFrame& picture) const
{
    const std::uint8_t* const rows[4] = {frame.rgba.data(), nullptr, nullptr, nullptr};
    const int strides[4] = {frame.width * 4, 0, 0, 0};
    FFmpeg().sws_scale(m_context.get(), rows, strides, 0, frame.height, picture.data,
                       picture.linesize);
}

bool PictureToFrame::Prepare(const AVFrame& picture)
{
    const int space = MatrixOf(picture);
    const int range = IsFullRange(picture) ? 1 : 0;
    if (m_context && m_width == picture.width && m_height == picture.height &&
        m_format == picture.format && m_space == space && m_range == range)
    {
        return true;
    }
    m_width = picture.width;
    m_height = picture.height;
    m_format = picture.format;
    m_space = space;
    m_range = range;
    const auto format = AVPixelFormat(picture.format);
    m_context.reset();
    if (FFmpeg().sws_isSupportedInput(format) != 0)
    {
        m_context.reset(FFmpeg().sws_getContext(m_width, m_height, format, m_width, m_height,
                                                AV_PIX_FMT_RGB0, kFlags, nullptr, nullptr,
                                                nullptr));
    }
    if (m_context)
    {
        SetColours(m_context.get(), space, range != 0, SWS_CS_ITU709, true);
    }
    return m_context != nullptr;
}

Result<void> PictureToFrame::Convert(const AVFrame& picture, Frame& frame)
{
    if (!Prepare(picture))
    {
        const char* name = FFmpeg().av_get_pix_fmt_name(AVPixelFormat(picture.format));
        return Error{ErrorKind::Unusable, std::string("pictures of the kind ") +
                                              (name != nullptr ? name : "unknown") +
                                              " cannot be converted"};
    }
    if (frame.width != picture.width || frame.height != picture.height)
    {
        frame = Frame(picture.width, picture.height);
    }
    std::uint8_t* const rows[4] = {frame.rgba.data(), nullptr, nullptr, nullptr};
    const int strides[4] = {frame.width * 4, 0, 0, 0};
    FFmpeg().sws_scale(m_context.get(), picture.data, picture.linesize, 0, picture.height, rows,
                       strides);
    for (std::size_t i = 3; i < frame.rgba.size(); i += 4)
    {
        frame.rgba[i] = 255;
    }
    return {};
}

} // namespace boxreel
