// SPDX-License-Identifier: MIT
#include "FFmpegPicture.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

namespace boxreel
{

namespace
{

// Exact rounding and chroma for each pixel; BITEXACT makes the SIMD paths of different machines
// equal.
constexpr int kFlags =
    SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP | SWS_FULL_CHR_H_INT | SWS_BITEXACT;

constexpr int kOne = 1 << 16; // swscale's 1.0 for contrast and saturation

void SetColours(SwsContext* context, int sourceSpace, bool sourceFull, int targetSpace,
                bool targetFull)
{
    // Fails if both sides are RGB, where no matrix applies.
    FFmpeg().sws_setColorspaceDetails(context, FFmpeg().sws_getCoefficients(sourceSpace),
                                      sourceFull ? 1 : 0, FFmpeg().sws_getCoefficients(targetSpace),
                                      targetFull ? 1 : 0, 0, kOne, kOne);
}

/// Returns swscale's number for the matrix of a picture.
int MatrixOf(const AVFrame& picture)
{
    const bool isNamed =
        picture.colorspace != AVCOL_SPC_UNSPECIFIED && picture.colorspace != AVCOL_SPC_RGB;
    switch (isNamed ? picture.colorspace : UntaggedSpace(picture.height))
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
        return SWS_CS_ITU709; // a matrix that boxreel does not write
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

const char* NameOf(AVPixelFormat format)
{
    const char* name = FFmpeg().av_get_pix_fmt_name(format);
    return name != nullptr ? name : "unknown";
}

std::optional<PlaneFormat> PlanesOf(AVPixelFormat format)
{
    switch (format)
    {
    case AV_PIX_FMT_YUV420P:
        return PlaneFormat::Yuv420;
    case AV_PIX_FMT_YUV444P:
        return PlaneFormat::Yuv444;
    case AV_PIX_FMT_GBRP:
        return PlaneFormat::Gbr;
    case AV_PIX_FMT_BGR0:
        return PlaneFormat::Bgr0;
    case AV_PIX_FMT_RGB24:
        return PlaneFormat::Rgb24;
    default:
        return std::nullopt;
    }
}

/// Sets the chroma position, in 1/256 pixel from the centre of the first one. swscale's default is
/// centred; film formats, and untagged films, have it on the left.
void PlaceChroma(SwsContext* context, const AVFrame& picture)
{
    const AVPixFmtDescriptor* description =
        FFmpeg().av_pix_fmt_desc_get(AVPixelFormat(picture.format));
    const AVChromaLocation place = picture.chroma_location;
    const bool isLeft = place == AVCHROMA_LOC_UNSPECIFIED || place == AVCHROMA_LOC_LEFT ||
                        place == AVCHROMA_LOC_TOPLEFT || place == AVCHROMA_LOC_BOTTOMLEFT;
    const bool isTop = place == AVCHROMA_LOC_TOPLEFT || place == AVCHROMA_LOC_TOP;
    const bool isBottom = place == AVCHROMA_LOC_BOTTOMLEFT || place == AVCHROMA_LOC_BOTTOM;
    if (description->log2_chroma_w == 1 && isLeft)
    {
        FFmpeg().av_opt_set_int(context, "src_h_chr_pos", 0, 0);
    }
    if (description->log2_chroma_h == 1 && (isTop || isBottom))
    {
        FFmpeg().av_opt_set_int(context, "src_v_chr_pos", isTop ? 0 : 256, 0);
    }
}

} // namespace

AVColorSpace UntaggedSpace(int height)
{
    constexpr int kHdLines = 720; // minimum height of high definition
    return height >= kHdLines ? AVCOL_SPC_BT709 : AVCOL_SPC_SMPTE170M;
}

Result<FrameToPicture> FrameToPicture::Create(int width, int height, AVPixelFormat format,
                                              AVColorSpace space)
{
    const std::optional<PlaneFormat> planes = PlanesOf(format);
    if (!planes)
    {
        return Error{ErrorKind::Unusable, std::string(NameOf(format)),
                     "frames cannot be converted to this pixel format",
                     "use yuv420p, yuv444p, gbrp, bgr0 or rgb24"};
    }
    const bool isBt601 = space == AVCOL_SPC_SMPTE170M;
    return FrameToPicture(width, height, *planes, isBt601 ? YuvMatrix::Bt601 : YuvMatrix::Bt709);
}

FrameToPicture::FrameToPicture(int width, int height, PlaneFormat format, YuvMatrix matrix)
    : m_width(width), m_height(height), m_format(format), m_matrix(matrix)
{}

void FrameToPicture::Convert(const Frame& frame, AVFrame& picture) const
{
    const PixelBounds all{0, 0, m_width, m_height};
    Convert(frame, {&all, 1}, picture);
}

void FrameToPicture::Convert(const Frame& frame, std::span<const PixelBounds> changed,
                             AVFrame& picture) const
{
    assert(frame.width == m_width && frame.height == m_height && "the size of Create");
    assert(picture.width == m_width && picture.height == m_height && "the size of Create");
    assert(PlanesOf(AVPixelFormat(picture.format)) == m_format && "the format of Create");
    PicturePlanes planes{.format = m_format, .matrix = m_matrix};
    for (int i = 0; i < 3; ++i)
    {
        planes.data[i] = picture.data[i];
        planes.strides[i] = picture.linesize[i];
    }
    for (const PixelBounds& part : changed)
    {
        ConvertPixels(frame, part, planes);
    }
}

bool PictureToFrame::Prepare(const AVFrame& picture)
{
    const int space = MatrixOf(picture);
    const int range = IsFullRange(picture) ? 1 : 0;
    if (m_context && m_width == picture.width && m_height == picture.height &&
        m_format == picture.format && m_space == space && m_range == range &&
        m_chromaLocation == picture.chroma_location)
    {
        return true;
    }
    m_width = picture.width;
    m_height = picture.height;
    m_format = picture.format;
    m_space = space;
    m_range = range;
    m_chromaLocation = picture.chroma_location;
    m_context.reset();
    if (FFmpeg().sws_isSupportedInput(AVPixelFormat(picture.format)) != 0)
    {
        OpenContext(picture);
    }
    return m_context != nullptr;
}

/// Leaves no context if swscale refuses.
void PictureToFrame::OpenContext(const AVFrame& picture)
{
    m_context.reset(FFmpeg().sws_alloc_context());
    if (!m_context)
    {
        return;
    }
    const std::pair<const char*, int> options[] = {
        {"srcw", m_width},     {"srch", m_height},       {"dstw", m_width},
        {"dsth", m_height},    {"src_format", m_format}, {"dst_format", AV_PIX_FMT_RGB0},
        {"sws_flags", kFlags},
    };
    for (const auto& [name, value] : options)
    {
        FFmpeg().av_opt_set_int(m_context.get(), name, value, 0);
    }
    PlaceChroma(m_context.get(), picture);
    if (FFmpeg().sws_init_context(m_context.get(), nullptr, nullptr) < 0)
    {
        m_context.reset();
        return;
    }
    SetColours(m_context.get(), m_space, m_range != 0, SWS_CS_ITU709, true);
}

namespace
{

/// Copies directly, because swscale would convert through YUV.
void CopyRgb(const AVFrame& picture, Frame& frame)
{
    for (int y = 0; y < picture.height; ++y)
    {
        const std::uint8_t* rgb = picture.data[0] + std::ptrdiff_t(y) * picture.linesize[0];
        for (int x = 0; x < picture.width; ++x)
        {
            std::copy_n(rgb + std::ptrdiff_t(x) * 3, 3, frame.Pixel(x, y));
            frame.Pixel(x, y)[3] = 255;
        }
    }
}

} // namespace

Result<void> PictureToFrame::Convert(const AVFrame& picture, Frame& frame)
{
    if (picture.format == AV_PIX_FMT_RGB24)
    {
        frame = Frame(picture.width, picture.height);
        CopyRgb(picture, frame);
        return {};
    }
    if (!Prepare(picture))
    {
        return Error{ErrorKind::Unusable, std::string(NameOf(AVPixelFormat(picture.format))),
                     "pictures of this pixel format cannot be converted"};
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
