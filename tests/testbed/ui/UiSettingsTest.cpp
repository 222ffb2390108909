// SPDX-License-Identifier: MIT
#include "../../base/Errors.h"
#include "../cli/Subprocess.h"

#include <ui/UiSettings.h>

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

namespace boxreel
{
namespace
{

class UiSettingsTest : public testing::Test
{
protected:
    void Write(const std::string& text) const { std::ofstream(File()) << text; }
    std::filesystem::path File() const { return folder / "ui.json"; }

    TemporaryFolder folder;
};

TEST_F(UiSettingsTest, AreTheDefaultsWithoutFile)
{
    const Result<UiSettings> settings = ReadUiSettings(File());
    ASSERT_TRUE(settings);
    EXPECT_EQ(*settings, UiSettings());
}

TEST_F(UiSettingsTest, AreReadAsTheyWereWritten)
{
    UiSettings settings;
    settings.width = 1600;
    settings.height = 901;
    settings.scene = "folder/my \"scene\" é.json";
    settings.openSections = {"Keys", "Solver"};
    PanelChoices& choices = settings.choices;
    choices.showsPanels = false;
    choices.keepsSolver = true;
    choices.solver = {11, 7, 4, 120, false, false, false, true};
    for (const LayerInfo& layer : kOptionalLayers)
    {
        choices.layers[layer.layer] = !choices.layers[layer.layer];
    }
    choices.labels = true;
    choices.statistics = false;
    choices.profile = false;
    choices.theme = "okabe-ito";
    choices.filmsPanels = true;
    const std::filesystem::path file = folder / "new" / "folders" / "ui.json";
    ASSERT_TRUE(WriteUiSettings(file, settings));
    ASSERT_TRUE(WriteUiSettings(file, settings)) << "over the old ones";
    const Result<UiSettings> read = ReadUiSettings(file);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, settings);
}

TEST_F(UiSettingsTest, KeepValidEntriesOfInvalidFile)
{
    Write(R"({"width": -5, "height": 1e9, "scene": 7, "sub-steps": 1000, "theme": "pink",
              "sleep": "no", "hertz": 30, "unknown": [1]})");
    const Result<UiSettings> settings = ReadUiSettings(File());
    ASSERT_TRUE(settings);
    EXPECT_EQ(settings->width, 320);
    EXPECT_EQ(settings->height, 8192);
    EXPECT_EQ(settings->scene, "Pyramid");
    EXPECT_EQ(settings->choices.solver.subSteps, 64);
    EXPECT_EQ(settings->choices.solver.hertz, 30);
    EXPECT_TRUE(settings->choices.solver.sleep);
    EXPECT_EQ(settings->choices.theme, "classic");
}

TEST_F(UiSettingsTest, AreRefusedWithoutValidJson)
{
    for (const std::string& text :
         {std::string("{"), std::string("[1, 2]"), std::string(2'000'000, ' ')})
    {
        Write(text);
        EXPECT_THAT(ReadUiSettings(File()), Fails(testing::_, File().string()));
    }
    EXPECT_FALSE(ReadUiSettings(folder.Path()));
}

TEST_F(UiSettingsTest, ReportFileThatCannotBeWritten)
{
    Write("");
    const Result<void> written = WriteUiSettings(File() / "ui.json", UiSettings());
    ASSERT_FALSE(written);
    EXPECT_EQ(written.GetError().culprit, File().string());
}

TEST(UiSettingsPath, IsBelowTheFolderForSettings)
{
    const char* const home = std::getenv("HOME");
    const std::string before = home != nullptr ? home : "";
    setenv("HOME", "/people/somebody", 1);
    unsetenv("XDG_CONFIG_HOME");
    EXPECT_EQ(UiSettingsPath(), "/people/somebody/.config/boxreel/ui.json");
    setenv("XDG_CONFIG_HOME", "relative", 1);
    EXPECT_EQ(UiSettingsPath(), "/people/somebody/.config/boxreel/ui.json");
    setenv("XDG_CONFIG_HOME", "/etc/mine", 1);
    EXPECT_EQ(UiSettingsPath(), "/etc/mine/boxreel/ui.json");
    unsetenv("XDG_CONFIG_HOME");
    unsetenv("HOME");
    EXPECT_EQ(UiSettingsPath(), "");
    setenv("HOME", before.c_str(), 1);
}

} // namespace
} // namespace boxreel
