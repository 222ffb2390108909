// SPDX-License-Identifier: MIT
#include "Commands.h"
#include "OutputPath.h"
#include "RenderReport.h"
#include "Terminal.h"

#include <render/Figure.h>
#include <render/Png.h>
#include <render/Renderer.h>

namespace boxreel
{
namespace
{

/// One of the files that a shot writes.
struct Picture
{
    std::filesystem::path path;
    Theme theme;
};

/// dir/bridge.svg becomes dir/bridge-dark.svg.
std::filesystem::path WithSuffix(std::filesystem::path path, const char* suffix)
{
    const std::filesystem::path extension = path.extension();
    path.replace_filename(path.stem() += suffix);
    return path += extension;
}

std::vector<Picture> PicturesOf(const ShotOptions& options)
{
    if (!options.bothThemes)
    {
        return {{options.output, options.look.theme}};
    }
    return {{WithSuffix(options.output, "-light"), Theme::Print()},
            {WithSuffix(options.output, "-dark"), Theme::Dark()}};
}

/// Asked before anything is simulated.
Result<void> CheckPictures(const std::vector<Picture>& pictures, bool force)
{
    for (const Picture& picture : pictures)
    {
        if (const Result<void> usable = CheckFigurePath(picture.path, force); !usable)
        {
            return usable;
        }
    }
    return PictureFormatOf(pictures.front().path) == PictureFormat::Pdf ? PreparePdf()
                                                                        : Result<void>();
}

/// One for each picture; none where no pixels are asked for. Made before anything is simulated.
Result<std::vector<Renderer>> MakeRenderers(const ShotOptions& options,
                                            const std::vector<Picture>& pictures)
{
    std::vector<Renderer> renderers;
    const Camera size = Scaled(Camera{.width = options.look.width, .height = options.look.height},
                               options.look.scale);
    for (const Picture& picture : pictures)
    {
        if (PictureFormatOf(picture.path) == PictureFormat::Png)
        {
            Result<Renderer> renderer = Renderer::Create({.width = size.width,
                                                          .height = size.height,
                                                          .theme = picture.theme,
                                                          .backend = options.backend,
                                                          .scale = options.look.scale});
            if (!renderer)
            {
                return renderer.GetError();
            }
            renderers.push_back(std::move(*renderer));
        }
    }
    return renderers;
}

Result<void> WritePixels(const Picture& picture, Renderer& renderer, const FrameContent& content,
                         bool force)
{
    Frame frame;
    const Result<void> drawn = renderer.Draw(content.list, content.camera, frame, &content.overlay);
    return drawn ? WritePng(picture.path, frame, {.overwrite = force}) : drawn;
}

Result<void> WriteFigure(const ShotOptions& options, const Picture& picture,
                         const FrameContent& content, const std::string& title)
{
    Figure figure = FigureOf(content.list, content.camera, picture.theme);
    figure.scale = options.look.scale;
    figure.title = title;
    const FigureFileSettings settings{.overwrite = options.force};
    return PictureFormatOf(picture.path) == PictureFormat::Svg
               ? WriteSvg(picture.path, figure, settings)
               : WritePdf(picture.path, figure, settings);
}

Result<void> TakePictures(const ShotOptions& options, const std::vector<Picture>& pictures,
                          SceneSource source)
{
    Result<std::vector<Renderer>> renderers = MakeRenderers(options, pictures);
    if (!renderers)
    {
        return renderers.GetError();
    }
    SceneLook look = options.look;
    look.scale = renderers->empty() ? 1.0 : look.scale; // a figure is scaled as a whole
    Result<SceneSession> session = SceneSession::Open(std::move(source), look);
    if (!session)
    {
        return session.GetError();
    }
    session->AdvanceTo(options.at ? StepAt(*options.at, session->StepsPerSecond())
                                  : options.step.value_or(0));
    FrameContent content;
    session->Fill(content);
    for (std::size_t i = 0; i < pictures.size(); ++i)
    {
        const Result<void> written =
            renderers->empty() ? WriteFigure(options, pictures[i], content, session->Title())
                               : WritePixels(pictures[i], (*renderers)[i], content, options.force);
        if (!written)
        {
            return written;
        }
        if (options.stats)
        {
            WriteMessage(DescribeDrawing((*renderers)[i].Totals()));
        }
    }
    return {};
}

} // namespace

Result<int> RunShot(const ShotOptions& options)
{
    const std::vector<Picture> pictures = PicturesOf(options);
    if (const Result<void> usable = CheckPictures(pictures, options.force); !usable)
    {
        return usable.GetError();
    }
    Result<SceneSource> source = OpenScene(options.scene);
    if (!source)
    {
        return source.GetError();
    }
    for (const std::string& line : source->leftOut)
    {
        WriteMessage(line);
    }
    const Result<void> taken = TakePictures(options, pictures, std::move(*source));
    return taken ? Result<int>(0) : taken.GetError();
}

} // namespace boxreel
