// SPDX-License-Identifier: MIT
#pragma once

#include "FFmpegLibrary.h"

#include <render/Frame.h>

#include <span>

/// Colours between frames (RGB, full range) and the pictures codecs take. The one place that knows
/// matrices and ranges.
namespace boxreel
{

/// Frame -> picture of a fixed size and pixel format; YUV by the bt709 matrix, limited range.
class FrameToPicture
{
public:
    static Result<FrameToPicture> Create(int width, int height, AVPixelFormat format);

    /// Writes into `picture`, which must be writable and of that size and format.
    void Convert(const Frame& frame, AVFrame& picture) const;

    /// The same when the picture shows a frame that differs inside of `changed` only.
    void Convert(const Frame& frame, std::span<const PixelBounds> changed, AVFrame& picture) const;

private:
    explicit FrameToPicture(FFmpegOwner<SwsContext> context);
    FFmpegOwner<SwsContext> m_context;
};

/// Picture -> frame, by the picture's own tags. Untagged YUV is taken as players take it: bt709
/// from 720 lines on, else bt601. Follows a film whose pictures change.
class PictureToFrame
{
public:
    Result<void> Convert(const AVFrame& picture, Frame& frame);

private:
    bool Prepare(const AVFrame& picture);

    FFmpegOwner<SwsContext> m_context;
    int m_width = 0;
    int m_height = 0;
    int m_format = -1;
    int m_space = -1;
    int m_range = -1;
};

} // namespace boxreel
