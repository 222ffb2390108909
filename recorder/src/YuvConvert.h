// SPDX-License-Identifier: MIT
#pragma once

#include <render/Frame.h>

#include <cstddef>
#include <cstdint>

/// The pixels of a frame become the planes that codecs take, whole or where they have changed.
/// Alpha is ignored. Knows no codec: FFmpegPicture says where the planes are.
///
/// YUV is limited range, 8 bits, by the matrix of BT.709-6 (part 3). With colours of 0 to 255:
/// Y' = 0.2126 R + 0.7152 G + 0.0722 B, and
/// Y = 16 + 219/255 Y', Cb = 128 + 224/255 (B - Y')/1.8556, Cr = 128 + 224/255 (R - Y')/1.5748.
/// Or by that of BT.601-7 (part 2.5.1), for formats that do not name theirs:
/// Y' = 0.299 R + 0.587 G + 0.114 B, and 1.772 and 1.402 in the places of 1.8556 and 1.5748.
/// In 4:2:0 a chroma sample lies on the left pixel of its two columns and between its two rows
/// (H.264, annex E, chroma_sample_loc_type 0). It is the mean of its two rows, by the weights
/// -1 2 6 2 -1 of five columns around it: the low pass that belongs to the linear interpolation of
/// players (5/3 wavelet, Le Gall and Tabatabai 1988), at most 254 and at least 1. At the border of
/// the frame the pixels there count for those outside.
///
/// Distance from the real number: Y at most 0.500003; Cb and Cr of one pixel at most 0.5, so the
/// nearest integer; Cb and Cr of 4:2:0 at most 0.501, and 0.5002 where all pixels are alike. By
/// BT.601 0.50001 for all of one pixel.
namespace boxreel
{

enum class PlaneFormat
{
    Yuv420, ///< Y, Cb, Cr; these two of half the width and height, rounded up
    Yuv444, ///< Y, Cb, Cr
    Gbr,    ///< G, B, R
    Bgr0,   ///< one plane of four bytes a pixel: B, G, R, 0
    Rgb24,  ///< one plane of three bytes a pixel: R, G, B
};

enum class YuvMatrix
{
    Bt709,
    Bt601,
};

struct PicturePlanes
{
    PlaneFormat format = PlaneFormat::Yuv420;
    YuvMatrix matrix = YuvMatrix::Bt709; ///< of the two YUV formats
    std::uint8_t* data[3] = {};          ///< the top row of each
    std::ptrdiff_t strides[3] = {};      ///< from a row to the one below [B]
};

/// How wide the processor's registers may be. Not a bit differs.
enum class Instructions
{
    Any,    ///< what every processor of this kind has
    Widest, ///< what this one has
};

/// Writes every sample that depends on a pixel within `changed`, and some beside them as they would
/// be anyway. Of `changed` only what lies in the frame counts.
void ConvertPixels(const Frame& frame, const PixelBounds& changed, const PicturePlanes& picture,
                   Instructions instructions = Instructions::Widest);

} // namespace boxreel
