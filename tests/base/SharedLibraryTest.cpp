// SPDX-License-Identifier: MIT
#include <base/SharedLibrary.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{

using namespace boxreel;

TEST(SharedLibrary, NamesLibraryAndPackageWhenItIsMissing)
{
    const Result<SharedLibrary> opened = SharedLibrary::Open("libNone.so.1", "libnone1");
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.GetError().kind, ErrorKind::Absent);
    EXPECT_EQ(opened.GetError().culprit, "libNone.so.1");
    EXPECT_THAT(opened.GetError().remedy, testing::EndsWith("libnone1"));
}

TEST(SharedLibrary, BindsOnlyFunctionsThatItHas)
{
    for (const auto symbols : {SharedLibrary::Symbols::Lazy, SharedLibrary::Symbols::Now})
    {
        const Result<SharedLibrary> math = SharedLibrary::Open("libm.so.6", "libc6", symbols);
        ASSERT_TRUE(math);
        double (*cosine)(double) = nullptr;
        EXPECT_TRUE(math->Bind("cos", cosine));
        EXPECT_EQ(cosine(0.0), 1.0);
        EXPECT_FALSE(math->Bind("noSuchFunction", cosine));
        EXPECT_EQ(math->MissingError("it").culprit, "libm.so.6");
    }
}

} // namespace
