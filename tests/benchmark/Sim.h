// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

/// The operations of an engine that the benchmark's scenes use, in plain numbers: metres, seconds,
/// radians. Each program links one implementation (Sim*.cpp), so the scenes are the same for all
/// engines.
namespace bench
{

enum class Kind
{
    Static,
    Kinematic,
    Dynamic
};

using BodyId = int;

struct BodySpec
{
    Kind kind = Kind::Dynamic;
    double x = 0.0, y = 0.0;
    double angle = 0.0;
    double vx = 0.0, vy = 0.0;
    double angularVelocity = 0.0;
    bool bullet = false;
};

struct Material
{
    double density = 1.0;
    double friction = 0.6;
    double restitution = 0.0;
    std::uint16_t category = 1;
    std::uint16_t mask = 0xFFFF;
};

struct BodyState
{
    double x, y, angle, vx, vy, w;
    bool dynamic; ///< the others stay where the scene wants them
};

/// Pairs of shapes that touch, and how deep they overlap, skins included.
struct Touching
{
    double pairs = 0.0;
    double points = 0.0;  ///< that overlap
    double squares = 0.0; ///< of these overlaps, summed [m^2]
    double deepest = 0.0; ///< of these overlaps [m]

    void AddPoint(double separation, double weight = 1.0)
    {
        points += separation < 0.0 ? weight : 0.0;
        squares += separation < 0.0 ? weight * separation * separation : 0.0;
        deepest = std::max(deepest, -separation);
    }
    /// The root of the mean square [m]: a few deep ones count for more than many shallow ones.
    double Overlap() const { return points > 0.0 ? std::sqrt(squares / points) : 0.0; }
};

class Sim
{
public:
    virtual ~Sim() = default;

    virtual BodyId AddBody(const BodySpec& spec) = 0;
    virtual void AddBox(BodyId body, double hx, double hy, double cx, double cy,
                        const Material& material) = 0;
    virtual void AddCircle(BodyId body, double radius, const Material& material) = 0;
    virtual void AddEdge(BodyId body, double x1, double y1, double x2, double y2,
                         const Material& material) = 0;
    /// At a world point; the two bodies do not collide.
    virtual void AddRevolute(BodyId a, BodyId b, double x, double y) = 0;
    /// Removes the last added body.
    virtual void RemoveLastBody() = 0;

    /// One step of the length and with the iterations of the settings.
    virtual void Step() = 0;
    /// Returns the fraction of a ray before its first hit; 1 without a hit.
    virtual double CastRay(double x1, double y1, double x2, double y2) = 0;

    /// At once, though the engine would not yet; only in a world that lets bodies sleep.
    virtual void PutToSleep(BodyId body) = 0;
    virtual bool IsAsleep(BodyId body) const = 0;

    virtual int BodyCount() const = 0;
    virtual BodyState State(BodyId body) const = 0;
    virtual Touching LookAtContacts() = 0;
    /// Returns the number of threads of a step, including the calling one.
    virtual int Threads() const = 0;
};

struct SimSettings
{
    double gravity = -10.0;
    bool sleep = false;
    int threads = 1; ///< where the engine has a choice
    int hz = 60;     ///< steps a second
    /// Chipmunk has one count: 10, its own default, for 8 and 3, and in proportion to the first.
    int velocityIterations = 8;
    int positionIterations = 3;
    int subSteps = 1; ///< of a step: from 1 to MostSubSteps()
};

struct Iterations
{
    int velocity = 0;
    int position = 0; ///< 0: the engine has no such iterations
};

/// Returns the iterations of one sub-step, as this engine divides and counts them. The iterations
/// of the settings are those of a whole step.
Iterations IterationsOfASubStep(const SimSettings& settings);
/// Name and version of the engine that this program was built with.
std::string EngineName();
/// Returns the maximum number of sub-steps; 1: the engine has no sub-steps.
int MostSubSteps();
std::unique_ptr<Sim> CreateSim(const SimSettings& settings);

} // namespace bench
