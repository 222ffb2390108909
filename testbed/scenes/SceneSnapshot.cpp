// SPDX-License-Identifier: MIT
#include <scenes/SceneSnapshot.h>

#include <scenes/SceneState.h>

namespace boxreel
{

namespace
{

// The scene's own part comes first, with its length; the world's has its own checksum.
constexpr std::size_t kLengthBytes = 8;
/// FNV-1a (RFC 9923) of the scene's part: it is short.
constexpr std::size_t kSumBytes = 8;

std::uint64_t SumOf(std::span<const uint8> bytes)
{
    std::uint64_t sum = 0xcbf29ce484222325u;
    for (const uint8 byte : bytes)
    {
        sum = (sum ^ byte) * 0x100000001b3u;
    }
    return sum;
}

void Put(std::vector<uint8>& bytes, std::uint64_t number)
{
    for (int shift = 0; shift < 64; shift += 8)
    {
        bytes.push_back(uint8(number >> shift));
    }
}

std::uint64_t NumberAt(std::span<const uint8> bytes, std::size_t at)
{
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < 8; ++i)
    {
        number |= std::uint64_t(bytes[at + i]) << (8 * i);
    }
    return number;
}

constexpr std::size_t kHeaderBytes = kLengthBytes + kSumBytes;

} // namespace

std::vector<uint8> SaveScene(Scene& scene)
{
    SceneState state(scene.World());
    scene.VisitCommonState(state);
    scene.VisitState(state);
    const std::vector<uint8> own = state.Take();
    const std::vector<uint8> world = b2SaveSnapshot(scene.World());
    std::vector<uint8> bytes;
    Put(bytes, own.size());
    Put(bytes, SumOf(own));
    bytes.insert(bytes.end(), own.begin(), own.end());
    bytes.insert(bytes.end(), world.begin(), world.end());
    return bytes;
}

std::string RestoreScene(Scene& scene, std::span<const uint8> bytes)
{
    if (bytes.size() < kHeaderBytes || NumberAt(bytes, 0) > bytes.size() - kHeaderBytes)
    {
        return "This is not a complete snapshot of a scene: pass the bytes that SaveScene "
               "returned.";
    }
    const std::span<const uint8> own = bytes.subspan(kHeaderBytes, NumberAt(bytes, 0));
    if (SumOf(own) != NumberAt(bytes, kLengthBytes))
    {
        return "The snapshot of the scene is damaged: save it again.";
    }
    const std::vector<uint8> before = SaveScene(scene);
    if (const char* why =
            b2RestoreSnapshot(scene.World(), bytes.subspan(kHeaderBytes + own.size())))
    {
        return why;
    }
    SceneState state(scene.World(), own);
    scene.VisitCommonState(state);
    scene.VisitState(state);
    if (!state.IsWhole())
    {
        (void)RestoreScene(scene, before);
        return "The snapshot is of a scene of another kind: restore it into one of the same.";
    }
    return "";
}

} // namespace boxreel
