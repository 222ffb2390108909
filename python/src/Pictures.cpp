// SPDX-License-Identifier: MIT
#include "Bind.h"
#include "Module.h"
#include "Toolkit.h"

#include <debugdraw/DrawCollector.h>
#include <debugdraw/Trail.h>
#include <debugdraw/WorldBounds.h>
#include <golden/StateHash.h>
#include <render/Figure.h>
#include <render/Png.h>
#include <render/Renderer.h>

#include <cstring>

/// Cameras, pictures and figures of worlds.
namespace boxreel::python
{
namespace
{

PyObject* g_error = nullptr; // boxreel.Error, which lives as long as the process

struct LayerName
{
    const char* name;
    std::uint32_t bit;
};
constexpr LayerName kLayers[] = {{"shapes", b2Draw::e_shapeBit},
                                 {"joints", b2Draw::e_jointBit},
                                 {"boxes", b2Draw::e_aabbBit},
                                 {"pairs", b2Draw::e_pairBit},
                                 {"masses", b2Draw::e_centerOfMassBit}};

std::uint32_t LayerBit(const std::string& name)
{
    std::string known;
    for (const LayerName& layer : kLayers)
    {
        if (name == layer.name)
        {
            return layer.bit;
        }
        known += (known.empty() ? "" : ", ") + std::string(layer.name);
    }
    ThrowMisuse("layers: there is no '" + name + "'; expected some of " + known);
}

/// A renderer for pictures of one size. It owns a GL context, so it belongs to one thread.
struct PictureRenderer
{
    PictureRenderer(int width, int height, const std::string& theme, double scale)
    {
        const Theme colors = ThemeFrom(theme);
        const RendererSettings settings{
            .width = width, .height = height, .theme = colors, .scale = scale};
        const py::gil_scoped_release unlocked;
        Result<Renderer> result = Renderer::Create(settings);
        const py::gil_scoped_acquire locked;
        renderer = std::make_unique<Renderer>(Need(std::move(result)));
    }

    Frame Draw(WorldObject& world, const Camera& camera, const Look& look)
    {
        const DrawList list = ListOf(world, camera, look);
        Frame frame;
        const Result<void> result = [&] {
            const py::gil_scoped_release unlocked;
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
        .def("__eq__", [](const Camera& a, const Camera& b) { return a == b; })
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

void WriteFigure(py::handle world, const std::string& path, const Camera& camera,
                 const std::string& theme, double scale, const Look& look, bool overwrite)
{
    Figure figure =
        FigureOf(ListOf(WorldFrom(world, "world"), camera, look), camera, ThemeFrom(theme));
    figure.scale = scale;
    const Result<void> result = [&] {
        const py::gil_scoped_release unlocked;
        return path.ends_with(".pdf") ? WritePdf(path, figure, {overwrite})
                                      : WriteSvg(path, figure, {overwrite});
    }();
    Need(result);
}

} // namespace

void ThrowError(const Error& error)
{
    PyErr_SetString(g_error, error.Text().c_str());
    throw py::error_already_set();
}

Theme ThemeFrom(const std::string& name)
{
    if (const std::optional<Theme> theme = FindTheme(name))
    {
        return *theme;
    }
    std::string known;
    for (const std::string_view each : ThemeNames())
    {
        known += (known.empty() ? "" : ", ") + std::string(each);
    }
    ThrowMisuse("theme: there is no '" + name + "'; expected one of " + known);
}

Look LookFrom(py::handle layers, py::handle trails)
{
    Look look{0, {}};
    if (layers.is_none())
    {
        look.layers = b2Draw::e_shapeBit | b2Draw::e_jointBit;
    }
    else
    {
        for (const py::handle name : py::reinterpret_borrow<py::iterable>(layers))
        {
            look.layers |= LayerBit(py::str(name));
        }
    }
    if (!trails.is_none())
    {
        for (const py::handle trail : py::reinterpret_borrow<py::iterable>(trails))
        {
            std::vector<Vec2>& points = look.trails.emplace_back();
            for (const b2Vec2& point : From<std::vector<b2Vec2>>(trail, "trails"))
            {
                points.push_back({point.x, point.y});
            }
        }
    }
    return look;
}

DrawList ListOf(WorldObject& world, const Camera& camera, const Look& look)
{
    world.RequireUnlocked("drawing");
    DrawList list;
    for (std::size_t i = 0; i < look.trails.size(); ++i)
    {
        AddTrail(list, camera, look.trails[i], {.color = TrailColor(i)});
    }
    DrawCollector collector(list);
    collector.SetFlags(look.layers);
    world.world.SetDebugDraw(&collector);
    world.world.DrawDebugData();
    world.world.SetDebugDraw(nullptr);
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
    g_error = PyErr_NewExceptionWithDoc(
        "boxreel.Error",
        "A file, codec or driver that cannot be used. The text names it and the remedy.",
        PyExc_RuntimeError, nullptr);
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
            const py::gil_scoped_release unlocked;
            return EncodePng(frame);
        }();
        const std::vector<std::uint8_t> png = Need(bytes);
        return py::bytes(reinterpret_cast<const char*>(png.data()), png.size());
    });
    module.def("_write_png", [](const std::string& path, py::handle pixels, bool overwrite) {
        const Frame frame = FrameFrom(pixels);
        const Result<void> result = [&] {
            const py::gil_scoped_release unlocked;
            return WritePng(path, frame, {.overwrite = overwrite});
        }();
        Need(result);
    });
    module.def("_read_png", [](const std::string& path) { return ArrayOf(Need(ReadPng(path))); });
    module.def("_state_hash",
               [](py::handle world) { return StateHashText(WorldFrom(world, "world").world); });
}

} // namespace boxreel::python
