// SPDX-License-Identifier: MIT
#include "../base/Errors.h"
#include "../base/TemporaryFolder.h"
#include "TestFilm.h"

#include "SequenceName.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{

using namespace testfilm;
using boxreel::Fails;
using boxreel::ParseSequenceName;
using boxreel::Refuses;
using boxreel::Result;
using boxreel::VideoWriter;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

const boxreel::VideoSettings kSmall{.width = 64, .height = 48};

class PngSequence : public testing::Test
{
protected:
    TemporaryFolder m_folder;
};

TEST_F(PngSequence, IsNumberedFromZeroWithAsManyDigitsAsMarks)
{
    WriteFilm(m_folder / "a-###-b.png", kSmall, Drawings(64, 48, 3));
    EXPECT_THAT(m_folder.Names(),
                UnorderedElementsAre("a-000-b.png", "a-001-b.png", "a-002-b.png"));
}

TEST_F(PngSequence, UsesMoreDigitsForLargerNumbers)
{
    WriteFilm(m_folder / "#.png", kSmall, Drawings(64, 48, 12));
    EXPECT_TRUE(std::filesystem::exists(m_folder / "9.png"));
    EXPECT_TRUE(std::filesystem::exists(m_folder / "11.png"));
    EXPECT_EQ(ReadFilm(m_folder / "#.png").frames, Drawings(64, 48, 12));
}

TEST_F(PngSequence, IsTheSameWithAnyNumberOfThreads)
{
    for (const int threads : {1, 2, 5})
    {
        boxreel::VideoSettings settings = kSmall;
        settings.threads = threads;
        settings.overwrite = true;
        WriteFilm(m_folder / "a-##.png", settings, Drawings(64, 48, 40));
        EXPECT_EQ(ReadFilm(m_folder / "a-##.png").frames, Drawings(64, 48, 40)) << threads;
    }
}

TEST_F(PngSequence, WritesRepeatedFrameToOwnFile)
{
    Result<VideoWriter> writer = VideoWriter::Open(m_folder / "a-#.png", kSmall);
    ASSERT_TRUE(writer);
    ASSERT_TRUE(writer->Append(Drawing(64, 48, 0)));
    ASSERT_TRUE(writer->Repeat());
    ASSERT_TRUE(writer->Append(Drawing(64, 48, 7)));
    ASSERT_TRUE(writer->Repeat());
    ASSERT_TRUE(writer->Close());
    EXPECT_EQ(ReadBytes(m_folder / "a-0.png"), ReadBytes(m_folder / "a-1.png"));
    EXPECT_EQ(ReadFilm(m_folder / "a-#.png").frames.size(), 4u);
    EXPECT_EQ(ReadFilm(m_folder / "a-#.png").frames[3], Drawing(64, 48, 7));
}

TEST_F(PngSequence, IsGoneWhenTheWriterIsDestroyedBeforeClose)
{
    {
        Result<VideoWriter> writer = VideoWriter::Open(m_folder / "a-##.png", kSmall);
        ASSERT_TRUE(writer);
        for (int i = 0; i < 20; ++i)
        {
            ASSERT_TRUE(writer->Append(Drawing(64, 48, i)));
        }
    }
    EXPECT_THAT(m_folder.Names(), IsEmpty());
}

TEST_F(PngSequence, IsNotMixedWithAnOlderOneUnlessAllowed)
{
    WriteBytes(m_folder / "a-0017.png", "precious");
    const Result<VideoWriter> refused = VideoWriter::Open(m_folder / "a-####.png", kSmall);
    EXPECT_THAT(refused, Refuses((m_folder / "a-0017.png").string()));
    EXPECT_THAT(m_folder.Names(), ElementsAre("a-0017.png"));
    boxreel::VideoSettings settings = kSmall;
    settings.overwrite = true;
    WriteFilm(m_folder / "a-####.png", settings, Drawings(64, 48, 20));
    EXPECT_EQ(ReadFilm(m_folder / "a-####.png").frames, Drawings(64, 48, 20));
}

TEST_F(PngSequence, FailsWhenAForeignFileExists)
{
    Result<VideoWriter> writer = VideoWriter::Open(m_folder / "a-##.png", kSmall);
    ASSERT_TRUE(writer);
    std::filesystem::create_directory(m_folder / "a-05.png"); // turns up meanwhile
    Result<void> done;
    for (int i = 0; i < 40 && done; ++i)
    {
        done = writer->Append(Drawing(64, 48, i));
    }
    EXPECT_THAT(done, Fails(testing::_, (m_folder / "a-05.png").string()));
    EXPECT_THAT(m_folder.Names(), ElementsAre("a-05.png"));
}

TEST(SequenceName, ReadsOnlyItsOwnNumbers)
{
    const boxreel::SequenceName name = *ParseSequenceName("folder/a#-###.png");
    EXPECT_EQ(name.PathOf(7), std::filesystem::path("folder/a#-007.png"));
    EXPECT_EQ(name.PathOf(12345), std::filesystem::path("folder/a#-12345.png"));
    EXPECT_EQ(name.NumberIn("a#-007.png"), 7);
    EXPECT_EQ(name.NumberIn("a#-12345.png"), 12345);
    for (const char* other :
         {"a#-7.png", "a#-0007.png", "a#-.png", "a#-00x.png", "b#-007.png", "a#-007.part.png", ""})
    {
        EXPECT_FALSE(name.NumberIn(other)) << other;
    }
    EXPECT_FALSE(ParseSequenceName("folder-##/a.png"));
}

} // namespace
