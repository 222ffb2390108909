// SPDX-License-Identifier: MIT
#include <render/Png.h>

#include "../base/Errors.h"
#include "../base/TemporaryFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include <png.h>

using namespace boxreel;
using testing::ElementsAre;
using testing::IsEmpty;

namespace
{

// A picture as another program might write it: any type, depth, interlacing and transparency.
struct Picture
{
    int width = 13;
    int height = 9; // both odd, so that Adam7 has passes of unequal size
    int depth = 8;
    int type = PNG_COLOR_TYPE_RGB;
    int interlace = PNG_INTERLACE_NONE;
    std::vector<std::vector<png_byte>> rows;
    std::vector<png_color> palette;
    std::vector<png_byte> paletteAlpha;
    bool hasKey = false; // tRNS of gray and RGB: samples of this value are transparent
    png_color_16 key{};

    int Channels() const
    {
        return type == PNG_COLOR_TYPE_RGB          ? 3
               : type == PNG_COLOR_TYPE_RGBA       ? 4
               : type == PNG_COLOR_TYPE_GRAY_ALPHA ? 2
                                                   : 1;
    }
    std::uint32_t Sample(int x, int y, int channel) const
    {
        const std::size_t index = std::size_t(x * Channels() + channel);
        const std::vector<png_byte>& row = rows[std::size_t(y)];
        if (depth == 16)
        {
            return std::uint32_t(row[2 * index] << 8 | row[2 * index + 1]);
        }
        const std::size_t bit = index * std::size_t(depth);
        return std::uint32_t(row[bit / 8] >> (8 - depth - int(bit % 8))) & ((1u << depth) - 1);
    }
};

void FillRandomly(Picture& picture, std::uint32_t seed)
{
    std::mt19937 random(seed);
    const std::size_t rowBytes =
        (std::size_t(picture.width * picture.Channels() * picture.depth) + 7) / 8;
    picture.rows.assign(std::size_t(picture.height), std::vector<png_byte>(rowBytes));
    for (auto& row : picture.rows)
    {
        for (png_byte& byte : row)
        {
            byte = png_byte(random());
        }
    }
    if (picture.type == PNG_COLOR_TYPE_PALETTE)
    {
        for (int i = 0; i < 1 << picture.depth; ++i)
        {
            picture.palette.push_back({png_byte(random()), png_byte(random()), png_byte(random())});
        }
    }
}

void Save(const Picture& picture, const std::filesystem::path& path)
{
    std::FILE* file = std::fopen(path.c_str(), "wb");
    ASSERT_NE(file, nullptr);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, png_uint_32(picture.width), png_uint_32(picture.height), picture.depth,
                 picture.type, picture.interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (!picture.palette.empty())
    {
        png_set_PLTE(png, info, picture.palette.data(), int(picture.palette.size()));
    }
    if (!picture.paletteAlpha.empty())
    {
        png_set_tRNS(png, info, picture.paletteAlpha.data(), int(picture.paletteAlpha.size()),
                     nullptr);
    }
    if (picture.hasKey)
    {
        png_set_tRNS(png, info, nullptr, 0, &picture.key);
    }
    png_set_gAMA(png, info, 1.0); // must not change the pixels
    std::vector<png_bytep> rows;
    for (const auto& row : picture.rows)
    {
        rows.push_back(const_cast<png_bytep>(row.data()));
    }
    png_write_info(png, info);
    png_write_image(png, rows.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
}

// 8-bit RGBA, not premultiplied, by the definition of the format.
std::array<std::uint32_t, 4> Meaning(const Picture& picture, int x, int y)
{
    const std::uint32_t top = (1u << picture.depth) - 1;
    const auto scaled = [&](int channel) {
        return (picture.Sample(x, y, channel) * 255 + top / 2) / top;
    };
    switch (picture.type)
    {
    case PNG_COLOR_TYPE_GRAY:
        return {scaled(0), scaled(0), scaled(0),
                picture.hasKey && picture.Sample(x, y, 0) == picture.key.gray ? 0u : 255u};
    case PNG_COLOR_TYPE_GRAY_ALPHA:
        return {scaled(0), scaled(0), scaled(0), scaled(1)};
    case PNG_COLOR_TYPE_PALETTE: {
        const std::size_t index = picture.Sample(x, y, 0);
        const png_color color = picture.palette[index];
        const std::uint32_t alpha =
            index < picture.paletteAlpha.size() ? picture.paletteAlpha[index] : 255u;
        return {color.red, color.green, color.blue, alpha};
    }
    case PNG_COLOR_TYPE_RGB: {
        const bool isKey = picture.hasKey && picture.Sample(x, y, 0) == picture.key.red &&
                           picture.Sample(x, y, 1) == picture.key.green &&
                           picture.Sample(x, y, 2) == picture.key.blue;
        return {scaled(0), scaled(1), scaled(2), isKey ? 0u : 255u};
    }
    default:
        return {scaled(0), scaled(1), scaled(2), scaled(3)};
    }
}

void ExpectReadsAsMeant(const Picture& picture)
{
    const TemporaryFolder folder;
    Save(picture, folder / "picture.png");
    const Result<Frame> frame = ReadPng(folder / "picture.png");
    ASSERT_TRUE(frame) << frame.GetError().Text();
    ASSERT_EQ(frame->width, picture.width);
    ASSERT_EQ(frame->height, picture.height);
    for (int y = 0; y < picture.height; ++y)
    {
        for (int x = 0; x < picture.width; ++x)
        {
            const auto meant = Meaning(picture, x, y);
            const std::uint8_t* pixel = frame->Pixel(x, y);
            for (std::size_t c = 0; c < 3; ++c)
            {
                const int premultiplied = int((meant[c] * meant[3] * 2 + 255) / 510);
                EXPECT_EQ(pixel[c], premultiplied) << "at " << x << ", " << y << " channel " << c;
            }
            EXPECT_EQ(pixel[3], meant[3]) << "at " << x << ", " << y;
        }
    }
}

// Premultiplied, as renderers make them.
Frame RandomFrame(int width, int height, bool isOpaque, std::uint32_t seed)
{
    std::mt19937 random(seed);
    Frame frame(width, height);
    for (std::size_t i = 0; i < frame.rgba.size(); i += 4)
    {
        const std::uint32_t alpha = isOpaque ? 255u : random() % 256;
        for (std::size_t c = 0; c < 3; ++c)
        {
            frame.rgba[i + c] = std::uint8_t(random() % (alpha + 1));
        }
        frame.rgba[i + 3] = std::uint8_t(alpha);
    }
    return frame;
}

int ColorTypeOf(const std::filesystem::path& path)
{
    return int(ReadBytes(path).at(25));
}

struct Kind
{
    int type;
    int depth;
};

void PrintTo(const Kind& kind, std::ostream* out)
{
    *out << "type " << kind.type << ", depth " << kind.depth;
}

constexpr Kind kEveryKind[] = {
    {PNG_COLOR_TYPE_GRAY, 1},        {PNG_COLOR_TYPE_GRAY, 2},    {PNG_COLOR_TYPE_GRAY, 4},
    {PNG_COLOR_TYPE_GRAY, 8},        {PNG_COLOR_TYPE_GRAY, 16},   {PNG_COLOR_TYPE_RGB, 8},
    {PNG_COLOR_TYPE_RGB, 16},        {PNG_COLOR_TYPE_PALETTE, 1}, {PNG_COLOR_TYPE_PALETTE, 2},
    {PNG_COLOR_TYPE_PALETTE, 4},     {PNG_COLOR_TYPE_PALETTE, 8}, {PNG_COLOR_TYPE_GRAY_ALPHA, 8},
    {PNG_COLOR_TYPE_GRAY_ALPHA, 16}, {PNG_COLOR_TYPE_RGBA, 8},    {PNG_COLOR_TYPE_RGBA, 16},
};

std::string NameOf(const testing::TestParamInfo<Kind>& kind)
{
    const char* names[] = {"Gray", "", "Rgb", "Palette", "GrayAlpha", "", "Rgba"};
    return names[kind.param.type] + std::to_string(kind.param.depth);
}

class EveryPngKind : public testing::TestWithParam<Kind>
{};

} // namespace

TEST_P(EveryPngKind, IsReadExactlyInterlacedOrNot)
{
    for (const int interlace : {PNG_INTERLACE_NONE, PNG_INTERLACE_ADAM7})
    {
        Picture picture;
        picture.type = GetParam().type;
        picture.depth = GetParam().depth;
        picture.interlace = interlace;
        FillRandomly(picture, 7);
        ExpectReadsAsMeant(picture);
    }
}

TEST_P(EveryPngKind, KeepsItsTransparency)
{
    Picture picture;
    picture.type = GetParam().type;
    picture.depth = GetParam().depth;
    FillRandomly(picture, 11);
    if (picture.type == PNG_COLOR_TYPE_PALETTE)
    {
        for (std::size_t i = 0; i + 1 < picture.palette.size(); ++i)
        {
            picture.paletteAlpha.push_back(png_byte(i * 29));
        }
    }
    else if (picture.type == PNG_COLOR_TYPE_GRAY || picture.type == PNG_COLOR_TYPE_RGB)
    {
        picture.hasKey = true;
        picture.key.gray = png_uint_16(picture.Sample(3, 2, 0));
        picture.key.red = png_uint_16(picture.Sample(3, 2, 0));
        picture.key.green = png_uint_16(picture.Sample(3, 2, picture.Channels() > 1 ? 1 : 0));
        picture.key.blue = png_uint_16(picture.Sample(3, 2, picture.Channels() > 1 ? 2 : 0));
    }
    ExpectReadsAsMeant(picture);
}

INSTANTIATE_TEST_SUITE_P(Png, EveryPngKind, testing::ValuesIn(kEveryKind), NameOf);

TEST(WritePng, StoresAnOpaqueFrameAsRgbAndReadsItBackBitForBit)
{
    const TemporaryFolder folder;
    const Frame frame = RandomFrame(37, 21, true, 1);
    for (const int level : {1, 3, 9})
    {
        const Result<void> written =
            WritePng(folder / "frame.png", frame, {.compressionLevel = level, .overwrite = true});
        ASSERT_TRUE(written) << written.GetError().Text();
        EXPECT_EQ(ColorTypeOf(folder / "frame.png"), PNG_COLOR_TYPE_RGB);
        EXPECT_EQ(*ReadPng(folder / "frame.png"), frame);
    }
    EXPECT_THAT(folder.Names(), ElementsAre("frame.png"));
}

TEST(WritePng, KeepsEveryPremultipliedColourBitForBit)
{
    const TemporaryFolder folder;
    Frame frame(256, 256); // column: colour, row: alpha, every pair that can be
    for (int alpha = 0; alpha < 256; ++alpha)
    {
        for (int color = 0; color < 256; ++color)
        {
            std::uint8_t* pixel = frame.Pixel(color, alpha);
            pixel[0] = std::uint8_t(std::min(color, alpha));
            pixel[1] = std::uint8_t(std::max(0, alpha - color));
            pixel[2] = std::uint8_t(alpha);
            pixel[3] = std::uint8_t(alpha);
        }
    }
    ASSERT_TRUE(WritePng(folder / "frame.png", frame));
    EXPECT_EQ(ColorTypeOf(folder / "frame.png"), PNG_COLOR_TYPE_RGBA);
    EXPECT_EQ(*ReadPng(folder / "frame.png"), frame);
}

TEST(WritePng, ClampsAColourBrighterThanItsAlpha)
{
    const TemporaryFolder folder;
    Frame frame(2, 1);
    frame.rgba = {200, 100, 50, 100, 9, 9, 9, 0};
    ASSERT_TRUE(WritePng(folder / "frame.png", frame));
    EXPECT_THAT(ReadPng(folder / "frame.png")->rgba, ElementsAre(100, 100, 50, 100, 0, 0, 0, 0));
}

TEST(PngText, IsReadAgainAndLeavesThePixelsAsTheyAre)
{
    const TemporaryFolder folder;
    const Frame frame = RandomFrame(9, 7, false, 2);
    const auto bytes = EncodePng(frame, 9, {{"First", "one"}, {"Who drew it", "0123abcd"}});
    ASSERT_TRUE(bytes);
    WriteBytes(folder / "a.png", std::string(bytes->begin(), bytes->end()));
    EXPECT_EQ(*ReadPngText(folder / "a.png", "Who drew it"), "0123abcd");
    EXPECT_EQ(*ReadPngText(folder / "a.png", "First"), "one");
    EXPECT_THAT(*ReadPngText(folder / "a.png", "Who drew"), IsEmpty());
    EXPECT_TRUE(*ReadPng(folder / "a.png") == frame);
}

TEST(PngText, IsEmptyWhereTheFileHasNone)
{
    const TemporaryFolder folder;
    ASSERT_TRUE(WritePng(folder / "a.png", RandomFrame(4, 4, true, 3)));
    EXPECT_THAT(*ReadPngText(folder / "a.png", "Who drew it"), IsEmpty());
}

TEST(PngText, IsRefusedWhenDamagedOrAbsent)
{
    const TemporaryFolder folder;
    const auto bytes = EncodePng(RandomFrame(4, 4, true, 3), 3, {{"Who", "0123abcd"}});
    std::string damaged(bytes->begin(), bytes->end());
    damaged[damaged.find("0123abcd")] = 'x';
    WriteBytes(folder / "a.png", damaged);
    EXPECT_EQ(ReadPngText(folder / "a.png", "Who").GetError().kind, ErrorKind::Unusable);
    EXPECT_EQ(ReadPngText(folder / "none.png", "Who").GetError().kind, ErrorKind::Unusable);
}

TEST(WritePng, MakesTheSameBytesEachTime)
{
    const Frame frame = RandomFrame(64, 64, false, 2);
    EXPECT_EQ(*EncodePng(frame, 3), *EncodePng(frame, 3));
}

TEST(WritePng, LeavesAnExistingFileAloneByDefault)
{
    const TemporaryFolder folder;
    WriteBytes(folder / "frame.png", "precious");
    const Result<void> refused = WritePng(folder / "frame.png", RandomFrame(4, 4, true, 3));
    EXPECT_THAT(refused, Refuses((folder / "frame.png").string()));
    EXPECT_EQ(ReadBytes(folder / "frame.png"), "precious");
    EXPECT_TRUE(WritePng(folder / "frame.png", RandomFrame(4, 4, true, 3), {.overwrite = true}));
    EXPECT_EQ(*ReadPng(folder / "frame.png"), RandomFrame(4, 4, true, 3));
    EXPECT_THAT(folder.Names(), ElementsAre("frame.png"));
}

TEST(WritePng, RefusesAFrameWithoutPixelsAndLeavesNothingBehind)
{
    const TemporaryFolder folder;
    Frame torn(4, 4);
    torn.rgba.pop_back();
    for (const Frame& frame : {Frame(), Frame(0, 5), torn})
    {
        const Result<void> written = WritePng(folder / "frame.png", frame);
        ASSERT_FALSE(written);
        EXPECT_EQ(written.GetError().kind, ErrorKind::Unusable);
    }
    EXPECT_THAT(folder.Names(), IsEmpty());
}

TEST(WritePng, RefusesASideLongerThanItCanReadBack)
{
    const TemporaryFolder folder;
    EXPECT_THAT(WritePng(folder / "frame.png", Frame(16385, 1)),
                Fails(ErrorKind::Failed, "16385x1"));
    EXPECT_TRUE(WritePng(folder / "frame.png", Frame(16384, 1)));
    EXPECT_EQ(ReadPng(folder / "frame.png")->width, 16384);
}

TEST(ReadPng, RefusesFilesCutOffAnywhere)
{
    const TemporaryFolder folder;
    for (const int interlace : {PNG_INTERLACE_NONE, PNG_INTERLACE_ADAM7})
    {
        Picture picture;
        picture.type = PNG_COLOR_TYPE_PALETTE;
        picture.paletteAlpha = {0, 100};
        picture.interlace = interlace;
        FillRandomly(picture, 5);
        Save(picture, folder / "whole.png");
        const std::string whole = ReadBytes(folder / "whole.png");
        for (std::size_t size = 0; size < whole.size(); ++size)
        {
            WriteBytes(folder / "cut.png", whole.substr(0, size));
            const Result<Frame> frame = ReadPng(folder / "cut.png");
            ASSERT_FALSE(frame) << "cut to " << size << " of " << whole.size() << " bytes";
            EXPECT_THAT(frame, Refuses((folder / "cut.png").string()));
        }
    }
}

TEST(ReadPng, NoticesEveryFlippedBit)
{
    const TemporaryFolder folder;
    Picture picture;
    picture.type = PNG_COLOR_TYPE_PALETTE;
    picture.depth = 4;
    picture.paletteAlpha = {0, 100};
    FillRandomly(picture, 6);
    Save(picture, folder / "whole.png");
    const std::string whole = ReadBytes(folder / "whole.png");
    for (std::size_t bit = 0; bit < whole.size() * 8; ++bit)
    {
        std::string damaged = whole;
        damaged[bit / 8] = char(damaged[bit / 8] ^ (1 << bit % 8));
        WriteBytes(folder / "damaged.png", damaged);
        EXPECT_FALSE(ReadPng(folder / "damaged.png"))
            << "bit " << bit % 8 << " of byte " << bit / 8;
    }
}

TEST(ReadPng, ReportsNameThatIsNotPng)
{
    const TemporaryFolder folder;
    WriteBytes(folder / "film.png", "\x1a\x45\xdf\xa3 this is a Matroska film, really it is");
    WriteBytes(folder / "empty.png", "");
    for (const std::string name :
         {"film.png", "empty.png", "missing.png", "no/folder.png", "film.png/inside.png", ""})
    {
        const Result<Frame> frame = ReadPng(folder / name);
        EXPECT_THAT(frame, Refuses((folder / name).string()));
    }
}

TEST(ReadPng, RefusesAHugePictureBeforeMakingRoomForIt)
{
    const TemporaryFolder folder;
    Picture picture;
    FillRandomly(picture, 8);
    Save(picture, folder / "small.png");
    const std::string small = ReadBytes(folder / "small.png");
    for (const png_uint_32 side : {16384u, 16385u, 0x7fffffffu})
    {
        std::string huge = small;
        png_save_uint_32(reinterpret_cast<png_bytep>(huge.data()) + 16, side);
        png_save_uint_32(reinterpret_cast<png_bytep>(huge.data()) + 20, side);
        // The header's checksum covers its name and 13 bytes.
        std::uint32_t crc = 0xffffffffu;
        for (std::size_t i = 12; i < 29; ++i)
        {
            crc ^= static_cast<std::uint8_t>(huge[i]);
            for (int bit = 0; bit < 8; ++bit)
            {
                crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320u : 0u);
            }
        }
        png_save_uint_32(reinterpret_cast<png_bytep>(huge.data()) + 29, ~crc);
        WriteBytes(folder / "huge.png", huge);
        const Result<Frame> frame = ReadPng(folder / "huge.png");
        EXPECT_THAT(frame, RefusesWith((folder / "huge.png").string(),
                                       side == 16384u ? "" : "16384x16384"));
    }
}
