// SPDX-License-Identifier: MIT
#include <render/Png.h>

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <base/ReadWhole.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <memory>
#include <new>
#include <string>
#include <system_error>

#include <png.h>

namespace boxreel
{

namespace
{

namespace fs = std::filesystem;

constexpr png_uint_32 kMaxSide = 16384;          // twice the renderer's limit; 1 GiB if square
constexpr std::uint64_t kMaxDeflateRatio = 1032; // maximum compression ratio of zlib
constexpr std::size_t kMaxMessage = 160;

// The error of a libpng call. libpng reports errors by longjmp, so no object with a destructor may
// be alive in between.
struct PngError
{
    char message[kMaxMessage] = "";
    bool isDevice = false; // a read error, not invalid data
};

[[noreturn]] void OnError(png_structp png, png_const_charp message)
{
    auto* error = static_cast<PngError*>(png_get_error_ptr(png));
    std::snprintf(error->message, kMaxMessage, "%s", message);
    png_longjmp(png, 1);
}

void OnWarning(png_structp, png_const_charp) {}

// Runs `body`, which may call libpng but must not own objects; false after a libpng error.
template <class Body>
bool Guarded(png_structp png, const Body& body)
{
    if (setjmp(png_jmpbuf(png)) != 0)
    {
        return false;
    }
    body();
    return true;
}

// Returns c * a / 255, rounded; 255 is odd, so there are no ties.
std::uint8_t Premultiply(unsigned c, unsigned a)
{
    return static_cast<std::uint8_t>((c * a + 127) / 255);
}

// Returns the nearest straight value. Its product is off by less than a / 510 < 1/2, so Premultiply
// restores c.
std::uint8_t Unpremultiply(unsigned c, unsigned a)
{
    return a == 0 ? std::uint8_t{0}
                  : static_cast<std::uint8_t>(std::min(255u, (c * 255 + a / 2) / a));
}

void PremultiplyAll(Frame& frame)
{
    for (std::size_t i = 0; i < frame.rgba.size(); i += 4)
    {
        std::uint8_t* p = frame.rgba.data() + i;
        if (p[3] != 255)
        {
            p[0] = Premultiply(p[0], p[3]);
            p[1] = Premultiply(p[1], p[3]);
            p[2] = Premultiply(p[2], p[3]);
        }
    }
}

struct CloseFile
{
    void operator()(std::FILE* file) const { std::fclose(file); }
};

struct Reader
{
    std::unique_ptr<std::FILE, CloseFile> file;
    PngError error;
    png_structp png = nullptr;
    png_infop info = nullptr;
    png_uint_32 width = 0;
    png_uint_32 height = 0;
    std::size_t rowBytes = 0; // size of a stored row before compression
    bool hasAlpha = false;

    Reader() = default;
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

void OnRead(png_structp png, png_bytep bytes, std::size_t count)
{
    auto* file = static_cast<std::FILE*>(png_get_io_ptr(png));
    if (std::fread(bytes, 1, count, file) != count)
    {
        auto* error = static_cast<PngError*>(png_get_error_ptr(png));
        error->isDevice = std::ferror(file) != 0;
        png_error(png, error->isDevice ? "the device failed" : "it ends too early");
    }
}

// Reads the chunks before the pixels. Memory use does not depend on the declared size.
void ReadHeader(Reader& reader, bool readsTexts)
{
    const png_structp png = reader.png;
    png_set_read_fn(png, reader.file.get(), OnRead);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX); // our limits are checked by the
                                                                // caller
    // A damaged transparency chunk would change the picture unnoticed. All other optional chunks
    // are skipped, except texts on request.
    png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    static const png_byte kRead[] = "tRNS\0tEXt"; // a name has 4 letters and a zero
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_AS_DEFAULT, kRead, readsTexts ? 2 : 1);
    png_read_info(png, reader.info);

    reader.width = png_get_image_width(png, reader.info);
    reader.height = png_get_image_height(png, reader.info);
    reader.rowBytes = png_get_rowbytes(png, reader.info);
}

// Reads as 8-bit RGBA from any format.
void ReadPixels(Reader& reader, png_bytep* rows)
{
    const png_structp png = reader.png;
    reader.hasAlpha = (png_get_color_type(png, reader.info) & PNG_COLOR_MASK_ALPHA) != 0 ||
                      png_get_valid(png, reader.info, PNG_INFO_tRNS) != 0;
    png_set_expand(png);
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png);
    png_read_update_info(png, reader.info);
    png_read_image(png, rows);
    png_read_end(png, nullptr);
}

Error CannotRead(ErrorKind kind, const fs::path& path, const std::string& problem,
                 const std::string& remedy)
{
    return Error{kind, path.string(), "cannot be read: " + problem, remedy};
}

Error Damaged(const Reader& reader, const fs::path& path)
{
    const std::string what = reader.error.message;
    if (reader.error.isDevice)
    {
        return CannotRead(ErrorKind::Failed, path, what, "check the disk and try again");
    }
    return CannotRead(ErrorKind::Unusable, path, "it is not a complete PNG picture (" + what + ")",
                      "choose another file");
}

Result<void> OpenFile(Reader& reader, const fs::path& path)
{
    std::error_code code;
    if (fs::is_directory(path, code))
    {
        return CannotRead(ErrorKind::Unusable, path, "is a folder", "name a PNG file");
    }
    reader.file.reset(std::fopen(path.c_str(), "rb"));
    if (!reader.file)
    {
        return errno == ENOENT || errno == ENOTDIR
                   ? FileNotFound(path)
                   : CannotRead(ErrorKind::Unusable, path, std::generic_category().message(errno),
                                "check its permissions");
    }
    return {};
}

// Checks that the declared pixel count is within the limit and plausible for the file's length.
Result<void> CheckSize(const Reader& reader, const fs::path& path)
{
    const std::string promise = std::to_string(reader.width) + "x" + std::to_string(reader.height);
    const std::string limit = std::to_string(kMaxSide);
    if (reader.width > kMaxSide || reader.height > kMaxSide)
    {
        return CannotRead(ErrorKind::Unusable, path, "it has " + promise + " pixels",
                          "choose a picture of at most " + limit + "x" + limit);
    }
    std::error_code code;
    const bool isRegular = fs::is_regular_file(path, code);
    const std::uint64_t size = isRegular ? fs::file_size(path, code) : 0;
    if (isRegular && !code &&
        std::uint64_t{reader.rowBytes} * reader.height / kMaxDeflateRatio > size)
    {
        return CannotRead(ErrorKind::Unusable, path,
                          "it is too short for " + promise + " pixels, the size in its header",
                          "copy it again or choose another file");
    }
    return {};
}

// Writes opaque frames as RGB without filters: smaller and faster for flat pictures than libpng's
// defaults.
struct Writer
{
    PngError error;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::vector<std::uint8_t> bytes;
    std::vector<std::uint8_t> row;

    Writer() = default;
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() { png_destroy_write_struct(&png, &info); }
};

void OnWrite(png_structp png, png_bytep bytes, std::size_t count)
{
    auto* writer = static_cast<Writer*>(png_get_io_ptr(png));
    bool isStored = true;
    try
    {
        writer->bytes.insert(writer->bytes.end(), bytes, bytes + count);
    }
    catch (const std::bad_alloc&)
    {
        isStored = false; // longjmp must not leave the handler's scope
    }
    if (!isStored)
    {
        png_error(png, "out of memory");
    }
}

void OnFlush(png_structp) {}

bool IsOpaque(const Frame& frame)
{
    for (std::size_t i = 3; i < frame.rgba.size(); i += 4)
    {
        if (frame.rgba[i] != 255)
        {
            return false;
        }
    }
    return true;
}

void PackRow(const std::uint8_t* from, int width, bool isOpaque, std::uint8_t* to)
{
    for (int x = 0; x < width; ++x, from += 4)
    {
        if (isOpaque)
        {
            to[0] = from[0];
            to[1] = from[1];
            to[2] = from[2];
            to += 3;
            continue;
        }
        const unsigned a = from[3];
        to[0] = Unpremultiply(from[0], a);
        to[1] = Unpremultiply(from[1], a);
        to[2] = Unpremultiply(from[2], a);
        to[3] = from[3];
        to += 4;
    }
}

// libpng copies keyword and text.
void WriteTexts(Writer& writer, const std::vector<PngText>& texts)
{
    for (const PngText& text : texts)
    {
        png_text chunk{};
        chunk.compression = PNG_TEXT_COMPRESSION_NONE;
        chunk.key = const_cast<png_charp>(text.keyword.c_str());
        chunk.text = const_cast<png_charp>(text.text.c_str());
        chunk.text_length = text.text.size();
        png_set_text(writer.png, writer.info, &chunk, 1);
    }
}

void WriteAll(Writer& writer, const Frame& frame, bool isOpaque, int compressionLevel,
              const std::vector<PngText>& texts)
{
    const png_structp png = writer.png;
    png_set_write_fn(png, &writer, OnWrite, OnFlush);
    png_set_user_limits(png, kMaxSide, kMaxSide);
    png_set_IHDR(png, writer.info, static_cast<png_uint_32>(frame.width),
                 static_cast<png_uint_32>(frame.height), 8,
                 isOpaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
    png_set_compression_level(png, compressionLevel);
    png_set_compression_buffer_size(png, std::size_t{1} << 16);
    WriteTexts(writer, texts);
    png_write_info(png, writer.info);
    for (int y = 0; y < frame.height; ++y)
    {
        PackRow(frame.Pixel(0, y), frame.width, isOpaque, writer.row.data());
        png_write_row(png, writer.row.data());
    }
    png_write_end(png, nullptr);
}

/// Opens the file and reads the chunks before the pixels.
Result<void> Begin(Reader& reader, const fs::path& path, bool readsTexts)
{
    RETURN_IF_ERROR(OpenFile(reader, path));
    reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader.error, OnError, OnWarning);
    reader.info = reader.png ? png_create_info_struct(reader.png) : nullptr;
    if (!reader.info)
    {
        return CannotRead(ErrorKind::Failed, path, "libpng cannot start",
                          "free some memory and try again");
    }
    return Guarded(reader.png, [&] { ReadHeader(reader, readsTexts); })
               ? Result<void>()
               : Result<void>(Damaged(reader, path));
}

} // namespace

Result<Frame> ReadPng(const std::filesystem::path& path)
{
    Reader reader;
    RETURN_IF_ERROR(Begin(reader, path, false));
    RETURN_IF_ERROR(CheckSize(reader, path));
    Frame frame(static_cast<int>(reader.width), static_cast<int>(reader.height));
    std::vector<png_bytep> rows(reader.height);
    for (int y = 0; y < frame.height; ++y)
    {
        rows[std::size_t(y)] = frame.Pixel(0, y);
    }
    if (!Guarded(reader.png, [&reader, &rows] { ReadPixels(reader, rows.data()); }))
    {
        return Damaged(reader, path);
    }
    if (reader.hasAlpha)
    {
        PremultiplyAll(frame);
    }
    return frame;
}

Result<std::string> ReadPngText(const std::filesystem::path& path, const std::string& keyword)
{
    Reader reader;
    RETURN_IF_ERROR(Begin(reader, path, true));
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(reader.png, reader.info, &texts, &count);
    const png_textp end = texts + count;
    const png_textp found =
        std::find_if(texts, end, [&](const png_text& text) { return keyword == text.key; });
    return found == end ? std::string() : std::string(found->text, found->text_length);
}

Result<std::vector<std::uint8_t>> EncodePng(const Frame& frame, int compressionLevel,
                                            const std::vector<PngText>& texts)
{
    assert(compressionLevel >= 1 && compressionLevel <= 9);
    const std::size_t size =
        std::size_t(std::max(frame.width, 0)) * std::size_t(std::max(frame.height, 0)) * 4;
    if (size == 0 || size != frame.rgba.size())
    {
        return Error{
            ErrorKind::Unusable, std::to_string(frame.width) + "x" + std::to_string(frame.height),
            "a picture of this size cannot have " + std::to_string(frame.rgba.size()) + " bytes",
            "draw it first"};
    }
    Writer writer;
    const bool isOpaque = IsOpaque(frame);
    writer.row.resize(std::size_t(frame.width) * (isOpaque ? 3 : 4));
    writer.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &writer.error, OnError, OnWarning);
    writer.info = writer.png ? png_create_info_struct(writer.png) : nullptr;
    if (!writer.info)
    {
        return Error{ErrorKind::Failed, "libpng", "cannot start", "free some memory"};
    }
    if (!Guarded(writer.png, [&] { WriteAll(writer, frame, isOpaque, compressionLevel, texts); }))
    {
        return Error{
            ErrorKind::Failed, std::to_string(frame.width) + "x" + std::to_string(frame.height),
            std::string("a picture of this size cannot be encoded (") + writer.error.message + ")",
            "choose a smaller size, at most " + std::to_string(kMaxSide) + " a side"};
    }
    return std::move(writer.bytes);
}

Result<void> WritePng(const std::filesystem::path& path, const Frame& frame,
                      const PngSettings& settings)
{
    // Opened before encoding, so that an Error of the file is reported early.
    ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::Create(path, settings.overwrite));
    ASSIGN_OR_RETURN(const std::vector<std::uint8_t> bytes,
                     EncodePng(frame, settings.compressionLevel));
    const Result<void> written = file.Write(bytes);
    return written ? file.Commit() : written;
}

} // namespace boxreel
