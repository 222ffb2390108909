// SPDX-License-Identifier: MIT
#pragma once

#include "FFmpegLibrary.h"
#include "YuvConvert.h"

#include <render/Frame.h>

#include <span>

/// Converts between frames (RGB, full range) and the pictures of codecs. The only place with
/// matrices, ranges and chroma positions. YuvConvert does the arithmetic towards a codec, swscale
/// the reverse.
namespace boxreel
{

/// Converts a frame to a picture of a fixed size and pixel format. YUV is yuv420p with chroma on
/// the left or yuv444p, in limited range, with the matrix `space`, bt709 or bt601. RGB is gbrp,
/// bgr0 or rgb24.
class FrameToPicture
{
public:
    /// An Error (Unusable) for another format.
    static Result<FrameToPicture> Create(int width, int height, AVPixelFormat format,
                                         AVColorSpace space = AVCOL_SPC_BT709);

    /// Writes to `picture`, which must be writable and of that size and format.
    void Convert(const Frame& frame, AVFrame& picture) const;

    /// Same as above, if `picture` already shows a frame that differs from this one only in
    /// `changed`.
    void Convert(const Frame& frame, std::span<const PixelBounds> changed, AVFrame& picture) const;

private:
    FrameToPicture(int width, int height, PlaneFormat format, YuvMatrix matrix);
    int m_width;
    int m_height;
    PlaneFormat m_format;
    YuvMatrix m_matrix;
};

/// Converts a picture to a frame by the picture's tags. Untagged YUV is interpreted as players do:
/// bt709 from 720 lines on, otherwise bt601, chroma on the left. Pictures may change size and
/// format.
class PictureToFrame
{
public:
    Result<void> Convert(const AVFrame& picture, Frame& frame);

private:
    bool Prepare(const AVFrame& picture);
    void OpenContext(const AVFrame& picture);

    FFmpegOwner<SwsContext> m_context;
    int m_width = 0;
    int m_height = 0;
    int m_format = -1;
    int m_space = -1;
    int m_range = -1;
    int m_chromaLocation = -1;
};

/// Returns the matrix that players assume for untagged YUV such as y4m.
AVColorSpace UntaggedSpace(int height);

} // namespace boxreel
