// SPDX-License-Identifier: MIT
#include "Module.h"
#include "Toolkit.h"

#include <golden/Compare.h>
#include <golden/GoldenCheck.h>
#include <golden/GoldenWorld.h>

#include <pybind11/stl.h>

/// Comparison of pictures and golden tests of worlds.
namespace boxreel::python
{
namespace
{

constexpr Word<GoldenAccept> kModes[] = {{"none", GoldenAccept::None},
                                         {"missing", GoldenAccept::Missing},
                                         {"changed", GoldenAccept::Changed},
                                         {"all", GoldenAccept::All},
                                         {"this-renderer", GoldenAccept::ThisRenderer}};

py::dict Compared(py::handle expected, py::handle actual, const std::string& preset)
{
    const CompareSettings settings = Need(CompareSettings::Preset("preset", preset));
    const Frame first = FrameFrom(expected);
    const Frame second = FrameFrom(actual);
    Comparison result = [&] {
        const WithoutLock unlocked;
        return Compare(first, second, settings);
    }();
    py::dict verdict;
    verdict["equal"] = result.equal;
    verdict["text"] = result.Text();
    verdict["differentPixels"] = result.differentPixels;
    verdict["overTolerance"] = result.overTolerance;
    verdict["largestDistance"] = result.largestDistance;
    verdict["difference"] = ArrayOf(std::move(result.difference));
    return verdict;
}

py::tuple Check(py::handle world, const std::string& name, py::handle camera, int width, int height,
                const std::string& preset, const std::string& references, const std::string& output,
                const std::string& accept, std::set<std::string> accepted)
{
    WorldObject& self = WorldFrom(world, "world");
    self.RequireUnlocked("a golden test");
    GoldenWorldLook look{.width = width, .height = height};
    if (!camera.is_none())
    {
        look.camera = CameraFrom(camera, self, width, height);
    }
    const GoldenCandidate candidate = Need(CandidateOf(self.world, name, look));
    const CompareSettings settings = Need(CompareSettings::Preset("preset", preset));
    const GoldenCheckSettings folders{
        .references = references, .output = output, .accept = OneOf("accept", accept, kModes)};
    const GoldenOutcome outcome = [&] {
        const WithoutLock unlocked;
        return CheckGolden(candidate, settings, folders, accepted);
    }();
    return py::make_tuple(outcome.passed, outcome.message, outcome.output, accepted);
}

} // namespace

void BindGolden(py::module_& module)
{
    module.def("_compare", Compared);
    module.def("_check_golden", Check);
}

} // namespace boxreel::python
