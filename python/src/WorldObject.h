// SPDX-License-Identifier: MIT
#pragma once

#include "Handles.h"

#include <vector>

/// The world of Python: the engine's world, the program's callbacks, and the handles of its
/// objects.
namespace boxreel::python
{

/// Refers to a world as long as it exists, for contacts.
struct WorldLink
{
    WorldObject* world;
};

/// The functions of a listener that a program has overridden. The others are not called.
struct ContactCalls
{
    bool begin = false;
    bool end = false;
    bool preSolve = false;
    bool postSolve = false;
};

struct WorldObject final : b2ContactListener,
                           b2ContactFilter,
                           b2DestructionListener,
                           b2SnapshotUserData
{
    WorldObject(const b2Vec2& gravity, bool doSleep);
    ~WorldObject() override;
    WorldObject(const WorldObject&) = delete;
    WorldObject& operator=(const WorldObject&) = delete;

    /// Throws b2Error while another thread steps the world.
    void RequireThread() const;
    /// Throws b2Error inside a callback.
    void RequireUnlocked(const char* function) const;
    /// Throws the first exception of a callback since the last call, and what the engine refused.
    void Finish();
    /// Keeps other threads from using the world: callbacks may let them run.
    class Use
    {
    public:
        explicit Use(WorldObject& world) : m_world(world), m_before(world.stepper)
        {
            world.RequireThread();
            world.stepper = PyThread_get_thread_ident();
        }
        ~Use() { m_world.stepper = m_before; }
        Use(const Use&) = delete;
        Use& operator=(const Use&) = delete;

    private:
        WorldObject& m_world;
        unsigned long m_before;
    };

    /// Calls `function`, in which callbacks may run, and then Finish.
    template <class Function>
    void Run(Function function)
    {
        {
            const Use use(*this);
            ++epoch;
            function();
            ++epoch;
        }
        Finish();
    }

    void Step(float32 timeStep, int32 velocityIterations, int32 positionIterations);
    void DestroyBody(BodyHandle& handle);
    void DestroyFixture(b2Body& body, FixtureHandle& handle);
    void DestroyJoint(JointHandle& handle);
    void SetShape(FixtureHandle& handle, const b2Shape& shape);
    py::bytes Save();
    void Restore(const std::string& bytes);

    void SetContactListener(py::object listener);
    void SetContactFilter(py::object filter);
    void SetDestructionListener(py::object listener);
    void SetRenderer(py::object drawer);

    // b2ContactListener, b2ContactFilter, b2DestructionListener, b2SnapshotUserData
    void BeginContact(b2Contact* contact) override;
    void EndContact(b2Contact* contact) override;
    void PreSolve(b2Contact* contact, const b2Manifold* oldManifold) override;
    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override;
    bool ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB) override;
    void SayGoodbye(b2Joint* joint) override;
    void SayGoodbye(b2Fixture* fixture) override;
    std::uint64_t ToNumber(void* userData) override;
    void* ToPointer(std::uint64_t number) override;

    /// Calls back into Python. The first exception is kept for Finish, and later calls are left
    /// out.
    template <class Function>
    void Call(Function function)
    {
        if (!failure)
        {
            try
            {
                function();
            }
            catch (...)
            {
                failure = std::current_exception();
            }
        }
    }

    /// Returns the objects of all bodies in the order of creation.
    py::list BodyObjects();
    /// Returns all bodies in the order of creation. Valid until a body is created or destroyed.
    const std::vector<b2Body*>& Bodies();

    /// Marks the handle as destroyed. Its reference is dropped by Finish, because that may run
    /// code.
    void Release(HandleBase& handle);
    /// Calls `visit` with each handle of the world.
    template <class Visit>
    void ForEachHandle(Visit visit);

    b2World world;
    std::shared_ptr<WorldLink> link;
    std::uint64_t handleCount = 0; ///< of all handles so far
    std::uint64_t epoch = 0;       ///< grows when contacts may have been destroyed
    unsigned long stepper = 0;     ///< thread that steps, queries or draws the world; 0: none
    bool isDestroying = false;     ///< inside DestroyBody and the like, where callbacks may run
    std::vector<b2Body*> bodies;   ///< of Bodies(); empty: not up to date
    ContactCalls calls;
    py::object contactListener = py::none();
    py::object contactFilter = py::none();
    py::object destructionListener = py::none();
    py::object renderer = py::none();
    std::exception_ptr failure;
    std::vector<PyObject*> released;                          ///< owned references
    std::vector<std::pair<std::uint64_t, HandleBase*>> known; ///< during Restore, sorted
};

template <class T>
HandleBase* HandleOf(const T* object)
{
    // Only this module sets user data, and always to a handle.
    return static_cast<HandleBase*>(object->GetUserData());
}

template <class Visit>
void WorldObject::ForEachHandle(Visit visit)
{
    const auto visitOne = [&visit](HandleBase* handle) {
        if (handle != nullptr)
        {
            visit(*handle);
        }
    };
    // The next one is read first, because `visit` may forget the handle.
    for (b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        for (b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr;
             fixture = fixture->GetNext())
        {
            visitOne(HandleOf(fixture));
        }
        visitOne(HandleOf(body));
    }
    for (b2Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext())
    {
        visitOne(HandleOf(joint));
    }
}

/// Returns the argument as a world.
WorldObject& WorldFrom(py::handle value, const char* name);

/// Returns an object for a contact, which is valid while the contact exists.
py::object WrapContact(WorldObject& world, b2Contact* contact);

/// Draws the world with its renderer, an object of Python.
void DrawWith(WorldObject& world, const py::object& renderer);

} // namespace boxreel::python
