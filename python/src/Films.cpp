// SPDX-License-Identifier: MIT
#include "Module.h"
#include "Toolkit.h"

#include <base/ErrorMacros.h>
#include <base/Nearest.h>
#include <base/Words.h>
#include <debugdraw/WorldBounds.h>
#include <debugdraw/WorldGlyphs.h>
#include <page/PageWriter.h>
#include <recorder/Recording.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>

/// Films of worlds and of arrays.
namespace boxreel::python
{
namespace
{

constexpr Word<Quality> kQualities[] = {{"draft", Quality::Draft},
                                        {"standard", Quality::Standard},
                                        {"high", Quality::High},
                                        {"lossless", Quality::Lossless}};

/// Fails if the folder does not exist.
void RequireFolder(const std::filesystem::path& path)
{
    const std::filesystem::path folder = path.parent_path();
    std::error_code ignored;
    if (!folder.empty() && path.filename().string().find('#') == std::string::npos &&
        !std::filesystem::is_directory(folder, ignored))
    {
        ThrowError({ErrorKind::Unusable, path.string(),
                    "the folder " + folder.string() + " does not exist", "create it first"});
    }
}

std::string TextOf(const py::object& option, const char* name)
{
    return From<std::string>(py::str(option), name);
}

Rational RateFrom(const py::object& fps)
{
    const std::string text = TextOf(fps, "fps");
    Result<Rational> rate = Rational::Parse(text);
    if (!rate)
    {
        Error error = std::move(rate).TakeError();
        error.culprit = ErrorSetting{BOXREEL_MEMBER(VideoSettings, framesPerSecond), {text}};
        ThrowError(error);
    }
    return *rate;
}

/// Refuses an extension that neither films nor pages have. Other names are left to the writers.
void RequireKnownEnd(const std::filesystem::path& path)
{
    std::vector<std::string> ends = VideoEnds();
    ends.emplace_back(".png");
    ends.emplace_back(".html");
    const std::string end = Lower(path.extension().string());
    if (!path.stem().empty() && std::find(ends.begin(), ends.end(), end) == ends.end())
    {
        const std::string known =
            "use " + JoinedBy(", ", VideoEnds()) + ", .html or a name like frames-####.png";
        ThrowError({ErrorKind::Unusable, path.string(),
                    end.empty() ? "has no extension"
                                : "unsupported extension " + path.extension().string(),
                    DidYouMean(end, ends, known)});
    }
}

bool IsPage(const std::string& path)
{
    return Lower(path).ends_with(".html");
}

/// Returns what a page says of the bodies that are pointed at.
std::vector<PageBody> BodiesOf(WorldObject& world)
{
    const BodyNames names = NamesOf(world);
    std::vector<PageBody> bodies;
    for (const b2Body* b = world.world.GetBodyList(); b != nullptr; b = b->GetNext())
    {
        const auto number = std::uint32_t(b->GetNumber());
        const auto name = names.find(number);
        bodies.push_back({.number = number,
                          .position = {b->GetPosition().x, b->GetPosition().y},
                          .angle = b->GetAngle(),
                          .name = name != names.end() ? name->second : "",
                          .velocity = {b->GetLinearVelocity().x, b->GetLinearVelocity().y},
                          .spin = b->GetAngularVelocity()});
    }
    return bodies;
}

/// Calls a function without Python's lock.
template <class Function>
auto Unlocked(Function function)
{
    const WithoutLock unlocked;
    return function();
}

/// Marks a film as in use, because adding lets other threads run.
class Busy
{
public:
    explicit Busy(bool& isBusy) : m_isBusy(isBusy) { m_isBusy = true; }
    ~Busy() { m_isBusy = false; }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;

private:
    bool& m_isBusy;
};

/// A film. Its first frame decides whether it shows worlds, which are drawn here, or arrays. A page
/// shows worlds, which the browser draws.
class Film
{
public:
    Film(std::string path, const py::dict& options) : m_path(std::move(path))
    {
        m_video.width = From<int32>(options["width"], "size");
        m_video.height = From<int32>(options["height"], "size");
        m_video.framesPerSecond = RateFrom(options["fps"]);
        m_video.quality = OneOf("quality", TextOf(options["quality"], "quality"), kQualities);
        m_video.codec = TextOf(options["codec"], "codec");
        m_video.overwrite = From<bool>(options["overwrite"], "overwrite");
        m_drawing.theme = ThemeFrom(TextOf(options["theme"], "theme"));
        m_drawing.scale = From<double>(options["scale"], "scale");
        // Before anything is simulated.
        if (IsPage(m_path))
        {
            RequireNoneOfFilms();
            Need(CheckPagePath(m_path, PageOf({})));
        }
        else
        {
            RequireKnownEnd(m_path);
            Need(CheckVideoPath(m_path, m_video));
        }
        RequireFolder(m_path);
    }

    void AddWorld(WorldObject& world, py::handle camera, const Look& look)
    {
        RequireOpen();
        const Busy busy(m_isBusy);
        if (m_writer)
        {
            ThrowMisuse("this film is of arrays; use another for a world");
        }
        const Camera view = ViewOf(world, camera);
        if (IsPage(m_path))
        {
            return AddToPage(world, view, look);
        }
        const DrawList list = ListOf(world, view, look);
        if (!m_recording)
        {
            RequireThreadsOfFilms();
            Result<Recording> recording =
                Unlocked([&] { return Recording::Open(m_path, m_video, m_drawing); });
            m_recording.emplace(Need(std::move(recording)));
        }
        if (!Unlocked([&] { return m_recording->Add(list, view); }))
        {
            Result<void> reason = Unlocked([&] { return m_recording->Close(); });
            Discard();
            Need(reason);
        }
        ++m_frames;
    }

    void AddArray(py::handle array)
    {
        RequireOpen();
        const Busy busy(m_isBusy);
        if (m_recording || IsPage(m_path))
        {
            ThrowMisuse(IsPage(m_path) ? "a page shows worlds; use a film for arrays"
                                       : "this film is of a world; use another for arrays");
        }
        const Frame frame = FrameFrom(array);
        if (!m_writer)
        {
            if (!m_sizeIsGiven)
            {
                m_video.width = frame.width;
                m_video.height = frame.height;
            }
            RequireSize(frame);
            RequireThreadsOfFilms();
            Result<VideoWriter> writer =
                Unlocked([&] { return VideoWriter::Open(m_path, m_video); });
            m_writer.emplace(Need(std::move(writer)));
        }
        RequireSize(frame);
        Need(Unlocked([&] { return m_writer->Append(frame); }));
        ++m_frames;
    }

    void Close()
    {
        if (m_isDone)
        {
            return;
        }
        RequireIdle();
        m_isDone = true;
        if (!m_recording && !m_writer && !m_page)
        {
            ThrowMisuse("a film needs at least one frame; call add before close");
        }
        Result<void> result = Unlocked([&] {
            return m_recording ? m_recording->Close()
                   : m_page    ? m_page->Close()
                               : m_writer->Close();
        });
        Discard();
        Need(result);
    }

    ~Film()
    {
        if (m_process != ::getpid())
        {
            Discard();
        }
    }
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    void Discard()
    {
        m_isDone = true;
        if (m_process != ::getpid())
        {
            // A forked process would wait for the threads of its parent, and remove its file.
            new std::optional<Recording>(std::move(m_recording));
            new std::optional<VideoWriter>(std::move(m_writer));
            new std::optional<PageWriter>(std::move(m_page));
            m_recording.reset();
            m_writer.reset();
            m_page.reset();
            return;
        }
        Unlocked([&] {
            m_recording.reset();
            m_writer.reset();
            m_page.reset();
            return 0;
        });
    }

    void SizeIsGiven(bool isGiven) { m_sizeIsGiven = isGiven; }
    std::int64_t Frames() const { return m_frames; }
    const std::string& Path() const { return m_path; }
    py::tuple Size() const { return py::make_tuple(m_video.width, m_video.height); }

private:
    void RequireOpen() const
    {
        if (m_isDone)
        {
            ThrowMisuse("this film is closed; nothing can be added");
        }
        RequireIdle();
    }

    void RequireIdle() const
    {
        if (m_process != ::getpid())
        {
            ThrowMisuse("this film belongs to the process that this one was forked from");
        }
        if (m_isBusy)
        {
            ThrowMisuse("another thread adds to this film; wait until it is done");
        }
    }

    /// Fails if an option is given that a page does not have.
    void RequireNoneOfFilms() const
    {
        const bool isUsual = m_video.codec.empty() && m_video.quality == VideoSettings().quality &&
                             m_drawing.scale == RendererSettings().scale;
        if (!isUsual)
        {
            ThrowMisuse("a page has no quality, codec or scale; leave them out");
        }
    }

    PageSettings PageOf(const LayerSet& shown) const
    {
        return {.width = m_video.width,
                .height = m_video.height,
                .framesPerSecond = m_video.framesPerSecond.ToDouble(),
                .title = std::filesystem::path(m_path).stem().string(),
                .theme = m_drawing.theme,
                .shown = shown,
                .overwrite = m_video.overwrite};
    }

    void AddToPage(WorldObject& world, const Camera& view, const Look& look)
    {
        const DrawList list = ListOf(world, view, look, kPageZoom);
        const std::vector<PageBody> bodies = BodiesOf(world);
        const std::vector<Vec2> anchors =
            look.layers[DrawLayer::JointGlyphs]
                ? JointGlyphAnchors(world.world, ViewOfEverything(view), kPageZoom)
                : std::vector<Vec2>();
        if (!m_page)
        {
            m_page.emplace(Need(PageWriter::Open(m_path, PageOf(look.layers))));
        }
        Need(Unlocked([&] { return m_page->Append(list, view, bodies, anchors); }));
        ++m_frames;
    }

    void RequireSize(const Frame& frame) const
    {
        if (frame.width != m_video.width || frame.height != m_video.height)
        {
            ThrowMisuse("this frame is " + std::to_string(frame.width) + " x " +
                        std::to_string(frame.height) + " pixels, and the film is " +
                        std::to_string(m_video.width) + " x " + std::to_string(m_video.height) +
                        "; all frames have the size of the film");
        }
    }

    /// Returns the camera of the caller, or one that keeps what moves in view.
    Camera ViewOf(WorldObject& world, py::handle camera)
    {
        if (!camera.is_none())
        {
            return CameraFrom(camera, world, m_video.width, m_video.height);
        }
        if (!m_follower)
        {
            world.RequireUnlocked("drawing");
            const Rect ground = GroundBelow(world.world);
            m_follower.emplace(m_video.width, m_video.height, BoundsAtStart(world.world, ground));
        }
        else
        {
            m_follower->Update(BoundsOfMovers(world.world),
                               1.0 / m_video.framesPerSecond.ToDouble());
        }
        return m_follower->View();
    }

    std::string m_path;
    VideoSettings m_video;
    RendererSettings m_drawing;
    std::optional<Recording> m_recording;
    std::optional<VideoWriter> m_writer;
    std::optional<PageWriter> m_page;
    std::optional<FitCamera> m_follower;
    std::int64_t m_frames = 0;
    bool m_isDone = false;
    pid_t m_process = ::getpid();
    bool m_isBusy = false; ///< a frame is being added
    bool m_sizeIsGiven = false;
};

} // namespace

void BindFilms(py::module_& module)
{
    py::class_<Film>(module, "_Film")
        .def(py::init<std::string, const py::dict&>())
        .def("size_is_given", &Film::SizeIsGiven)
        .def("add_world",
             [](Film& self, py::handle world, py::handle camera, py::handle layers,
                py::handle trails) {
                 self.AddWorld(WorldFrom(world, "world"), camera, LookFrom(layers, trails));
             })
        .def("add_array", &Film::AddArray)
        .def("close", &Film::Close)
        .def("discard", &Film::Discard)
        .def_property_readonly("frames", &Film::Frames)
        .def_property_readonly("path", &Film::Path)
        .def_property_readonly("size", &Film::Size);
}

} // namespace boxreel::python
