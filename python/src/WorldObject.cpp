// SPDX-License-Identifier: MIT
#include "WorldObject.h"

#include <algorithm>

namespace boxreel::python
{
namespace
{

/// Throws TypeError for an object that has none of the functions of a callback.
void RequireCallback(const py::object& object, const char* name, const char* expected,
                     std::initializer_list<const char*> functions)
{
    const auto has = [&object](const char* function) { return py::hasattr(object, function); };
    const bool isUsable =
        !PyType_Check(object.ptr()) && std::any_of(functions.begin(), functions.end(), has);
    if (!object.is_none() && !isUsable)
    {
        ThrowType(name, expected, object);
    }
}

/// True if the object has the function and did not inherit it from the class of this module.
bool Overrides(const py::object& object, const char* function, const char* base)
{
    if (!py::hasattr(object, function))
    {
        return false;
    }
    const py::object method = object.attr(function);
    if (!py::hasattr(method, "__func__"))
    {
        return true;
    }
    const py::object inherited = py::module_::import("Box2D").attr(base).attr(function);
    return !py::object(method.attr("__func__")).is(inherited);
}

template <class Object, class HandleType>
py::object WrapWith(WorldObject& world, Object* object, HandleType* handle, py::object self)
{
    handle->world = &world;
    handle->object = object;
    handle->self = self.ptr();
    handle->number = ++world.handleCount;
    handle->kind = KindOf(*object);
    object->SetUserData(static_cast<HandleBase*>(handle));
    self.inc_ref(); // the engine's
    return self;
}

template <class Object>
py::object WrapPlain(WorldObject& world, Object* object)
{
    if (object == nullptr)
    {
        return py::none();
    }
    if (const HandleBase* known = HandleOf(object))
    {
        return py::reinterpret_borrow<py::object>(known->self);
    }
    auto* handle = new Handle<Object>();
    return WrapWith(world, object, handle,
                    py::cast(handle, py::return_value_policy::take_ownership));
}

void* ValueOf(PyObject* self)
{
    return reinterpret_cast<py::detail::instance*>(self)->get_value_and_holder().value_ptr();
}

int VisitHandle(void* value, visitproc visit, void* arg)
{
    Py_VISIT(static_cast<HandleBase*>(value)->userData.ptr());
    return 0;
}

void ClearHandle(void* value)
{
    static_cast<HandleBase*>(value)->userData = py::none();
}

/// The functions of one class, because slots are plain functions.
template <int (*visitMembers)(void*, visitproc, void*), void (*clearMembers)(void*)>
void Install(PyHeapTypeObject* type)
{
    type->ht_type.tp_traverse = [](PyObject* self, visitproc visit, void* arg) -> int {
        if (void* value = ValueOf(self))
        {
            if (const int result = visitMembers(value, visit, arg))
            {
                return result;
            }
        }
        return py::detail::pybind11_traverse(self, visit, arg);
    };
    type->ht_type.tp_clear = [](PyObject* self) -> int {
        if (void* value = ValueOf(self))
        {
            clearMembers(value);
        }
        return py::detail::pybind11_clear(self);
    };
}

int VisitWorld(void* value, visitproc visit, void* arg)
{
    WorldObject& world = *static_cast<WorldObject*>(value);
    Py_VISIT(world.contactListener.ptr());
    Py_VISIT(world.contactFilter.ptr());
    Py_VISIT(world.destructionListener.ptr());
    Py_VISIT(world.renderer.ptr());
    int result = 0;
    world.ForEachHandle([&](HandleBase& handle) {
        if (result == 0)
        {
            result = visit(handle.self, arg);
        }
    });
    return result;
}

void ClearWorld(void* value)
{
    WorldObject& world = *static_cast<WorldObject*>(value);
    for (py::object* object : {&world.contactListener, &world.contactFilter,
                               &world.destructionListener, &world.renderer})
    {
        const py::object last = std::exchange(*object, py::none());
    }
    world.calls = {};
}

} // namespace

void RequireUsable(const HandleBase& handle, const char* kind)
{
    if (handle.world == nullptr)
    {
        ThrowMisuse(std::string("this ") + kind +
                    " was destroyed, or its world was; it cannot be used");
    }
    if (handle.world->stepper != 0)
    {
        handle.world->RequireThread();
    }
}

py::object Wrap(WorldObject& world, b2Body* body)
{
    return WrapPlain(world, body);
}

py::object Wrap(WorldObject& world, b2Fixture* fixture)
{
    return WrapPlain(world, fixture);
}

py::object Wrap(WorldObject& world, b2Joint* joint)
{
    if (joint == nullptr)
    {
        return py::none();
    }
    if (const HandleBase* known = HandleOf(joint))
    {
        return py::reinterpret_borrow<py::object>(known->self);
    }
    py::object self;
    JointHandle* handle = NewJointHandle(joint->GetType(), self);
    return WrapWith(world, joint, handle, std::move(self));
}

template <>
b2Body* From<b2Body*>(py::handle value, const char* name)
{
    if (value.is_none())
    {
        return nullptr;
    }
    if (!py::isinstance<BodyHandle>(value))
    {
        ThrowType(name, "a b2Body", value);
    }
    return &value.cast<BodyHandle&>().Get();
}

template <>
b2Joint* From<b2Joint*>(py::handle value, const char* name)
{
    if (value.is_none())
    {
        return nullptr;
    }
    if (!py::isinstance<JointHandle>(value))
    {
        ThrowType(name, "a b2Joint", value);
    }
    return &value.cast<JointHandle&>().Get();
}

py::custom_type_setup HandleTraversal()
{
    return py::custom_type_setup(Install<VisitHandle, ClearHandle>);
}

py::custom_type_setup WorldTraversal()
{
    return py::custom_type_setup(Install<VisitWorld, ClearWorld>);
}

WorldObject::WorldObject(const b2Vec2& gravity, bool doSleep)
    : world(gravity, doSleep), link(std::make_shared<WorldLink>(WorldLink{this}))
{
    world.SetDestructionListener(this);
}

WorldObject::~WorldObject()
{
    link->world = nullptr;
    world.SetDestructionListener(nullptr);
    world.SetContactListener(nullptr);
    world.SetContactFilter(nullptr);
    ForEachHandle([this](HandleBase& handle) { Release(handle); });
    failure = nullptr;
    // Code that runs now finds no object of this world.
    for (PyObject* object : std::exchange(released, {}))
    {
        Py_DECREF(object);
    }
}

void WorldObject::RequireThread() const
{
    if (stepper != 0 && stepper != PyThread_get_thread_ident())
    {
        ThrowMisuse("another thread is stepping this world; wait until it is done");
    }
}

void WorldObject::RequireUnlocked(const char* function) const
{
    RequireThread();
    if (isDestroying || world.IsLocked())
    {
        ThrowMisuse(std::string(function) +
                    " must not be called from inside a callback; do it after the step");
    }
}

void WorldObject::Finish()
{
    if (!world.IsLocked() && !isDestroying)
    {
        while (!released.empty())
        {
            for (PyObject* object : std::exchange(released, {}))
            {
                Py_DECREF(object);
            }
        }
        if (failure)
        {
            std::rethrow_exception(std::exchange(failure, nullptr));
        }
    }
    CheckMisuse();
}

const std::vector<b2Body*>& WorldObject::Bodies()
{
    if (bodies.empty())
    {
        bodies.resize(static_cast<std::size_t>(world.GetBodyCount()));
        std::size_t i = bodies.size();
        for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        {
            bodies[--i] = body; // the engine's list begins with the newest
        }
    }
    return bodies;
}

py::list WorldObject::BodyObjects()
{
    const WithoutCollector wholeList;
    const std::vector<b2Body*>& all = Bodies();
    py::list list(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
    {
        list[i] = Wrap(*this, all[i]);
    }
    return list;
}

void WorldObject::Release(HandleBase& handle)
{
    handle.world = nullptr;
    released.push_back(handle.self);
}

void WorldObject::Step(float32 timeStep, int32 velocityIterations, int32 positionIterations)
{
    RequireUnlocked("b2World.Step");
    if (velocityIterations < 0 || positionIterations < 0)
    {
        ThrowMisuse("b2World.Step: the numbers of iterations must not be negative");
    }
    Run([&] {
        const bool callsPython = !contactListener.is_none() || !contactFilter.is_none();
        if (callsPython)
        {
            world.Step(timeStep, velocityIterations, positionIterations);
            return;
        }
        const WithoutLock unlocked;
        world.Step(timeStep, velocityIterations, positionIterations);
    });
}

void WorldObject::DestroyBody(BodyHandle& handle)
{
    b2Body& body = handle.Get();
    if (handle.world != this)
    {
        ThrowMisuse("b2World.DestroyBody: the body belongs to another world");
    }
    RequireUnlocked("b2World.DestroyBody");
    Run([&] {
        isDestroying = true;
        bodies.clear();
        world.DestroyBody(&body);
        bodies.clear(); // a callback may have asked for them
        isDestroying = false;
        Release(handle);
    });
}

void WorldObject::DestroyFixture(b2Body& body, FixtureHandle& handle)
{
    b2Fixture& fixture = handle.Get();
    if (fixture.GetBody() != &body)
    {
        ThrowMisuse("b2Body.DestroyFixture: the fixture belongs to another body");
    }
    RequireUnlocked("b2Body.DestroyFixture");
    Run([&] {
        isDestroying = true;
        body.DestroyFixture(&fixture);
        isDestroying = false;
        Release(handle);
    });
}

void WorldObject::SetShape(FixtureHandle& handle, const b2Shape& shape)
{
    b2Fixture& fixture = handle.Get();
    RequireUnlocked("changing the shape of a fixture");
    Run([&] {
        isDestroying = true; // contacts of a chain, whose listener may be called
        fixture.SetShape(shape);
        isDestroying = false;
    });
}

void WorldObject::DestroyJoint(JointHandle& handle)
{
    b2Joint& joint = handle.Get();
    if (handle.world != this)
    {
        ThrowMisuse("b2World.DestroyJoint: the joint belongs to another world");
    }
    RequireUnlocked("b2World.DestroyJoint");
    Run([&] {
        isDestroying = true;
        world.DestroyJoint(&joint);
        isDestroying = false;
        Release(handle);
    });
}

py::bytes WorldObject::Save()
{
    RequireUnlocked("save");
    const WithoutCollector wholeList;
    // Objects without a handle get one, so that Restore finds it again.
    for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        Wrap(*this, body);
        for (b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr;
             fixture = fixture->GetNext())
        {
            Wrap(*this, fixture);
        }
    }
    for (b2Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext())
    {
        Wrap(*this, joint);
    }
    const std::vector<uint8> bytes = b2SaveSnapshot(world, this);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void WorldObject::Restore(const std::string& bytes)
{
    RequireUnlocked("restore");
    known.clear();
    ForEachHandle([this](HandleBase& handle) { known.emplace_back(handle.number, &handle); });
    std::sort(known.begin(), known.end());
    const char* problem =
        b2RestoreSnapshot(world, reinterpret_cast<const uint8*>(bytes.data()), bytes.size(), this);
    if (problem != nullptr)
    {
        ThrowMisuse(problem);
    }
    bodies.clear();
    Run([&] {
        // Handles that the snapshot names refer to the new objects; the others to none.
        for (auto& [number, handle] : known)
        {
            handle->world = nullptr;
        }
        const auto renew = [this](auto* object) {
            using Object = std::remove_pointer_t<decltype(object)>;
            HandleBase* handle = HandleOf(object);
            if (handle == nullptr)
            {
                return;
            }
            if (handle->kind != KindOf(*object) || handle->world != nullptr)
            {
                object->SetUserData(nullptr); // the snapshot is of another world
                return;
            }
            static_cast<Handle<Object>*>(handle)->object = object;
            handle->world = this;
        };
        for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        {
            renew(body);
            for (b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr;
                 fixture = fixture->GetNext())
            {
                renew(fixture);
            }
        }
        for (b2Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext())
        {
            renew(joint);
        }
        for (auto& [number, handle] : std::exchange(known, {}))
        {
            if (handle->world == nullptr)
            {
                released.push_back(handle->self);
            }
        }
    });
}

std::uint64_t WorldObject::ToNumber(void* userData)
{
    return static_cast<HandleBase*>(userData)->number;
}

void* WorldObject::ToPointer(std::uint64_t number)
{
    const auto found = std::lower_bound(known.begin(), known.end(),
                                        std::pair<std::uint64_t, HandleBase*>(number, nullptr));
    return found != known.end() && found->first == number ? found->second : nullptr;
}

void WorldObject::SetContactListener(py::object listener)
{
    RequireCallback(listener, "contactListener", "a b2ContactListener or None",
                    {"BeginContact", "EndContact", "PreSolve", "PostSolve"});
    RequireThread();
    calls = {};
    if (!listener.is_none())
    {
        calls.begin = Overrides(listener, "BeginContact", "b2ContactListener");
        calls.end = Overrides(listener, "EndContact", "b2ContactListener");
        calls.preSolve = Overrides(listener, "PreSolve", "b2ContactListener");
        calls.postSolve = Overrides(listener, "PostSolve", "b2ContactListener");
    }
    if (!world.IsLocked()) // else it goes on to be called, and calls nothing
    {
        world.SetContactListener(listener.is_none() ? nullptr : this);
    }
    std::swap(contactListener, listener);
}

void WorldObject::SetContactFilter(py::object filter)
{
    RequireCallback(filter, "contactFilter", "a b2ContactFilter or None", {"ShouldCollide"});
    RequireUnlocked("setting contactFilter");
    const bool isUsed = !filter.is_none() && Overrides(filter, "ShouldCollide", "b2ContactFilter");
    world.SetContactFilter(isUsed ? this : nullptr);
    std::swap(contactFilter, filter);
}

void WorldObject::SetDestructionListener(py::object listener)
{
    RequireCallback(listener, "destructionListener", "a b2DestructionListener or None",
                    {"SayGoodbye"});
    std::swap(destructionListener, listener);
}

void WorldObject::SetRenderer(py::object drawer)
{
    if (!drawer.is_none() && !py::isinstance(drawer, py::module_::import("Box2D").attr("b2Draw")))
    {
        ThrowType("renderer", "a b2Draw or None", drawer);
    }
    std::swap(renderer, drawer);
}

void WorldObject::BeginContact(b2Contact* contact)
{
    if (calls.begin)
    {
        Call([&] { contactListener.attr("BeginContact")(WrapContact(*this, contact)); });
    }
}

void WorldObject::EndContact(b2Contact* contact)
{
    if (calls.end)
    {
        Call([&] { contactListener.attr("EndContact")(WrapContact(*this, contact)); });
        ++epoch; // it may be destroyed after this
    }
}

void WorldObject::PreSolve(b2Contact* contact, const b2Manifold* oldManifold)
{
    if (calls.preSolve)
    {
        Call([&] {
            contactListener.attr("PreSolve")(WrapContact(*this, contact), b2Manifold(*oldManifold));
        });
    }
}

void WorldObject::PostSolve(b2Contact* contact, const b2ContactImpulse* impulse)
{
    if (calls.postSolve)
    {
        Call([&] {
            contactListener.attr("PostSolve")(WrapContact(*this, contact),
                                              b2ContactImpulse(*impulse));
        });
    }
}

bool WorldObject::ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB)
{
    bool result = false;
    Call([&] {
        result = From<bool>(
            contactFilter.attr("ShouldCollide")(Wrap(*this, fixtureA), Wrap(*this, fixtureB)),
            "result of ShouldCollide");
    });
    return result;
}

void WorldObject::SayGoodbye(b2Joint* joint)
{
    if (!destructionListener.is_none())
    {
        Call([&] { destructionListener.attr("SayGoodbye")(Wrap(*this, joint)); });
    }
    if (HandleBase* handle = HandleOf(joint))
    {
        Release(*handle);
    }
}

void WorldObject::SayGoodbye(b2Fixture* fixture)
{
    if (!destructionListener.is_none())
    {
        Call([&] { destructionListener.attr("SayGoodbye")(Wrap(*this, fixture)); });
    }
    if (HandleBase* handle = HandleOf(fixture))
    {
        Release(*handle);
    }
}

WorldObject& WorldFrom(py::handle value, const char* name)
{
    if (!py::isinstance<WorldObject>(value))
    {
        ThrowType(name, "a b2World", value);
    }
    WorldObject& world = value.cast<WorldObject&>();
    world.RequireThread();
    return world;
}

} // namespace boxreel::python
