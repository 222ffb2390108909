// SPDX-License-Identifier: MIT
// The renderers that count as equal.
#include "Probe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <render/Renderer.h>

#include <set>
#include <thread>
#include <tuple>
#include <vector>

using namespace boxreel;

namespace
{

Result<std::string> FingerprintOf(Backend backend)
{
    const Result<Renderer> renderer =
        Renderer::Create({.width = 8, .height = 8, .backend = backend});
    return renderer ? renderer->Fingerprint() : Result<std::string>(renderer.GetError());
}

} // namespace

TEST(Fingerprint, IsSixteenHexDigits)
{
    const Result<std::string> fingerprint = FingerprintOf(Backend::Auto);
    ASSERT_TRUE(fingerprint) << fingerprint.GetError().Text();
    EXPECT_EQ(fingerprint->size(), 16u);
    EXPECT_EQ(fingerprint->find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST(Fingerprint, IsTheSameForOSMesaAndEgl)
{
    const Result<std::string> osMesa = FingerprintOf(Backend::OSMesa);
    const Result<std::string> egl = FingerprintOf(Backend::Egl);
    if (!osMesa || !egl)
    {
        GTEST_SKIP() << (osMesa ? egl : osMesa).GetError().Text();
    }
    EXPECT_EQ(*osMesa, *egl);
}

// References carry these. When drawing is changed on purpose, accept all references again, and
// replace the numbers: otherwise each reference counts as another renderer's.
TEST(Fingerprint, EqualsThatOfReferencesWithKnownMesas)
{
    const Result<Renderer> renderer = Renderer::Create({.width = 8, .height = 8});
    ASSERT_TRUE(renderer) << renderer.GetError().Text();
    for (const auto& [mesa, fingerprint] :
         {std::pair("Mesa 22.3", "2e7b1e624270b67b"), std::pair("Mesa 25.0", "2e7b1e624270b67b"),
          std::pair("Mesa 26.1", "168f1ea46c72c294")})
    {
        if (renderer->Description().find(mesa) != std::string::npos)
        {
            EXPECT_EQ(*renderer->Fingerprint(), fingerprint);
            return;
        }
    }
    GTEST_SKIP() << "no measurement of " << renderer->Description();
}

TEST(Fingerprint, IsTheSameWhenThreadsAskAtOnce)
{
    std::vector<std::string> fingerprints(4);
    std::vector<std::thread> threads;
    for (std::string& fingerprint : fingerprints)
    {
        threads.emplace_back([&fingerprint] { fingerprint = *FingerprintOf(Backend::Auto); });
    }
    for (std::thread& thread : threads)
    {
        thread.join();
    }
    EXPECT_THAT(fingerprints, testing::Each(*FingerprintOf(Backend::Auto)));
}

TEST(Fingerprint, KeepsTheRenderersPicture)
{
    Result<Renderer> renderer = Renderer::Create({.width = 320, .height = 240});
    ASSERT_TRUE(renderer) << renderer.GetError().Text();
    const Camera camera{320, 240, 160.0, 120.0, 1.0};
    ASSERT_TRUE(renderer->Submit(ProbeList(), camera));
    ASSERT_TRUE(renderer->Fingerprint());
    Frame interrupted;
    ASSERT_TRUE(renderer->Read(interrupted));
    Frame plain;
    ASSERT_TRUE(renderer->Draw(ProbeList(), camera, plain));
    EXPECT_TRUE(interrupted == plain);
}

// Renderers differ only in blending rare pairs of numbers, which a few colours would not contain.
TEST(Probe, BlendsManyDifferentColours)
{
    const Result<Frame> probe = DrawProbe(Backend::Auto);
    ASSERT_TRUE(probe) << probe.GetError().Text();
    std::set<std::tuple<int, int, int>> colours;
    for (std::size_t i = 0; i < probe->rgba.size(); i += 4)
    {
        colours.emplace(probe->rgba[i], probe->rgba[i + 1], probe->rgba[i + 2]);
    }
    EXPECT_GT(colours.size(), 8000u);
}
