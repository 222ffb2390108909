// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

#include <map>
#include <memory>
#include <span>
#include <string>

/// What a scene is: a world it fills in its constructor and may steer around each step. Scenes use
/// the engine only; whoever shows them (film, window, test) is none of their business.
namespace boxreel
{

class SceneState;

struct SceneSettings
{
    uint32 seed = 1; ///< of the scene's random numbers
};

/// How far and how carefully one step goes.
struct StepSettings
{
    float32 timeStep = 1.0f / 60.0f; ///< [s]
    int32 velocityIterations = 8;
    int32 positionIterations = 3;
};

class Scene
{
public:
    explicit Scene(const SceneSettings& settings)
        : m_settings(settings), m_world(b2Vec2(0.0f, -10.0f))
    {}
    virtual ~Scene() = default;
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    b2World& World() { return m_world; }

    /// How the scene wants to be stepped unless the user says otherwise; scene files have their
    /// own.
    virtual StepSettings PreferredSteps() const { return {}; }

    /// Does it make bodies after it was created? When not, what is asked of a body that is not
    /// there can be refused before anything is simulated.
    virtual bool MakesBodiesLater() const { return false; }

    /// What it calls its bodies, by their number in the order of creation; those it leaves out have
    /// no name.
    const std::map<std::uint32_t, std::string>& Names() const { return m_names; }

    /// What it calls its joints; those it leaves out have no name.
    const std::map<const b2Joint*, std::string>& JointNames() const { return m_jointNames; }

    /// One step of the world; a scene that steers overrides it and calls this one.
    virtual void Step(const StepSettings& settings)
    {
        m_world.Step(settings.timeStep, settings.velocityIterations, settings.positionIterations);
    }

    /// Lists what the scene keeps beside its world and changes after it was made (SceneState.h), to
    /// be saved and restored; a scene that keeps nothing need not.
    virtual void VisitState(SceneState& state) { (void)state; }

    /// The names, for the same purpose: those of joints hang on addresses.
    void VisitNames(SceneState& state);

protected:
    SceneSettings m_settings;
    b2World m_world;
    std::map<std::uint32_t, std::string> m_names;
    std::map<const b2Joint*, std::string> m_jointNames; ///< only to look up: addresses
};

/// One line of the table of scenes.
struct SceneEntry
{
    const char* name;     ///< as users know it, e.g. "Newton's Cradle"
    const char* category; ///< for lists and menus
    const char* summary;  ///< what it shows, one sentence
    std::unique_ptr<Scene> (*create)(const SceneSettings&);
};

/// Every scene, in the order of the list. An explicit table: testbed/scenes/SceneTable.cpp.
std::span<const SceneEntry> AllScenes();

} // namespace boxreel
