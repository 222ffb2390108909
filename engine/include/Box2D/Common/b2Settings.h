// SPDX-License-Identifier: MIT
#pragma once

#include <cfloat>
#include <cstddef>
#include <cstdint>

/// @file
/// Types, tolerances, memory, logging and assertions: what every other file of the engine starts
/// from. Lengths are metres, masses kilograms, times seconds, angles radians. Nothing here is
/// changed by the engine at run time; the hooks at the end are the program's to set.

/// 8 bits, with a sign.
typedef std::int8_t int8;
/// 16 bits, with a sign.
typedef std::int16_t int16;
/// 32 bits, with a sign.
typedef std::int32_t int32;
/// 8 bits, 0 or more.
typedef std::uint8_t uint8;
/// 16 bits, 0 or more.
typedef std::uint16_t uint16;
/// 32 bits, 0 or more.
typedef std::uint32_t uint32;
/// The engine's numbers: 32 bits of IEEE 754.
typedef float float32;
/// 64 bits of IEEE 754, where 32 are too few.
typedef double float64;

/// Half of a turn [rad].
inline constexpr float32 b2_pi = 3.14159265359f;
/// From 1 to the next number above it.
inline constexpr float32 b2_epsilon = FLT_EPSILON;
/// The largest finite number.
inline constexpr float32 b2_maxFloat = FLT_MAX;

// ---- Collision

/// Two convex shapes touch along a segment at most, so two points carry all of a contact.
inline constexpr int32 b2_maxManifoldPoints = 2;

/// The most corners of a polygon. More makes every polygon larger in memory.
inline constexpr int32 b2_maxPolygonVertices = 8;

/// A proxy's box in the dynamic tree is this much larger on every side [m], so that a body may
/// move a little before the tree has to change.
inline constexpr float32 b2_aabbExtension = 0.1f;

/// A moved proxy's box reaches this many displacements ahead.
inline constexpr float32 b2_aabbMultiplier = 2.0f;

/// A length that is small enough not to be seen and large enough to compute with [m].
/// Larger shows gaps between resting bodies, smaller makes contacts flicker.
inline constexpr float32 b2_linearSlop = 0.005f;

/// The same for angles [rad].
inline constexpr float32 b2_angularSlop = 2.0f / 180.0f * b2_pi;

/// The skin around polygons and edges [m]. Must exceed the slop, for resting skins overlap by it
/// and the cores must stay apart for continuous collision to work.
inline constexpr float32 b2_polygonRadius = 2.0f * b2_linearSlop;

/// The most sub-steps a contact may get in the continuous phase of one step.
inline constexpr int32 b2_maxSubSteps = 8;

// ---- Dynamics

/// The most contacts solved together for one time-of-impact event.
inline constexpr int32 b2_maxTOIContacts = 32;

/// Slower impacts than this do not bounce [m/s]; without it nothing would come to rest.
inline constexpr float32 b2_velocityThreshold = 1.0f;

/// The most that one position iteration moves a body [m]; more overshoots.
inline constexpr float32 b2_maxLinearCorrection = 0.2f;

/// The most that one position iteration turns a body [rad]; more overshoots.
inline constexpr float32 b2_maxAngularCorrection = 8.0f / 180.0f * b2_pi;

/// The furthest a body may move in one step [m]; at 60 Hz: 120 m/s. In a small step (see
/// b2World::SetSubStepCount) ten times as far.
inline constexpr float32 b2_maxTranslation = 2.0f;
/// Its square [m^2]: what compares needs no root.
inline constexpr float32 b2_maxTranslationSquared = b2_maxTranslation * b2_maxTranslation;

/// The furthest a body may turn in one step [rad]; in a small step forty times as far.
inline constexpr float32 b2_maxRotation = 0.5f * b2_pi;
/// Its square [rad^2].
inline constexpr float32 b2_maxRotationSquared = b2_maxRotation * b2_maxRotation;

/// How much of an overlap one position iteration removes. 1 would be all of it, but overshoots.
inline constexpr float32 b2_baumgarte = 0.2f;
inline constexpr float32 b2_toiBaugarte = 0.75f; ///< the same for time-of-impact events

/// How long a body must be still before it sleeps [s].
inline constexpr float32 b2_timeToSleep = 0.5f;

/// What still means for the velocity [m/s].
inline constexpr float32 b2_linearSleepTolerance = 0.01f;
/// What still means for the rotation [rad/s].
inline constexpr float32 b2_angularSleepTolerance = 2.0f / 180.0f * b2_pi;

// ---- Memory

/// Where every large block of the engine comes from and goes back to; `size` in bytes, >= 0. Never
/// returns null: running out of memory ends the program with a sentence.
void* b2Alloc(int32 size);
/// Gives back what b2Alloc returned; null is nothing to give back.
void b2Free(void* memory);

/// Returns memory for so many bytes, aligned as malloc does, or null.
typedef void* (*b2AllocFunction)(std::size_t size);
/// Takes back what the function beside it returned.
typedef void (*b2FreeFunction)(void* memory);

/// Puts the program's memory system behind b2Alloc and b2Free; nulls bring malloc and free back,
/// and so does, after an assert, a null for one of them. Call it before the first world is made,
/// for a block must return to where it came from.
void b2SetAllocator(b2AllocFunction alloc, b2FreeFunction free);

// ---- Logging

#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
/// Writes formatted text, to standard output unless a sink is set. Only Dump functions use it.
void b2Log(const char* format, ...);

/// Takes a piece of text, which is gone after the call.
typedef void (*b2LogFunction)(const char* text);

/// Sends what b2Log writes to the program; null brings standard output back.
void b2SetLog(b2LogFunction log);

// ---- Version

/// The version whose interface this is: major.minor.revision.
struct b2Version
{
    int32 major;    ///< significant changes
    int32 minor;    ///< incremental changes
    int32 revision; ///< repairs
};

/// The manual's: 2.3.0.
inline constexpr b2Version b2_version = {2, 3, 0};

// ---- Assertions

/// Asserts are on unless NDEBUG is defined; BOXREEL_ASSERTS set to 0 or 1 overrides that. With
/// asserts off the engine makes the best of a mistake and stays whole.
#if !defined(BOXREEL_ASSERTS)
#if defined(NDEBUG)
#define BOXREEL_ASSERTS 0
#else
#define BOXREEL_ASSERTS 1
#endif
#endif

namespace box2d
{
/// Prints "file:line: sentence" to standard error and aborts.
[[noreturn]] void AssertionFailed(const char* sentence, const char* file, int line);

/// What a broken requirement comes to: the end with asserts on, false with asserts off.
inline bool Misuse([[maybe_unused]] const char* sentence, [[maybe_unused]] const char* file,
                   [[maybe_unused]] int line)
{
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

/// For what a caller can get wrong: true when the condition holds; otherwise says the sentence and
/// aborts with asserts on, or is false with asserts off, so that
///
///     if (!B2_REQUIRE(count >= 3, "A polygon needs at least 3 points.")) return;
///
/// both explains the mistake and survives it.
#define B2_REQUIRE(condition, sentence) ((condition) || box2d::Misuse(sentence, __FILE__, __LINE__))

/// Silences the warning about a parameter that only asserts read.
#define B2_NOT_USED(x) static_cast<void>(x)
