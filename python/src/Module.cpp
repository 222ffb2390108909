// SPDX-License-Identifier: MIT
#include "Module.h"

#include "Convert.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdlib>

/// The module _boxreel. The packages Box2D and boxreel are what programs import.
namespace boxreel::python
{
namespace
{

/// Statistics of the engine by the names of the 2.3 generation, which programs read and set to 0.
template <class Number>
void BindCounter(py::dict& counters, const char* name, Number& counter)
{
    counters[name] = py::make_tuple(py::cpp_function([&counter] { return counter; }),
                                    py::cpp_function([&counter, name](py::handle value) {
                                        counter = From<Number>(value, name);
                                    }));
}

void BindCounters(py::module_& module)
{
    py::dict counters;
    BindCounter(counters, "b2_gjkCalls", b2_gjkCalls);
    BindCounter(counters, "b2_gjkIters", b2_gjkIters);
    BindCounter(counters, "b2_gjkMaxIters", b2_gjkMaxIters);
    BindCounter(counters, "b2_toiCalls", b2_toiCalls);
    BindCounter(counters, "b2_toiIters", b2_toiIters);
    BindCounter(counters, "b2_toiMaxIters", b2_toiMaxIters);
    BindCounter(counters, "b2_toiRootIters", b2_toiRootIters);
    BindCounter(counters, "b2_toiMaxRootIters", b2_toiMaxRootIters);
    BindCounter(counters, "b2_toiTime", b2_toiTime);
    BindCounter(counters, "b2_toiMaxTime", b2_toiMaxTime);
    module.attr("_counters") = counters;
}

void BindConstants(py::module_& module)
{
    const auto number = [&module](const char* name, auto value) { module.attr(name) = value; };
    number("b2_pi", double(b2_pi));
    number("b2_epsilon", double(b2_epsilon));
    number("b2_maxFloat", double(b2_maxFloat));
    number("b2_maxManifoldPoints", b2_maxManifoldPoints);
    number("b2_maxPolygonVertices", b2_polygonCapacity);
    number("b2_aabbExtension", double(b2_aabbExtension));
    number("b2_aabbMultiplier", double(b2_aabbMultiplier));
    number("b2_linearSlop", double(b2_linearSlop));
    number("b2_angularSlop", double(b2_angularSlop));
    number("b2_polygonRadius", double(b2_polygonRadius));
    number("b2_maxSubSteps", b2_maxSubSteps);
    number("b2_maxTOIContacts", b2_maxTOIContacts);
    number("b2_velocityThreshold", double(b2_velocityThreshold));
    number("b2_maxLinearCorrection", double(b2_maxLinearCorrection));
    number("b2_maxAngularCorrection", double(b2_maxAngularCorrection));
    number("b2_maxTranslation", double(b2_maxTranslation));
    number("b2_maxTranslationSquared", double(b2_maxTranslationSquared));
    number("b2_maxRotation", double(b2_maxRotation));
    number("b2_maxRotationSquared", double(b2_maxRotationSquared));
    number("b2_baumgarte", double(b2_baumgarte));
    number("b2_toiBaugarte", double(b2_toiBaugarte));
    number("b2_timeToSleep", double(b2_timeToSleep));
    number("b2_linearSleepTolerance", double(b2_linearSleepTolerance));
    number("b2_angularSleepTolerance", double(b2_angularSleepTolerance));
    number("b2_minPulleyLength", double(b2_minPulleyLength));
    number("b2_chunkSize", b2_chunkSize);
    number("b2_chunkArrayIncrement", 128); // only a name: this allocator has a list of chunks
    number("b2_maxBlockSize", b2_maxBlockSize);
    number("b2_blockSizes", b2_blockSizes);
    number("b2_stackSize", b2_stackSize);
    number("b2_maxStackEntries", b2_maxStackEntries);
    number("b2_nullFeature", int(b2_nullFeature));
    number("b2_staticBody", int(b2_staticBody));
    number("b2_kinematicBody", int(b2_kinematicBody));
    number("b2_dynamicBody", int(b2_dynamicBody));
    number("b2_nullState", int(b2_nullState));
    number("b2_addState", int(b2_addState));
    number("b2_persistState", int(b2_persistState));
    number("b2_removeState", int(b2_removeState));
    number("e_unknownJoint", int(e_unknownJoint));
    number("e_revoluteJoint", int(e_revoluteJoint));
    number("e_prismaticJoint", int(e_prismaticJoint));
    number("e_distanceJoint", int(e_distanceJoint));
    number("e_pulleyJoint", int(e_pulleyJoint));
    number("e_mouseJoint", int(e_mouseJoint));
    number("e_gearJoint", int(e_gearJoint));
    number("e_wheelJoint", int(e_wheelJoint));
    number("e_weldJoint", int(e_weldJoint));
    number("e_frictionJoint", int(e_frictionJoint));
    number("e_ropeJoint", int(e_ropeJoint));
    number("e_motorJoint", int(e_motorJoint));
    number("e_inactiveLimit", int(e_inactiveLimit));
    number("e_atLowerLimit", int(e_atLowerLimit));
    number("e_atUpperLimit", int(e_atUpperLimit));
    number("e_equalLimits", int(e_equalLimits));
    number("_toi_states",
           py::make_tuple(int(b2TOIOutput::e_unknown), int(b2TOIOutput::e_failed),
                          int(b2TOIOutput::e_overlapped), int(b2TOIOutput::e_touching),
                          int(b2TOIOutput::e_separated)));
}

} // namespace
} // namespace boxreel::python

PYBIND11_MODULE(_boxreel, module)
{
    using namespace boxreel::python;
    // NumPy is loaded here, where no other thread can be inside. pybind11 would load it at the
    // first array. Other threads would then wait for it while holding the interpreter's lock.
    try
    {
        (void)py::detail::npy_api::get();
    }
    catch (const py::error_already_set&) // not installed: what returns arrays says so
    {}
    module.doc() = "The engine and the toolkit, for the packages Box2D and boxreel.";
    // The classes have the names that programs import them by.
    const py::object own = module.attr("__name__");
    module.attr("__name__") = "Box2D";
    InstallMisuse(module);
    BindConstants(module);
    BindCounters(module);
    BindMath(module);
    BindMathFunctions(module);
    BindShapes(module);
    BindCollision(module);
    BindDefinitions(module);
    BindContacts(module);
    BindBodies(module);
    BindJoints(module);
    BindWorld(module);
    module.attr("__name__") = "boxreel";
    BindPictures(module);
    BindFilms(module);
    BindScenes(module);
    BindGolden(module);
    module.attr("__name__") = own;
    BindHints(module);
    if (std::getenv("BOXREEL_SIGNATURES") == nullptr) // else python/stubs.py reads the signatures
    {
        AddFallbacks(module);
    }
}
