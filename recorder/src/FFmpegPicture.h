// SPDX-License-Identifier: MIT
#pragma once

#include "FFmpegLibrary.h"
#include "YuvConvert.h"

#include <render/Frame.h>

#include <span>

/// Colours between frames (RGB, full range) and the pictures codecs take. The one place that knows
/// matrices, ranges and places of chroma; the arithmetic is YuvConvert's towards a codec and
/// swscale's back.
namespace boxreel
{

/// Frame -> picture of a fixed size and pixel format: yuv420p with chroma to the left or yuv444p,
/// both in limited range by the matrix that `space` names, bt709 or bt601; gbrp, bgr0 or rgb24.
class FrameToPicture
{
public:
    /// An Error (Unusable) for another format.
    static Result<FrameToPicture> Create(int width, int height, AVPixelFormat format,
                                         AVColorSpace space = AVCOL_SPC_BT709);

    /// Writes into `picture`, which must be writable and of that size and format.
    void Convert(const Frame& frame, AVFrame& picture) const;

    /// The same when `picture` already shows a frame that differs from this one in `changed` only.
    void Convert(const Frame& frame, std::span<const PixelBounds> changed, AVFrame& picture) const;

private:
    FrameToPicture(int width, int height, PlaneFormat format, YuvMatrix matrix);
    int m_width;
    int m_height;
    PlaneFormat m_format;
    YuvMatrix m_matrix;
};

/// Picture -> frame, by the picture's own tags. Untagged YUV is taken as players take it: bt709
/// from 720 lines on, else bt601, its chroma to the left. Follows a film whose pictures change.
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

/// The matrix that players take YUV for which does not name its own: y4m.
AVColorSpace UntaggedSpace(int height);

} // namespace boxreel
