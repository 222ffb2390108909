// SPDX-License-Identifier: MIT
#pragma once

#include <cfloat>
#include <cstddef>
#include <cstdint>

/// @file
/// Types, tolerances, memory, logging and assertions: the base of all other files of the engine.
/// Units are metres, kilograms, seconds and radians. The engine changes nothing here at run time;
/// the program may set the hooks at the end.

/// 8 bits, signed.
typedef std::int8_t int8;
/// 16 bits, signed.
typedef std::int16_t int16;
/// 32 bits, signed.
typedef std::int32_t int32;
/// 8 bits, unsigned.
typedef std::uint8_t uint8;
/// 16 bits, unsigned.
typedef std::uint16_t uint16;
/// 32 bits, unsigned.
typedef std::uint32_t uint32;
/// IEEE 754 single precision.
typedef float float32;
/// IEEE 754 double precision.
typedef double float64;

/// Half a turn [rad].
inline constexpr float32 b2_pi = 3.14159265359f;
/// Difference between 1 and the next larger number.
inline constexpr float32 b2_epsilon = FLT_EPSILON;
/// The largest finite number.
inline constexpr float32 b2_maxFloat = FLT_MAX;

// ---- Collision

/// Two convex shapes touch along a segment at most, so two points describe a contact.
inline constexpr int32 b2_maxManifoldPoints = 2;

/// Number of vertices up to which programs of Box2D 2.3 make polygons.
inline constexpr int32 b2_maxPolygonVertices = 8;

/// Maximum number of vertices of a polygon: the b2_maxPolygonVertices of the Python module of 2.3,
/// whose programs may need them. More makes every polygon larger in memory.
inline constexpr int32 b2_polygonCapacity = 16;

/// Margin of a proxy's box in the dynamic tree on every side [m]. A body may move a little before
/// the tree must change.
inline constexpr float32 b2_aabbExtension = 0.1f;

/// The box of a moved proxy is extended by this many displacements.
inline constexpr float32 b2_aabbMultiplier = 2.0f;

/// A length that is small enough to be invisible and large enough to compute with [m].
/// Larger shows gaps between resting bodies, smaller makes contacts flicker.
inline constexpr float32 b2_linearSlop = 0.005f;

/// The same for angles [rad].
inline constexpr float32 b2_angularSlop = 2.0f / 180.0f * b2_pi;

/// The skin around polygons and edges [m]. It must exceed the slop: resting skins overlap by it,
/// and continuous collision needs separated cores.
inline constexpr float32 b2_polygonRadius = 2.0f * b2_linearSlop;

/// Maximum number of sub-steps of a contact in the continuous phase of one step.
inline constexpr int32 b2_maxSubSteps = 8;

// ---- Dynamics

/// Maximum number of contacts solved together for one time-of-impact event.
inline constexpr int32 b2_maxTOIContacts = 32;

/// Slower impacts do not bounce [m/s]; without the threshold, bodies would never come to rest.
inline constexpr float32 b2_velocityThreshold = 1.0f;

/// Maximum linear correction of a position iteration [m]; more overshoots.
inline constexpr float32 b2_maxLinearCorrection = 0.2f;

/// Maximum angular correction of a position iteration [rad]; more overshoots.
inline constexpr float32 b2_maxAngularCorrection = 8.0f / 180.0f * b2_pi;

/// Maximum translation of a body in one step [m]; at 60 Hz: 120 m/s. Ten times as much with
/// sub-steps (see b2World::SetSubStepCount).
inline constexpr float32 b2_maxTranslation = 2.0f;
/// Its square [m^2], to compare without a root.
inline constexpr float32 b2_maxTranslationSquared = b2_maxTranslation * b2_maxTranslation;

/// Maximum rotation of a body in one step [rad]; forty times as much with sub-steps.
inline constexpr float32 b2_maxRotation = 0.5f * b2_pi;
/// Its square [rad^2].
inline constexpr float32 b2_maxRotationSquared = b2_maxRotation * b2_maxRotation;

/// Fraction of an overlap that one position iteration removes. 1 would overshoot.
inline constexpr float32 b2_baumgarte = 0.2f;
inline constexpr float32 b2_toiBaugarte = 0.75f; ///< the same for time-of-impact events

/// Time that a body must be at rest before it sleeps [s].
inline constexpr float32 b2_timeToSleep = 0.5f;

/// Maximum velocity of a body at rest [m/s].
inline constexpr float32 b2_linearSleepTolerance = 0.01f;
/// Maximum angular velocity of a body at rest [rad/s].
inline constexpr float32 b2_angularSleepTolerance = 2.0f / 180.0f * b2_pi;

// ---- Memory

/// Allocates a large block of memory for the engine; `size` in bytes, >= 0. Never returns null: out
/// of memory ends the program with a message.
void* b2Alloc(int32 size);
/// Frees memory from b2Alloc; null is allowed.
void b2Free(void* memory);

/// Returns `size` bytes of memory, aligned as malloc does, or null.
typedef void* (*b2AllocFunction)(std::size_t size);
/// Frees memory from the matching b2AllocFunction.
typedef void (*b2FreeFunction)(void* memory);

/// Replaces the functions behind b2Alloc and b2Free. Two nulls restore malloc and free; a single
/// null asserts and restores them too. Call it before the first world is created: a block must
/// return to the allocator that it came from.
void b2SetAllocator(b2AllocFunction alloc, b2FreeFunction free);

// ---- Logging

#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
/// Writes formatted text, to standard output unless a sink is set. Only Dump functions use it.
void b2Log(const char* format, ...);

/// Receives a piece of text, which is valid during the call only.
typedef void (*b2LogFunction)(const char* text);

/// Redirects the output of b2Log; null restores standard output.
void b2SetLog(b2LogFunction log);

// ---- Version

/// The version of the implemented interface: major.minor.revision.
struct b2Version
{
    int32 major;    ///< significant changes
    int32 minor;    ///< incremental changes
    int32 revision; ///< fixes
};

/// The version of the manual: 2.3.0.
inline constexpr b2Version b2_version = {2, 3, 0};

// ---- Assertions

/// Asserts are on unless NDEBUG is defined; BOXREEL_ASSERTS set to 0 or 1 overrides that. With
/// asserts off, an invalid call has a defined effect and leaves the world consistent.
#if !defined(BOXREEL_ASSERTS)
#if defined(NDEBUG)
#define BOXREEL_ASSERTS 0
#else
#define BOXREEL_ASSERTS 1
#endif
#endif

/// Receives the sentence of a broken requirement, and where it was checked.
typedef void (*b2MisuseFunction)(const char* sentence, const char* file, int line);

/// Replaces the reaction to an invalid call, in every build. The function is called, and then the
/// call has the effect that it has with asserts off. Null restores the default. For bindings to
/// languages that have exceptions. An addition to the manual's interface.
void b2SetMisuse(b2MisuseFunction function);

namespace box2d
{
/// Prints "file:line: sentence" to standard error and aborts.
[[noreturn]] void AssertionFailed(const char* sentence, const char* file, int line);

/// Calls the function of b2SetMisuse; false if there is none.
bool ReportMisuse(const char* sentence, const char* file, int line);

/// Handles a broken requirement. Returns false after the function of b2SetMisuse. Without one it
/// aborts with asserts on, and returns false with asserts off.
inline bool Misuse(const char* sentence, const char* file, int line)
{
    if (ReportMisuse(sentence, file, line))
    {
        return false;
    }
#if BOXREEL_ASSERTS
    AssertionFailed(sentence, file, line);
#else
    return false;
#endif
}
} // namespace box2d

/// A program may define its own b2Assert before it includes this file.
#if !defined(b2Assert)
#if BOXREEL_ASSERTS
#define b2Assert(condition)                                                                        \
    ((condition) ? static_cast<void>(0)                                                            \
                 : box2d::AssertionFailed("b2Assert failed: " #condition ".", __FILE__, __LINE__))
#else
#define b2Assert(condition) static_cast<void>(sizeof((condition) ? 1 : 0))
#endif
#endif

/// Checks a condition that the caller can violate. True if it holds; otherwise it prints the
/// sentence and aborts with asserts on, or is false with asserts off (see b2SetMisuse). Usage:
///
///     if (!B2_REQUIRE(count >= 3, "A polygon needs at least 3 points.")) return;
#define B2_REQUIRE(condition, sentence) ((condition) || box2d::Misuse(sentence, __FILE__, __LINE__))

/// Silences the warning about a parameter that only asserts read.
#define B2_NOT_USED(x) static_cast<void>(x)
