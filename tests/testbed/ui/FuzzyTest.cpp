// SPDX-License-Identifier: MIT
#include <ui/Fuzzy.h>

#include <scenes/Scene.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

using testing::ElementsAre;

std::vector<std::string> Found(std::string_view query, const std::vector<std::string_view>& names)
{
    std::vector<std::string> found;
    for (const std::size_t place : FindFuzzily(query, names))
    {
        found.emplace_back(names[place]);
    }
    return found;
}

TEST(Fuzzy, FindsNamesByTheBeginningsOfTheirWords)
{
    EXPECT_THAT(Found("mp", {"Ramp", "Many Pyramids", "Pyramid"}),
                ElementsAre("Many Pyramids", "Ramp"));
    EXPECT_THAT(Found("npyr", {"Pyramid", "Many Pyramids"}), ElementsAre("Many Pyramids"));
    EXPECT_THAT(Found("sst", {"Sensor Test", "SphereStack"}),
                ElementsAre("SphereStack", "Sensor Test"));
}

TEST(Fuzzy, PrefersAdjacentLettersAndShorterNames)
{
    EXPECT_THAT(Found("pyr", {"Apply Force", "Far Pyramid", "Pyramid"}),
                ElementsAre("Pyramid", "Far Pyramid", "Apply Force"));
}

TEST(Fuzzy, IgnoresCaseBlanksAndPunctuation)
{
    EXPECT_THAT(Found("NEWTONS-c", {"Newton's Cradle", "Car"}), ElementsAre("Newton's Cradle"));
}

TEST(Fuzzy, FindsNothingWhenALetterIsMissingOrInAnotherPlace)
{
    EXPECT_FALSE(MatchFuzzily("rac", "Car"));
    EXPECT_FALSE(MatchFuzzily("carr", "Car"));
    EXPECT_FALSE(MatchFuzzily("a", ""));
}

TEST(Fuzzy, KeepsOrderOfAllNamesWithoutLetters)
{
    EXPECT_THAT(Found(" -", {"Web", "Arch"}), ElementsAre("Web", "Arch"));
}

TEST(Fuzzy, ReportsMatchedLetters)
{
    EXPECT_THAT(MatchFuzzily("cb", "Conveyor Belt")->letters, ElementsAre(0u, 9u));
    EXPECT_THAT(MatchFuzzily("conbe", "Conveyor Belt")->letters, ElementsAre(0u, 1u, 2u, 9u, 10u));
}

TEST(Fuzzy, FindsEverySceneFirstByItsOwnName)
{
    std::vector<std::string_view> names;
    for (const SceneEntry& entry : AllScenes())
    {
        names.emplace_back(entry.name);
    }
    for (const std::string_view name : names)
    {
        EXPECT_EQ(Found(name, names).front(), name);
    }
}

} // namespace
} // namespace boxreel
