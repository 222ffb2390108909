// SPDX-License-Identifier: MIT
#include "Strips.h"
#include "ChildProcess.h"

#include <base/ErrorMacros.h>
#include <base/Quoting.h>
#include <base/ReadWhole.h>
#include <base/WorkFolder.h>
#include <debugdraw/NiceNumbers.h>
#include <golden/StateHash.h>
#include <options/OptionNames.h>
#include <render/Png.h>
#include <session/GoldenScenes.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace boxreel
{

namespace
{

namespace fs = std::filesystem;

// A quarter of a golden picture: ten of them are seen without scrolling far.
constexpr int kWidth = kGoldenWidth / 2;
constexpr int kHeight = kGoldenHeight / 2;
constexpr std::uintmax_t kLargestPicture = 64u << 20; // [bytes]
constexpr std::uintmax_t kLargestPage = 64u << 20;    // [bytes]
constexpr const char* kThisProgram = "/proc/self/exe";
constexpr double kCloseUpMargin = 0.3; // of the picture's height, on every side of the body

/// Returns the bounds of a body; empty if it draws nothing.
Rect BoundsOf(const DrawList& list, int body)
{
    Rect bounds;
    for (const DrawItem& item : list.items)
    {
        if (item.owner != std::uint32_t(body))
        {
            continue;
        }
        // The second point of these is a direction.
        const bool isRound = item.kind == DrawKind::SolidCircle || item.kind == DrawKind::Circle;
        const std::size_t count =
            isRound || item.kind == DrawKind::Transform ? 1 : std::size_t{item.count};
        const float radius = isRound ? item.size : 0.0f;
        for (std::size_t i = 0; i < count; ++i)
        {
            const Vec2 point = list.points[item.first + i];
            bounds.Include(Vec2{point.x - radius, point.y - radius});
            bounds.Include(Vec2{point.x + radius, point.y + radius});
        }
    }
    return bounds;
}

/// With two pixels around it, and as much of it as is in the picture; empty when nothing is.
std::vector<int> MarkOf(const Rect& bounds, const Camera& camera)
{
    const Vec2 upperLeft = camera.ToPixel({bounds.lower.x, bounds.upper.y});
    const Vec2 lowerRight = camera.ToPixel({bounds.upper.x, bounds.lower.y});
    const auto in = [](float pixel, int side) {
        return int(std::clamp(std::round(pixel), 0.0f, float(side)));
    };
    const int left = in(upperLeft.x - 3.0f, kWidth), right = in(lowerRight.x + 3.0f, kWidth);
    const int top = in(upperLeft.y - 3.0f, kHeight), bottom = in(lowerRight.y + 3.0f, kHeight);
    return bounds.IsEmpty() || left >= right || top >= bottom
               ? std::vector<int>()
               : std::vector<int>{left, top, right - left, bottom - top};
}

/// In whole millimetres, so that it can be said to another program.
Camera CloseUp(const Rect& bounds)
{
    const auto rounded = [](double metres) { return std::round(metres * 1000.0) / 1000.0; };
    Camera camera = FitTo(bounds, kWidth, kHeight, kCloseUpMargin);
    camera.centerX = rounded(camera.centerX);
    camera.centerY = rounded(camera.centerY);
    camera.pixelsPerMeter = kHeight / rounded(kHeight / camera.pixelsPerMeter);
    return camera;
}

Result<std::string> Drawn(Renderer& renderer, const DrawList& list, const Camera& camera)
{
    Frame frame;
    RETURN_IF_ERROR(renderer.Draw(list, camera, frame));
    const Result<std::vector<std::uint8_t>> png = EncodePng(frame, 9);
    return png ? Result<std::string>(std::string(png->begin(), png->end()))
               : Result<std::string>(png.GetError());
}

/// Draws the same step with another program. `close`: the visible area; none: the scene's view.
Result<std::string> PictureBy(const fs::path& program, const std::string& scene, std::int64_t step,
                              const std::optional<Camera>& close)
{
    ASSIGN_OR_RETURN(const WorkFolder folder, WorkFolder::Create());
    const fs::path picture = folder.Path() / "shot.png";
    const std::string size = std::to_string(kWidth) + "x" + std::to_string(kHeight);
    std::vector<std::string> arguments{"shot",   scene, "--step", std::to_string(step),
                                       "--size", size,  "-o",     picture.string()};
    if (close)
    {
        arguments.push_back("--camera=" + NumberPlain(close->centerX) + "," +
                            NumberPlain(close->centerY) + "," +
                            NumberPlain(close->height / close->pixelsPerMeter));
    }
    const Result<std::string> said = OutputOf(program, arguments, ChildBounds{1u << 20, 300.0});
    Result<std::string> bytes = ReadWhole(picture, kLargestPicture);
    if (!said || !bytes || bytes->empty())
    {
        return Error{ErrorKind::Unusable, "--against " + program.string(),
                     "made no picture of " + Quoted(scene),
                     "give another build of boxreel that knows the scene"};
    }
    return bytes;
}

/// Records a scene from its start to the step with a program, as a page. Empty if it cannot, as
/// versions from before there were pages; it says so itself.
Result<std::string> PageBy(const fs::path& program, const std::string& scene, std::int64_t step)
{
    ASSIGN_OR_RETURN(const WorkFolder folder, WorkFolder::Create());
    const fs::path page = folder.Path() / "page.html";
    const std::vector<std::string> arguments{
        "record",     scene,  "--frames", std::to_string(step + 1),
        "--progress", "none", "-o",       page.string()};
    const Result<std::string> said = OutputOf(program, arguments, ChildBounds{1u << 20, 600.0});
    return said ? ReadWhole(page, kLargestPage) : Result<std::string>(std::string());
}

class StripMaker
{
public:
    StripMaker(fs::path against, Backend backend)
        : m_against(std::move(against)), m_backend(backend)
    {}

    Result<FilmStrip> Make(const GoldenSelection& selection, const ReportedVerdict& verdict,
                           std::int64_t last)
    {
        FilmStrip strip;
        strip.width = kWidth;
        strip.height = kHeight;
        const std::int64_t first = *verdict.firstStep;
        ASSIGN_OR_RETURN(const std::int64_t end, LastStepOf(selection));
        // A verdict comes from a file, and may say any number.
        const bool isOurs = first >= 1 && first <= last && last <= end;
        ASSIGN_OR_RETURN(const GoldenRun run, SimulateGolden(selection, isOurs ? first : 0));
        // Another project's scene of the same name, or a program that was built since.
        if (run.trace.steps.empty() || run.trace.steps.back().world != verdict.firstHash)
        {
            strip.note = "The steps cannot be shown, because the verdict is not from this program; "
                         "verify again with this program.";
            return strip;
        }
        if (const Result<void> ready = Prepare(); !ready)
        {
            strip.note = "The steps could not be drawn: " + TextInOptions(ready.GetError());
            return strip;
        }
        ASSIGN_OR_RETURN(SceneSession session, OpenGolden(selection, kWidth, kHeight));
        for (const std::int64_t step : StepsAround(first, last))
        {
            session.AdvanceTo(step);
            std::optional<Camera> close;
            ASSIGN_OR_RETURN(FilmStrip::Picture picture, Picture(session, verdict, close));
            RETURN_IF_ERROR(m_against.empty()
                                ? Result<void>()
                                : AskTheOther(SceneSlug(selection.scene->name), close, picture));
            strip.pictures.push_back(std::move(picture));
        }
        RETURN_IF_ERROR(AddPages(SceneSlug(selection.scene->name), last, strip));
        return strip;
    }

private:
    Result<void> Prepare()
    {
        if (m_renderer)
        {
            return {};
        }
        ASSIGN_OR_RETURN(
            Renderer renderer,
            Renderer::Create({.width = kWidth, .height = kHeight, .backend = m_backend}));
        m_renderer = std::move(renderer);
        return {};
    }

    Result<void> AskTheOther(const std::string& scene, const std::optional<Camera>& close,
                             FilmStrip::Picture& picture) const
    {
        Result<std::string> whole = PictureBy(m_against, scene, picture.step, {});
        Result<std::string> part =
            close ? PictureBy(m_against, scene, picture.step, close) : std::string();
        if (!whole || !part)
        {
            return whole ? part.GetError() : whole.GetError();
        }
        picture.expected = *std::move(whole);
        picture.expectedCloseUp = *std::move(part);
        return {};
    }

    /// Adds pages of both worlds up to the moment.
    Result<void> AddPages(const std::string& scene, std::int64_t last, FilmStrip& strip) const
    {
        if (m_against.empty())
        {
            return {};
        }
        ASSIGN_OR_RETURN(strip.expectedPage, PageBy(m_against, scene, last));
        if (!strip.expectedPage.empty())
        {
            ASSIGN_OR_RETURN(strip.actualPage, PageBy(kThisProgram, scene, last));
        }
        return {};
    }

    /// `close`: where the first body is, if it is seen.
    Result<FilmStrip::Picture> Picture(SceneSession& session, const ReportedVerdict& verdict,
                                       std::optional<Camera>& close)
    {
        FrameContent content;
        session.Fill(content);
        FilmStrip::Picture picture;
        picture.step = session.Step();
        ASSIGN_OR_RETURN(std::string whole, Drawn(*m_renderer, content.list, content.camera));
        picture.actual = std::move(whole);
        const Rect bounds = verdict.firstBodies.empty()
                                ? Rect{}
                                : BoundsOf(content.list, verdict.firstBodies.front());
        if (bounds.IsEmpty())
        {
            return picture;
        }
        picture.mark = MarkOf(bounds, content.camera);
        close = CloseUp(bounds);
        ASSIGN_OR_RETURN(std::string part, Drawn(*m_renderer, content.list, *close));
        picture.closeUp = std::move(part);
        return picture;
    }

    fs::path m_against;
    Backend m_backend;
    std::optional<Renderer> m_renderer; // once it is needed
};

} // namespace

std::vector<std::int64_t> StepsAround(std::int64_t first, std::int64_t last)
{
    std::vector<std::int64_t> steps;
    for (const std::int64_t step : {first - 2, first - 1, first, first + 1})
    {
        if (step >= 0 && step <= std::max(first, last))
        {
            steps.push_back(step);
        }
    }
    // A difference that starts with a rounding error is visible some ten or a hundred steps later.
    for (const std::int64_t behind : {4, 12, 30, 60, 120})
    {
        if (first + behind < last)
        {
            steps.push_back(first + behind);
        }
    }
    if (steps.back() < last)
    {
        steps.push_back(last);
    }
    return steps;
}

Result<std::map<std::string, FilmStrip>> MakeStrips(const std::vector<ReportedMoment>& moments,
                                                    const std::filesystem::path& against,
                                                    Backend backend)
{
    std::map<std::string, FilmStrip> strips;
    std::map<std::string, std::pair<std::int64_t, std::string>>
        earliest; // of a scene: step and moment
    const auto sceneOf = [](const std::string& name) { return name.substr(0, name.rfind('/')); };
    const auto isParted = [](const ReportedVerdict& verdict) {
        return verdict.firstStep && verdict.lastStep && !verdict.firstHash.empty();
    };
    for (const ReportedMoment& moment : moments)
    {
        const ReportedVerdict& verdict = moment.shown;
        if (!isParted(verdict))
        {
            continue;
        }
        const std::pair known{*verdict.firstStep, verdict.name};
        const auto [place, isNew] = earliest.try_emplace(sceneOf(verdict.name), known);
        place->second = isNew ? known : std::min(place->second, known);
    }
    StripMaker maker(against, backend);
    for (const ReportedMoment& moment : moments)
    {
        const ReportedVerdict& verdict = moment.shown;
        if (!isParted(verdict))
        {
            continue;
        }
        const Result<GoldenSelection> selection = SelectGolden(verdict.name);
        if (!selection)
        {
            continue; // a world of another project's test
        }
        const auto& [firstStep, name] = earliest.at(sceneOf(verdict.name));
        if (name != verdict.name)
        {
            strips[verdict.name].note = "step " + std::to_string(firstStep);
            strips[verdict.name].earlier = name;
            continue;
        }
        ASSIGN_OR_RETURN(FilmStrip strip, maker.Make(*selection, verdict, *verdict.lastStep));
        strips[verdict.name] = std::move(strip);
    }
    return strips;
}

} // namespace boxreel
