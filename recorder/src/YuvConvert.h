// SPDX-License-Identifier: MIT
#pragma once

#include <render/Frame.h>

#include <cstddef>
#include <cstdint>

/// Converts the pixels of a frame to the planes of codecs, completely or where they changed. Alpha
/// is ignored. Independent of codecs: FFmpegPicture provides the planes.
///
/// YUV is limited range, 8 bits, with the matrix of BT.709-6 (part 3). With colours of 0 to 255:
/// Y' = 0.2126 R + 0.7152 G + 0.0722 B, and
/// Y = 16 + 219/255 Y', Cb = 128 + 224/255 (B - Y')/1.8556, Cr = 128 + 224/255 (R - Y')/1.5748.
/// Untagged formats use BT.601-7 (part 2.5.1):
/// Y' = 0.299 R + 0.587 G + 0.114 B, with 1.772 and 1.402 instead of 1.8556 and 1.5748.
/// In 4:2:0 a chroma sample is on the left pixel of its two columns and between its two rows
/// (H.264, annex E, chroma_sample_loc_type 0). It is the mean of its two rows, with the weights -1
/// 2 6 2 -1 over five columns. This low pass belongs to the linear interpolation of players (5/3
/// wavelet, Le Gall and Tabatabai 1988). Results are clamped to 1 to 254. The frame's border is
/// repeated outside.
///
/// Distance from the exact value: Y at most 0.500003; Cb and Cr of one pixel at most 0.5, so the
/// nearest integer. Cb and Cr of 4:2:0 at most 0.501, and 0.5002 where all pixels are equal. With
/// BT.601, one pixel at most 0.50001.
namespace boxreel
{

enum class PlaneFormat
{
    Yuv420, ///< Y, Cb, Cr; chroma with half the width and height, rounded up
    Yuv444, ///< Y, Cb, Cr
    Gbr,    ///< G, B, R
    Bgr0,   ///< one plane of four bytes per pixel: B, G, R, 0
    Rgb24,  ///< one plane of three bytes per pixel: R, G, B
};

enum class YuvMatrix
{
    Bt709,
    Bt601,
};

struct PicturePlanes
{
    PlaneFormat format = PlaneFormat::Yuv420;
    YuvMatrix matrix = YuvMatrix::Bt709; ///< for the two YUV formats
    std::uint8_t* data[3] = {};          ///< the top row of each plane
    std::ptrdiff_t strides[3] = {};      ///< from a row to the one below [bytes]
};

/// The vector instructions to use. The result has the same bits.
enum class Instructions
{
    Any,    ///< supported by every processor of this architecture
    Widest, ///< the widest of this processor
};

/// Writes every sample that depends on a pixel within `changed`; neighbouring samples may be
/// rewritten with equal values. `changed` is clipped to the frame.
void ConvertPixels(const Frame& frame, const PixelBounds& changed, const PicturePlanes& picture,
                   Instructions instructions = Instructions::Widest);

} // namespace boxreel
