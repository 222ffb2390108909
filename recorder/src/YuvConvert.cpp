// SPDX-License-Identifier: MIT
#include "YuvConvert.h"

#include <algorithm>
#include <bit>
#include <cstring>

// The loops are plain, over integers, and the compiler makes vectors of them: once for any
// processor and, on x86-64, once more for those with AVX2. Two functions and a question at run time
// instead of target_clones, whose resolvers run before the sanitizers have started.
#define BOXREEL_INLINE [[gnu::always_inline]] inline
#if defined(__x86_64__)
#define BOXREEL_AVX2 1
#endif

namespace boxreel
{

namespace
{

/// One row of the matrix: (red R + green G + blue B + offset) / 2^24, modulo 2^32, so negative
/// weights are their complements. The offset holds the half that rounds.
struct Weights
{
    std::uint32_t red;
    std::uint32_t green;
    std::uint32_t blue;
    std::uint32_t offset;
};

// All integers within 5 of the real weights were tried against the exact results near halves;
// YuvConvertTest goes through all 2^24 colours. These of Cb and Cr are right for every one. None of
// Y is, for its sum fills 32 bits with just these 24 behind the point; this one takes 7 colours,
// within 2.4e-6 of a half, to the other side.
constexpr Weights kY = {3063283u, 10305079u, 1040306u, (16u << 24) + (1u << 23) - 19u};
constexpr Weights kCb = {-1688522u, -5680295u, 7368817u, (128u << 24) + (1u << 23)};
constexpr Weights kCr = {7368816u, -6693138u, -675678u, (128u << 24) + (1u << 23)};

// Of the sum of eight pixels, which takes three bits of the weights. Of flat areas some hundred of
// the 2^24 colours go to the other side of a half.
constexpr Weights kCbOfEight = {-211065u, -710037u, 921102u, (128u << 24) + (1u << 23)};
constexpr Weights kCrOfEight = {921102u, -836642u, -84460u, (128u << 24) + (1u << 23)};

// Grey has no colour, whatever its brightness.
constexpr bool IsNeutral(const Weights& w)
{
    return w.red + w.green + w.blue == 0;
}
static_assert(IsNeutral(kCb) && IsNeutral(kCr) && IsNeutral(kCbOfEight) && IsNeutral(kCrOfEight));

constexpr int kBlockWidth = 512; // so what is kept between two loops stays in the fastest memory
static_assert(kBlockWidth % 2 == 0);

// Where a colour is in a pixel loaded as one number.
constexpr bool kLittle = std::endian::native == std::endian::little;
constexpr int kRedShift = kLittle ? 0 : 24;
constexpr int kGreenShift = kLittle ? 8 : 16;
constexpr int kBlueShift = kLittle ? 16 : 8;

BOXREEL_INLINE std::uint32_t Load(const std::uint8_t* rgba, int x)
{
    std::uint32_t pixel;
    std::memcpy(&pixel, rgba + std::ptrdiff_t(x) * 4, 4);
    return pixel;
}

BOXREEL_INLINE std::uint32_t Red(std::uint32_t pixel)
{
    return (pixel >> kRedShift) & 255;
}

BOXREEL_INLINE std::uint32_t Green(std::uint32_t pixel)
{
    return (pixel >> kGreenShift) & 255;
}

BOXREEL_INLINE std::uint32_t Blue(std::uint32_t pixel)
{
    return (pixel >> kBlueShift) & 255;
}

BOXREEL_INLINE std::uint8_t Weigh(const Weights& w, std::uint32_t red, std::uint32_t green,
                                  std::uint32_t blue)
{
    return std::uint8_t((w.red * red + w.green * green + w.blue * blue + w.offset) >> 24);
}

/// A run of pixels in a row to as many samples.
BOXREEL_INLINE void WeighRow(const Weights& weights, const std::uint8_t* rgba, int count,
                             std::uint8_t* __restrict samples)
{
    for (int x = 0; x < count; ++x)
    {
        const std::uint32_t pixel = Load(rgba, x);
        samples[x] = Weigh(weights, Red(pixel), Green(pixel), Blue(pixel));
    }
}

BOXREEL_INLINE void SplitRow(const std::uint8_t* rgba, int count, std::uint8_t* __restrict greens,
                             std::uint8_t* __restrict blues, std::uint8_t* __restrict reds)
{
    for (int x = 0; x < count; ++x)
    {
        const std::uint32_t pixel = Load(rgba, x);
        greens[x] = std::uint8_t(Green(pixel));
        blues[x] = std::uint8_t(Blue(pixel));
        reds[x] = std::uint8_t(Red(pixel));
    }
}

BOXREEL_INLINE void SwapRow(const std::uint8_t* rgba, int count, std::uint8_t* __restrict bgr0)
{
    for (int x = 0; x < count; ++x)
    {
        const std::uint32_t pixel = Load(rgba, x);
        const std::uint32_t swapped =
            Blue(pixel) << kRedShift | Green(pixel) << kGreenShift | Red(pixel) << kBlueShift;
        std::memcpy(bgr0 + std::ptrdiff_t(x) * 4, &swapped, 4);
    }
}

/// The colours of columns of two pixels, added; red in the low half and blue in the high one, where
/// even eight pixels fit. Index 1 is the first column of a block, 0 the one to the left of it.
struct ColumnSums
{
    std::uint32_t redBlue[kBlockWidth + 2];
    std::uint32_t green[kBlockWidth + 2];
};

BOXREEL_INLINE void AddRows(const std::uint8_t* above, const std::uint8_t* below, int count,
                            std::uint32_t* __restrict redBlue, std::uint32_t* __restrict green)
{
    for (int x = 0; x < count; ++x)
    {
        const std::uint32_t a = Load(above, x);
        const std::uint32_t b = Load(below, x);
        redBlue[x] = (Red(a) | Blue(a) << 16) + (Red(b) | Blue(b) << 16);
        green[x] = Green(a) + Green(b);
    }
}

BOXREEL_INLINE std::uint32_t OneTwoOne(const std::uint32_t* sums, int x)
{
    return sums[x] + 2 * sums[x + 1] + sums[x + 2];
}

BOXREEL_INLINE void WeighColumns(const ColumnSums& sums, int count, std::uint8_t* __restrict cb,
                                 std::uint8_t* __restrict cr)
{
    for (int x = 0; x < count; ++x)
    {
        const std::uint32_t redBlue = OneTwoOne(sums.redBlue, 2 * x);
        const std::uint32_t green = OneTwoOne(sums.green, 2 * x);
        const std::uint32_t red = redBlue & 0xffff;
        const std::uint32_t blue = redBlue >> 16;
        cb[x] = Weigh(kCbOfEight, red, green, blue);
        cr[x] = Weigh(kCrOfEight, red, green, blue);
    }
}

std::uint8_t* Sample(const PicturePlanes& picture, int plane, int x, int y)
{
    return picture.data[plane] + y * picture.strides[plane] + x;
}

/// Of two rows from `y`, an even one, the columns from `x0`, an even one, to `x1`: at most a block;
/// it may end on an odd column only where the frame ends.
BOXREEL_INLINE void ConvertBlock420(const Frame& frame, int x0, int x1, int y,
                                    const PicturePlanes& picture)
{
    const int yBelow = std::min(y + 1, frame.height - 1);
    const std::uint8_t* above = frame.Pixel(x0, y);
    const std::uint8_t* below = frame.Pixel(x0, yBelow);
    const int count = x1 - x0;
    WeighRow(kY, above, count, Sample(picture, 0, x0, y));
    WeighRow(kY, below, count, Sample(picture, 0, x0, yBelow));

    ColumnSums sums;
    const int left = x0 > 0 ? 1 : 0; // the first column has no other to the left
    AddRows(above - left * 4, below - left * 4, count + left, sums.redBlue + 1 - left,
            sums.green + 1 - left);
    if (left == 0)
    {
        sums.redBlue[0] = sums.redBlue[1];
        sums.green[0] = sums.green[1];
    }
    sums.redBlue[count + 1] = sums.redBlue[count]; // used when the count is odd
    sums.green[count + 1] = sums.green[count];
    WeighColumns(sums, (count + 1) / 2, Sample(picture, 1, x0 / 2, y / 2),
                 Sample(picture, 2, x0 / 2, y / 2));
}

/// Whole pairs of rows and columns: a pixel in an odd column counts for the sample to its right
/// too.
BOXREEL_INLINE void Convert420(const Frame& frame, const PixelBounds& part,
                               const PicturePlanes& picture)
{
    const int end = std::min((part.x1 / 2 + 1) * 2, frame.width);
    for (int y = part.y0 / 2 * 2; y < part.y1; y += 2)
    {
        for (int x = part.x0 / 2 * 2; x < end; x += kBlockWidth)
        {
            ConvertBlock420(frame, x, std::min(x + kBlockWidth, end), y, picture);
        }
    }
}

BOXREEL_INLINE void ConvertRow(const std::uint8_t* rgba, int count, int x, int y,
                               const PicturePlanes& picture)
{
    switch (picture.format)
    {
    case PlaneFormat::Yuv420:
        break; // not row by row
    case PlaneFormat::Yuv444:
        WeighRow(kY, rgba, count, Sample(picture, 0, x, y));
        WeighRow(kCb, rgba, count, Sample(picture, 1, x, y));
        WeighRow(kCr, rgba, count, Sample(picture, 2, x, y));
        break;
    case PlaneFormat::Gbr:
        SplitRow(rgba, count, Sample(picture, 0, x, y), Sample(picture, 1, x, y),
                 Sample(picture, 2, x, y));
        break;
    case PlaneFormat::Bgr0:
        SwapRow(rgba, count, Sample(picture, 0, x * 4, y));
        break;
    }
}

BOXREEL_INLINE void ConvertPart(const Frame& frame, const PixelBounds& part,
                                const PicturePlanes& picture)
{
    if (picture.format == PlaneFormat::Yuv420)
    {
        Convert420(frame, part, picture);
        return;
    }
    for (int y = part.y0; y < part.y1; ++y)
    {
        ConvertRow(frame.Pixel(part.x0, y), part.x1 - part.x0, part.x0, y, picture);
    }
}

void ConvertAnywhere(const Frame& frame, const PixelBounds& part, const PicturePlanes& picture)
{
    ConvertPart(frame, part, picture);
}

#if defined(BOXREEL_AVX2)
[[gnu::target("avx2")]] void ConvertWithAvx2(const Frame& frame, const PixelBounds& part,
                                             const PicturePlanes& picture)
{
    ConvertPart(frame, part, picture);
}
#endif

} // namespace

void ConvertPixels(const Frame& frame, const PixelBounds& changed, const PicturePlanes& picture,
                   Instructions instructions)
{
    const PixelBounds part = Intersection(changed, {0, 0, frame.width, frame.height});
    if (part.IsEmpty())
    {
        return;
    }
#if defined(BOXREEL_AVX2)
    if (instructions == Instructions::Widest && __builtin_cpu_supports("avx2") != 0)
    {
        ConvertWithAvx2(frame, part, picture);
        return;
    }
#else
    (void)instructions;
#endif
    ConvertAnywhere(frame, part, picture);
}

} // namespace boxreel
