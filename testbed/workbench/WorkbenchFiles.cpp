// SPDX-License-Identifier: MIT
// What the buttons of a workbench write: films, figures, scripts.
#include "Workbench.h"

#include <base/AtomicFile.h>
#include <render/Figure.h>
#include <render/FigureFrame.h>
#include <render/Png.h>

#include <cmath>

namespace boxreel
{
namespace
{

constexpr double kMostFramesPerSecond = 60.0;

/// Most formats halve colours.
int Even(int pixels)
{
    return std::max(2, pixels / 2 * 2);
}

std::string Decimals(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.9f", value);
    return text;
}

} // namespace

/// "pyramid-1.mp4": the first number that is not taken.
std::filesystem::path Workbench::FreeName(const std::string& extension) const
{
    const std::string name = SceneSlug(m_session->Title());
    for (int number = 1;; ++number)
    {
        const std::filesystem::path path =
            m_settings.into /
            ((name.empty() ? "scene" : name) + "-" + std::to_string(number) + extension);
        std::error_code error;
        if (!std::filesystem::exists(path, error) &&
            !std::filesystem::exists(PartPath(path), error))
        {
            return path;
        }
    }
}

/// What pictures of it show, as options.
std::vector<std::string> Workbench::PictureOptions() const
{
    std::vector<std::string> options;
    const std::string layers = TextOf(m_choices.layers);
    if (!layers.empty())
    {
        options.insert(options.end(), {"--draw", layers});
    }
    if (m_choices.labels)
    {
        options.emplace_back("--labels");
    }
    if (m_choices.theme != "classic")
    {
        options.insert(options.end(), {"--theme", m_choices.theme});
    }
    return options;
}

/// Begins one, or ends it.
void Workbench::Film()
{
    if (m_film)
    {
        const Result<void> ended = Finish();
        Say(ended ? "Wrote " + m_filmPath.string() + "." : ended.GetError().Text());
        return;
    }
    const Rational& rate = m_session->StepsPerSecond();
    m_filmEvery = std::max(1, static_cast<int>(std::ceil(rate.ToDouble() / kMostFramesPerSecond)));
    m_filmHasPanels = m_choices.filmsPanels;
    const Camera view = m_filmHasPanels ? View() : Scaled(Uncovered(), m_settings.look.scale);
    m_filmWidth = Even(view.width);
    m_filmHeight = Even(view.height);
    VideoSettings film;
    film.width = m_filmWidth;
    film.height = m_filmHeight;
    film.framesPerSecond = {rate.num, rate.den * m_filmEvery};
    m_filmPath = FreeName(".mp4");
    Result<Recording> recording = Recording::Open(m_filmPath, film,
                                                  {.theme = m_settings.look.theme,
                                                   .backend = m_settings.backend,
                                                   .scale = m_settings.look.scale});
    if (!recording)
    {
        Say(recording.GetError().Text());
        return;
    }
    m_film.emplace(std::move(*recording));
    m_filmFirst = m_session->SceneStep();
    m_filmFrames = 0;
    FilmFrame();
    Say("Recording " + m_filmPath.string() + ".");
}

/// With the pixels that the window shows, less an odd row or column.
void Workbench::FilmFrame()
{
    FrameContent content;
    m_session->Fill(content);
    content.camera = m_filmHasPanels ? View() : Scaled(Uncovered(), m_settings.look.scale);
    // Rows and columns are left off at the right and below, so that the middle moves by half of
    // them.
    content.camera.centerX -=
        0.5 * (content.camera.width - m_filmWidth) / content.camera.pixelsPerMeter;
    content.camera.centerY +=
        0.5 * (content.camera.height - m_filmHeight) / content.camera.pixelsPerMeter;
    content.camera.width = m_filmWidth;
    content.camera.height = m_filmHeight;
    const Overlay* const panels = m_filmHasPanels ? &m_panels->Picture() : nullptr;
    if (m_film->Add(content.list, content.camera, panels))
    {
        ++m_filmFrames;
        return;
    }
    const Result<void> why = Finish();
    Say(why ? "The film ended." : why.GetError().Text());
}

Result<void> Workbench::Finish()
{
    if (!m_film)
    {
        return {};
    }
    const Result<void> closed = m_film->Close();
    m_film.reset();
    const double rate = m_session->StepsPerSecond().ToDouble();
    if (closed && m_filmFirst <= m_session->SceneStep()) // of this scene, not of the one before
    {
        ScriptProduct film;
        film.kind = ScriptProduct::Kind::Record;
        film.name = m_filmPath.filename().string();
        film.options = PictureOptions();
        film.options.insert(film.options.end(),
                            {"--from", Decimals(double(m_filmFirst) / rate) + "s", "--frames",
                             std::to_string(m_filmFrames), "--fps",
                             std::to_string(m_session->StepsPerSecond().num) + "/" +
                                 std::to_string(m_session->StepsPerSecond().den * m_filmEvery)});
        m_log.Add(std::move(film));
    }
    return closed;
}

void Workbench::Picture(const std::string& extension)
{
    FrameContent content;
    m_session->Fill(content);
    Figure figure = FigureOf(std::move(content.list), Uncovered(), m_settings.look.theme);
    figure.title = m_session->Title();
    figure.panels.front().bodyNames = m_session->Names();
    const std::filesystem::path path = FreeName(extension);
    Result<void> written;
    if (extension == ".svg")
    {
        written = WriteSvg(path, figure);
    }
    else
    {
        figure.scale = m_settings.look.scale;
        const Result<Frame> frame = ToFrame(figure, m_settings.backend);
        written = frame ? WritePng(path, *frame) : frame.GetError();
    }
    Say(written ? "Wrote " + path.string() + "." : written.GetError().Text());
    if (written)
    {
        ScriptProduct shot;
        shot.kind = ScriptProduct::Kind::Shot;
        shot.name = path.filename().string();
        shot.options = PictureOptions();
        shot.options.insert(shot.options.end(), {"--step", std::to_string(m_session->SceneStep())});
        m_log.Add(std::move(shot));
    }
}

void Workbench::SaveScript()
{
    const std::filesystem::path path = FreeName(".play");
    const std::string text = m_log.Text(m_session->SceneStep(), m_session->World());
    const Result<void> written = WriteWhole(path, text, false);
    Say(written ? "Wrote " + path.string() + ": what was done since the scene began."
                : written.GetError().Text());
}

} // namespace boxreel
