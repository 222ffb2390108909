// SPDX-License-Identifier: MIT
#include <base/Words.h>

#include <gtest/gtest.h>

namespace boxreel
{
namespace
{

TEST(FilledTemplate, ReplacesEachWordOnceAndNotInParts)
{
    EXPECT_EQ(FilledTemplate("{{a}} and {{b}}, {{a}}", {{"a", "{{b}}"}, {"b", "two"}}),
              "{{b}} and two, {{b}}");
    EXPECT_EQ(FilledTemplate("an open {{a", {}), "an open ");
    EXPECT_EQ(FilledTemplate("", {}), "");
}

} // namespace
} // namespace boxreel
