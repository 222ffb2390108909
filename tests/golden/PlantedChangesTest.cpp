// SPDX-License-Identifier: MIT
#include <golden/ReferenceStore.h>

#include "../base/TemporaryFolder.h"
#include "TestPictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

using namespace boxreel;
using namespace boxreel::test;
using testing::HasSubstr;

namespace
{

constexpr std::size_t kOverlapped = 1; // the item that the next one covers in part
constexpr std::size_t kJointLine = 4;
constexpr std::size_t kLabel = 5;

// A small scene that was approved, and changes of the kind that slip through a review.
class PlantedChange : public testing::TestWithParam<std::string>
{
protected:
    void SetUp() override
    {
        m_style.ground = GetParam() == "DarkGround" ? kDark : kLight;
        ASSERT_TRUE(m_store.Accept(Candidate("scene/3s", SmallScene(), m_style)));
    }

    GoldenVerdict Verify(const DrawList& list, const Style& style)
    {
        Result<GoldenVerdict> verdict = m_store.Verify(Candidate("scene/3s", list, style));
        EXPECT_TRUE(verdict) << verdict.GetError().Text();
        return *std::move(verdict);
    }

    // Compares only the pixels, like a project without draw lists.
    Comparison Pixels(const DrawList& list, const Style& style)
    {
        return Compare(Painted(SmallScene(), m_style), Painted(list, style));
    }

    TemporaryFolder m_folder;
    ReferenceStore m_store{m_folder / "references", m_folder / "output"};
    Style m_style;
};

} // namespace

TEST_P(PlantedChange, IsNotReportedForUnchangedPicture)
{
    for (int i = 0; i < 3; ++i)
    {
        EXPECT_EQ(Verify(SmallScene(), m_style).status, GoldenStatus::Same);
    }
}

TEST_P(PlantedChange, IsFoundInDrawListWhenBodyMovesByCentimetre)
{
    DrawList moved = SmallScene();
    const DrawItem& body = moved.items[3];
    for (std::size_t i = 0; i < body.count; ++i)
    {
        moved.points[body.first + i].x += 0.01f;
    }
    const GoldenVerdict verdict = Verify(moved, m_style);
    EXPECT_TRUE(verdict.pixels.equal) << "a seventh of a pixel";
    EXPECT_EQ(verdict.status, GoldenStatus::DrawList);
    ASSERT_TRUE(verdict.list && verdict.list->actual);
    EXPECT_EQ(verdict.list->line, 4u);
    EXPECT_THAT(*verdict.list->actual, HasSubstr("4.01"));
}

TEST_P(PlantedChange, IsFoundWhenJointLineIsMissing)
{
    const DrawList changed = WithoutItem(SmallScene(), kJointLine);
    EXPECT_EQ(Verify(changed, m_style).status, GoldenStatus::DrawList);
    EXPECT_FALSE(Pixels(changed, m_style).equal);
}

TEST_P(PlantedChange, IsFoundWhenFillIsOffByFour)
{
    for (const int shift : {4, -4})
    {
        Style style = m_style;
        style.fillShift = shift;
        const GoldenVerdict verdict = Verify(SmallScene(), style);
        EXPECT_EQ(verdict.status, GoldenStatus::Pixels);
    }
}

TEST_P(PlantedChange, IsFoundWhenLabelIsMisspelt)
{
    for (const char* wrong : {"cramk", "Crank", "crnak"})
    {
        DrawList changed = SmallScene();
        changed.texts[changed.items[kLabel].text] = wrong;
        const GoldenVerdict verdict = Verify(changed, m_style);
        EXPECT_EQ(verdict.status, GoldenStatus::DrawList);
        ASSERT_TRUE(verdict.list && verdict.list->actual && verdict.list->expected);
        EXPECT_THAT(*verdict.list->actual, HasSubstr(wrong));
        EXPECT_THAT(*verdict.list->expected, HasSubstr("crank"));
        EXPECT_FALSE(Pixels(changed, m_style).equal);
    }
}

TEST_P(PlantedChange, IsFoundWhenOutlineIsOnePixelThicker)
{
    Style style = m_style;
    style.outline = 2;
    EXPECT_EQ(Verify(SmallScene(), style).status, GoldenStatus::Pixels);
}

TEST_P(PlantedChange, IsFoundWhenDrawOrderIsSwapped)
{
    const DrawList changed = WithSwappedOrder(SmallScene(), kOverlapped);
    EXPECT_EQ(Verify(changed, m_style).status, GoldenStatus::DrawList);
    EXPECT_FALSE(Pixels(changed, m_style).equal);
}

TEST_P(PlantedChange, IsFoundWhenPictureIsShiftedByOnePixel)
{
    Style style = m_style;
    DrawList changed = SmallScene();
    for (Vec2& point : changed.points)
    {
        point.x += static_cast<float>(1.0 / style.pixelsPerMeter);
    }
    EXPECT_FALSE(Pixels(changed, style).equal);
}

INSTANTIATE_TEST_SUITE_P(On, PlantedChange, testing::Values("DarkGround", "LightGround"),
                         [](const auto& which) { return which.param; });
