// SPDX-License-Identifier: MIT
#include "../../base/Errors.h"
#include "../../base/TemporaryFolder.h"

#include <session/SceneSearch.h>

#include <gmock/gmock.h>

#include <filesystem>
#include <set>

namespace boxreel
{
namespace
{

using testing::HasSubstr;

TEST(SceneSearch, IgnoresCaseSpacesAndPunctuation)
{
    for (const char* name :
         {"Newton's Cradle", "newtons-cradle", "NEWTONSCRADLE", "newtons_cradle", "Newtons Cradle"})
    {
        const Result<const SceneEntry*> found = FindScene(name);
        ASSERT_TRUE(found) << name;
        EXPECT_STREQ((*found)->name, "Newton's Cradle");
    }
}

TEST(SceneSearch, FindsEverySceneByItsNameAndByItsSlug)
{
    std::set<std::string> slugs;
    for (const SceneEntry& entry : AllScenes())
    {
        const Result<const SceneEntry*> byName = FindScene(entry.name);
        const Result<const SceneEntry*> bySlug = FindScene(SceneSlug(entry.name));
        ASSERT_TRUE(byName && bySlug) << entry.name;
        EXPECT_EQ(*byName, &entry);
        EXPECT_EQ(*bySlug, &entry);
        EXPECT_TRUE(slugs.insert(SceneSlug(entry.name)).second)
            << entry.name << " is not the only one";
    }
}

TEST(SceneSearch, MakesSlugsForFileNames)
{
    EXPECT_EQ(SceneSlug("Newton's Cradle"), "newtons-cradle");
    EXPECT_EQ(SceneSlug("Vertical Stack"), "vertical-stack");
    EXPECT_EQ(SceneSlug("One-Sided Platform"), "one-sided-platform");
    EXPECT_EQ(SceneSlug("Heavy 1/2"), "heavy-1-2");
    EXPECT_EQ(SceneSlug(" Ball & Chain! "), "ball-chain");
}

TEST(SceneSearch, SuggestsNearestForUnknownName)
{
    const Result<const SceneEntry*> found = FindScene("pyrmid");
    ASSERT_FALSE(found);
    EXPECT_EQ(found.GetError().kind, ErrorKind::Unusable);
    EXPECT_EQ(found.GetError().culprit, "'pyrmid'");
    EXPECT_THAT(found.GetError().remedy, HasSubstr("pyramid"));
}

TEST(SceneSearch, SuggestsListForNameLikeNoOther)
{
    for (const char* name : {"xylophone", "", "--", "\xff\xfe"})
    {
        const Result<const SceneEntry*> found = FindScene(name);
        ASSERT_FALSE(found) << name;
        EXPECT_EQ(found.GetError().culprit, "'" + std::string(name) + "'");
        EXPECT_THAT(found.GetError().remedy, HasSubstr("boxreel list"));
    }
}

TEST(SceneSearch, ReportsMissingFile)
{
    const Result<SceneSource> source = OpenScene("no-such-file.json");
    EXPECT_THAT(source, Refuses("no-such-file.json"));
}

TEST(SceneSearch, ReadsExistingFileOfAnyNameAsScene)
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "foreign.rube";
    WriteBytes(file, "not a scene");
    EXPECT_THAT(OpenScene(file.string()), Refuses(file.string() + ":1:2"));
}

} // namespace
} // namespace boxreel
