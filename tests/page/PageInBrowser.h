// SPDX-License-Identifier: MIT
#pragma once

#include "Base64.h"
#include "Browser.h"

#include <Box2D/Dynamics/b2Body.h>
#include <base/ErrorMacros.h>
#include <debugdraw/WorldGlyphs.h>
#include <page/PageWriter.h>
#include <session/SessionPanels.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

/// Pages of scenes in Chromium.
namespace boxreel
{

// As the page shows a resting picture on a screen of one pixel per CSS pixel.
inline constexpr const char* kDrawScript = R"(
function drawExactly(player, frame, view, hidden) {
  return drawBy(player.exactPainter, frame, view, hidden);
}
function drawDense(player, frame) { // on a screen of two pixels per CSS pixel
  const {x, y, scale} = player.film.viewOf(frame);
  return drawBy(player.exactPainter, frame, {x, y, scale: 2 * scale}, new Set(), 2);
}
function drawPlaying(player, frame) {
  return drawBy(player.painter, frame);
}
function drawBy(painter, frame, view = painter.film.viewOf(frame), hidden = new Set(), ratio = 1) {
  const {film} = painter;
  const picture = document.createElement("canvas");
  picture.width = ratio * film.width;
  picture.height = ratio * film.height;
  painter.draw(picture, frame, {view, ratio, theme: film.themes[0], hidden});
  return picture.toDataURL().split(",")[1];
}
function leave(text) {
  const results = document.createElement("pre");
  results.textContent = `\nBEGIN\n${text}\nEND\n`;
  document.body.append(results);
}
)";

class PageInBrowser : public testing::Test
{
protected:
    void SetUp() override
    {
        if (browser.empty())
        {
            GTEST_SKIP() << "Chromium is not installed; install it with: apt install chromium";
        }
    }

    /// Opens a scene as `record` does for a page that zooms so far, or as `shot` does for 1.
    static Result<SceneSession> Open(const std::string& scene, const std::string& layers,
                                     double zoom)
    {
        SceneLook look;
        look.collectEverything = zoom > 1.0;
        look.zoom = zoom;
        look.layers = *ParseLayers("--draw", layers);
        Result<SceneSource> source = OpenScene(scene);
        return OpenSession(std::move(*source), look);
    }

    /// Writes a page of the scene, up to a step, and keeps the lists that `shot` draws of that.
    std::string PageOf(const std::string& scene, const std::string& layers, int lastFrame,
                       const Theme& theme = Theme::Classic())
    {
        Result<SceneSession> session = Open(scene, layers, kPageZoom);
        Result<SceneSession> shot = Open(scene, layers, 1.0);
        EXPECT_TRUE(session && shot);
        const std::filesystem::path path = folder / (scene + ".html");
        PageSettings settings;
        settings.overwrite = true;
        settings.theme = theme;
        Result<PageWriter> writer = PageWriter::Open(path, settings);
        EXPECT_TRUE(writer);
        for (int frame = 0; frame <= lastFrame; ++frame)
        {
            session->AdvanceTo(frame);
            FrameContent filmed;
            session->Fill(filmed);
            std::vector<PageBody> bodies;
            for (const b2Body* b = session->World().GetBodyList(); b != nullptr; b = b->GetNext())
            {
                bodies.push_back({std::uint32_t(b->GetNumber()),
                                  {b->GetPosition().x, b->GetPosition().y},
                                  b->GetAngle(),
                                  "body " + std::to_string(b->GetNumber()),
                                  {b->GetLinearVelocity().x, b->GetLinearVelocity().y},
                                  b->GetAngularVelocity()});
            }
            last = bodies;
            EXPECT_TRUE(writer->Append(
                filmed.list, filmed.camera, bodies,
                JointGlyphAnchors(session->World(), ViewOfEverything(filmed.camera), kPageZoom)));
            shot->AdvanceTo(frame);
            content = {};
            shot->Fill(content);
        }
        zoomed = Nearer(*shot);
        EXPECT_TRUE(writer->Close());
        return ReadBytes(path);
    }

    /// The same moment, nearer and aside.
    FrameContent Nearer(SceneSession& shot) const
    {
        FrameContent nearer;
        shot.LookAt({float(content.camera.centerX) + 1.53f, float(content.camera.centerY) + 0.57f},
                    3.0 * content.camera.pixelsPerMeter);
        shot.Fill(nearer);
        return nearer;
    }

    std::string Run(const std::string& page, const std::string& script)
    {
        const Outcome outcome = LoadInChromium(browser, page, kDrawScript + script, folder);
        EXPECT_THAT(outcome.errors, testing::Not(testing::HasSubstr("CONSOLE")));
        return ResultsOf(outcome);
    }

    const std::string browser = Chromium();
    TemporaryFolder folder;
    FrameContent content;       // of the last frame
    FrameContent zoomed;        // of the same, nearer and aside
    std::vector<PageBody> last; // of the last frame
};

} // namespace boxreel
