// SPDX-License-Identifier: MIT
#include "WorkbenchFiles.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <render/Figure.h>
#include <render/FigureFrame.h>
#include <render/Png.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace boxreel
{
namespace
{

constexpr double kMaxFramesPerSecond = 60.0;

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

/// Returns the view of films: the window, or the part that no panel covers.
Camera FilmedView(const SceneWork& work, bool hasPanels)
{
    return hasPanels ? work.View() : Scaled(work.Uncovered(), work.Session().Look().scale);
}

/// A file that a script makes again, with what its pictures show as options, then `moment`.
ScriptProduct ProductOf(ScriptProduct::Kind kind, const std::filesystem::path& path,
                        const PanelChoices& choices, const std::vector<std::string>& moment)
{
    ScriptProduct product;
    product.kind = kind;
    product.name = path.filename().string();
    std::vector<std::string>& options = product.options;
    const std::string layers = TextOf(choices.layers);
    if (!layers.empty())
    {
        options.insert(options.end(), {"--draw", layers});
    }
    if (choices.labels)
    {
        options.emplace_back("--labels");
    }
    if (choices.theme != "classic")
    {
        options.insert(options.end(), {"--theme", choices.theme});
    }
    options.insert(options.end(), moment.begin(), moment.end());
    return product;
}

} // namespace

std::filesystem::path FreeName(const std::filesystem::path& folder, const std::string& title,
                               const std::string& extension)
{
    const std::string name = SceneSlug(title);
    for (int number = 1;; ++number)
    {
        const std::filesystem::path path =
            folder / ((name.empty() ? "scene" : name) + "-" + std::to_string(number) + extension);
        std::error_code error;
        if (!std::filesystem::exists(path, error) &&
            !std::filesystem::exists(PartPath(path), error))
        {
            return path;
        }
    }
}

Result<std::filesystem::path> WritePicture(SceneWork& work, const WorkbenchOutput& output,
                                           const std::string& extension)
{
    SceneSession& session = work.Session();
    FrameContent content;
    session.Fill(content);
    Figure figure = FigureOf(std::move(content.list), work.Uncovered(), output.theme);
    figure.title = session.Title();
    figure.panels.front().bodyNames = session.Names();
    std::filesystem::path path = FreeName(output.into, session.Title(), extension);
    if (extension == ".svg")
    {
        RETURN_IF_ERROR(WriteSvg(path, figure));
    }
    else
    {
        figure.scale = session.Look().scale;
        ASSIGN_OR_RETURN(const Frame frame, ToFrame(figure, output.backend));
        RETURN_IF_ERROR(WritePng(path, frame));
    }
    work.Log().Add(ProductOf(ScriptProduct::Kind::Shot, path, output.choices,
                             {"--step", std::to_string(session.SceneStep())}));
    return path;
}

Result<WorkbenchFilm> WorkbenchFilm::Open(const SceneWork& work, const WorkbenchOutput& output)
{
    const SceneSession& session = work.Session();
    const Rational& rate = session.StepsPerSecond();
    const int every =
        std::max(1, static_cast<int>(std::ceil(rate.ToDouble() / kMaxFramesPerSecond)));
    const Camera view = FilmedView(work, output.choices.filmsPanels);
    VideoSettings film;
    film.width = Even(view.width);
    film.height = Even(view.height);
    film.framesPerSecond = {rate.num, rate.den * every};
    const std::filesystem::path path = FreeName(output.into, session.Title(), ".mp4");
    ASSIGN_OR_RETURN(Recording recording, Recording::Open(path, film,
                                                          {.theme = output.theme,
                                                           .backend = output.backend,
                                                           .scale = session.Look().scale}));
    WorkbenchFilm opened(std::move(recording), path);
    opened.m_first = session.SceneStep();
    opened.m_every = every;
    opened.m_width = film.width;
    opened.m_height = film.height;
    opened.m_hasPanels = output.choices.filmsPanels;
    return opened;
}

double WorkbenchFilm::Seconds(const SceneWork& work) const
{
    return double(m_frames) * m_every / work.Session().StepsPerSecond().ToDouble();
}

bool WorkbenchFilm::Add(SceneWork& work, const Overlay& panels)
{
    FrameContent content;
    work.Session().Fill(content);
    content.camera = FilmedView(work, m_hasPanels);
    // Rows and columns are left off at the right and below, so that the middle moves by half of
    // them.
    content.camera.centerX -=
        0.5 * (content.camera.width - m_width) / content.camera.pixelsPerMeter;
    content.camera.centerY +=
        0.5 * (content.camera.height - m_height) / content.camera.pixelsPerMeter;
    content.camera.width = m_width;
    content.camera.height = m_height;
    const bool isAdded =
        bool(m_film.Add(content.list, content.camera, m_hasPanels ? &panels : nullptr));
    m_frames += isAdded ? 1 : 0;
    return isAdded;
}

Result<void> WorkbenchFilm::Close(SceneWork& work, const PanelChoices& choices)
{
    RETURN_IF_ERROR(m_film.Close());
    if (m_first > work.Session().SceneStep())
    {
        return {}; // it began in the scene before this one
    }
    const Rational& rate = work.Session().StepsPerSecond();
    work.Log().Add(
        ProductOf(ScriptProduct::Kind::Record, m_path, choices,
                  {"--from", Decimals(double(m_first) / rate.ToDouble()) + "s", "--frames",
                   std::to_string(m_frames), "--fps",
                   std::to_string(rate.num) + "/" + std::to_string(rate.den * m_every)}));
    return {};
}

} // namespace boxreel
