// SPDX-License-Identifier: MIT
#include "PngStream.h"

#include "HuffmanCode.h"

#include <base/Gzip.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>
#include <span>
#include <string_view>
#include <utility>

namespace boxreel
{

namespace
{

using Bytes = std::vector<std::uint8_t>;

constexpr int kColors = 3; // bytes of a pixel

// ------------------------------------------------------------------------------ Deflate's alphabet

constexpr std::size_t kMinMatch = 3;
constexpr std::size_t kMaxMatch = 258;
constexpr std::size_t kWindow = 32768; // largest distance
constexpr int kEnd = 256;              // ends the block
constexpr int kLiteralCodes = 286;
constexpr int kDistanceCodes = 30;
constexpr int kLengthCodes = 19; // of code lengths
constexpr int kMaxBits = 15;
constexpr int kMaxLengthBits = 7; // of the codes of code lengths

/// A code, and bits that follow it.
struct Code
{
    int code, extraBits, extra;
};

/// RFC 1951, 3.2.5: lengths 3 to 10 have codes of their own, then four codes share each power of
/// two; 258 has its own.
constexpr Code CodeOfLength(std::size_t length)
{
    if (length == kMaxMatch)
    {
        return {285, 0, 0};
    }
    const auto n = unsigned(length - kMinMatch);
    if (n < 8)
    {
        return {257 + int(n), 0, 0};
    }
    const int bits = std::bit_width(n) - 3;
    return {257 + 4 * bits + int(n >> bits), bits, int(n & ((1u << bits) - 1u))};
}

/// The same for distances: two codes share each power of two.
constexpr Code CodeOfDistance(std::size_t distance)
{
    const auto n = unsigned(distance - 1);
    if (n < 4)
    {
        return {int(n), 0, 0};
    }
    const int bits = std::bit_width(n) - 2;
    return {2 * bits + int(n >> bits), bits, int(n & ((1u << bits) - 1u))};
}

static_assert(CodeOfLength(10).code == 264 && CodeOfLength(11).code == 265);
static_assert(CodeOfLength(257).code == 284 && CodeOfLength(257).extra == 30);
static_assert(CodeOfDistance(4).code == 3 && CodeOfDistance(5).code == 4);
static_assert(CodeOfDistance(kWindow).code == 29 && CodeOfDistance(kWindow).extraBits == 13);

/// A literal byte, or a match.
struct Token
{
    std::uint16_t length;          // 0: a literal
    std::uint16_t distanceOrValue; // the distance - 1, or the byte
};

// ------------------------------------------------------------------------------------ words

/// The first byte is the lowest on every processor.
std::uint64_t Load8(const std::uint8_t* from)
{
    std::uint64_t word = 0;
    if constexpr (std::endian::native == std::endian::little)
    {
        std::memcpy(&word, from, sizeof word);
        return word;
    }
    for (int i = 0; i < 8; ++i)
    {
        word |= std::uint64_t(from[i]) << (8 * i);
    }
    return word;
}

void Store8(std::uint64_t word, std::uint8_t* to)
{
    if constexpr (std::endian::native == std::endian::little)
    {
        std::memcpy(to, &word, sizeof word);
        return;
    }
    for (int i = 0; i < 8; ++i)
    {
        to[i] = std::uint8_t(word >> (8 * i));
    }
}

// ------------------------------------------------------------------------------------ rows

/// Stores the rows as RGB, each after a zero for "no filter". False if a pixel is transparent.
bool StoreRows(const Frame& frame, Bytes& rows)
{
    constexpr std::size_t overhang = 2; // two pixels have six bytes and are stored as eight
    constexpr std::uint64_t first = 0x0000000000FFFFFFu, second = 0x0000FFFFFF000000u;
    const std::size_t width = std::size_t(frame.width), stride = width * kColors + 1;
    rows.resize(stride * std::size_t(frame.height) + overhang);
    std::uint64_t opaque = ~std::uint64_t{0};
    for (int y = 0; y < frame.height; ++y)
    {
        const std::uint8_t* from = frame.Pixel(0, y);
        std::uint8_t* to = rows.data() + std::size_t(y) * stride;
        *to++ = 0;
        for (std::size_t x = 0; x + 1 < width; x += 2, from += 8, to += 2 * kColors)
        {
            const std::uint64_t pixels = Load8(from);
            Store8((pixels & first) | (pixels >> 8 & second), to);
            opaque &= pixels;
        }
        if (width % 2 != 0)
        {
            std::copy_n(from, kColors, to);
            opaque &= ~(std::uint64_t(255 - from[3]) << 24);
        }
    }
    rows.resize(rows.size() - overhang);
    return (opaque & 0xFF000000FF000000u) == 0xFF000000FF000000u;
}

// ------------------------------------------------------------------------------------ matches

/// Returns how many bytes from `here` to `end` equal those `distance` before them.
std::size_t MatchLength(const std::uint8_t* here, const std::uint8_t* end, std::size_t distance)
{
    const std::uint8_t* p = here;
    while (end - p >= 8)
    {
        const std::uint64_t differing = Load8(p) ^ Load8(p - distance);
        if (differing != 0)
        {
            return std::size_t(p - here) + std::size_t(std::countr_zero(differing) / 8);
        }
        p += 8;
    }
    while (p < end && *p == *(p - distance))
    {
        ++p;
    }
    return std::size_t(p - here);
}

/// The last place of each pair of pixels.
class Places
{
public:
    /// Returns the last place with the same hash as the six bytes there, or `none`, and stores the
    /// new one.
    std::size_t Exchange(const std::uint8_t* bytes, std::size_t place)
    {
        constexpr std::uint64_t odd = 0x9E3779B97F4A7C15u; // 2^64 divided by the golden ratio
        const std::uint64_t hash = (Load8(bytes) << 16) * odd;
        std::uint32_t& slot = m_places[std::size_t(hash >> (64 - kBits))];
        return std::exchange(slot, std::uint32_t(place));
    }

    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

private:
    static constexpr int kBits = 13;
    std::vector<std::uint32_t> m_places =
        std::vector<std::uint32_t>(std::size_t{1} << kBits, kNone);
};

struct Match
{
    std::size_t length = 0, distance = 0;
};

/// Takes the longer one; a match of equal length nearer by has fewer bits.
void TakeLonger(Match& best, std::size_t length, std::size_t distance)
{
    if (length > best.length)
    {
        best = {length, distance};
    }
}

/// Divides the rows into literals and matches. `stride`: bytes of a row.
void Divide(const Bytes& rows, std::size_t stride, std::vector<Token>& tokens)
{
    tokens.clear();
    Places places;
    const std::uint8_t* const begin = rows.data();
    const std::uint8_t* const end = begin + rows.size();
    for (const std::uint8_t* p = begin; p < end;)
    {
        const auto place = std::size_t(p - begin);
        Match best;
        if (place >= kColors)
        {
            TakeLonger(best, MatchLength(p, end, kColors), kColors);
        }
        if (best.length < kMaxMatch && place >= stride && stride <= kWindow)
        {
            TakeLonger(best, MatchLength(p, std::min(end, p + 2 * kMaxMatch), stride), stride);
        }
        if (best.length < kMaxMatch && end - p >= 8)
        {
            const std::size_t last = places.Exchange(p, place);
            if (last != Places::kNone && place - last <= kWindow)
            {
                const std::size_t distance = place - last;
                TakeLonger(best, MatchLength(p, std::min(end, p + kMaxMatch), distance), distance);
            }
        }
        if (best.length < kMinMatch)
        {
            tokens.push_back({0, *p++});
            continue;
        }
        p += best.length;
        while (best.length > 0)
        {
            // The last part must not be shorter than a match.
            std::size_t part = std::min(best.length, kMaxMatch);
            part -= best.length - part > 0 && best.length - part < kMinMatch ? kMinMatch : 0;
            tokens.push_back({std::uint16_t(part), std::uint16_t(best.distance - 1)});
            best.length -= part;
        }
    }
}

// ------------------------------------------------------------------------------------ bits

/// Appends at most `maxBytes` of bits, the lowest first.
class BitWriter
{
public:
    BitWriter(Bytes& to, std::size_t maxBytes) : m_to(to), m_size(to.size())
    {
        m_to.resize(m_size + maxBytes + sizeof m_bits);
    }

    /// At most 32 bits.
    void Put(std::uint32_t bits, int count)
    {
        m_bits |= std::uint64_t(bits) << m_count;
        m_count += count;
        if (m_count >= 32)
        {
            Store(4);
        }
    }
    void Put(const HuffmanCode& code, int symbol)
    {
        Put(code.words[std::size_t(symbol)], code.lengths[std::size_t(symbol)]);
    }
    void Put(const Code& code) { Put(std::uint32_t(code.extra), code.extraBits); }
    /// Fills the last byte with zeros.
    void Finish()
    {
        Store((m_count + 7) / 8);
        m_to.resize(m_size);
    }

private:
    void Store(int bytes)
    {
        for (int i = 0; i < bytes; ++i)
        {
            m_to[m_size++] = std::uint8_t(m_bits >> (8 * i));
        }
        m_bits >>= 8 * bytes;
        m_count -= 8 * bytes;
    }

    Bytes& m_to;
    std::size_t m_size; // so much of it is written
    std::uint64_t m_bits = 0;
    int m_count = 0;
};

/// The code lengths of both codes, themselves coded: 16 repeats the last length 3 to 6 times, 17
/// and 18 are 3 to 10 and 11 to 138 zeros.
std::vector<Code> CodedLengths(const std::vector<std::uint8_t>& lengths)
{
    std::vector<Code> coded;
    for (std::size_t i = 0; i < lengths.size();)
    {
        std::size_t run = 1;
        while (i + run < lengths.size() && lengths[i + run] == lengths[i])
        {
            ++run;
        }
        i += run;
        const int length = lengths[i - 1];
        if (length != 0)
        {
            coded.push_back({length, 0, 0});
            --run;
        }
        while (run > 0)
        {
            const std::size_t most = length == 0 ? 138 : 6;
            const std::size_t part = std::min(run, most);
            if (part < 3)
            {
                coded.push_back({length, 0, 0});
                --run;
                continue;
            }
            coded.push_back(length != 0  ? Code{16, 2, int(part) - 3}
                            : part <= 10 ? Code{17, 3, int(part) - 3}
                                         : Code{18, 7, int(part) - 11});
            run -= part;
        }
    }
    return coded;
}

/// Writes both codes in front of the block's data (RFC 1951, 3.2.7).
void PutCodes(BitWriter& bits, const HuffmanCode& literals, const HuffmanCode& distances)
{
    std::vector<std::uint8_t> lengths = literals.lengths;
    lengths.insert(lengths.end(), distances.lengths.begin(), distances.lengths.end());
    const std::vector<Code> coded = CodedLengths(lengths);
    std::vector<std::uint32_t> counts(kLengthCodes);
    for (const Code& code : coded)
    {
        ++counts[std::size_t(code.code)];
    }
    const HuffmanCode ofLengths = MakeHuffmanCode(counts, kMaxLengthBits);
    bits.Put(kLiteralCodes - 257, 5);
    bits.Put(kDistanceCodes - 1, 5);
    bits.Put(kLengthCodes - 4, 4);
    for (const int symbol : {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15})
    {
        bits.Put(ofLengths.lengths[std::size_t(symbol)], 3);
    }
    for (const Code& code : coded)
    {
        bits.Put(ofLengths, code.code);
        bits.Put(code);
    }
}

/// Appends the rows as one block with codes of its own.
void AppendDeflate(const std::vector<Token>& tokens, Bytes& to)
{
    std::vector<std::uint32_t> literalCounts(kLiteralCodes), distanceCounts(kDistanceCodes);
    for (const Token& token : tokens)
    {
        if (token.length == 0)
        {
            ++literalCounts[token.distanceOrValue];
            continue;
        }
        ++literalCounts[std::size_t(CodeOfLength(token.length).code)];
        ++distanceCounts[std::size_t(CodeOfDistance(token.distanceOrValue + 1u).code)];
    }
    ++literalCounts[kEnd];
    const HuffmanCode literals = MakeHuffmanCode(literalCounts, kMaxBits);
    const HuffmanCode distances = MakeHuffmanCode(distanceCounts, kMaxBits);
    constexpr std::size_t maxOfToken = 6; // 15 + 5 bits for a length, 15 + 13 for a distance
    constexpr std::size_t maxOfCodes = 512;
    BitWriter bits(to, maxOfToken * tokens.size() + maxOfCodes);
    bits.Put(1, 1); // the last block
    bits.Put(2, 2); // with codes of its own
    PutCodes(bits, literals, distances);
    for (const Token& token : tokens)
    {
        if (token.length == 0)
        {
            bits.Put(literals, token.distanceOrValue);
            continue;
        }
        const Code length = CodeOfLength(token.length);
        const Code distance = CodeOfDistance(token.distanceOrValue + 1u);
        bits.Put(literals, length.code);
        bits.Put(length);
        bits.Put(distances, distance.code);
        bits.Put(distance);
    }
    bits.Put(literals, kEnd);
    bits.Finish();
}

// ------------------------------------------------------------------------------------ the file

void AppendNumber(Bytes& to, std::uint32_t number)
{
    for (int shift = 24; shift >= 0; shift -= 8)
    {
        to.push_back(std::uint8_t(number >> shift));
    }
}

/// Appends a chunk whose data are made by `data`.
template <class Data>
void AppendChunk(Bytes& to, std::string_view type, const Data& data)
{
    const std::size_t begin = to.size();
    AppendNumber(to, 0); // the length, when it is known
    to.insert(to.end(), type.begin(), type.end());
    data();
    const std::size_t length = to.size() - begin - 8;
    for (std::size_t i = 0; i < 4; ++i)
    {
        to[begin + i] = std::uint8_t(length >> (24 - 8 * i));
    }
    AppendNumber(to, Crc32(std::span(to).subspan(begin + 4)));
}

/// Returns the checksum of RFC 1950: 1 plus the sum of the bytes, and the sum of all its values,
/// both modulo 65521. Many columns are summed side by side, which the compiler does in wide
/// registers.
std::uint32_t Adler32(const std::uint8_t* bytes, std::size_t size)
{
    constexpr std::uint64_t modulus = 65521;
    constexpr std::size_t columns = 64;
    constexpr std::size_t rows = 23; // 255 * 23 * 22 / 2 fits into 16 bits
    std::uint64_t a = 1, b = 0;
    for (; size >= rows * columns; size -= rows * columns)
    {
        std::uint16_t sums[columns] = {}, sumsOfSums[columns] = {};
        for (std::size_t row = 0; row < rows; ++row, bytes += columns)
        {
            for (std::size_t i = 0; i < columns; ++i)
            {
                sumsOfSums[i] = std::uint16_t(sumsOfSums[i] + sums[i]);
                sums[i] = std::uint16_t(sums[i] + bytes[i]);
            }
        }
        std::uint32_t sum = 0, weighted = 0, sumOfSums = 0;
        for (std::size_t i = 0; i < columns; ++i)
        {
            sum += sums[i];
            weighted += std::uint32_t(columns - i) * sums[i];
            sumOfSums += sumsOfSums[i];
        }
        b = (b + rows * columns * a + columns * std::uint64_t(sumOfSums) + weighted) % modulus;
        a = (a + sum) % modulus;
    }
    for (; size > 0; --size)
    {
        a = (a + *bytes++) % modulus;
        b = (b + a) % modulus;
    }
    return std::uint32_t(b << 16 | a);
}

} // namespace

struct PngStream::Buffers
{
    Bytes rows;
    std::vector<Token> tokens;
    Bytes file;
};

PngStream::PngStream() : m_buffers(std::make_unique<Buffers>()) {}

PngStream::~PngStream() = default;

std::span<const std::uint8_t> PngStream::Encode(const Frame& frame)
{
    assert(frame.width > 0 && frame.height > 0);
    Bytes& rows = m_buffers->rows; // clang before 16 does not capture structured bindings
    Bytes& file = m_buffers->file;
    if (!StoreRows(frame, rows))
    {
        return {};
    }
    file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    AppendChunk(file, "IHDR", [&] {
        AppendNumber(file, std::uint32_t(frame.width));
        AppendNumber(file, std::uint32_t(frame.height));
        // 8 bits, RGB, deflate, the usual filters, no interlace
        file.insert(file.end(), {8, 2, 0, 0, 0});
    });
    AppendChunk(file, "IDAT", [&] {
        file.insert(file.end(), {0x78, 0x01}); // zlib (RFC 1950), a window of 32 kB, fastest
        Divide(rows, std::size_t(frame.width) * kColors + 1, m_buffers->tokens);
        AppendDeflate(m_buffers->tokens, file);
        AppendNumber(file, Adler32(rows.data(), rows.size()));
    });
    AppendChunk(file, "IEND", [] {});
    return file;
}

} // namespace boxreel
