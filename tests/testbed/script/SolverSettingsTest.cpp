// SPDX-License-Identifier: MIT
#include <script/SolverSettings.h>
#include <session/SessionPanels.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

using testing::ElementsAre;
using testing::Pair;

TEST(SolverSettings, AreReadAsTheyWereApplied)
{
    for (const SolverSetting& setting : SolverSettings())
    {
        SCOPED_TRACE(setting.name);
        Result<SceneSession> session = OpenSession(*OpenScene("pyramid"), SceneLook());
        ASSERT_TRUE(session);
        const SolverChoices before = SolverOf(*session);
        const int value = setting.get(session->World(), session->Steps());
        const int other = setting.maximum == 1 ? 1 - value : value + 1;
        const std::string text = SettingText(setting.name, other);
        ApplySetting(setting.name, *ParseSetting(setting.name, text), session->World(),
                     session->Steps());
        const SolverChoices after = SolverOf(*session);
        EXPECT_THAT(Differences(before, after), ElementsAre(Pair(setting.name, text)));
        ApplySettings(before, session->World(), session->Steps());
        EXPECT_EQ(SolverOf(*session), before);
    }
}

TEST(SolverSettings, HaveNumbersUpToTheirMaximum)
{
    for (const SolverSetting& setting : SolverSettings())
    {
        SCOPED_TRACE(setting.name);
        const bool isFlag = std::holds_alternative<bool SolverChoices::*>(setting.member);
        EXPECT_EQ(bool(ParseSetting(setting.name, std::to_string(setting.maximum))), !isFlag);
        EXPECT_FALSE(ParseSetting(setting.name, std::to_string(setting.maximum + 1)));
        EXPECT_LE(setting.sliderMaximum, setting.maximum);
    }
}

} // namespace
} // namespace boxreel
