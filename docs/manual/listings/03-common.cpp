// SPDX-License-Identifier: MIT
#include "Stage.h"

#include <gmock/gmock.h>

#include <cstdio>
#include <cstdlib>

namespace
{

// [allocator]
int32 blocksOut = 0;

void* CountedAlloc(std::size_t size)
{
    ++blocksOut;
    return std::malloc(size);
}

void CountedFree(void* memory)
{
    --blocksOut;
    std::free(memory);
}
// [/allocator]

TEST(CommonListing, PutsTheProgramsMemoryBehindTheWorld)
{
    // [set-allocator]
    b2SetAllocator(CountedAlloc, CountedFree); // before the first world is made
    // [/set-allocator]
    {
        manual::Stage stage;
        stage.Ground();
        stage.Box(0.0f, 3.0f);
        stage.Run(1.0f);
        EXPECT_GT(blocksOut, 0);
    }
    EXPECT_EQ(blocksOut, 0);
    b2SetAllocator(nullptr, nullptr);
}

TEST(CommonListing, TellsItsVersion)
{
    testing::internal::CaptureStdout();
    // [version]
    std::printf("Box2D %d.%d.%d\n", b2_version.major, b2_version.minor, b2_version.revision);
    // [/version]
    const std::string printed = testing::internal::GetCapturedStdout();
    EXPECT_THAT(manual::PageText("03-common.md"), testing::HasSubstr("`" + printed.substr(0, 11)));
    EXPECT_EQ(printed, "Box2D 2.3.0\n");
}

TEST(CommonListing, GoesFromFrameToFrame)
{
    // [transforms]
    const b2Transform car(b2Vec2(10.0f, 2.0f), b2Rot(0.5f * b2_pi)); // turned to the left
    const b2Vec2 lamp(1.5f, 0.0f);                                   // in the car's frame
    const b2Vec2 inWorld = b2Mul(car, lamp);                         // (10, 3.5)
    const b2Vec2 inCar = b2MulT(car, inWorld);                       // (1.5, 0) again
    // [/transforms]
    EXPECT_NEAR(b2Distance(inWorld, b2Vec2(10.0f, 3.5f)), 0.0f, 1e-6f);
    EXPECT_NEAR(b2Distance(inCar, lamp), 0.0f, 1e-6f);
}

/// A number as the tables of the page write it.
std::string Written(float32 value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", double(value));
    return text;
}

TEST(CommonListing, HasTheConstantsOfTheTable)
{
    struct Row
    {
        const char* name;
        float32 value;
        const char* unit;
    };
    const float32 degree = b2_pi / 180.0f;
    const Row rows[] = {
        {"b2_linearSlop", b2_linearSlop, " m"},
        {"b2_angularSlop", b2_angularSlop / degree, " degrees"},
        {"b2_polygonRadius", b2_polygonRadius, " m"},
        {"b2_aabbExtension", b2_aabbExtension, " m"},
        {"b2_aabbMultiplier", b2_aabbMultiplier, ""},
        {"b2_maxManifoldPoints", float32(b2_maxManifoldPoints), ""},
        {"b2_maxPolygonVertices", float32(b2_maxPolygonVertices), ""},
        {"b2_polygonCapacity", float32(b2_polygonCapacity), ""},
        {"b2_maxSubSteps", float32(b2_maxSubSteps), ""},
        {"b2_maxTOIContacts", float32(b2_maxTOIContacts), ""},
        {"b2_velocityThreshold", b2_velocityThreshold, " m/s"},
        {"b2_maxLinearCorrection", b2_maxLinearCorrection, " m"},
        {"b2_maxAngularCorrection", b2_maxAngularCorrection / degree, " degrees"},
        {"b2_maxTranslation", b2_maxTranslation, " m"},
        {"b2_maxRotation", b2_maxRotation / degree, " degrees"},
        {"b2_baumgarte", b2_baumgarte, ""},
        {"b2_toiBaugarte", b2_toiBaugarte, ""},
        {"b2_timeToSleep", b2_timeToSleep, " s"},
        {"b2_linearSleepTolerance", b2_linearSleepTolerance, " m/s"},
        {"b2_angularSleepTolerance", b2_angularSleepTolerance / degree, " degrees/s"},
    };
    const std::string page = manual::SectionText("03-common.md", "## Constants");
    for (const Row& row : rows)
    {
        EXPECT_THAT(page, testing::HasSubstr(std::string("| `") + row.name + "` | " +
                                             Written(row.value) + row.unit + " |"));
    }
}

} // namespace
