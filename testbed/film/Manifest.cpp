// SPDX-License-Identifier: MIT
#include "Manifest.h"

#include <base/AtomicFile.h>
#include <base/Bytes.h>
#include <base/ReadWhole.h>
#include <options/Values.h>
#include <recorder/VideoWriter.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <span>
#include <string_view>

#include <nlohmann/json.hpp>

namespace boxreel
{
namespace
{

using nlohmann::json;

constexpr std::uintmax_t kLargestManifest = 16'000'000; ///< [bytes]

struct Exempt
{
    std::string_view option;
    bool hasValue;
};

constexpr std::array<Exempt, 13> kExempt = {{
    {"-o", true},
    {"--output", true},
    {"--frame-range", true},
    {"--progress", true},
    {"--snapshots", true},
    {"--snapshot-every", true},
    {"--thumbnail", true},
    {"--thumbnail-at", true},
    {"--backend", true},
    {"--resume", false},
    {"--skip-done", false},
    {"--force", false},
    {"--stats", false},
}};

/// -oFILE, the only option of one letter that has a value.
bool IsAttachedOutput(std::string_view word)
{
    return word.size() > 2 && word.starts_with("-o");
}

const Exempt* ExemptionOf(std::string_view word)
{
    const bool isAttached = IsAttachedOutput(word);
    const std::string_view option = isAttached ? "-o" : word.substr(0, word.find('='));
    const auto* found = std::find_if(kExempt.begin(), kExempt.end(),
                                     [option](const Exempt& e) { return e.option == option; });
    return found == kExempt.end() ? nullptr : found;
}

json ToJson(const Manifest& manifest)
{
    json states = json::object();
    for (const auto& [frame, state] : manifest.states)
    {
        states[std::to_string(frame)] = state;
    }
    return {{"boxreel", manifest.version},
            {"command", manifest.command},
            {"fps", {manifest.framesPerSecond.num, manifest.framesPerSecond.den}},
            {"group", manifest.groupFrames},
            {"loop", manifest.plays},
            {"frames", manifest.frameCount},
            {"first", manifest.first},
            {"end", manifest.end},
            {"checksum", manifest.checksum},
            {"states", states}};
}

Manifest FromJson(const json& object)
{
    Manifest manifest;
    manifest.version = object.at("boxreel").get<std::string>();
    manifest.command = object.at("command").get<std::vector<std::string>>();
    manifest.framesPerSecond = {object.at("fps").at(0).get<std::int64_t>(),
                                object.at("fps").at(1).get<std::int64_t>()};
    manifest.groupFrames = object.at("group").get<std::int64_t>();
    manifest.plays = object.at("loop").get<int>();
    manifest.frameCount = object.at("frames").get<std::int64_t>();
    manifest.first = object.at("first").get<std::int64_t>();
    manifest.end = object.at("end").get<std::int64_t>();
    manifest.checksum = object.at("checksum").get<std::string>();
    for (const auto& [frame, state] : object.at("states").items())
    {
        manifest.states[std::stoll(frame)] = state.get<std::string>();
    }
    return manifest;
}

/// True if the numbers can be those of a film.
bool IsSound(const Manifest& manifest)
{
    const Rational& rate = manifest.framesPerSecond;
    return rate.num >= 1 && rate.den >= 1 && manifest.groupFrames >= 1 && manifest.plays >= 0 &&
           manifest.first >= 0 && manifest.end > manifest.first &&
           manifest.frameCount >= manifest.end;
}

/// The checksum of files behind each other.
class FileSum
{
public:
    /// False if the file is not readable.
    bool Add(const std::filesystem::path& path)
    {
        std::error_code ignored;
        std::ifstream file(path, std::ios::binary);
        if (!std::filesystem::is_regular_file(path, ignored))
        {
            return false;
        }
        while (file)
        {
            file.read(m_buffer.data(), std::streamsize(m_buffer.size()));
            const std::size_t count = std::size_t(file.gcount());
            m_checksum = ChecksumOf({reinterpret_cast<const std::uint8_t*>(m_buffer.data()), count},
                                    m_checksum);
            m_size += count;
        }
        return file.eof() && !file.bad();
    }

    std::string Text() const
    {
        return HexText(m_checksum) + " of " + std::to_string(m_size) + " bytes";
    }

private:
    std::vector<char> m_buffer = std::vector<char>(std::size_t(1) << 20);
    std::uint64_t m_checksum = ChecksumOf(std::span<const std::uint8_t>());
    std::uint64_t m_size = 0;
};

} // namespace

std::filesystem::path ManifestPath(const std::filesystem::path& film)
{
    std::filesystem::path path = film;
    path += ".json";
    return path;
}

Result<void> WriteManifest(const std::filesystem::path& film, const Manifest& manifest)
{
    return WriteWhole(ManifestPath(film), ToJson(manifest).dump(1) + "\n", true);
}

Result<Manifest> ReadManifest(const std::filesystem::path& film, const std::string& remedy)
{
    const std::filesystem::path path = ManifestPath(film);
    const Result<std::string> text = ReadWhole(path, kLargestManifest);
    if (!text)
    {
        return Error{ErrorKind::Unusable, path.string(),
                     "the manifest of " + film.string() + " cannot be read", remedy};
    }
    try
    {
        Manifest manifest = FromJson(json::parse(*text));
        if (IsSound(manifest))
        {
            return manifest;
        }
    }
    catch (const std::exception&)
    {
        // Reported below, with other faults.
    }
    return Error{ErrorKind::Unusable, path.string(), "is damaged or of another version of boxreel",
                 remedy};
}

std::string WriterOfManifest(const std::filesystem::path& film)
{
    const Result<std::string> text = ReadWhole(ManifestPath(film), kLargestManifest);
    const json object = json::parse(text ? *text : std::string(), nullptr, false);
    const bool isOurs = object.is_object() && object.contains("boxreel") &&
                        object["boxreel"].is_string() && object.contains("command");
    return isOurs ? object["boxreel"].get<std::string>() : "";
}

std::string ChecksumOfFrames(const std::filesystem::path& film, std::int64_t first,
                             std::int64_t end)
{
    FileSum sum;
    for (std::int64_t number = first; number < end; ++number)
    {
        const std::filesystem::path file = FileOfFrame(film, number);
        if (number > first && file == film)
        {
            break; // all frames are in one
        }
        if (!sum.Add(file))
        {
            return "";
        }
    }
    return sum.Text();
}

std::vector<std::string> CommandOfFilm(const std::vector<std::string>& arguments)
{
    std::vector<std::string> command;
    for (std::size_t i = 0; i < arguments.size(); ++i)
    {
        const Exempt* exempt = ExemptionOf(arguments[i]);
        if (exempt == nullptr)
        {
            command.push_back(arguments[i]);
        }
        else if (exempt->hasValue && arguments[i].find('=') == std::string::npos &&
                 !IsAttachedOutput(arguments[i]))
        {
            ++i; // its value
        }
    }
    return command;
}

std::string DifferenceOf(const Manifest& a, const Manifest& b)
{
    if (a.command != b.command)
    {
        return "the commands differ: `" + JoinedBy(" ", a.command) + "` and `" +
               JoinedBy(" ", b.command) + "`";
    }
    if (a.version != b.version)
    {
        return "versions " + a.version + " and " + b.version + " of boxreel made them";
    }
    return "";
}

} // namespace boxreel
