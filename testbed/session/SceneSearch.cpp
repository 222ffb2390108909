// SPDX-License-Identifier: MIT
#include "SceneSearch.h"

#include <base/ErrorMacros.h>
#include <base/Nearest.h>
#include <base/Quoting.h>
#include <rube/RubeFile.h>

#include <filesystem>

namespace boxreel
{
namespace
{

bool IsLetterOrDigit(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

/// Plain ASCII, so that no locale changes what a name matches.
char Lower(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

Error UnknownScene(std::string_view name)
{
    std::vector<std::string> keys;
    for (const SceneEntry& entry : AllScenes())
    {
        keys.push_back(SceneKey(entry.name));
    }
    const int nearest = NearestWord(SceneKey(name), keys);
    const std::string remedy =
        nearest < 0 ? "`boxreel list` shows all"
                    : "did you mean '" +
                          SceneSlug(AllScenes()[static_cast<std::size_t>(nearest)].name) + "'?";
    return Error{ErrorKind::Unusable, Quoted(name), "unknown scene", remedy};
}

const SceneEntry* SceneOfKey(const std::string& key)
{
    for (const SceneEntry& entry : AllScenes())
    {
        if (SceneKey(entry.name) == key)
        {
            return &entry;
        }
    }
    return nullptr;
}

Result<SceneSource> OpenFile(const std::filesystem::path& file)
{
    SceneSource source;
    ASSIGN_OR_RETURN(std::unique_ptr<Scene> scene, LoadRubeScene(file, source.leftOut));
    source.scene = std::move(scene);
    source.asked = file.string();
    source.title = file.stem().string();
    return source;
}

} // namespace

std::string SceneKey(std::string_view name)
{
    std::string key;
    for (const char c : name)
    {
        if (IsLetterOrDigit(Lower(c)))
        {
            key += Lower(c);
        }
    }
    return key;
}

std::string SceneSlug(std::string_view name)
{
    std::string slug;
    for (const char c : name)
    {
        if (IsLetterOrDigit(Lower(c)))
        {
            slug += Lower(c);
        }
        else if (c != '\'' && !slug.empty() && slug.back() != '-')
        {
            slug += '-';
        }
    }
    while (!slug.empty() && slug.back() == '-')
    {
        slug.pop_back();
    }
    return slug;
}

Result<const SceneEntry*> FindScene(std::string_view name)
{
    if (const SceneEntry* entry = SceneOfKey(SceneKey(name)))
    {
        return entry;
    }
    return UnknownScene(name);
}

Result<SceneSource> OpenScene(const std::string& nameOrFile)
{
    const bool isNamedAsFile = nameOrFile.ends_with(".json");
    const SceneEntry* entry = isNamedAsFile ? nullptr : SceneOfKey(SceneKey(nameOrFile));
    if (entry != nullptr)
    {
        SceneSource source;
        source.entry = entry;
        source.asked = entry->name;
        source.title = entry->name;
        return source;
    }
    std::error_code ignored;
    if (isNamedAsFile || std::filesystem::is_regular_file(nameOrFile, ignored))
    {
        return OpenFile(nameOrFile);
    }
    return UnknownScene(nameOrFile);
}

} // namespace boxreel
