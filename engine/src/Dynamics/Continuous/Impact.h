// SPDX-License-Identifier: MIT
#pragma once

#include "../Energy/EnergyGuard.h"
#include "../State/Solver.h"

#include <Box2D/Common/Array.h>

#include <span>

struct b2ContactImpulse;

/// One impact within a step. Its bodies have been moved to its time; their contacts get separating
/// velocities, and the bodies advance for the rest of the step. Continuous collision fills it again
/// for each impact.
namespace box2d
{

struct ContactBlock;
struct ContactData;
struct ImpactMemory;
struct OverlapBlock;
struct SolverMemory;
class World;

class Impact
{
public:
    Impact(World& world, float32 timeStep, int32 velocityIterations);

    Array<b2Body*>& Bodies() { return m_bodies; }
    Array<b2Contact*>& Contacts() { return m_contacts; }

    /// Reduces the overlaps of the two bodies; only they move.
    void SolvePositions(b2Body& bodyA, b2Body& bodyB);
    /// Solves velocities and advances the bodies. The time is a fraction of the step.
    void SolveVelocities(float32 time);

    /// Those of its bodies that fall freely with all that their joints connect.
    Array<const BodyData*>& Falling() { return m_falling; }

    /// Returns the acceleration of a freely falling body, or one of Falling, in a step with
    /// sub-steps, where only the velocity is known at every time. Otherwise 0 [m/s^2].
    b2Vec2 AccelerationOf(const BodyData& body) const;

private:
    static bool IsSpent(b2Body& body);
    void PutGroundLast();
    void LoadBodies();
    void Prepare();
    std::span<ContactBlock> Impulses() const;
    float32 DepthOf(std::size_t contact, int32 point) const;
    void NoteDepths();
    void LimitPush(SolverBody& pushed, float32 maxExtent) const;
    double CorrectBounces();
    double CorrectBounce(std::size_t index);
    template <class Function>
    void ForMoved(Function&& function) const;
    bool IsInCorner() const;
    void BounceWithJoints(float32 timeLeft);
    bool IsJointed(std::size_t index);
    float32 RestitutionOf(std::size_t index) const;
    bool Bounce(std::size_t index);
    b2ContactImpulse ImpulsesOf(std::size_t index) const;
    void PushApart(std::size_t first) const;
    void Sweep();
    bool KeepsEnergy() const;
    double KineticEnergyOfAll() const;
    void BounceLess(double maximum);
    EnergyGuard::Path PathOf(std::size_t index, float32 time) const;
    void MoveOn(std::size_t index, float32 time);
    void MoveJoined(std::size_t index, float32 timeLeft);
    void MoveOn(SolverBody& body, const b2Vec2& acceleration, float32 timeLeft) const;

    World& m_world;
    ImpactMemory& m_memory;
    SolverMemory& m_solver;
    int32 m_velocityIterations;
    SolverContext m_context;
    Array<b2Body*>& m_bodies;
    Array<const BodyData*>& m_falling;
    Array<b2Contact*>& m_contacts;
    Array<SolverBody>& m_bounced; // scratch of BounceLess: by body
    std::size_t m_ground = 0;     // the first contact with the ground, if that comes after others
    Array<float32>& m_depths;     // two of each contact, when they matter
};

} // namespace box2d
