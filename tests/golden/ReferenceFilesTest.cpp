// SPDX-License-Identifier: MIT
#include <golden/ReferenceStore.h>

#include "../base/Errors.h"
#include "../base/TemporaryFolder.h"
#include "TestPictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

using namespace boxreel;
using namespace boxreel::test;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

namespace
{

namespace fs = std::filesystem;

// Effects of the environment on a store: names, links, damaged files, folders without permission.
class ReferenceFiles : public testing::Test
{
protected:
    ReferenceFiles()
    {
        fs::create_directories(m_references);
        fs::create_directories(m_output);
    }

    /// Returns the error for a damaged reference. The approved files stay unchanged.
    Error Damage(const GoldenCandidate& candidate)
    {
        const Result<GoldenVerdict> verdict = m_store.Verify(candidate);
        EXPECT_TRUE(verdict) << verdict.GetError().Text();
        EXPECT_EQ(verdict ? verdict->status : GoldenStatus::Same, GoldenStatus::NotCompared);
        EXPECT_THAT(verdict->accept,
                    testing::StartsWith("boxreel golden accept " + candidate.name + " "));
        return verdict->problem;
    }

    TemporaryFolder m_folder;
    fs::path m_references = m_folder / "references";
    fs::path m_output = m_folder / "output";
    ReferenceStore m_store{m_references, m_output};
};

DrawList LongList()
{
    DrawList list;
    for (int i = 0; i < 3000; ++i)
    {
        list.AddSegment({0.1f * static_cast<float>(i), 0.3f}, {0.7f, 0.2f}, kJoint);
    }
    return list;
}

} // namespace

TEST_F(ReferenceFiles, RefuseNamesThatCouldLeaveTheFolder)
{
    const std::string tooLong(201, 'a');
    for (const std::string& name : {std::string(),
                                    std::string("../escape"),
                                    std::string("a/../../escape"),
                                    std::string("a/.."),
                                    std::string(".."),
                                    std::string("."),
                                    std::string("a/./b"),
                                    std::string("/absolute"),
                                    std::string("a//b"),
                                    std::string("a/"),
                                    std::string("/"),
                                    std::string(".hidden"),
                                    std::string("a/.hidden"),
                                    std::string("Upper"),
                                    std::string("a b"),
                                    std::string("a\\b"),
                                    std::string("a\nb"),
                                    std::string("a\0b", 3),
                                    std::string("caf\xc3\xa9"),
                                    std::string("a*"),
                                    std::string("~root"),
                                    std::string("c:file"),
                                    std::string("a.part"),
                                    tooLong})
    {
        const GoldenCandidate candidate = Candidate(name);
        EXPECT_THAT(m_store.Verify(candidate), Refuses("'" + name + "'"));
        EXPECT_THAT(m_store.Accept(candidate), Refuses("'" + name + "'"));
    }
    EXPECT_THAT(m_folder.Names(), UnorderedElementsAre("references", "output"));
    EXPECT_TRUE(fs::is_empty(m_references));
    EXPECT_TRUE(fs::is_empty(m_output));
}

TEST_F(ReferenceFiles, AcceptOrdinaryNames)
{
    const std::string longest(200, 'a');
    for (const std::string& name :
         {std::string("pyramid/3s"), std::string("newtons-cradle/0.5s"), std::string("a"),
          std::string("a_b/c-d/e.f"), std::string("0"), std::string("a..b"), longest})
    {
        EXPECT_TRUE(m_store.Accept(Candidate(name))) << name;
        EXPECT_TRUE(m_store.Verify(Candidate(name))) << name;
    }
}

TEST_F(ReferenceFiles, RefuseLinksOutOfTheFolder)
{
    fs::create_directories(m_folder / "outside");
    fs::create_directories(m_references / "frames");
    fs::create_directory_symlink(m_folder / "outside", m_references / "frames/pyramid");
    const std::string link = (m_references / "frames/pyramid").string();
    EXPECT_THAT(Damage(Candidate("pyramid/3s")), IsError(ErrorKind::Unusable, link));
    EXPECT_THAT(m_store.Accept(Candidate("pyramid/3s")), Refuses(link));
    EXPECT_TRUE(fs::is_empty(m_folder / "outside"));
    EXPECT_FALSE(fs::exists(m_references / "state")) << "nothing half accepted";
}

TEST_F(ReferenceFiles, RefuseFilesThatAreLinksOutOrNowhere)
{
    WriteBytes(m_folder / "secret", "0123456789abcdef\n");
    fs::create_directories(m_references / "state");
    for (const char* target : {"secret", "nowhere"})
    {
        fs::create_symlink(m_folder / target, m_references / "state/scene.txt");
        EXPECT_THAT(Damage(Candidate("scene")),
                    IsError(ErrorKind::Unusable, (m_references / "state/scene.txt").string()));
        EXPECT_THAT(m_store.Accept(Candidate("scene")),
                    Refuses((m_references / "state/scene.txt").string()));
        fs::remove(m_references / "state/scene.txt");
    }
    EXPECT_EQ(ReadBytes(m_folder / "secret"), "0123456789abcdef\n");
    EXPECT_FALSE(fs::exists(m_folder / "nowhere"));
}

TEST_F(ReferenceFiles, RefuseLinksOutOfTheOutputFolder)
{
    fs::create_directories(m_folder / "outside");
    fs::create_directory_symlink(m_folder / "outside", m_output / "pyramid");
    WriteBytes(m_folder / "outside/3s.actual.png", "of someone else");
    EXPECT_THAT(m_store.Verify(Candidate("pyramid/3s")), Refuses((m_output / "pyramid").string()));
    EXPECT_EQ(ReadBytes(m_folder / "outside/3s.actual.png"), "of someone else");
}

TEST_F(ReferenceFiles, FollowLinksInsideTheFolder)
{
    ASSERT_TRUE(m_store.Accept(Candidate("old/3s")));
    for (const char* depth : {"state", "drawlist", "frames"})
    {
        fs::create_directory_symlink("old", m_references / depth / "new");
    }
    const Result<GoldenVerdict> verdict = m_store.Verify(Candidate("new/3s"));
    ASSERT_TRUE(verdict) << verdict.GetError().Text();
    EXPECT_EQ(verdict->status, GoldenStatus::Same);
}

TEST_F(ReferenceFiles, NameTruncatedPictureAndAcceptItAgain)
{
    ASSERT_TRUE(m_store.Accept(Candidate("scene")));
    const fs::path png = m_references / "frames/scene.png";
    const std::string whole = ReadBytes(png);
    for (const std::size_t size :
         {std::size_t(0), std::size_t(20), whole.size() / 2, whole.size() - 12})
    {
        WriteBytes(png, whole.substr(0, size));
        EXPECT_THAT(Damage(Candidate("scene")), IsError(testing::_, png.string()))
            << size << " bytes";
        ASSERT_TRUE(m_store.Accept(Candidate("scene")));
        EXPECT_EQ(m_store.Judge(Candidate("scene"))->status, GoldenStatus::Same);
    }
}

TEST_F(ReferenceFiles, NameDamagedPackedListAndAcceptItAgain)
{
    const GoldenCandidate candidate{"scene", "", LongList(), Frame()};
    ASSERT_TRUE(m_store.Accept(candidate));
    const fs::path packed = m_references / "drawlist/scene.txt.gz";
    const std::string whole = ReadBytes(packed);
    std::string flipped = whole;
    flipped[flipped.size() / 2] = static_cast<char>(flipped[flipped.size() / 2] ^ 0x10);
    for (const std::string& bytes :
         {std::string(), whole.substr(0, 9), whole.substr(0, whole.size() - 1), whole + "x",
          flipped, std::string("plain text\n")})
    {
        WriteBytes(packed, bytes);
        EXPECT_THAT(Damage(candidate), IsError(ErrorKind::Unusable, packed.string()));
        ASSERT_TRUE(m_store.Accept(candidate));
        EXPECT_EQ(m_store.Judge(candidate)->status, GoldenStatus::Same);
    }
}

TEST_F(ReferenceFiles, NameDamagedStateAndAcceptItAgain)
{
    ASSERT_TRUE(m_store.Accept(Candidate("scene")));
    const fs::path state = m_references / "state/scene.txt";
    for (const std::string bytes :
         {"", "0123456789abcdef", "0123456789abcde\n", "0123456789ABCDEF\n", "<<<<<<< HEAD\n...."})
    {
        WriteBytes(state, bytes);
        EXPECT_THAT(Damage(Candidate("scene")), IsError(ErrorKind::Unusable, state.string()));
        ASSERT_TRUE(m_store.Accept(Candidate("scene")));
        EXPECT_EQ(m_store.Judge(Candidate("scene"))->status, GoldenStatus::Same);
    }
}

TEST_F(ReferenceFiles, NameLineEndsConvertedByCheckout)
{
    ASSERT_TRUE(m_store.Accept(Candidate("scene")));
    for (const char* file : {"drawlist/scene.txt", "state/scene.txt"})
    {
        std::string text = ReadBytes(m_references / file);
        for (std::size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at + 2))
        {
            text.insert(at, "\r");
        }
        WriteBytes(m_references / file, text);
        const Error error = Damage(Candidate("scene"));
        EXPECT_THAT(error, IsError(ErrorKind::Unusable, (m_references / file).string()));
        EXPECT_THAT(error.problem, HasSubstr("CR LF"));
        ASSERT_TRUE(m_store.Accept(Candidate("scene")));
    }
}

TEST_F(ReferenceFiles, ReportDrawListCutAtItsEndAsDifferent)
{
    ASSERT_TRUE(m_store.Accept(Candidate("scene")));
    const fs::path list = m_references / "drawlist/scene.txt";
    std::string text = ReadBytes(list);
    text.pop_back();
    WriteBytes(list, text);
    const Result<GoldenVerdict> verdict = m_store.Verify(Candidate("scene"));
    ASSERT_TRUE(verdict);
    EXPECT_EQ(verdict->status, GoldenStatus::DrawList);
    ASSERT_TRUE(verdict->list);
    EXPECT_FALSE(verdict->list->expected || verdict->list->actual) << "the newline at the end";
}

// A folder in a file's place stops everyone, root included.
TEST_F(ReferenceFiles, KeepOtherFilesWhenAcceptFails)
{
    ASSERT_TRUE(m_store.Accept(Candidate("scene")));
    const std::string list = ReadBytes(m_references / "drawlist/scene.txt");
    fs::remove(m_references / "frames/scene.png");
    fs::create_directories(m_references / "frames/scene.png");
    GoldenCandidate changed = Candidate("scene", WithoutItem(SmallScene(), 4));
    changed.stateHash = "ffffffffffffffff";
    EXPECT_THAT(m_store.Accept(changed),
                Fails(testing::_, (m_references / "frames/scene.png").string()));
    EXPECT_THAT(Damage(changed), IsError(testing::_, (m_references / "frames/scene.png").string()));
    EXPECT_EQ(ReadBytes(m_references / "state/scene.txt"), "0123456789abcdef\n");
    EXPECT_EQ(ReadBytes(m_references / "drawlist/scene.txt"), list);
}

// A file where a folder should be stops everyone, root included.
TEST_F(ReferenceFiles, GiveVerdictWhenOutputIsNotWritable)
{
    ASSERT_TRUE(m_store.Accept(Candidate("scene")));
    WriteBytes(m_folder / "file", "not a folder");
    const ReferenceStore store(m_references, m_folder / "file");
    const Result<GoldenVerdict> same = store.Verify(Candidate("scene"));
    ASSERT_TRUE(same) << same.GetError().Text();
    EXPECT_EQ(same->status, GoldenStatus::Same) << "nothing needs to be written";
    ASSERT_TRUE(same->warning);
    EXPECT_THAT(*same->warning, IsError(ErrorKind::Unusable, (m_folder / "file").string()));
    EXPECT_FALSE(m_store.Verify(Candidate("scene"))->warning);

    const Result<GoldenVerdict> different =
        store.Verify(Candidate("scene", SmallScene(), {.outline = 2}));
    EXPECT_THAT(different, RefusesWith("scene", (m_folder / "file").string()));
    EXPECT_THAT(store.Verify(Candidate("unknown")),
                RefusesWith("unknown", (m_folder / "file").string()));
}

TEST_F(ReferenceFiles, LeaveNoUnfinishedFile)
{
    ASSERT_TRUE(m_store.Accept(Candidate("scene")));
    EXPECT_TRUE(m_store.Verify(Candidate("scene", SmallScene(), {.outline = 2})));
    for (const auto& entry : fs::recursive_directory_iterator(m_folder / ""))
    {
        EXPECT_THAT(entry.path().string(), testing::Not(HasSubstr(".part")));
    }
}
