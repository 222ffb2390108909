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
/// References are in the folder BOXREEL_GOLDEN_REFERENCES (environment variable, otherwise a
/// definition of the compiler). Failures write their pictures to BOXREEL_GOLDEN_OUTPUT (default
/// golden-output in the working folder). BOXREEL_GOLDEN_ACCEPT=missing|changed|all|this-renderer
/// accepts candidates as references.
namespace boxreel::golden_test
{

/// The reference and limits of EXPECT_GOLDEN.
struct FrameCheck
{
    std::string name;        ///< name of the reference
    CompareSettings compare; ///< limits
};

/// Returns EXPECT_GOLDEN's arguments: a name, and optional limits.
inline FrameCheck CheckAs(std::string name, CompareSettings compare = {})
{
    return {std::move(name), std::move(compare)};
}

/// The reference, drawing and limits of EXPECT_GOLDEN_WORLD.
struct WorldCheck
{
    std::string name;        ///< name of the reference
    GoldenWorldLook look;    ///< look of the world
    CompareSettings compare; ///< limits
};

/// Returns EXPECT_GOLDEN_WORLD's arguments: a name, and optional look and limits.
inline WorldCheck CheckWorldAs(std::string name, GoldenWorldLook look = {},
                               CompareSettings compare = {})
{
    return {std::move(name), std::move(look), std::move(compare)};
}

/// Returns the folder set by boxreel_add_golden_tests.
inline std::filesystem::path CompiledReferences()
{
#ifdef BOXREEL_GOLDEN_REFERENCES
    return BOXREEL_GOLDEN_REFERENCES;
#else
    return {};
#endif
}

/// Compares a candidate; an Error fails the test with its text.
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

/// Called by EXPECT_GOLDEN.
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

/// Called by EXPECT_GOLDEN_WORLD.
inline testing::AssertionResult IsGoldenWorld(const char*, const char*, b2World& world,
                                              const WorldCheck& check)
{
    return Check(CandidateOf(world, check.name, check.look), check.compare);
}

/// The reference, sampling and limits of EXPECT_GOLDEN_FILM.
struct FilmCheck
{
    std::string name;           ///< name of the reference
    ContactSheetSettings sheet; ///< the moments to compare
    CompareSettings compare;    ///< limits
};

/// Returns EXPECT_GOLDEN_FILM's arguments: a name, and optional sampling and limits.
inline FilmCheck CheckFilmAs(std::string name, ContactSheetSettings sheet = {},
                             CompareSettings compare = {})
{
    return {std::move(name), sheet, std::move(compare)};
}

/// Called by EXPECT_GOLDEN_FILM.
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

/// Fails the test if a frame differs from its reference: (frame, name [, CompareSettings]).
#define EXPECT_GOLDEN(frame, ...)                                                                  \
    EXPECT_PRED_FORMAT2(::boxreel::golden_test::IsGolden, frame,                                   \
                        ::boxreel::golden_test::CheckAs(__VA_ARGS__))
/// Same as EXPECT_GOLDEN, but ends the test on failure.
#define ASSERT_GOLDEN(frame, ...)                                                                  \
    ASSERT_PRED_FORMAT2(::boxreel::golden_test::IsGolden, frame,                                   \
                        ::boxreel::golden_test::CheckAs(__VA_ARGS__))

/// Fails the test if a world differs from its reference: (world, name [, GoldenWorldLook [,
/// CompareSettings]]).
#define EXPECT_GOLDEN_WORLD(world, ...)                                                            \
    EXPECT_PRED_FORMAT2(::boxreel::golden_test::IsGoldenWorld, world,                              \
                        ::boxreel::golden_test::CheckWorldAs(__VA_ARGS__))
/// Same as EXPECT_GOLDEN_WORLD, but ends the test on failure.
#define ASSERT_GOLDEN_WORLD(world, ...)                                                            \
    ASSERT_PRED_FORMAT2(::boxreel::golden_test::IsGoldenWorld, world,                              \
                        ::boxreel::golden_test::CheckWorldAs(__VA_ARGS__))

/// Fails the test if a film differs from its reference: (path of a film, name [,
/// ContactSheetSettings [, CompareSettings]]).
#define EXPECT_GOLDEN_FILM(film, ...)                                                              \
    EXPECT_PRED_FORMAT2(::boxreel::golden_test::IsGoldenFilm, film,                                \
                        ::boxreel::golden_test::CheckFilmAs(__VA_ARGS__))
/// Same as EXPECT_GOLDEN_FILM, but ends the test on failure.
#define ASSERT_GOLDEN_FILM(film, ...)                                                              \
    ASSERT_PRED_FORMAT2(::boxreel::golden_test::IsGoldenFilm, film,                                \
                        ::boxreel::golden_test::CheckFilmAs(__VA_ARGS__))
