// SPDX-License-Identifier: MIT
#include "Pictures.h"
#include "Truth.h"

#include <random>

// The maximum difference of edges from the mean of 16 x 16 points per pixel, of 255. The reference
// itself is off by about 1, because its points are on a grid. Compared with 64 x 64 points,
// straight edges are within the rounding of 8 bits.
using namespace boxreel;

namespace
{

constexpr int kWidth = 320;
constexpr int kHeight = 240;

class Random
{
public:
    float Between(float a, float b)
    {
        return a + (b - a) * float(m_generator() % 100000u) / 100000.0f;
    }
    Vec2 Anywhere(float margin)
    {
        return {Between(margin, kWidth - margin), Between(margin, kHeight - margin)};
    }

private:
    std::mt19937 m_generator{7};
};

/// Places on a grid, so neighbours do not touch. Where shapes overlap, a renderer that draws one
/// after the other cannot know how their parts of a pixel overlap.
template <class AddShape>
DrawList OnGrid(float cell, const AddShape& addShape)
{
    Random random;
    DrawList list;
    for (float y = 0.5f * cell; y < kHeight; y += cell)
    {
        for (float x = 0.5f * cell; x < kWidth; x += cell)
        {
            addShape(list, random,
                     Vec2{x + random.Between(-1.0f, 1.0f), y + random.Between(-1.0f, 1.0f)});
        }
    }
    return list;
}

EdgeError ErrorOf(const DrawList& list, const char* what, int grid = 16,
                  const Theme& theme = Theme::Classic())
{
    const Frame frame = Picture(list, kWidth, kHeight, theme);
    const EdgeError error =
        Compare(frame, Supersample(list, PixelCamera(kWidth, kHeight), theme, grid));
    EXPECT_GT(error.edgePixels, 500u) << what;
    std::printf("%-32s rms %.2f, most %.1f of 255, on %zu edge pixels\n", what, error.rms,
                error.maximum, error.edgePixels);
    return error;
}

void AddRandomBox(DrawList& list, Random& random, Vec2 at)
{
    AddTurnedBox(list, at, random.Between(3, 12), random.Between(3, 12), random.Between(0, 6),
                 kAwake);
}

} // namespace

TEST(Edges, AreExactForBoxes)
{
    const EdgeError error = ErrorOf(OnGrid(40, AddRandomBox), "boxes");
    EXPECT_LE(error.rms, 1.1);
    EXPECT_LE(error.maximum, 10.0);
}

TEST(Edges, AreExactForPolygons)
{
    const auto add = [](DrawList& list, Random& random, Vec2 at) {
        AddRegular(list, at, random.Between(4, 16), random.Between(4, 16),
                   3 + int(random.Between(0, 5.99f)), random.Between(0, 6), kStatic);
    };
    const EdgeError error = ErrorOf(OnGrid(40, add), "polygons");
    EXPECT_LE(error.rms, 1.0);
    EXPECT_LE(error.maximum, 8.0);
}

TEST(Edges, AreExactForSlivers)
{
    const auto add = [](DrawList& list, Random& random, Vec2 at) {
        AddRegular(list, at, random.Between(8, 16), random.Between(0.05f, 2.0f),
                   3 + int(random.Between(0, 5.99f)), random.Between(0, 6), kKinematic);
    };
    const EdgeError error = ErrorOf(OnGrid(40, add), "slivers");
    EXPECT_LE(error.rms, 1.0);
    EXPECT_LE(error.maximum, 9.0);
}

TEST(Edges, AreExactForShapesSmallerThanAPixel)
{
    const auto add = [](DrawList& list, Random& random, Vec2 at) {
        AddTurnedBox(list, at, random.Between(0.05f, 0.6f), random.Between(0.05f, 0.6f),
                     random.Between(0, 6), kAwake);
    };
    const EdgeError error = ErrorOf(OnGrid(8, add), "tiny boxes");
    EXPECT_LE(error.rms, 1.1);
    EXPECT_LE(error.maximum, 10.0);
}

TEST(Edges, AreExactForCircles)
{
    const auto add = [](DrawList& list, Random& random, Vec2 at) {
        const float angle = random.Between(0, 6);
        list.AddSolidCircle(at, random.Between(3, 17), {std::cos(angle), std::sin(angle)}, kAwake);
    };
    const EdgeError error = ErrorOf(OnGrid(40, add), "circles with axis");
    EXPECT_LE(error.rms, 1.1);
    EXPECT_LE(error.maximum, 16.0);
}

TEST(Edges, AreExactForRings)
{
    const auto add = [](DrawList& list, Random& random, Vec2 at) {
        list.AddCircle(at, random.Between(3, 17), kStatic);
    };
    const EdgeError error = ErrorOf(OnGrid(40, add), "rings");
    EXPECT_LE(error.rms, 1.1);
    EXPECT_LE(error.maximum, 6.0);
}

TEST(Edges, AreNearlyExactForSmallDiscs)
{
    const auto circle = [](DrawList& list, Random& random, Vec2 at) {
        list.AddCircle(at, random.Between(0.1f, 3.0f), kStatic);
    };
    EXPECT_LE(ErrorOf(OnGrid(10, circle), "small rings").rms, 1.2);
    const auto point = [](DrawList& list, Random& random, Vec2 at) {
        list.AddPoint(at, random.Between(0.5f, 9.0f), kStatic);
    };
    EXPECT_LE(ErrorOf(OnGrid(12, point), "points").rms, 1.1);
}

TEST(Edges, AreExactForLinesExceptTheirEnds)
{
    const auto add = [](DrawList& list, Random& random, Vec2 at) {
        const float angle = random.Between(0, 6);
        const float length = random.Between(10, 18);
        list.AddSegment({at.x - length * std::cos(angle), at.y - length * std::sin(angle)},
                        {at.x + length * std::cos(angle), at.y + length * std::sin(angle)}, kAwake);
    };
    EXPECT_LE(ErrorOf(OnGrid(40, add), "lines").rms, 1.8);
}

TEST(Edges, AreRoundAtEndsOfThickLines)
{
    Theme theme = Theme::Classic();
    theme.outlineWidth = 8.0f;
    const auto add = [](DrawList& list, Random& random, Vec2 at) {
        const float angle = random.Between(0, 6);
        list.AddSegment(at, {at.x + 12 * std::cos(angle), at.y + 12 * std::sin(angle)}, kAwake);
    };
    const EdgeError error = ErrorOf(OnGrid(50, add), "thick lines", 16, theme);
    EXPECT_LE(error.rms, 1.2);
    EXPECT_LE(error.maximum, 8.0);
}

TEST(Edges, AreMoreExactAgainstFinerSampling)
{
    const double coarse = ErrorOf(OnGrid(64, AddRandomBox), "boxes, 16 x 16 points").rms;
    const double fine = ErrorOf(OnGrid(64, AddRandomBox), "boxes, 48 x 48 points", 48).rms;
    EXPECT_LT(fine, coarse);
    EXPECT_LE(fine, 0.7);
}
