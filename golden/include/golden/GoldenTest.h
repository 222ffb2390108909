// SPDX-License-Identifier: MIT
#pragma once

#include <golden/GoldenCheck.h>
#include <golden/GoldenWorld.h>

#include <gtest/gtest.h>

#include <iostream>
#include <string>
#include <utility>

/// @file
/// Golden tests with GoogleTest, in a program that links boxreel::golden and, for worlds,
/// boxreel::goldenworld (the CMake function boxreel_add_golden_tests does both):
///
///     EXPECT_GOLDEN(frame, "menu/opened");
///     EXPECT_GOLDEN(frame, "menu/opened", boxreel::CompareSettings::Exact());
///     EXPECT_GOLDEN_WORLD(world, "pyramid/3s");
///     EXPECT_GOLDEN_WORLD(world, "pyramid/3s", {.width = 640, .height = 360});
///     EXPECT_GOLDEN_FILM("pyramid.mp4", "pyramid/film");
///     EXPECT_GOLDEN_FILM("pyramid.mp4", "pyramid/film", {.every = 60});
///
/// ASSERT_GOLDEN, ASSERT_GOLDEN_WORLD and ASSERT_GOLDEN_FILM end the test when they fail.
/// References lie in the folder BOXREEL_GOLDEN_REFERENCES (environment, else a definition with
/// which the test is compiled), failures leave their pictures in BOXREEL_GOLDEN_OUTPUT
/// (golden-output below the working folder), BOXREEL_GOLDEN_ACCEPT=missing|changed|all|
/// this-renderer makes candidates the references.
namespace boxreel::golden_test
{

/// What EXPECT_GOLDEN compares with.
struct FrameCheck
{
    std::string name;        ///< of the reference
    CompareSettings compare; ///< presets and limits
};

/// EXPECT_GOLDEN's second argument: a name, and limits where they differ.
inline FrameCheck CheckAs(std::string name, CompareSettings compare = {})
{
    return {std::move(name), std::move(compare)};
}

/// What EXPECT_GOLDEN_WORLD compares with.
struct WorldCheck
{
    std::string name;        ///< of the reference
    GoldenWorldLook look;    ///< how the world is drawn
    CompareSettings compare; ///< presets and limits
};

/// EXPECT_GOLDEN_WORLD's second argument: a name, a look and limits.
inline WorldCheck CheckWorldAs(std::string name, GoldenWorldLook look = {},
                               CompareSettings compare = {})
{
    return {std::move(name), std::move(look), std::move(compare)};
}

/// The folder that boxreel_add_golden_tests has named.
inline std::filesystem::path CompiledReferences()
{
#ifdef BOXREEL_GOLDEN_REFERENCES
    return BOXREEL_GOLDEN_REFERENCES;
#else
    return {};
#endif
}

/// Compares what could be drawn; an Error fails the test with its sentence.
inline testing::AssertionResult Check(const Result<GoldenCandidate>& candidate,
                                      const CompareSettings& compare)
{
    if (!candidate)
    {
        return testing::AssertionFailure() << candidate.GetError().Text();
    }
    const Result<GoldenCheckSettings> settings =
        GoldenSettingsFromEnvironment(CompiledReferences());
    if (!settings)
    {
        return testing::AssertionFailure() << settings.GetError().Text();
    }
    static std::set<std::string> accepted; // by all checks of this program
    const GoldenOutcome outcome = CheckGolden(*candidate, compare, *settings, accepted);
    std::cout << outcome.output << std::flush;
    return (outcome.passed ? testing::AssertionSuccess() : testing::AssertionFailure())
           << outcome.message;
}

/// EXPECT_GOLDEN calls it.
inline testing::AssertionResult IsGolden(const char* expression, const char*, const Frame& frame,
                                         const FrameCheck& check)
{
    if (frame.rgba.empty())
    {
        return testing::AssertionFailure() << check.name << ": " << expression
                                           << " has no pixels; draw it before it is compared.";
    }
    GoldenCandidate candidate;
    candidate.name = check.name;
    candidate.frame = frame;
    candidate.fingerprint = DefaultFingerprint();
    return Check(candidate, check.compare);
}

/// EXPECT_GOLDEN_WORLD calls it.
inline testing::AssertionResult IsGoldenWorld(const char*, const char*, b2World& world,
                                              const WorldCheck& check)
{
    return Check(CandidateOf(world, check.name, check.look), check.compare);
}

/// What EXPECT_GOLDEN_FILM compares with.
struct FilmCheck
{
    std::string name;           ///< of the reference
    ContactSheetSettings sheet; ///< which moments are compared
    CompareSettings compare;    ///< presets and limits
};

/// EXPECT_GOLDEN_FILM's second argument: a name, moments and limits.
inline FilmCheck CheckFilmAs(std::string name, ContactSheetSettings sheet = {},
                             CompareSettings compare = {})
{
    return {std::move(name), sheet, std::move(compare)};
}

/// EXPECT_GOLDEN_FILM calls it.
inline testing::AssertionResult
IsGoldenFilm(const char*, const char*, const std::filesystem::path& film, const FilmCheck& check)
{
    Result<ContactSheet> sheet = ContactSheetOf(film, check.sheet);
    if (!sheet)
    {
        return testing::AssertionFailure() << sheet.GetError().Text();
    }
    GoldenCandidate candidate = CandidateOf(std::move(*sheet), check.name);
    candidate.fingerprint = DefaultFingerprint();
    return Check(candidate, check.compare);
}

} // namespace boxreel::golden_test

/// Fails the test where a frame is not what was approved: (frame, name [, CompareSettings]).
#define EXPECT_GOLDEN(frame, ...)                                                                  \
    EXPECT_PRED_FORMAT2(::boxreel::golden_test::IsGolden, frame,                                   \
                        ::boxreel::golden_test::CheckAs(__VA_ARGS__))
/// As EXPECT_GOLDEN, and the test ends where it fails.
#define ASSERT_GOLDEN(frame, ...)                                                                  \
    ASSERT_PRED_FORMAT2(::boxreel::golden_test::IsGolden, frame,                                   \
                        ::boxreel::golden_test::CheckAs(__VA_ARGS__))

/// Fails the test where a world is not what was approved: (world, name [, GoldenWorldLook [,
/// CompareSettings]]).
#define EXPECT_GOLDEN_WORLD(world, ...)                                                            \
    EXPECT_PRED_FORMAT2(::boxreel::golden_test::IsGoldenWorld, world,                              \
                        ::boxreel::golden_test::CheckWorldAs(__VA_ARGS__))
/// As EXPECT_GOLDEN_WORLD, and the test ends where it fails.
#define ASSERT_GOLDEN_WORLD(world, ...)                                                            \
    ASSERT_PRED_FORMAT2(::boxreel::golden_test::IsGoldenWorld, world,                              \
                        ::boxreel::golden_test::CheckWorldAs(__VA_ARGS__))

/// Fails the test where a film is not what was approved: (path of a film, name [,
/// ContactSheetSettings [, CompareSettings]]).
#define EXPECT_GOLDEN_FILM(film, ...)                                                              \
    EXPECT_PRED_FORMAT2(::boxreel::golden_test::IsGoldenFilm, film,                                \
                        ::boxreel::golden_test::CheckFilmAs(__VA_ARGS__))
/// As EXPECT_GOLDEN_FILM, and the test ends where it fails.
#define ASSERT_GOLDEN_FILM(film, ...)                                                              \
    ASSERT_PRED_FORMAT2(::boxreel::golden_test::IsGoldenFilm, film,                                \
                        ::boxreel::golden_test::CheckFilmAs(__VA_ARGS__))
