// SPDX-License-Identifier: MIT
#include "Bind.h"
#include "Module.h"
#include "Toolkit.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <base/Nearest.h>
#include <debugdraw/Trail.h>
#include <debugdraw/WorldBounds.h>
#include <debugdraw/WorldLayers.h>
#include <golden/StateHash.h>
#include <page/PageWriter.h>
#include <recorder/VideoWriter.h>
#include <render/Figure.h>
#include <render/Png.h>
#include <render/Renderer.h>

#include <unistd.h>

#include <cstring>

/// Cameras, pictures and figures of worlds.
namespace boxreel::python
{
namespace
{

// Converts impulses to forces for the lengths of arrows.
constexpr double kStepsPerSecond = 60.0;

PyObject* g_error = nullptr; // boxreel.Error, which lives as long as the process

// The only table from members of settings to keywords. A setting without a keyword has no row.
constexpr SettingName kKeywords[] = {
    {BOXREEL_MEMBER(AtomicFileSettings, overwrite), "true", "overwrite=True"},
    {BOXREEL_MEMBER(VideoSettings, overwrite), "true", "overwrite=True"},
    {BOXREEL_MEMBER(PageSettings, overwrite), "true", "overwrite=True"},
    {BOXREEL_MEMBERS(VideoSettings, width, height), "", "size", "=(", ", ", ")"},
    {BOXREEL_MEMBERS(PageSettings, width, height), "", "size", "=(", ", ", ")"},
    {BOXREEL_MEMBER(VideoSettings, framesPerSecond), "", "fps", "="},
    {BOXREEL_MEMBER(PageSettings, framesPerSecond), "", "fps", "="},
    {BOXREEL_MEMBER(VideoSettings, quality), "Quality::Lossless", "quality=\"lossless\""},
    {BOXREEL_MEMBER(VideoSettings, codec), "", "codec", "=\"", "", "\""},
};

pid_t g_drew = 0;   // the process that drew or filmed first
pid_t g_filmed = 0; // the process that filmed first

void RequireProcess(pid_t first, const char* what)
{
    if (first != 0 && first != ::getpid())
    {
        ThrowMisuse(std::string(what) +
                    ": this process was forked after its parent drew or filmed, whose threads are "
                    "not here; use multiprocessing.set_start_method('spawn')");
    }
}

/// Returns the name of an ErrorKind in boxreel.Error.
const char* KindName(ErrorKind kind)
{
    switch (kind)
    {
    case ErrorKind::Unusable:
        return "unusable";
    case ErrorKind::Different:
        return "different";
    case ErrorKind::Absent:
        return "absent";
    case ErrorKind::Failed:
        break;
    }
    return "failed";
}

JointNames NamesOfJoints(WorldObject& world)
{
    JointNames names;
    for (b2Joint* joint = world.world.GetJointList(); joint != nullptr; joint = joint->GetNext())
    {
        const py::object name = py::getattr(Wrap(world, joint), "name", py::none());
        if (!name.is_none())
        {
            names[joint] = NameFrom(name);
        }
    }
    return names;
}

/// A renderer for pictures of one size. It owns a GL context, so it belongs to one thread.
struct PictureRenderer
{
    PictureRenderer(int width, int height, const std::string& theme, double scale)
    {
        const Theme colors = ThemeFrom(theme);
        const RendererSettings settings{
            .width = width, .height = height, .theme = colors, .scale = scale};
        RequireThreadsOfPictures();
        const WithoutLock unlocked;
        Result<Renderer> result = Renderer::Create(settings);
        const py::gil_scoped_acquire locked;
        renderer = std::make_unique<Renderer>(Need(std::move(result)));
    }

    Frame Draw(WorldObject& world, const Camera& camera, const Look& look)
    {
        const DrawList list = ListOf(world, camera, look);
        Frame frame;
        const Result<void> result = [&] {
            const WithoutLock unlocked;
            return renderer->Draw(list, camera, frame);
        }();
        Need(result);
        return frame;
    }

    std::unique_ptr<Renderer> renderer;
};

void BindCamera(py::module_& module)
{
    py::class_<Camera> type(
        module, "Camera", "The visible part of the world, in a picture of width x height pixels.");
    type.def(py::init([](py::handle width, py::handle height, py::handle center,
                         py::handle pixelsPerMeter) {
                 const b2Vec2 middle = From<b2Vec2>(center, "center");
                 const Camera camera{From<int32>(width, "width"), From<int32>(height, "height"),
                                     double(middle.x), double(middle.y),
                                     From<double>(pixelsPerMeter, "pixelsPerMeter")};
                 if (!middle.IsValid())
                 {
                     ThrowMisuse("Camera: center: expected finite numbers");
                 }
                 if (camera.width < 1 || camera.height < 1 || !CanBeDrawn(camera))
                 {
                     ThrowMisuse("Camera: expected a size above 0 and a scale above 0");
                 }
                 return camera;
             }),
             py::arg("width") = 1280, py::arg("height") = 720,
             py::arg("center") = py::make_tuple(0.0, 0.0), py::arg("pixelsPerMeter") = 20.0)
        .def_readonly("width", &Camera::width, "Width of the picture [px].")
        .def_readonly("height", &Camera::height, "Height of the picture [px].")
        .def_property_readonly(
            "center", [](const Camera& c) { return py::make_tuple(c.centerX, c.centerY); },
            "World point in the centre of the picture [m].")
        .def_readonly("pixelsPerMeter", &Camera::pixelsPerMeter, "Scale [px/m].")
        .def(
            "to_pixel",
            [](const Camera& c, py::handle point) {
                const b2Vec2 world = From<b2Vec2>(point, "point");
                const Vec2 pixel = c.ToPixel({world.x, world.y});
                return py::make_tuple(pixel.x, pixel.y);
            },
            py::arg("point"), "Converts a point of the world [m] to the picture [px, y down].")
        .def(
            "to_world",
            [](const Camera& c, py::handle pixel) {
                const b2Vec2 place = From<b2Vec2>(pixel, "pixel");
                const Vec2 point = c.ToWorld({place.x, place.y});
                return py::make_tuple(point.x, point.y);
            },
            py::arg("pixel"), "Converts a point of the picture [px, y down] to the world [m].")
        .def(
            "__eq__", [](const Camera& a, const Camera& b) { return a == b; }, py::is_operator())
        .def("__repr__", [](const Camera& c) {
            return "Camera(width=" + std::to_string(c.width) +
                   ", height=" + std::to_string(c.height) + ", center=(" +
                   std::string(py::str(py::float_(c.centerX))) + ", " +
                   std::string(py::str(py::float_(c.centerY))) +
                   "), pixelsPerMeter=" + std::string(py::str(py::float_(c.pixelsPerMeter))) + ")";
        });
    Copies(
        type,
        [](const Camera& c) {
            return py::make_tuple(c.width, c.height, c.centerX, c.centerY, c.pixelsPerMeter);
        },
        [](const py::tuple& s) {
            return Camera{From<int32>(s[0], "width"), From<int32>(s[1], "height"),
                          From<double>(s[2], "center"), From<double>(s[3], "center"),
                          From<double>(s[4], "pixelsPerMeter")};
        });
    module.def("_fit", [](py::handle world, int width, int height, double margin) {
        return FitTo(BoundsAtStart(WorldFrom(world, "world").world), width, height, margin);
    });
}

bool IsIterable(py::handle value)
{
    return py::isinstance<py::iterable>(value) && !py::isinstance<py::str>(value);
}

py::iterable Iterate(py::handle value, const char* name, const char* expected)
{
    if (!IsIterable(value))
    {
        ThrowType(name, expected, value);
    }
    return py::reinterpret_borrow<py::iterable>(value);
}

void WriteFigure(py::handle world, const std::string& path, const Camera& camera,
                 const std::string& theme, double scale, const Look& look, bool overwrite)
{
    Figure figure =
        FigureOf(ListOf(WorldFrom(world, "world"), camera, look), camera, ThemeFrom(theme));
    figure.scale = scale;
    const Result<void> result = [&] {
        const WithoutLock unlocked;
        return path.ends_with(".pdf") ? WritePdf(path, figure, {overwrite})
                                      : WriteSvg(path, figure, {overwrite});
    }();
    Need(result);
}

template <class Names>
py::tuple TupleOf(const Names& names)
{
    py::list words;
    for (const auto& name : names)
    {
        words.append(py::str(std::string(name)));
    }
    return words;
}

} // namespace

void RequireThreadsOfPictures()
{
    RequireProcess(g_filmed, "picture");
    g_drew = g_drew == 0 ? ::getpid() : g_drew;
}

void RequireThreadsOfFilms()
{
    RequireProcess(g_drew, "film");
    g_drew = g_drew == 0 ? ::getpid() : g_drew;
    g_filmed = g_filmed == 0 ? ::getpid() : g_filmed;
}

void ThrowError(const Error& error)
{
    const py::object raised = py::handle(g_error)(error.Text(kKeywords));
    raised.attr("kind") = KindName(error.kind);
    raised.attr("culprit") = error.culprit.Text(kKeywords);
    raised.attr("problem") = error.problem.Text(kKeywords);
    raised.attr("remedy") = error.remedy.Text(kKeywords);
    PyErr_SetObject(g_error, raised.ptr());
    throw py::error_already_set();
}

void ThrowNotOneOf(const char* argument, const std::string& word,
                   const std::vector<std::string>& words)
{
    ThrowMisuse(NotOneOf(argument, word, words).Text());
}

Theme ThemeFrom(const std::string& name)
{
    if (const std::optional<Theme> theme = FindTheme(name))
    {
        return *theme;
    }
    ThrowNotOneOf("theme", name, {ThemeNames().begin(), ThemeNames().end()});
}

Rect GroundBelow(const b2World& world)
{
    struct FirstStatic final : b2RayCastCallback
    {
        float32 ReportFixture(b2Fixture* fixture, const b2Vec2& point, const b2Vec2&,
                              float32 fraction) override
        {
            if (fixture->IsSensor() || fixture->GetBody()->GetType() != b2_staticBody)
            {
                return -1.0f;
            }
            place = point;
            return fraction;
        }

        std::optional<b2Vec2> place;
    };

    b2Vec2 down = world.GetGravity();
    Rect bounds;
    if (down.Normalize() == 0.0f)
    {
        return bounds;
    }
    const Rect scene = BoundsAtStart(world);
    const float32 reach =
        10.0f * std::max(scene.upper.x - scene.lower.x, scene.upper.y - scene.lower.y);
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        const b2Vec2 from = body->GetWorldCenter();
        const b2Vec2 to = from + reach * down;
        if (body->GetType() == b2_dynamicBody && body->IsActive() && from.IsValid() &&
            to.IsValid() && from != to)
        {
            FirstStatic ray;
            world.RayCast(&ray, from, to);
            if (ray.place)
            {
                bounds.Include(Vec2{ray.place->x, ray.place->y});
            }
        }
    }
    return bounds;
}

Look LookFrom(py::handle layers, py::handle trails)
{
    Look look;
    if (!layers.is_none())
    {
        look.layers = LayerSet::None();
        for (const py::handle each : Iterate(layers, "layers", "a list of names"))
        {
            const auto name = From<std::string>(py::str(each), "layers");
            const std::optional<DrawLayer> layer = FindLayer(name);
            if (!layer)
            {
                ThrowNotOneOf("layers", name, LayerNames());
            }
            look.layers[*layer] = true;
        }
    }
    if (!trails.is_none())
    {
        for (const py::handle trail : Iterate(trails, "trails", "a list of paths"))
        {
            if (IsVec2(trail) || !IsIterable(trail))
            {
                const std::string name = "trails[" + std::to_string(look.trails.size()) + "]";
                ThrowType(name.c_str(),
                          "a path, which is a list of points (for one path: trails=[path])", trail);
            }
            std::vector<Vec2>& points = look.trails.emplace_back();
            for (const b2Vec2& point : From<std::vector<b2Vec2>>(trail, "trails"))
            {
                points.push_back({point.x, point.y});
            }
        }
    }
    return look;
}

std::string NameFrom(py::handle name)
{
    return From<std::string>(py::str(name), "name");
}

BodyNames NamesOf(WorldObject& world)
{
    BodyNames names;
    for (const py::handle object : world.BodyObjects())
    {
        const py::object name = py::getattr(object, "name", py::none());
        if (!name.is_none()) // reading it may have destroyed the body
        {
            names[std::uint32_t(object.cast<BodyHandle&>().Get().GetNumber())] = NameFrom(name);
        }
    }
    return names;
}

DrawList ListOf(WorldObject& world, const Camera& camera, const Look& look, double zoom)
{
    world.RequireUnlocked("drawing");
    DrawList list;
    for (std::size_t i = 0; i < look.trails.size(); ++i)
    {
        AddTrail(list, camera, look.trails[i], {.color = TrailColor(i)});
    }
    // Which contact points are new is not known here, so none are drawn as new.
    LayerCollector collector(look.layers, {}, kStepsPerSecond, world.world);
    collector.BeforeStep(world.world);
    const BodyNames names = look.layers[DrawLayer::Labels] ? NamesOf(world) : BodyNames();
    const JointNames jointNames =
        look.layers[DrawLayer::Labels] ? NamesOfJoints(world) : JointNames();
    View view = ViewOfEverything(camera);
    view.zoom = zoom;
    collector.Collect(world.world, view, names, jointNames, list);
    return list;
}

Camera CameraFrom(py::handle camera, WorldObject& world, int width, int height)
{
    if (camera.is_none())
    {
        return FitTo(BoundsAtStart(world.world), width, height);
    }
    if (!py::isinstance<Camera>(camera))
    {
        ThrowType("camera", "a boxreel.Camera", camera);
    }
    const Camera& view = camera.cast<Camera&>();
    if (view.width != width || view.height != height)
    {
        ThrowMisuse("camera: its size must be that of the picture, " + std::to_string(width) +
                    " x " + std::to_string(height));
    }
    return view;
}

py::array ArrayOf(Frame&& frame)
{
    auto owner = std::make_unique<Frame>(std::move(frame));
    const Frame& pixels = *owner;
    const py::capsule base(owner.release(),
                           [](void* memory) { delete static_cast<Frame*>(memory); });
    const std::vector<py::ssize_t> shape = {pixels.height, pixels.width, 4};
    return py::array(py::dtype::of<std::uint8_t>(), shape, pixels.rgba.data(), base);
}

Frame FrameFrom(py::handle array)
{
    if (!py::isinstance<py::array>(array) || !py::isinstance<py::array_t<std::uint8_t>>(array))
    {
        ThrowType("pixels", "an array of uint8", array);
    }
    const auto pixels =
        py::array_t<std::uint8_t, py::array::c_style | py::array::forcecast>::ensure(array);
    if (pixels.ndim() != 3 || (pixels.shape(2) != 3 && pixels.shape(2) != 4))
    {
        ThrowMisuse("pixels: expected the shape (height, width, 3) or (height, width, 4)");
    }
    Frame frame(static_cast<int>(pixels.shape(1)), static_cast<int>(pixels.shape(0)));
    const std::size_t count = frame.rgba.size() / 4;
    const std::uint8_t* from = pixels.data();
    if (pixels.shape(2) == 4)
    {
        std::memcpy(frame.rgba.data(), from, frame.rgba.size());
        return frame;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
        std::memcpy(frame.rgba.data() + 4 * i, from + 3 * i, 3);
        frame.rgba[4 * i + 3] = 255;
    }
    return frame;
}

void BindPictures(py::module_& module)
{
    module.attr("_layers") = TupleOf(LayerNames());
    module.attr("_themes") = TupleOf(ThemeNames());
    py::dict members;
    for (const char* const name : {"kind", "culprit", "problem", "remedy"})
    {
        members[name] = "";
    }
    g_error = PyErr_NewExceptionWithDoc("boxreel.Error",
                                        "A file, codec or driver that cannot be used. The text "
                                        "names it and the remedy. `kind` is unusable (wrong "
                                        "name or settings), different, absent (a library) or "
                                        "failed (reading or writing). `culprit` is the argument "
                                        "or file at fault. `problem` and `remedy` may be empty.",
                                        PyExc_RuntimeError, members.ptr());
    module.attr("Error") = py::handle(g_error);
    BindCamera(module);
    py::class_<PictureRenderer>(module, "_Renderer")
        .def(py::init<int, int, const std::string&, double>())
        .def("draw",
             [](PictureRenderer& self, py::handle world, const Camera& camera, py::handle layers,
                py::handle trails) {
                 return ArrayOf(
                     self.Draw(WorldFrom(world, "world"), camera, LookFrom(layers, trails)));
             })
        .def_property_readonly("description", [](const PictureRenderer& self) {
            return self.renderer->Description();
        });
    module.def("_camera", [](py::handle camera, py::handle world, int width, int height) {
        return CameraFrom(camera, WorldFrom(world, "world"), width, height);
    });
    module.def("_figure", [](py::handle world, const std::string& path, const Camera& camera,
                             const std::string& theme, double scale, py::handle layers,
                             py::handle trails, bool overwrite) {
        WriteFigure(world, path, camera, theme, scale, LookFrom(layers, trails), overwrite);
    });
    module.def("_svg", [](py::handle world, const Camera& camera, const std::string& theme) {
        const Look look = LookFrom(py::none(), py::none());
        return Need(ToSvg(
            FigureOf(ListOf(WorldFrom(world, "world"), camera, look), camera, ThemeFrom(theme))));
    });
    module.def("_png", [](py::handle pixels) {
        const Frame frame = FrameFrom(pixels);
        const Result<std::vector<std::uint8_t>> bytes = [&] {
            const WithoutLock unlocked;
            return EncodePng(frame);
        }();
        const std::vector<std::uint8_t> png = Need(bytes);
        return py::bytes(reinterpret_cast<const char*>(png.data()), png.size());
    });
    module.def("_text",
               [](py::handle text, const char* name) { return From<std::string>(text, name); });
    module.def("_write_text", [](const std::string& path, const std::string& text) {
        Need(WriteWhole(path, text, true));
    });
    module.def("_error", [](const std::string& culprit, const std::string& problem,
                            const std::string& remedy) {
        ThrowError({ErrorKind::Unusable, culprit, problem, remedy});
    });
    module.def("_write_png", [](const std::string& path, py::handle pixels, bool overwrite) {
        const Frame frame = FrameFrom(pixels);
        const Result<void> result = [&] {
            const WithoutLock unlocked;
            return WritePng(path, frame, {.overwrite = overwrite});
        }();
        Need(result);
    });
    module.def("_read_png", [](const std::string& path) { return ArrayOf(Need(ReadPng(path))); });
    module.def("_state_hash",
               [](py::handle world) { return StateHashText(WorldFrom(world, "world").world); });
}

} // namespace boxreel::python
