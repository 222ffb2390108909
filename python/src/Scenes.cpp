// SPDX-License-Identifier: MIT
#include "Module.h"
#include "Toolkit.h"

#include <rube/RubeExport.h>
#include <rube/RubeFile.h>
#include <rube/RubeWriter.h>
#include <scenes/Scene.h>

#include <pybind11/stl.h>

/// The program's scenes and scene files, as snapshots that a world of Python is restored from.
namespace boxreel::python
{
namespace
{

/// Returns the snapshot of a scene's world, its names of bodies by number, and its preferred steps.
py::tuple SnapshotOf(Scene& scene)
{
    const std::vector<uint8> bytes = b2SaveSnapshot(scene.World());
    py::dict names;
    for (const auto& [number, name] : scene.Names())
    {
        names[py::int_(number)] = name;
    }
    const StepSettings steps = scene.PreferredSteps();
    return py::make_tuple(
        py::bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size()), names,
        py::make_tuple(steps.timeStep, steps.velocityIterations, steps.positionIterations));
}

py::list TextsOf(const RubeNotes& notes)
{
    py::list texts;
    for (const RubeNote& note : notes)
    {
        texts.append(note.Text());
    }
    return texts;
}

} // namespace

void BindScenes(py::module_& module)
{
    module.def("_scenes", [] {
        py::dict scenes;
        for (const SceneEntry& entry : AllScenes())
        {
            scenes[entry.name] = entry.summary;
        }
        return scenes;
    });
    module.def("_scene", [](const std::string& name, py::handle number) {
        const uint32 seed = From<uint32>(number, "seed");
        for (const SceneEntry& entry : AllScenes())
        {
            if (name == entry.name)
            {
                return SnapshotOf(*entry.create({seed}));
            }
        }
        throw py::key_error(name);
    });
    module.def("_load_rube", [](const std::string& path) {
        RubeNotes leftOut;
        const std::unique_ptr<Scene> scene = Need(LoadRubeScene(path, leftOut));
        return py::make_tuple(SnapshotOf(*scene), TextsOf(leftOut));
    });
    module.def("_rube_text", [](py::handle world) {
        WorldObject& self = WorldFrom(world, "world");
        self.RequireUnlocked("writing a scene file");
        RubeNotes leftOut;
        const std::string text = WriteRubeText(ExportWorld(self.world, NamesOf(self), {}, leftOut));
        return py::make_tuple(text, TextsOf(leftOut));
    });
}

} // namespace boxreel::python
