// SPDX-License-Identifier: MIT
#include "Shot.h"
#include "Declare.h"
#include "MotionOptions.h"
#include "OutputPath.h"

#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <debugdraw/NiceNumbers.h>
#include <film/RenderReport.h>
#include <render/FigureFrame.h>
#include <render/FigureSheet.h>
#include <render/Png.h>
#include <render/Renderer.h>
#include <session/SceneMotion.h>
#include <session/SessionPanels.h>

#include <algorithm>

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

/// The steps at which pictures are taken.
std::vector<std::int64_t> MomentsOf(const ShotOptions& options, const Rational& stepsPerSecond)
{
    std::vector<std::int64_t> moments = options.steps;
    for (const Duration time : options.at)
    {
        moments.push_back(StepAt(time, stepsPerSecond));
    }
    return moments;
}

/// `pictures`: one a moment, with a title when there are several.
Figure MakeFigure(const ShotOptions& options, const Theme& theme,
                  std::vector<SheetPicture> pictures, const std::string& title)
{
    return SheetOf(std::move(pictures), {.columns = options.motion.columns,
                                         .axes = options.motion.axes,
                                         .scaleBar = options.motion.scaleBar,
                                         .caption = options.motion.caption,
                                         .theme = theme,
                                         .scale = options.look.scale,
                                         .title = title});
}

/// The figure with the bodies' names in its groups.
Figure Named(Figure figure, const BodyNames& names)
{
    for (FigurePanel& panel : figure.panels)
    {
        panel.bodyNames = names;
    }
    return figure;
}

/// Checks that all moments fit on one sheet. Uses empty pictures, before anything is simulated.
Result<void> CheckSheet(const ShotOptions& options, PictureFormat format)
{
    const std::size_t count = options.at.size() + options.steps.size();
    SheetPicture picture;
    picture.camera.width = options.look.width;
    picture.camera.height = options.look.height;
    picture.title = count > 1 ? "0 s" : "";
    const Figure figure =
        MakeFigure(options, options.look.theme, std::vector<SheetPicture>(count, picture), "");
    const bool isPixels = format == PictureFormat::Png;
    const Camera size = Scaled(Camera{.width = figure.width, .height = figure.height},
                               isPixels ? options.look.scale : 1.0);
    const int most = isPixels ? 8192 : kLargestFigure;
    if (std::max(size.width, size.height) > most)
    {
        return Error{ErrorKind::Unusable, "--size",
                     "makes a sheet of " + std::to_string(size.width) + "x" +
                         std::to_string(size.height) + " pixels; the limit is " +
                         std::to_string(most),
                     std::string("lower --size") + (isPixels ? " or --scale" : "") +
                         ", give fewer moments or other --columns" +
                         (isPixels ? ", or write .svg or .pdf" : "")};
    }
    return {};
}

/// Lists at most kMaxListed of them.
std::string Listed(const std::vector<std::string>& letters)
{
    constexpr std::size_t kMaxListed = 20;
    std::string named;
    for (std::size_t i = 0; i < std::min(letters.size(), kMaxListed); ++i)
    {
        named += letters[i];
    }
    return named + (letters.size() > kMaxListed ? "..." : "");
}

Result<void> TellMissingLetters(const Figure& figure, PictureFormat format)
{
    if (format == PictureFormat::Svg)
    {
        return {}; // its viewer has the fonts
    }
    const bool isPdf = format == PictureFormat::Pdf;
    ASSIGN_OR_RETURN(const std::vector<std::string> letters,
                     isPdf ? LettersWithoutPdf(figure) : LettersWithoutPixels(figure));
    if (!letters.empty())
    {
        WriteMessage(isPdf ? "boxreel: PDF: cannot show " + Listed(letters) + "; .svg can"
                           : "boxreel: PNG: no glyph for " + Listed(letters) +
                                 ", shown as ?; .svg has them");
    }
    return {};
}

/// Writes the figure and adds its rendering statistics to `totals`.
Result<void> WriteFigure(const ShotOptions& options, const Picture& picture, const Figure& figure,
                         RenderTotals& totals)
{
    const FigureFileSettings settings{.overwrite = options.force};
    switch (*PictureFormatOf(picture.path))
    {
    case PictureFormat::Svg:
        return WriteSvg(picture.path, figure, settings);
    case PictureFormat::Pdf:
        return WritePdf(picture.path, figure, settings);
    case PictureFormat::Png:
        break;
    }
    RenderTotals drawn;
    ASSIGN_OR_RETURN(const Frame frame, ToFrame(figure, options.backend, &drawn));
    totals += drawn;
    return WritePng(picture.path, frame, {.overwrite = options.force});
}

/// A picture under the panel, which only pixels can show.
Result<void> WriteWithPanel(const ShotOptions& options, const Picture& picture,
                            const DrawList& list, const Camera& camera, const Overlay& panel,
                            RenderTotals& totals)
{
    ASSIGN_OR_RETURN(Renderer renderer, Renderer::Create({.width = camera.width,
                                                          .height = camera.height,
                                                          .theme = picture.theme,
                                                          .backend = options.backend,
                                                          .scale = options.look.scale}));
    Frame frame;
    RETURN_IF_ERROR(renderer.Draw(list, camera, frame, &panel));
    totals += renderer.Totals();
    return WritePng(picture.path, frame, {.overwrite = options.force});
}

Result<void> TakePictures(const ShotOptions& options, const std::vector<Picture>& pictures,
                          SceneSource source)
{
    if (PictureFormatOf(pictures.front().path) == PictureFormat::Png)
    {
        RETURN_IF_ERROR(PrepareFrames(options.backend));
    }
    ASSIGN_OR_RETURN(SceneSession session, OpenSession(std::move(source), options.look));
    const std::vector<std::int64_t> moments = MomentsOf(options, session.StepsPerSecond());
    ASSIGN_OR_RETURN(SceneMotion motion, SceneMotion::Create(options.motion, session, moments));
    std::vector<SheetPicture> parts;
    FrameContent content;
    for (const std::int64_t moment : moments)
    {
        motion.AdvanceTo(session, moment);
        content = {};
        session.Fill(content, motion.Notes(session));
        parts.push_back({motion.Picture(session, content.list), session.CurrentCamera(),
                         moments.size() > 1 ? NumberPlain(session.Time()) + " s" : ""});
    }
    for (const Result<void>& came : {motion.CheckBodiesCame(), session.CheckView()})
    {
        if (!came)
        {
            return came;
        }
    }
    const Figure anyTheme = MakeFigure(options, options.look.theme, parts, "");
    const PictureFormat format = *PictureFormatOf(pictures.front().path);
    RETURN_IF_ERROR(TellMissingLetters(anyTheme, format));
    RenderTotals totals;
    for (const Picture& picture : pictures)
    {
        const Result<void> written =
            options.look.panels.hud || options.look.panels.testbed
                ? WriteWithPanel(options, picture, parts.front().list, content.camera,
                                 content.overlay, totals)
                : WriteFigure(options, picture,
                              Named(MakeFigure(options, picture.theme, parts, session.Title()),
                                    session.Names()),
                              totals);
        if (!written)
        {
            return written;
        }
    }
    if (options.stats)
    {
        WriteMessage(DescribeDrawing(totals));
    }
    return {};
}

/// Asked before anything is simulated.
Result<void> CheckPictures(const ShotOptions& options, const std::vector<Picture>& pictures)
{
    for (const Picture& picture : pictures)
    {
        RETURN_IF_ERROR(CheckFigurePath(picture.path, options.force));
    }
    const PictureFormat format = *PictureFormatOf(pictures.front().path);
    RETURN_IF_ERROR(CheckSheet(options, format));
    return format == PictureFormat::Pdf ? PreparePdf() : Result<void>();
}

} // namespace

std::vector<std::filesystem::path> FilesOf(const ShotOptions& options)
{
    std::vector<std::filesystem::path> files;
    for (const Picture& picture : PicturesOf(options))
    {
        files.push_back(picture.path);
    }
    return files;
}

Result<void> Prepare(const ShotOptions& options)
{
    return CheckPictures(options, PicturesOf(options));
}

Result<int> Run(const ShotOptions& options)
{
    const std::vector<Picture> pictures = PicturesOf(options);
    RETURN_IF_ERROR(CheckPictures(options, pictures));
    ASSIGN_OR_RETURN(SceneSource source, OpenScene(options.scene));
    for (const RubeNote& part : source.leftOut)
    {
        WriteMessage("left out: " + part.Text());
    }
    const Result<void> taken = TakePictures(options, pictures, std::move(source));
    return taken ? Result<int>(0) : taken.GetError();
}

namespace
{

Result<double> ParseScale(const std::string& option, const std::string& text)
{
    const Result<double> scale = ParseNumber(option, text);
    if (!scale || *scale < 0.1 || *scale > 16.0)
    {
        return BadValue(option, text, "must be a number from 0.1 to 16, such as 2");
    }
    return scale;
}

} // namespace

Command& Declare(Command& program, ShotOptions& shot)
{
    Command& command = AddCommand(program, "shot", "Make one picture of a scene");
    AddScene(command, shot.scene);
    AddPath(command, "-o,--output", "FILE", shot.output,
            "Write the picture here: .png, .svg or .pdf", FigureExtensions());
    AddForce(command, shot.force);
    AddStats(command, shot.stats);
    AddMotion(command, shot);
    AddValue(command, "--scale", "FACTOR", shot.look.scale, ParseScale,
             "Scale all lengths in pixels, also lines and text; 0.1 to 16 (1)")
        .Group("Picture");
    AddLook(command, shot.look, &shot.bothThemes);
    AddBackend(command, shot.backend).Group("Picture");
    command.notes = {
        {"A .png has the pixels of a film's frame at the same time. In .svg and .pdf, text stays\n"
         "text and each body is a named group. --theme both writes NAME-light.EXT (print) and\n"
         "NAME-dark.EXT. --size is the size of the picture without annotations; of several\n"
         "moments, of each (640x360)."}};
    command.examples = {
        "boxreel shot pyramid --at 3s -o pyramid.png",
        "boxreel shot bridge --step 180 -o bridge.png --size 1920x1080 --hud",
        "boxreel shot chain --at 500ms -o chain.png --draw shapes,joints,aabbs --labels",
        "boxreel shot tumbler --at 4s -o tumbler.svg --theme okabe-ito",
        "boxreel shot pyramid --at 3s -o pyramid.pdf --theme print --labels",
        "boxreel shot bridge --at 2s -o bridge.svg --theme both",
        "boxreel shot newtons-cradle --at 1s -o cradle.png --trail moving --onion 6:50ms",
        "boxreel shot dominos --at 0s,1s,2s,3s -o dominos.pdf --theme print --scale-bar",
        "boxreel shot bridge --at 2s -o b.svg --axes --dimension 3,17 --caption \"A bridge.\""};
    return command;
}

namespace
{

/// Checks the options that pixels exclude, and those that require pixels.
Result<void> CheckPixels(const ShotOptions& options)
{
    const bool isVector =
        PictureFormatOf(options.output).value_or(PictureFormat::Png) != PictureFormat::Png;
    if (isVector && (options.look.panels.hud || options.look.panels.testbed))
    {
        return Error{ErrorKind::Unusable, options.look.panels.hud ? "--hud" : "--ui",
                     "requires a .png picture, not " + options.output.string(), "use -o NAME.png"};
    }
    if (isVector && options.stats)
    {
        return Error{ErrorKind::Unusable, "--stats",
                     "requires a .png picture, not " + options.output.string(), "use -o NAME.png"};
    }
    const Camera size = Scaled(Camera{.width = options.look.width, .height = options.look.height},
                               options.look.scale);
    if (!isVector && std::max(size.width, size.height) > 8192)
    {
        return Error{ErrorKind::Unusable, "--scale",
                     "makes " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                         " pixels; the limit is 8192",
                     "lower it or --size, or write .svg or .pdf"};
    }
    return {};
}

} // namespace

Result<void> Check(ShotOptions& options)
{
    RETURN_IF_ERROR(CheckHud(options.look));
    if (options.scene.empty())
    {
        return Missing("shot", "SCENE", "boxreel shot pyramid --at 3s -o pyramid.png");
    }
    if (options.output.empty())
    {
        return Missing("shot", "-o FILE", "boxreel shot pyramid --at 3s -o pyramid.png");
    }
    if (!options.at.empty() && !options.steps.empty())
    {
        return Conflict("--at", "--step");
    }
    if (options.at.empty() && options.steps.empty())
    {
        return Missing("shot", "--at or --step", "--at 3s");
    }
    RETURN_IF_ERROR(CheckMotion(options));
    RETURN_IF_ERROR(CheckPixels(options));
    return {};
}

} // namespace boxreel
