// SPDX-License-Identifier: MIT
#include "Definitions.h"
#include "Module.h"
#include "WorldObject.h"

#include <pybind11/numpy.h>

#include <algorithm>
#include <chrono>

/// The class b2World.
namespace boxreel::python
{
namespace
{

using Class = py::class_<WorldObject>;

/// Queries with a callback object of Python.
struct Query final : b2QueryCallback, b2RayCastCallback
{
    Query(WorldObject& owner, py::object report) : world(owner), function(std::move(report)) {}

    bool ReportFixture(b2Fixture* fixture) override
    {
        bool goesOn = false;
        world.Call([&] {
            goesOn = From<bool>(function(Wrap(world, fixture)), "result of ReportFixture");
        });
        return goesOn;
    }

    float32 ReportFixture(b2Fixture* fixture, const b2Vec2& point, const b2Vec2& normal,
                          float32 fraction) override
    {
        float32 result = 0.0f;
        world.Call([&] {
            result = From<float32>(
                function(Wrap(world, fixture), b2Vec2(point), b2Vec2(normal), fraction),
                "result of ReportFixture");
        });
        return result;
    }

    WorldObject& world;
    py::object function;
};

/// Returns the function of a callback object, or the callback itself if it is a function.
py::object ReportOf(const py::object& callback)
{
    if (py::hasattr(callback, "ReportFixture"))
    {
        return callback.attr("ReportFixture");
    }
    if (PyCallable_Check(callback.ptr()) == 0)
    {
        ThrowType("callback", "an object with a function ReportFixture", callback);
    }
    return callback;
}

void QueryAABB(WorldObject& self, const py::object& callback, py::handle aabb)
{
    const b2AABB box = From<b2AABB>(aabb, "aabb");
    self.RequireThread();
    if (!box.IsValid())
    {
        ThrowMisuse("aabb: the bounds must be finite and sorted");
    }
    Query query(self, ReportOf(callback));
    {
        const WorldObject::Use use(self);
        self.world.QueryAABB(&query, box);
    }
    self.Finish();
}

void RayCast(WorldObject& self, const py::object& callback, py::handle point1, py::handle point2)
{
    const b2Vec2 p1 = From<b2Vec2>(point1, "point1");
    const b2Vec2 p2 = From<b2Vec2>(point2, "point2");
    self.RequireThread();
    if (!p1.IsValid() || !p2.IsValid())
    {
        ThrowMisuse("b2World.RayCast: both points must be finite");
    }
    Query query(self, ReportOf(callback));
    {
        const WorldObject::Use use(self);
        self.world.RayCast(&query, p1, p2);
    }
    self.Finish();
}

template <class Object, class WrapItem>
py::list ListOf(Object* first, int32 count, WrapItem wrap)
{
    const WithoutCollector wholeList;
    py::list items(count);
    for (Object* object = first; object != nullptr; object = object->GetNext())
    {
        items[static_cast<std::size_t>(--count)] =
            wrap(object); // the engine's list begins with the newest
    }
    return items;
}

py::list BodiesOf(WorldObject& self)
{
    self.RequireThread();
    return self.BodyObjects();
}

/// Writes x, y [m] and angle [rad] of each body, in the order of creation, into `out` or a new
/// array.
py::array_t<float32> PosesOf(WorldObject& self, const py::object& out)
{
    self.RequireThread();
    py::array_t<float32> poses;
    if (out.is_none())
    {
        do // the first array imports NumPy, which lets other threads run
        {
            poses = py::array_t<float32>({py::ssize_t(self.world.GetBodyCount()), py::ssize_t(3)});
        } while (poses.shape(0) != self.world.GetBodyCount());
        self.RequireThread();
    }
    else
    {
        if (!py::isinstance<py::array_t<float32>>(out))
        {
            ThrowType("out", "an array of float32", out);
        }
        const py::ssize_t count = self.world.GetBodyCount();
        poses = py::reinterpret_borrow<py::array_t<float32>>(out);
        if (poses.ndim() != 2 || poses.shape(0) != count || poses.shape(1) != 3 ||
            (poses.flags() & py::array::c_style) == 0)
        {
            ThrowMisuse("out: expected a contiguous array of the shape (" + std::to_string(count) +
                        ", 3)");
        }
    }
    float32* row = poses.mutable_data();
    const std::vector<b2Body*>& bodies = self.Bodies();
    constexpr std::size_t kAhead = 8; // bodies are far apart in memory
    for (std::size_t i = 0; i < bodies.size(); ++i, row += 3)
    {
        __builtin_prefetch(&bodies[std::min(i + kAhead, bodies.size() - 1)]->GetPosition());
        const b2Vec2& position = bodies[i]->GetPosition();
        row[0] = position.x;
        row[1] = position.y;
        row[2] = bodies[i]->GetAngle();
    }
    return poses;
}

template <class Value>
void Setting(Class& type, const char* name, Value (b2World::*get)() const,
             void (b2World::*set)(Value), const char* doc)
{
    type.def_property(
        name,
        [get](const WorldObject& self) {
            self.RequireThread();
            return (self.world.*get)();
        },
        [set, name](WorldObject& self, py::handle value) {
            const Value argument = From<Value>(value, name);
            self.RequireThread();
            (self.world.*set)(argument);
            CheckMisuse();
        },
        doc);
}

template <class Value>
void Fact(Class& type, const char* name, Value (b2World::*get)() const, const char* doc)
{
    type.def_property_readonly(
        name,
        [get](const WorldObject& self) {
            self.RequireThread();
            return (self.world.*get)();
        },
        doc);
}

void BindSettings(Class& type)
{
    type.def_property(
        "gravity", [](const WorldObject& self) { return self.world.GetGravity(); },
        [](WorldObject& self, py::handle value) {
            const b2Vec2 gravity = From<b2Vec2>(value, "gravity");
            self.RequireThread();
            self.world.SetGravity(gravity);
            CheckMisuse();
        },
        "Acceleration of all dynamic bodies [m/s^2].");
    Setting(type, "allowSleeping", &b2World::GetAllowSleeping, &b2World::SetAllowSleeping,
            "True if bodies may fall asleep.");
    Setting(type, "warmStarting", &b2World::GetWarmStarting, &b2World::SetWarmStarting,
            "True if the impulses of a step initialize the next.");
    Setting(type, "continuousPhysics", &b2World::GetContinuousPhysics,
            &b2World::SetContinuousPhysics, "True if continuous collision is enabled.");
    Setting(type, "subStepping", &b2World::GetSubStepping, &b2World::SetSubStepping,
            "True if a step ends at its first time of impact.");
    Setting(type, "autoClearForces", &b2World::GetAutoClearForces, &b2World::SetAutoClearForces,
            "True if forces last for one step only.");
    Setting(type, "subStepCount", &b2World::GetSubStepCount, &b2World::SetSubStepCount,
            "Sub-steps per step, 1 to 64.");
    Setting(type, "threadCount", &b2World::GetThreadCount, &b2World::SetThreadCount,
            "Threads of a step, 1 to 64. Results are the same for every number.");
    Setting(type, "restitutionThreshold", &b2World::GetRestitutionThreshold,
            &b2World::SetRestitutionThreshold, "Slower impacts do not bounce [m/s].");
    Fact(type, "locked", &b2World::IsLocked,
         "True inside a callback. Nothing can be created or destroyed then.");
    Fact(type, "bodyCount", &b2World::GetBodyCount, "Number of bodies.");
    Fact(type, "jointCount", &b2World::GetJointCount, "Number of joints.");
    Fact(type, "contactCount", &b2World::GetContactCount, "Number of contacts, touching or not.");
    Fact(type, "proxyCount", &b2World::GetProxyCount, "Number of boxes in the broad phase.");
    Fact(type, "treeHeight", &b2World::GetTreeHeight, "Height of the broad phase's highest tree.");
    Fact(type, "treeBalance", &b2World::GetTreeBalance, "Maximum balance of the trees.");
    Fact(type, "treeQuality", &b2World::GetTreeQuality, "Ratio of the areas of the trees.");
    type.def_property(
            "contactListener", [](const WorldObject& self) { return self.contactListener; },
            &WorldObject::SetContactListener, "The b2ContactListener, or None.")
        .def_property(
            "contactFilter", [](const WorldObject& self) { return self.contactFilter; },
            &WorldObject::SetContactFilter, "The b2ContactFilter, or None for the default.")
        .def_property(
            "destructionListener", [](const WorldObject& self) { return self.destructionListener; },
            &WorldObject::SetDestructionListener, "The b2DestructionListener, or None.")
        .def_property(
            "renderer", [](const WorldObject& self) { return self.renderer; },
            &WorldObject::SetRenderer, "The b2Draw that DrawDebugData calls, or None.");
}

py::object CreateBody(WorldObject& self, const py::dict& fields)
{
    const b2BodyDef def = BodyDefFrom(fields);
    self.RequireUnlocked("b2World.CreateBody");
    self.bodies.clear();
    b2Body* body = self.world.CreateBody(&def);
    CheckMisuse();
    const py::object result = Wrap(self, body);
    result.attr("userData") =
        fields.contains("userData") ? py::object(fields["userData"]) : py::none();
    return result;
}

py::object CreateJoint(WorldObject& self, const std::string& name, const py::dict& fields)
{
    b2Joint* joint = CreateJointFrom(self, name, fields);
    if (joint == nullptr)
    {
        ThrowMisuse(name + ": the engine cannot create this joint");
    }
    const py::object result = Wrap(self, joint);
    result.attr("userData") =
        fields.contains("userData") ? py::object(fields["userData"]) : py::none();
    return result;
}

void BindActions(Class& type)
{
    type.def(
            "Step",
            [](WorldObject& self, py::handle timeStep, py::handle velocity, py::handle position) {
                self.Step(From<float32>(timeStep, "timeStep"),
                          From<int32>(velocity, "velocityIterations"),
                          From<int32>(position, "positionIterations"));
            },
            py::arg("timeStep"), py::arg("velocityIterations"), py::arg("positionIterations"),
            "Advances the simulation by timeStep [s]; 8 and 3 iterations are typical.")
        .def(
            "ClearForces",
            [](WorldObject& self) {
                self.RequireThread();
                self.world.ClearForces();
            },
            "Clears all forces and torques.")
        .def(
            "DrawDebugData",
            [](WorldObject& self) {
                self.RequireUnlocked("b2World.DrawDebugData");
                if (!self.renderer.is_none())
                {
                    DrawWith(self, self.renderer);
                }
            },
            "Draws the world with the renderer.")
        .def("_create_body", CreateBody)
        .def("_create_joint", CreateJoint)
        .def("DestroyBody", &WorldObject::DestroyBody, py::arg("body"),
             "Destroys a body with its fixtures, joints and contacts. They cannot be used "
             "afterwards.")
        .def("DestroyJoint", &WorldObject::DestroyJoint, py::arg("joint"),
             "Destroys a joint. It cannot be used afterwards.")
        .def("QueryAABB", QueryAABB, py::arg("callback"), py::arg("aabb"),
             "Reports each fixture whose box overlaps: callback.ReportFixture(fixture) returns "
             "False to end.")
        .def("RayCast", RayCast, py::arg("callback"), py::arg("point1"), py::arg("point2"),
             "Reports each fixture that a ray hits: callback.ReportFixture(fixture, point, normal, "
             "fraction) "
             "returns -1 to ignore it, 0 to end, fraction to clip the ray, 1 to go on.")
        .def(
            "ShiftOrigin",
            [](WorldObject& self, py::handle origin) {
                const b2Vec2 place = From<b2Vec2>(origin, "newOrigin");
                self.RequireUnlocked("b2World.ShiftOrigin");
                self.world.ShiftOrigin(place);
                CheckMisuse();
            },
            py::arg("newOrigin"), "Makes this point [m] the origin of the world.")
        .def("poses", PosesOf, py::arg("out") = py::none(),
             "Returns x, y [m] and angle [rad] of each body, in the order of world.bodies, as an "
             "array (n, 3) of "
             "float32. `out` is an array to write into.")
        .def("_save", &WorldObject::Save)
        .def("_restore", &WorldObject::Restore)
        .def(
            "Dump", [](WorldObject& self) { self.world.Dump(); },
            "Writes the world as code of C++ to standard output.");
}

} // namespace

void BindWorld(py::module_& module)
{
    py::class_<b2Profile> profile(module, "b2Profile", "Timing of the last step [ms].");
    profile.def_readonly("step", &b2Profile::step, "Total [ms].")
        .def_readonly("collide", &b2Profile::collide, "Updating contacts [ms].")
        .def_readonly("solve", &b2Profile::solve, "Velocities and positions [ms].")
        .def_readonly("solveInit", &b2Profile::solveInit, "Preparing constraints [ms].")
        .def_readonly("solveVelocity", &b2Profile::solveVelocity, "Velocities [ms].")
        .def_readonly("solvePosition", &b2Profile::solvePosition, "Positions [ms].")
        .def_readonly("broadphase", &b2Profile::broadphase, "Finding pairs [ms].")
        .def_readonly("solveTOI", &b2Profile::solveTOI, "Continuous collision [ms].");

    Class type(module, "b2World", py::dynamic_attr(), WorldTraversal(),
               "A world: it owns bodies and joints, steps them and answers queries.");
    type.def(py::init([](py::handle gravity, bool doSleep) {
                 auto world =
                     std::make_unique<WorldObject>(From<b2Vec2>(gravity, "gravity"), doSleep);
                 CheckMisuse();
                 return world;
             }),
             py::arg("gravity") = py::make_tuple(0.0, -10.0), py::arg("doSleep") = true);
    BindSettings(type);
    BindActions(type);
    type.attr("DebugDraw") = type.attr("DrawDebugData");
    type.def_property_readonly("bodies", BodiesOf, "The bodies, in the order of creation.")
        .def_property_readonly(
            "joints",
            [](WorldObject& self) {
                self.RequireThread();
                return ListOf(self.world.GetJointList(), self.world.GetJointCount(),
                              [&](b2Joint* j) { return Wrap(self, j); });
            },
            "The joints, in the order of creation.")
        .def_property_readonly(
            "contacts",
            [](WorldObject& self) {
                self.RequireThread();
                return ListOf(self.world.GetContactList(), self.world.GetContactCount(),
                              [&](b2Contact* c) { return WrapContact(self, c); });
            },
            "The contacts, touching or not.")
        .def_property_readonly(
            "profile", [](const WorldObject& self) { return self.world.GetProfile(); },
            "Timing of the last step. The first use enables it.")
        .def("__iter__", [](WorldObject& self) { return py::iter(BodiesOf(self)); })
        .def("__contains__", [](const WorldObject& self, py::handle item) {
            return (py::isinstance<BodyHandle>(item) && item.cast<BodyHandle&>().world == &self) ||
                   (py::isinstance<JointHandle>(item) && item.cast<JointHandle&>().world == &self);
        });
    // For tests/benchmark/python_speed.py: the mean time of a step without Python [s].
    module.def("_time_steps", [](WorldObject& self, int count) {
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < count; ++i)
        {
            self.world.Step(1.0f / 60.0f, 8, 3);
        }
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() /
               count;
    });
    module.def("_should_collide", [](FixtureHandle& a, FixtureHandle& b) {
        return b2ContactFilter().ShouldCollide(&a.Get(), &b.Get());
    });
}

} // namespace boxreel::python
