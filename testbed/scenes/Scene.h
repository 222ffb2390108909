// SPDX-License-Identifier: MIT
#pragma once

#include <scenes/MouseGrip.h>
#include <scenes/Random.h>

#include <Box2D/Box2D.h>

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// A scene fills a world in its constructor. It may control the world around each step, on its own
/// or in response to keys and the mouse. Scenes use only the engine and do not depend on who shows
/// them (film, window, script, test).
namespace boxreel
{

class SceneState;

struct SceneSettings
{
    uint32 seed = 1; ///< of the scene's random numbers
};

/// Duration and iterations of one step.
struct StepSettings
{
    float32 timeStep = 1.0f / 60.0f; ///< [s]
    int32 velocityIterations = 8;
    int32 positionIterations = 3;
};

/// The visible area.
struct SceneArea
{
    b2Vec2 center;              ///< [m]; of a body that is followed, ignored
    b2Vec2 halfSize;            ///< all of this is seen, in a picture of any shape [m]
    b2Body* followed = nullptr; ///< stays in the middle
};

/// A key that a scene answers to: a lower-case letter, a digit or ','.
struct KeyBinding
{
    char key;
    const char* effect; ///< its effect, e.g. "drives forward"
};

class Scene : private b2DestructionListener
{
public:
    explicit Scene(const SceneSettings& settings);
    ~Scene() override = default;
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    b2World& World() { return m_world; }

    /// Returns the step settings that the scene prefers unless the user chooses others. Scene files
    /// have their own.
    virtual StepSettings PreferredSteps() const { return {}; }

    /// Returns the area to show unless the user chooses another; none: the dynamic bodies.
    virtual std::optional<SceneArea> PreferredView() const { return std::nullopt; }

    /// Returns true if it creates bodies after the constructor. If false, a reference to a missing
    /// body can be refused before anything is simulated.
    virtual bool MakesBodiesLater() const { return false; }

    /// Returns the names of its bodies, by number in the order of creation. Other bodies have no
    /// name.
    const std::map<std::uint32_t, std::string>& Names() const { return m_names; }

    /// Returns the names of its joints. Other joints have no name.
    const std::map<const b2Joint*, std::string>& JointNames() const { return m_jointNames; }

    /// One step of the world; a scene that steers overrides it and calls this one.
    virtual void Step(const StepSettings& settings)
    {
        m_world.Step(settings.timeStep, settings.velocityIterations, settings.positionIterations);
    }

    /// The keys it answers to, for help and for scripts: others are ignored.
    virtual std::span<const KeyBinding> Keys() const { return {}; }
    virtual void KeyDown(char key) { (void)key; }
    virtual void KeyUp(char key) { (void)key; }

    /// The mouse is pressed at a point of the world [m]. It grips the dynamic body there. A scene
    /// that uses the mouse differently overrides these.
    virtual void MouseDown(const b2Vec2& point) { m_grip.Take(m_world, point); }
    virtual void MouseMove(const b2Vec2& point) { m_grip.MoveTo(point); }
    virtual void MouseUp(const b2Vec2& point);

    /// A heavy ball, the one before it goes: from a place [m] with a velocity [m/s], or from
    /// somewhere above towards the origin.
    void ThrowBomb(const b2Vec2& place, const b2Vec2& velocity);
    void ThrowBomb();

    /// The world's, and that of what the scene keeps in coordinates of its own.
    virtual void ShiftOrigin(const b2Vec2& newOrigin) { m_world.ShiftOrigin(newOrigin); }

    /// Describes its present state as names and values: "torque", "12.5 N m".
    virtual std::vector<std::pair<std::string, std::string>> Describe() const { return {}; }

    /// Draws the additions to its bodies: rays, hulls, marks.
    virtual void Draw(b2Draw& draw) const { (void)draw; }

    /// Returns boxes [m] of its drawings that a camera which fits the scene keeps in view like
    /// bodies.
    virtual std::vector<b2AABB> Framed() const { return {}; }

    /// Lists what the scene keeps beside its world and changes after it was made (SceneState.h), to
    /// be saved and restored; a scene that keeps nothing need not.
    virtual void VisitState(SceneState& state) { (void)state; }

    /// Visits the state that all scenes have: names, the mouse's grip, the bomb.
    void VisitCommonState(SceneState& state);

protected:
    /// For pictures, cameras and scripts.
    void Name(const b2Body& body, const char* name)
    {
        m_names[static_cast<std::uint32_t>(body.GetNumber())] = name;
    }

    /// A joint that the scene may keep goes with a body that has been destroyed.
    virtual void JointGone(b2Joint* joint) { (void)joint; }

    SceneSettings m_settings;
    b2World m_world;
    std::map<std::uint32_t, std::string> m_names;
    std::map<const b2Joint*, std::string> m_jointNames; ///< only to look up: addresses

private:
    void SayGoodbye(b2Joint* joint) final;
    void SayGoodbye(b2Fixture*) final {}

    MouseGrip m_grip;
    b2Body* m_bomb = nullptr;
    Random m_bombs; ///< source of their positions
};

/// One line of the table of scenes.
struct SceneEntry
{
    const char* name;     ///< as users know it, e.g. "Newton's Cradle"
    const char* category; ///< for lists and menus
    const char* summary;  ///< one sentence about its content
    std::unique_ptr<Scene> (*create)(const SceneSettings&);
};

/// Every scene, in the order of the list. An explicit table: testbed/scenes/SceneTable.cpp.
std::span<const SceneEntry> AllScenes();

} // namespace boxreel
