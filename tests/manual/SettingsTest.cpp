// SPDX-License-Identifier: MIT
// The only header of the engine here: it has to hold all that the section promises.
#include <Box2D/Common/b2Settings.h>

#include <gtest/gtest.h>

#include <type_traits>

/// The section about the settings.
namespace
{

TEST(Types, HaveTheSizesOfTheirNames)
{
    EXPECT_EQ(sizeof(int8), 1u);
    EXPECT_EQ(sizeof(int16), 2u);
    EXPECT_EQ(sizeof(int32), 4u);
    EXPECT_EQ(sizeof(uint8), 1u);
    EXPECT_EQ(sizeof(uint16), 2u);
    EXPECT_EQ(sizeof(uint32), 4u);
    EXPECT_EQ(sizeof(float32), 4u);
    EXPECT_EQ(sizeof(float64), 8u);
    EXPECT_TRUE(std::is_signed_v<int8> && std::is_unsigned_v<uint8>);
}

TEST(Constants, HaveTheValuesOfTheManual)
{
    EXPECT_EQ(b2_maxPolygonVertices, 8);
    EXPECT_EQ(b2_linearSlop, 0.005f);
    EXPECT_GT(b2_polygonRadius, b2_linearSlop);
    EXPECT_EQ(b2_velocityThreshold, 1.0f);
    EXPECT_FLOAT_EQ(b2_pi, 3.14159265f);
}

TEST(Version, CanBeReadAtRunTime)
{
    const b2Version version = b2_version;
    EXPECT_EQ(version.major, 2);
    EXPECT_EQ(version.minor, 3);
    EXPECT_EQ(version.revision, 0);
}

TEST(AllocationWrappersSection, AreFunctionsOfTheSettings)
{
    void* memory = b2Alloc(16);
    EXPECT_NE(memory, nullptr);
    b2Free(memory);
}

} // namespace
