// SPDX-License-Identifier: MIT
#include "../cli/Subprocess.h"

#include <film/Manifest.h>

#include <gmock/gmock.h>

#include <fstream>

namespace boxreel
{
namespace
{

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

Manifest Sample()
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

class ManifestFile : public testing::Test
{
protected:
    void Write(const std::string& text) const
    {
        std::ofstream(ManifestPath(m_folder / "a.mkv")) << text;
    }

    std::string Refusal() const
    {
        const Result<Manifest> manifest = ReadManifest(m_folder / "a.mkv", "do this");
        return manifest ? "accepted" : manifest.GetError().culprit;
    }

    TemporaryFolder m_folder;
};

TEST_F(ManifestFile, IsReadAsItWasWritten)
{
    ASSERT_TRUE(WriteManifest(m_folder / "a.mkv", Sample()));
    EXPECT_THAT(m_folder.Names(), ElementsAre("a.mkv.json"));
    const Result<Manifest> read = ReadManifest(m_folder / "a.mkv", "");
    ASSERT_TRUE(read) << read.GetError().Text();
    EXPECT_EQ(DifferenceOf(*read, Sample()), "");
    EXPECT_EQ(read->framesPerSecond, Sample().framesPerSecond);
    EXPECT_EQ(read->groupFrames, 50);
    EXPECT_EQ(read->plays, 3);
    EXPECT_EQ(read->frameCount, 400);
    EXPECT_EQ(read->first, 100);
    EXPECT_EQ(read->end, 200);
    EXPECT_EQ(read->checksum, Sample().checksum);
    EXPECT_EQ(read->states, Sample().states);
}

TEST_F(ManifestFile, IsNamedWhenMissing)
{
    EXPECT_EQ(Refusal(), (m_folder / "a.mkv.json").string());
}

TEST_F(ManifestFile, IsNamedWhenDamaged)
{
    ASSERT_TRUE(WriteManifest(m_folder / "a.mkv", Sample()));
    const std::string good = ReadBytes(m_folder / "a.mkv.json");
    const auto with = [&good](const std::string& from, const std::string& to) {
        std::string text = good;
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    };
    Write(good);
    ASSERT_EQ(Refusal(), "accepted");
    for (const std::string& bad :
         {std::string(), std::string("no manifest"), std::string("[]"), good.substr(0, 60),
          with("\"group\": 50", "\"group\": 0"), with("\"end\": 200", "\"end\": 100"),
          with("\"first\": 100", "\"first\": -1"), with("\"frames\": 400", "\"frames\": 199"),
          with("1001", "0"), with("\"loop\": 3", "\"loop\": \"3\""), with("\"200\"", "\"x\"")})
    {
        Write(bad);
        EXPECT_EQ(Refusal(), (m_folder / "a.mkv.json").string()) << bad;
    }
}

TEST_F(ManifestFile, ChangesChecksumWhenFilmChanges)
{
    const auto checksum = [this](const std::string& bytes) {
        std::ofstream(m_folder / "a.mkv") << bytes;
        return ChecksumOfFrames(m_folder / "a.mkv", 0, 1);
    };
    std::string film(3'000'000, 'x'); // more than is read at once
    const std::string whole = checksum(film);
    EXPECT_THAT(whole, HasSubstr("3000000"));
    film[2'999'999] = 'y';
    EXPECT_NE(checksum(film), whole);
    film[2'999'999] = 'x';
    EXPECT_EQ(checksum(film), whole);
    EXPECT_EQ(ChecksumOfFrames(m_folder / "none.mkv", 0, 1), "");
    EXPECT_EQ(ChecksumOfFrames(m_folder.Path(), 0, 1), "");
}

TEST(Manifest, OmitsOptionsThatChangeNoFrame)
{
    EXPECT_THAT(CommandOfFilm({"record", "pyramid", "-o", "a.mkv", "--force", "--resume",
                               "--frame-range=0-9", "--quality", "high", "--progress", "none",
                               "--thumbnail", "a.png", "--thumbnail-at", "1s", "--stats",
                               "--backend=osmesa"}),
                ElementsAre("record", "pyramid", "--quality", "high"));
}

TEST(Manifest, OmitsFileAttachedToItsOption)
{
    for (const char* output : {"-oa.mkv", "-o=a.mkv", "-oa=b.mkv"})
    {
        EXPECT_THAT(CommandOfFilm({"record", "pyramid", output, "--quality", "high"}),
                    ElementsAre("record", "pyramid", "--quality", "high"))
            << output;
    }
}

TEST(Manifest, ReportsDifferentVersionAndCommand)
{
    Manifest other = Sample();
    other.first = 0;
    EXPECT_EQ(DifferenceOf(Sample(), other), "") << "another part of the same film";
    other.version = "1.2.4";
    EXPECT_THAT(DifferenceOf(Sample(), other), AllOf(HasSubstr("1.2.3"), HasSubstr("1.2.4")));
    other.command.back() = "401";
    EXPECT_THAT(DifferenceOf(Sample(), other), AllOf(HasSubstr("record pyramid --frames 400"),
                                                     HasSubstr("record pyramid --frames 401")));
}

} // namespace
} // namespace boxreel
