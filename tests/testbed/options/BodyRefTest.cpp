// SPDX-License-Identifier: MIT
#include <options/BodyRef.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

const std::map<std::uint32_t, std::string> kNames{{1, "ball"}, {4, "ball"}, {7, "left wheel"}};

std::string Refusal(BodyRef body, const std::map<std::uint32_t, std::string>& names)
{
    const Result<void> found = FindNames("--trail", {&body}, names);
    return found ? "found" : found.GetError().culprit;
}

TEST(BodyRef, BecomesTheNumberOfItsName)
{
    BodyRef wheel("left wheel");
    BodyRef third(3);
    ASSERT_TRUE(FindNames("--trail", {&wheel, &third}, kNames));
    EXPECT_EQ(wheel, BodyRef(7));
    EXPECT_EQ(third, BodyRef(3)) << "numbers need no name";
}

TEST(BodyRef, IsRefusedForNameOfSeveralBodies)
{
    EXPECT_EQ(Refusal(BodyRef("ball"), kNames), "--trail ball");
}

TEST(BodyRef, IsRefusedForUnknownName)
{
    EXPECT_EQ(Refusal(BodyRef("left wheal"), kNames), "--trail 'left wheal'");
    EXPECT_EQ(Refusal(BodyRef("ball"), {}), "--trail ball");
}

} // namespace
} // namespace boxreel
