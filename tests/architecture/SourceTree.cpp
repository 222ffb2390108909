// SPDX-License-Identifier: MIT
#include "SourceTree.h"

#include "TreeText.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace fs = std::filesystem;

namespace architecture
{
namespace
{

struct Layer
{
    std::string_view name;
    std::vector<std::string_view> mayUse; ///< the names of other layers; each may use itself
};

constexpr std::array<std::string_view, 11> kEngineRooms{
    "engine/src/Dynamics/State",  "engine/src/Dynamics/Islands",  "engine/src/Dynamics/Contacts",
    "engine/src/Dynamics/Joints", "engine/src/Dynamics/Solver",   "engine/src/Dynamics/Direct",
    "engine/src/Dynamics/Energy", "engine/src/Dynamics/SubSteps", "engine/src/Dynamics/Continuous",
    "engine/src/Dynamics/World",  "engine/src/Dynamics/Snapshot"};

/// The arrows of ARCHITECTURE.md. All other dependencies are forbidden.
std::vector<Layer> MakeLayers()
{
    std::vector<Layer> layers{
        {"engine/Common", {}},
        {"engine/Collision", {"engine/Common"}},
        // The public headers of Dynamics. Private ones are in rooms, below.
        {"engine/Dynamics", {"engine/Common", "engine/Collision"}},
        {"engine/Rope", {"engine/Common"}},
        {"engine", {"engine/Common", "engine/Collision", "engine/Dynamics", "engine/Rope"}},
        {"base", {}},
        {"drawlist", {"base"}},
        {"collector", {"drawlist", "base", "engine"}},
        {"page", {"drawlist", "base"}},
        {"render", {"drawlist", "base"}},
        {"recorder", {"render", "drawlist", "base"}},
        {"golden", {"recorder", "render", "drawlist", "base"}},
        {"golden state", {"golden", "drawlist", "base", "engine"}},
        {"golden world",
         {"golden state", "golden", "recorder", "render", "collector", "drawlist", "base",
          "engine"}},
        {"testbed/scenes", {"engine"}},
        {"testbed/rube", {"testbed/scenes", "drawlist", "base", "engine"}},
        {"python",
         {"testbed/rube", "testbed/scenes", "golden world", "golden state", "golden", "recorder",
          "page", "render", "collector", "drawlist", "base", "engine"}},
    };
    // The rooms of engine/src/Dynamics: each may use those before it.
    std::vector<std::string_view> engine{"engine/Common", "engine/Collision", "engine/Dynamics"};
    for (const std::string_view room : kEngineRooms)
    {
        layers.push_back({room, engine});
        engine.push_back(room);
    }
    // The other rooms of the program: each may use the libraries and the rooms before it.
    const std::vector<std::string_view> libraries{
        "golden world", "golden state", "golden",   "recorder", "render",
        "page",         "collector",    "drawlist", "base",     "engine"};
    std::vector<std::string_view> below = libraries;
    below.insert(below.end(), {"testbed/scenes", "testbed/rube"});
    for (const std::string_view room :
         {"testbed/options", "testbed/script", "testbed/ui", "testbed/session", "testbed/film",
          "testbed/workbench", "testbed/cli", "tests"})
    {
        layers.push_back({room, below});
        below.push_back(room);
    }
    layers.push_back({"docs", libraries}); // the programs that the pages show use the libraries
    std::vector<std::string_view>& ofTests =
        std::ranges::find(layers, "tests", &Layer::name)->mayUse;
    ofTests.insert(ofTests.end(), kEngineRooms.begin(), kEngineRooms.end());
    for (Layer& layer : layers) // whoever may use the engine's front may use its modules
    {
        if (std::ranges::count(layer.mayUse, "engine") > 0)
        {
            layer.mayUse.insert(layer.mayUse.end(),
                                {"engine/Common", "engine/Collision", "engine/Dynamics"});
        }
    }
    return layers;
}

const std::vector<Layer>& Layers()
{
    static const std::vector<Layer> layers = MakeLayers();
    return layers;
}

struct ForeignLibrary
{
    std::string_view header;             ///< how its includes begin
    std::vector<std::string_view> homes; ///< how the paths begin that may include it
};

// A foreign library lives in one file, or in one family of files.
const std::vector<ForeignLibrary>& ForeignLibraries()
{
    static const std::vector<ForeignLibrary> libraries{
        {"png.h", {"render/src/Png."}},
        {"zlib.h", {"base/src/Gzip."}},
        {"GL/", {"render/src/Context", "render/src/Gl"}},
        {"EGL/", {"render/src/Context", "render/src/Gl"}},
        {"GLES", {"render/src/Context", "render/src/Gl"}},
        {"GLFW/", {"render/src/WindowGlfw."}},
        {"libav", {"recorder/src/FFmpeg"}},
        {"libsw", {"recorder/src/FFmpeg"}},
        {"webp/", {"recorder/src/WebP"}},
        {"imgui",
         {"render/src/ImGui", "render/src/FontAtlas", "testbed/ui/", "tests/render/ImGui"}},
        {"stb", {"render/src/FontAtlas"}},
        {"CLI/", {"testbed/cli/Parser."}},
        {"nlohmann/",
         {"golden/src/VerdictFile.", "golden/src/report/Verdicts.", "testbed/rube/",
          "testbed/film/Manifest", "testbed/film/Progress.", "testbed/ui/UiSettings"}},
        {"cairo", {"render/src/FigureCairo."}},
        {"ft2build.h", {"render/src/FigureCairo."}},
        {"freetype", {"render/src/FigureCairo."}},
        {"pybind11/", {"python/src/"}},
        {"chipmunk/", {"tests/benchmark/"}},
        {"box2d/",
         {"debugdraw/include/debugdraw/Box2d24Draw.", "docs/examples/box2d24",
          "docs/examples/porting/before/", "tests/benchmark/", "tests/debugdraw/Box2d24Draw",
          "tests/engine/Header24Test.", "tests/consumer/engine/"}},
        // For tests of other projects; the manual's listings test themselves.
        {"gtest/", {"golden/include/golden/GoldenTest.", "docs/manual/listings/"}},
        {"gmock/", {"docs/manual/listings/"}},
    };
    return libraries;
}

// Headers of the system and the compiler. The engine may use only those of the second line.
constexpr std::array<std::string_view, 12> kSystemHeaders{
    "sys/",      "unistd.h",  "fcntl.h", "signal.h", "spawn.h", "dlfcn.h",
    "pthread.h", "termios.h", "poll.h",  "sched.h",  "errno.h", "malloc.h"};
constexpr std::array<std::string_view, 5> kSimdHeaders{"immintrin.h", "emmintrin.h", "xmmintrin.h",
                                                       "smmintrin.h", "arm_neon.h"};

bool StartsWithAny(std::string_view text, const auto& beginnings)
{
    return std::ranges::any_of(beginnings, [&](std::string_view b) { return text.starts_with(b); });
}

/// The manual's three modules and the rope beside them, from the path below include/Box2D/ or src/.
std::string_view EngineLayer(std::string_view below)
{
    for (std::string_view module :
         {"engine/Common", "engine/Collision", "engine/Dynamics", "engine/Rope"})
    {
        const std::string_view folder = module.substr(std::string_view("engine/").size());
        if (below.starts_with(folder) && below.substr(folder.size()).starts_with('/'))
        {
            return module;
        }
    }
    // Only the header that includes all others is outside the modules.
    return below == "Box2D.h" ? "engine" : "";
}

/// The layer a file belongs to; empty if none.
std::string_view LayerOf(std::string_view path)
{
    const std::string_view file = path.substr(path.rfind('/') + 1);
    for (const std::string_view room : kEngineRooms)
    {
        if (path.starts_with(room) && path.substr(room.size()).starts_with('/'))
        {
            return room;
        }
    }
    if (path.starts_with("engine/src/Dynamics/"))
    {
        return "";
    }
    for (std::string_view folder : {"engine/include/Box2D/", "engine/src/"})
    {
        if (path.starts_with(folder))
        {
            return EngineLayer(path.substr(folder.size()));
        }
    }
    if (path == "engine/include-2.4/box2d/box2d.h")
    {
        return "engine";
    }
    if (path.starts_with("debugdraw/"))
    {
        const bool knowsTheEngine = file.starts_with("DrawCollector") || file.starts_with("World");
        return knowsTheEngine ? "collector" : "drawlist";
    }
    if (path.starts_with("golden/"))
    {
        const bool takesWorlds =
            file.starts_with("GoldenTest.") || file.starts_with("GoldenWorld.");
        return takesWorlds                     ? "golden world"
               : file.starts_with("StateHash") ? "golden state"
                                               : "golden";
    }
    if (path.starts_with("testbed/"))
    {
        const std::string_view room = path.substr(0, path.find('/', sizeof "testbed"));
        const auto known = std::ranges::find(Layers(), room, &Layer::name);
        return known == Layers().end() ? "" : known->name;
    }
    for (std::string_view folder :
         {"base", "page", "render", "recorder", "python", "docs", "tests"})
    {
        if (path.starts_with(folder) && path.substr(folder.size()).starts_with('/'))
        {
            return folder;
        }
    }
    return "";
}

bool MayUse(std::string_view user, std::string_view used)
{
    if (user == used)
    {
        return true;
    }
    const auto layer = std::ranges::find(Layers(), user, &Layer::name);
    return layer != Layers().end() && std::ranges::find(layer->mayUse, used) != layer->mayUse.end();
}

struct Include
{
    std::size_t line = 0;
    std::string text; ///< between the brackets or quotes
};

std::optional<std::string> IncludedText(std::string_view line)
{
    const auto skipSpace = [&] {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    };
    skipSpace();
    if (!line.starts_with('#'))
    {
        return std::nullopt;
    }
    line.remove_prefix(1);
    skipSpace();
    if (!line.starts_with("include"))
    {
        return std::nullopt;
    }
    const std::size_t open = line.find_first_of("<\"");
    if (open == std::string_view::npos)
    {
        return std::nullopt;
    }
    const std::size_t close = line.find_first_of(">\"", open + 1);
    return std::string(line.substr(open + 1, close - open - 1));
}

std::vector<Include> IncludesOf(const fs::path& file)
{
    std::vector<Include> includes;
    const std::vector<std::string> lines = ReadLines(file);
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
        if (auto text = IncludedText(lines[i]))
        {
            includes.push_back({i + 1, *text});
        }
    }
    return includes;
}

/// The file of ours that an include names: beside the including file, or on one of the include
/// paths our targets have. Empty for the standard library and foreign headers. The file need not
/// exist when its first folder already says whose it would be.
std::string Resolve(const fs::path& root, const std::string& from, const std::string& text)
{
    static const std::vector<std::string> searched{"engine/include",    "base/include",
                                                   "debugdraw/include", "page/include",
                                                   "render/include",    "recorder/include",
                                                   "golden/include",    ".",
                                                   "testbed",           "tests"};
    const fs::path module = *fs::path(from).begin();
    std::vector<fs::path> candidates{fs::path(from).parent_path() / text, module / "src" / text,
                                     module / "include" / text, module / text};
    for (const std::string& folder : searched)
    {
        candidates.push_back(fs::path(folder) / text);
    }
    for (const fs::path& candidate : candidates)
    {
        const fs::path normal = candidate.lexically_normal();
        if (fs::is_regular_file(root / normal))
        {
            return normal.generic_string();
        }
    }
    for (const std::string_view folder :
         {"Box2D", "base", "debugdraw", "page", "render", "recorder", "golden"})
    {
        if (text.starts_with(folder) && text.substr(folder.size()).starts_with('/'))
        {
            const std::string owner = folder == "Box2D" ? "engine" : std::string(folder);
            return owner + "/include/" + text;
        }
    }
    return text.starts_with("tests/") ? text : "";
}

} // namespace

Findings CheckLayers(const fs::path& root)
{
    Findings findings;
    for (const std::string& path : FilesBelow(root))
    {
        if (!IsCpp(path))
        {
            continue;
        }
        const std::string_view user = LayerOf(path);
        if (user.empty())
        {
            findings.push_back(At(path, 1) +
                               "lies in no layer; see ARCHITECTURE.md for where it belongs");
            continue;
        }
        for (const Include& include : IncludesOf(root / path))
        {
            const std::string target = Resolve(root, path, include.text);
            if (!target.empty() && !MayUse(user, LayerOf(target)))
            {
                findings.push_back(At(path, include.line) + std::string(user) +
                                   " must not include " + include.text + " of " +
                                   std::string(LayerOf(target)));
            }
        }
    }
    return findings;
}

namespace
{

/// Why this include is not allowed, or empty.
std::string ForeignComplaint(const std::string& path, const std::string& header)
{
    const auto& libraries = ForeignLibraries();
    const auto library = std::ranges::find_if(
        libraries, [&](const ForeignLibrary& known) { return header.starts_with(known.header); });
    if (library != libraries.end())
    {
        return StartsWithAny(path, library->homes)
                   ? ""
                   : header + " is wrapped elsewhere; use the wrapper (see ARCHITECTURE.md)";
    }
    if (header.find('.') == std::string::npos || StartsWithAny(header, kSimdHeaders))
    {
        return ""; // the standard library, the compiler
    }
    if (path.starts_with("engine/"))
    {
        return header + " is not of the C++ standard library, and the engine uses nothing else";
    }
    return StartsWithAny(header, kSystemHeaders)
               ? ""
               : header + " belongs to no known library; give it one home in "
                          "tests/architecture/SourceTree.cpp";
}

} // namespace

Findings CheckForeignLibraries(const fs::path& root)
{
    Findings findings;
    for (const std::string& path : FilesBelow(root))
    {
        if (!IsCpp(path) || path.starts_with("tests/"))
        {
            continue;
        }
        for (const Include& include : IncludesOf(root / path))
        {
            if (!Resolve(root, path, include.text).empty())
            {
                continue;
            }
            if (const std::string complaint = ForeignComplaint(path, include.text);
                !complaint.empty())
            {
                findings.push_back(At(path, include.line) + complaint);
            }
        }
    }
    return findings;
}

} // namespace architecture
