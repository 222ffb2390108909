// SPDX-License-Identifier: MIT
#include <base/Counting.h>
#include <base/Gzip.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>

namespace boxreel
{

namespace
{

constexpr int kGzipFormat = 15 + 16; // zlib: the largest window, with a gzip header
constexpr int kMemoryLevel = 9;

Error NotGzip(const std::string& name)
{
    return Error{ErrorKind::Unusable, name, "is not a complete gzip file"};
}

Error NoMemory(const std::string& name)
{
    return Error{ErrorKind::Failed, name, "not enough memory to pack or unpack it"};
}

// A zlib stream, ended by the destructor.
struct Deflater
{
    z_stream stream{};
    const bool isReady = deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kGzipFormat,
                                      kMemoryLevel, Z_DEFAULT_STRATEGY) == Z_OK;
    ~Deflater() { deflateEnd(&stream); }
};

struct Inflater
{
    z_stream stream{};
    const bool isReady = inflateInit2(&stream, kGzipFormat) == Z_OK;
    ~Inflater() { inflateEnd(&stream); }
};

// zlib takes its input through a pointer to non-const, but does not write to it.
Bytef* Input(std::string_view bytes)
{
    return reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
}

bool FitsZlib(std::string_view bytes)
{
    return bytes.size() <= std::numeric_limits<uInt>::max();
}

} // namespace

Result<std::string> Gzip(const std::string& name, std::string_view text)
{
    Deflater deflater;
    if (!deflater.isReady || !FitsZlib(text))
    {
        return NoMemory(name);
    }
    z_stream& stream = deflater.stream;
    std::string out(deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
    if (!FitsZlib(out))
    {
        return NoMemory(name);
    }
    stream.next_in = Input(text);
    stream.avail_in = static_cast<uInt>(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    if (deflate(&stream, Z_FINISH) != Z_STREAM_END)
    {
        return NoMemory(name);
    }
    out.resize(stream.total_out);
    return out;
}

Result<std::string> Gunzip(const std::string& name, std::string_view bytes, std::size_t limit)
{
    Inflater inflater;
    if (!inflater.isReady)
    {
        return NoMemory(name);
    }
    if (!FitsZlib(bytes))
    {
        return NotGzip(name);
    }
    z_stream& stream = inflater.stream;
    stream.next_in = Input(bytes);
    stream.avail_in = static_cast<uInt>(bytes.size());
    std::string out;
    std::array<char, 1 << 16> block;
    int status = Z_OK;
    while (status == Z_OK)
    {
        stream.next_out = reinterpret_cast<Bytef*>(block.data());
        stream.avail_out = static_cast<uInt>(block.size());
        status = inflate(&stream, Z_NO_FLUSH);
        out.append(block.data(), block.size() - stream.avail_out);
        if (out.size() > limit)
        {
            return Error{ErrorKind::Unusable, name, "unpacks to more than " + SizeText(limit)};
        }
    }
    if (status != Z_STREAM_END || stream.avail_in != 0)
    {
        return NotGzip(name);
    }
    return out;
}

std::uint32_t Crc32(std::span<const std::uint8_t> bytes)
{
    return std::uint32_t(crc32_z(0, bytes.data(), bytes.size()));
}

} // namespace boxreel
