// SPDX-License-Identifier: MIT
#include "../cli/Subprocess.h"

#include <film/FilmPapers.h>

#include <gmock/gmock.h>

#include <fstream>

namespace boxreel
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

FilmPapers Papers()
{
    return {.version = "1.2.3",
            .command = {"record", "pyramid", "--frames", "400"},
            .framesPerSecond = {30000, 1001},
            .groupFrames = 50,
            .plays = 3,
            .frameCount = 400,
            .first = 100,
            .end = 200,
            .checksum = "0011223344556677 of 8 bytes",
            .states = {{100, "0123456789abcdef"}, {200, "fedcba9876543210"}}};
}

class FilmPapersFile : public testing::Test
{
protected:
    void Write(const std::string& text) const
    {
        std::ofstream(PapersPath(m_folder / "a.mkv")) << text;
    }

    std::string Refusal() const
    {
        const Result<FilmPapers> papers = ReadPapers(m_folder / "a.mkv", "do this");
        return papers ? "accepted" : papers.GetError().culprit;
    }

    TemporaryFolder m_folder;
};

TEST_F(FilmPapersFile, ComeBackAsTheyWereWritten)
{
    ASSERT_TRUE(WritePapers(m_folder / "a.mkv", Papers()));
    EXPECT_THAT(m_folder.Files(), ElementsAre("a.mkv.json"));
    const Result<FilmPapers> read = ReadPapers(m_folder / "a.mkv", "");
    ASSERT_TRUE(read) << read.GetError().Text();
    EXPECT_EQ(DifferenceOf(*read, Papers()), "");
    EXPECT_EQ(read->framesPerSecond, Papers().framesPerSecond);
    EXPECT_EQ(read->groupFrames, 50);
    EXPECT_EQ(read->plays, 3);
    EXPECT_EQ(read->frameCount, 400);
    EXPECT_EQ(read->first, 100);
    EXPECT_EQ(read->end, 200);
    EXPECT_EQ(read->checksum, Papers().checksum);
    EXPECT_EQ(read->states, Papers().states);
}

TEST_F(FilmPapersFile, ThatAreMissingAreNamedWithTheRemedy)
{
    EXPECT_EQ(Refusal(), (m_folder / "a.mkv.json").string());
}

TEST_F(FilmPapersFile, ThatAreDamagedAreNamedWithTheRemedy)
{
    ASSERT_TRUE(WritePapers(m_folder / "a.mkv", Papers()));
    const std::string good = ReadFile(m_folder / "a.mkv.json");
    const auto with = [&good](const std::string& from, const std::string& to) {
        std::string text = good;
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    };
    Write(good);
    ASSERT_EQ(Refusal(), "accepted");
    for (const std::string& bad :
         {std::string(), std::string("no papers"), std::string("[]"), good.substr(0, 60),
          with("\"group\": 50", "\"group\": 0"), with("\"end\": 200", "\"end\": 100"),
          with("\"first\": 100", "\"first\": -1"), with("\"frames\": 400", "\"frames\": 199"),
          with("1001", "0"), with("\"loop\": 3", "\"loop\": \"3\""), with("\"200\"", "\"x\"")})
    {
        Write(bad);
        EXPECT_EQ(Refusal(), (m_folder / "a.mkv.json").string()) << bad;
    }
}

TEST_F(FilmPapersFile, TellAFilmFromEveryOther)
{
    const auto checksum = [this](const std::string& bytes) {
        std::ofstream(m_folder / "a.mkv") << bytes;
        return ChecksumOfFilm(m_folder / "a.mkv");
    };
    std::string film(3'000'000, 'x'); // more than is read at once
    const std::string whole = checksum(film);
    EXPECT_THAT(whole, HasSubstr(" of 3000000 bytes"));
    film[2'999'999] = 'y';
    EXPECT_NE(checksum(film), whole);
    film[2'999'999] = 'x';
    EXPECT_EQ(checksum(film), whole);
    EXPECT_EQ(ChecksumOfFilm(m_folder / "none.mkv"), "");
    EXPECT_EQ(ChecksumOfFilm(m_folder.Path()), "");
}

TEST(FilmPapers, TheCommandIsWithoutWhatChangesNoFrame)
{
    EXPECT_THAT(CommandOfFilm({"record", "pyramid", "-o", "a.mkv", "--force", "--resume",
                               "--frame-range=0-9", "--quality", "high", "--progress", "none",
                               "--thumbnail", "a.png", "--thumbnail-at", "1s", "--stats",
                               "--backend=osmesa"}),
                ElementsAre("record", "pyramid", "--quality", "high"));
}

TEST(FilmPapers, TheCommandIsWithoutAFileAttachedToItsOption)
{
    for (const char* output : {"-oa.mkv", "-o=a.mkv", "-oa=b.mkv"})
    {
        EXPECT_THAT(CommandOfFilm({"record", "pyramid", output, "--quality", "high"}),
                    ElementsAre("record", "pyramid", "--quality", "high"))
            << output;
    }
}

TEST(FilmPapers, SayWhatDiffers)
{
    FilmPapers other = Papers();
    other.first = 0;
    EXPECT_EQ(DifferenceOf(Papers(), other), "") << "another part of the same film";
    other.version = "1.2.4";
    EXPECT_EQ(DifferenceOf(Papers(), other), "versions 1.2.3 and 1.2.4 of this program made them");
    other.command.back() = "401";
    EXPECT_EQ(DifferenceOf(Papers(), other), "the commands differ: `record pyramid --frames 400` "
                                             "and `record pyramid --frames 401`");
}

} // namespace
} // namespace boxreel
