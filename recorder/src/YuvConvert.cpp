// SPDX-License-Identifier: MIT
#include "YuvConvert.h"

#include <algorithm>
#include <bit>
#include <cstring>

// The loops are plain integer code that the compiler vectorizes. They are compiled once for any
// processor and, on x86-64, once for AVX2, selected at run time. target_clones is not used, because
// its resolvers run before the sanitizers have started.
#define BOXREEL_INLINE [[gnu::always_inline]] inline
#if defined(__x86_64__)
#define BOXREEL_AVX2 1
#endif

namespace boxreel
{

namespace
{

/// One row of the matrix: (red R + green G + blue B + offset) / 2^24, modulo 2^32, so negative
/// weights are stored as complements. The offset contains the half for rounding.
struct Weights
{
    std::uint32_t red;
    std::uint32_t green;
    std::uint32_t blue;
    std::uint32_t offset;
};

constexpr std::uint32_t kRoundedZero = (128u << 24) + (1u << 23);

// A weighted sum of sixteen pixels needs four bits more, and one for the filter's overshoot. Hence
// / 2^23, with an offset of kOvershoot.
constexpr std::uint32_t kOvershoot = 64; // chroma ranges from -40 to 296
constexpr std::uint32_t kZeroOfSums = ((128u + kOvershoot) << 23) + (1u << 22);

struct Matrix
{
    Weights y;
    Weights cb; ///< for one pixel
    Weights cr;
    Weights cbOfSums;
    Weights crOfSums;
};

// The best integers within 5 of the exact weights; YuvConvertTest checks all 2^24 colours. Those of
// Cb and Cr are right for every colour. No integers are right for all Y, because its sum fills 32
// bits with 24 fractional ones. These round 7 colours, within 2.4e-6 of a half, to the other side.
constexpr Matrix kBt709 = {
    {3063283u, 10305079u, 1040306u, (16u << 24) + (1u << 23) - 19u},
    {-1688522u, -5680295u, 7368817u, kRoundedZero},
    {7368816u, -6693138u, -675678u, kRoundedZero},
    {-52766u, -177509u, 230275u, kZeroOfSums},
    {230276u, -209161u, -21115u, kZeroOfSums},
};

// The nearest integers, adjusted where a row of chroma must sum to zero.
constexpr Matrix kBt601 = {
    {4308192u, 8457888u, 1642588u, (16u << 24) + (1u << 23)},
    {-2486768u, -4882049u, 7368817u, kRoundedZero},
    {7368816u, -6170464u, -1198352u, kRoundedZero},
    {-77711u, -152564u, 230275u, kZeroOfSums},
    {230276u, -192827u, -37449u, kZeroOfSums},
};

// True if grey has zero chroma at every brightness.
constexpr bool IsNeutral(const Weights& w)
{
    return w.red + w.green + w.blue == 0;
}
constexpr bool IsNeutral(const Matrix& m)
{
    return IsNeutral(m.cb) && IsNeutral(m.cr) && IsNeutral(m.cbOfSums) && IsNeutral(m.crOfSums);
}
static_assert(IsNeutral(kBt709) && IsNeutral(kBt601));

constexpr int kBlockWidth = 512; // small enough for intermediate rows to stay in the L1 cache
static_assert(kBlockWidth % 2 == 0);

// Position of a colour in a pixel loaded as one integer.
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

BOXREEL_INLINE std::uint32_t Weigh(const Weights& w, std::uint32_t red, std::uint32_t green,
                                   std::uint32_t blue)
{
    return w.red * red + w.green * green + w.blue * blue + w.offset;
}

/// Converts a run of pixels in a row to samples.
BOXREEL_INLINE void WeighRow(const Weights& weights, const std::uint8_t* rgba, int count,
                             std::uint8_t* __restrict samples)
{
    for (int x = 0; x < count; ++x)
    {
        const std::uint32_t pixel = Load(rgba, x);
        samples[x] = std::uint8_t(Weigh(weights, Red(pixel), Green(pixel), Blue(pixel)) >> 24);
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

BOXREEL_INLINE void PackRow(const std::uint8_t* rgba, int count, std::uint8_t* __restrict rgb)
{
    for (int x = 0; x < count; ++x)
    {
        rgb[x * 3] = rgba[x * 4];
        rgb[x * 3 + 1] = rgba[x * 4 + 1];
        rgb[x * 3 + 2] = rgba[x * 4 + 2];
    }
}

/// Sums of two pixels per column: red in the low half and blue in the high half, with room for
/// sixteen pixels. Column x of a block from x0 is at (x - x0) / 2 + 1, in `even` or for the next
/// column in `odd`. They are separate because chroma samples are two columns apart.
struct ColumnSums
{
    struct Colours
    {
        std::uint32_t redBlue[kBlockWidth / 2 + 3];
        std::uint32_t green[kBlockWidth / 2 + 3];
    };
    Colours even;
    Colours odd;
};

BOXREEL_INLINE std::uint32_t RedBlue(std::uint32_t pixel)
{
    return Red(pixel) | Blue(pixel) << 16;
}

BOXREEL_INLINE void AddPairs(const std::uint8_t* above, const std::uint8_t* below, int count,
                             ColumnSums& sums)
{
    std::uint32_t* __restrict evenRedBlue = sums.even.redBlue + 1;
    std::uint32_t* __restrict evenGreen = sums.even.green + 1;
    std::uint32_t* __restrict oddRedBlue = sums.odd.redBlue + 1;
    std::uint32_t* __restrict oddGreen = sums.odd.green + 1;
    for (int i = 0; i < count; ++i)
    {
        const std::uint32_t a = Load(above, 2 * i);
        const std::uint32_t b = Load(below, 2 * i);
        const std::uint32_t c = Load(above, 2 * i + 1);
        const std::uint32_t d = Load(below, 2 * i + 1);
        evenRedBlue[i] = RedBlue(a) + RedBlue(b);
        evenGreen[i] = Green(a) + Green(b);
        oddRedBlue[i] = RedBlue(c) + RedBlue(d);
        oddGreen[i] = Green(c) + Green(d);
    }
}

/// Applies the weights -1 2 6 2 -1, the low pass of the 5/3 wavelet.
BOXREEL_INLINE std::uint32_t LowPass(const std::uint32_t* even, const std::uint32_t* odd, int i)
{
    return 6 * even[i + 1] + 2 * (odd[i] + odd[i + 1]) - even[i] - even[i + 2];
}

/// Clamps to the range of a picture: 0 and 255 are reserved for synchronization (BT.709-6, part 4).
BOXREEL_INLINE std::uint8_t Chroma(std::uint32_t sum)
{
    return std::uint8_t(std::clamp(int(sum >> 23) - int(kOvershoot), 1, 254));
}

BOXREEL_INLINE void WeighColumns(const Matrix& matrix, const ColumnSums& sums, int count,
                                 std::uint8_t* __restrict cb, std::uint8_t* __restrict cr)
{
    // Added to each colour, it does not change chroma and keeps both halves non-negative.
    constexpr std::uint32_t bias = 1024;
    for (int x = 0; x < count; ++x)
    {
        const std::uint32_t redBlue =
            LowPass(sums.even.redBlue, sums.odd.redBlue, x) + (bias | bias << 16);
        const std::uint32_t green = LowPass(sums.even.green, sums.odd.green, x) + bias;
        const std::uint32_t red = redBlue & 0xffff;
        const std::uint32_t blue = redBlue >> 16;
        cb[x] = Chroma(Weigh(matrix.cbOfSums, red, green, blue));
        cr[x] = Chroma(Weigh(matrix.crOfSums, red, green, blue));
    }
}

std::uint8_t* Sample(const PicturePlanes& picture, int plane, int x, int y)
{
    return picture.data[plane] + y * picture.strides[plane] + x;
}

/// Adds one column of a block from `x0`; columns outside the frame repeat its border.
BOXREEL_INLINE void AddColumn(const Frame& frame, int x0, int x, int y, int yBelow,
                              ColumnSums& sums)
{
    const int inside = std::clamp(x, 0, frame.width - 1);
    const std::uint32_t a = Load(frame.Pixel(inside, y), 0);
    const std::uint32_t b = Load(frame.Pixel(inside, yBelow), 0);
    ColumnSums::Colours& colours = x % 2 == 0 ? sums.even : sums.odd;
    const int i = (x - x0 + 2) / 2;
    colours.redBlue[i] = RedBlue(a) + RedBlue(b);
    colours.green[i] = Green(a) + Green(b);
}

/// Adds the columns from `x0` to `x1` and two on either side.
BOXREEL_INLINE void AddColumns(const Frame& frame, int x0, int x1, int y, int yBelow,
                               ColumnSums& sums)
{
    const int pairs = (x1 - x0) / 2;
    AddPairs(frame.Pixel(x0, y), frame.Pixel(x0, yBelow), pairs, sums);
    for (const int x : {x0 - 2, x0 - 1, x0 + 2 * pairs, x0 + 2 * pairs + 1, x0 + 2 * pairs + 2})
    {
        AddColumn(frame, x0, x, y, yBelow, sums);
    }
}

/// Converts two rows from `y` (even), columns `x0` (even) to `x1`: at most one block. It may end on
/// an odd column only at the end of the frame.
BOXREEL_INLINE void ConvertBlock420(const Matrix& matrix, const Frame& frame, int x0, int x1, int y,
                                    const PicturePlanes& picture)
{
    const int yBelow = std::min(y + 1, frame.height - 1);
    WeighRow(matrix.y, frame.Pixel(x0, y), x1 - x0, Sample(picture, 0, x0, y));
    WeighRow(matrix.y, frame.Pixel(x0, yBelow), x1 - x0, Sample(picture, 0, x0, yBelow));
    ColumnSums sums;
    AddColumns(frame, x0, x1, y, yBelow, sums);
    WeighColumns(matrix, sums, (x1 - x0 + 1) / 2, Sample(picture, 1, x0 / 2, y / 2),
                 Sample(picture, 2, x0 / 2, y / 2));
}

/// Converts whole pairs of rows and columns: all whose samples depend on the part, two columns on
/// either side.
BOXREEL_INLINE void Convert420(const Matrix& matrix, const Frame& frame, const PixelBounds& part,
                               const PicturePlanes& picture)
{
    const int start = std::max(part.x0 - 1, 0) / 2 * 2;
    const int end = std::min((part.x1 + 3) / 2 * 2, frame.width);
    for (int y = part.y0 / 2 * 2; y < part.y1; y += 2)
    {
        for (int x = start; x < end; x += kBlockWidth)
        {
            ConvertBlock420(matrix, frame, x, std::min(x + kBlockWidth, end), y, picture);
        }
    }
}

BOXREEL_INLINE void ConvertRow(const Matrix& matrix, const std::uint8_t* rgba, int count, int x,
                               int y, const PicturePlanes& picture)
{
    switch (picture.format)
    {
    case PlaneFormat::Yuv420:
        break; // not row by row
    case PlaneFormat::Yuv444:
        WeighRow(matrix.y, rgba, count, Sample(picture, 0, x, y));
        WeighRow(matrix.cb, rgba, count, Sample(picture, 1, x, y));
        WeighRow(matrix.cr, rgba, count, Sample(picture, 2, x, y));
        break;
    case PlaneFormat::Gbr:
        SplitRow(rgba, count, Sample(picture, 0, x, y), Sample(picture, 1, x, y),
                 Sample(picture, 2, x, y));
        break;
    case PlaneFormat::Bgr0:
        SwapRow(rgba, count, Sample(picture, 0, x * 4, y));
        break;
    case PlaneFormat::Rgb24:
        PackRow(rgba, count, Sample(picture, 0, x * 3, y));
        break;
    }
}

BOXREEL_INLINE void ConvertBy(const Matrix& matrix, const Frame& frame, const PixelBounds& part,
                              const PicturePlanes& picture)
{
    if (picture.format == PlaneFormat::Yuv420)
    {
        Convert420(matrix, frame, part, picture);
        return;
    }
    for (int y = part.y0; y < part.y1; ++y)
    {
        ConvertRow(matrix, frame.Pixel(part.x0, y), part.x1 - part.x0, part.x0, y, picture);
    }
}

/// Instantiated for each matrix, so that the weights are constants in the loops.
BOXREEL_INLINE void ConvertPart(const Frame& frame, const PixelBounds& part,
                                const PicturePlanes& picture)
{
    if (picture.matrix == YuvMatrix::Bt601)
    {
        ConvertBy(kBt601, frame, part, picture);
    }
    else
    {
        ConvertBy(kBt709, frame, part, picture);
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
