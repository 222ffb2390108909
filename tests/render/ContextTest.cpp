// SPDX-License-Identifier: MIT
#include "Context.h"
#include "../base/Errors.h"
#include "FakeEgl.h"
#include "Pictures.h"

#include <base/Quoting.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <thread>
#include <vector>

#include <dlfcn.h>

using namespace boxreel;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace
{

const ContextLibraries kNoLibraries{"libNoSuchMesa.so.8", "libNoSuchEgl.so.1"};

/// The variable BOXREEL_BACKEND for as long as this lives.
class Variable
{
public:
    explicit Variable(const char* value)
    {
        if (const char* const before = std::getenv("BOXREEL_BACKEND"))
        {
            m_before = before;
        }
        value ? setenv("BOXREEL_BACKEND", value, 1) : unsetenv("BOXREEL_BACKEND");
    }
    ~Variable()
    {
        m_before ? setenv("BOXREEL_BACKEND", m_before->c_str(), 1) : unsetenv("BOXREEL_BACKEND");
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    std::optional<std::string> m_before;
};

std::string Refusal(Backend backend, const ContextLibraries& libraries,
                    ErrorKind kind = ErrorKind::Absent)
{
    const auto context = CreateContext(backend, libraries);
    if (context)
    {
        return std::string("made by ") + (*context)->BackEnd();
    }
    EXPECT_EQ(context.GetError().kind, kind);
    return context.GetError().Text();
}

Result<Renderer> RendererOf(Backend backend, int width = 320, int height = 240,
                            const Theme& theme = Theme::Classic())
{
    return Renderer::Create({.width = width, .height = height, .theme = theme, .backend = backend});
}

/// Both software back ends, or a sentence why the test is skipped.
class BothBackEnds : public testing::Test
{
protected:
    void SetUp() override
    {
        for (const Backend backend : {Backend::OSMesa, Backend::Egl})
        {
            if (const Result<Renderer> renderer = RendererOf(backend, 1, 1); !renderer)
            {
                GTEST_SKIP() << "one back end is not on this machine: "
                             << renderer.GetError().Text();
            }
        }
    }
};

/// A library in the place of EGL's that has the devices that the test says.
class FakeEglLibrary : public testing::Test
{
protected:
    void SetUp() override
    {
        void* const library = dlopen(BOXREEL_FAKE_EGL, RTLD_NOW | RTLD_LOCAL);
        ASSERT_NE(library, nullptr) << dlerror();
        fake = reinterpret_cast<GetFakeEgl>(dlsym(library, kGetFakeEgl))();
        *fake = {};
        fake->extensions =
            "EGL_EXT_platform_base EGL_EXT_platform_device EGL_MESA_platform_surfaceless";
    }
    void TearDown() override
    {
        for (const FakeDevice& device : fake->devices)
        {
            EXPECT_EQ(device.contexts, 0) << "a context outlives its owner";
        }
        EXPECT_EQ(fake->surfaceless.contexts, 0);
        EXPECT_EQ(fake->current, nullptr);
    }

    FakeDevice& Add(const FakeDevice& device)
    {
        FakeDevice& place = fake->devices[fake->deviceCount++];
        place = device;
        return place;
    }

    Result<std::unique_ptr<Context>> Create(Backend backend) const
    {
        return CreateContext(backend, {.osMesa = "libNoSuchMesa.so.8", .egl = BOXREEL_FAKE_EGL});
    }

    /// Returns the device that draws; null if none does, with the reason in `message`.
    const FakeDevice* Drawing(Backend backend)
    {
        const auto context = Create(backend);
        message = context ? "" : context.GetError().Text();
        return context ? fake->current : nullptr;
    }

    static constexpr FakeDevice kGpu{"EGL_EXT_device_drm", "AMD Radeon RX 6600"};
    static constexpr FakeDevice kSoftware{"EGL_MESA_device_software EGL_EXT_device_drm_render_node",
                                          "llvmpipe (LLVM 15.0.6, 256 bits)"};
    FakeEgl* fake = nullptr;
    std::string message;
};

} // namespace

TEST_F(BothBackEnds, GiveTheSameBits)
{
    // Both alive, and one between the two halves of the other.
    for (const auto& [width, height] : {std::pair{320, 240}, {101, 333}})
    {
        Theme theme = Theme::Classic();
        theme.outlineWidth = width == 101 ? 2.5f : theme.outlineWidth;
        Result<Renderer> osMesa = RendererOf(Backend::OSMesa, width, height, theme);
        Result<Renderer> egl = RendererOf(Backend::Egl, width, height, theme);
        ASSERT_TRUE(osMesa && egl);
        Result<Hud> hud = Hud::Create(width, height);
        ASSERT_TRUE(hud);
        const Camera camera = PixelCamera(width, height);
        for (unsigned seed = 1; seed <= 4; ++seed)
        {
            const DrawList list = Everything(seed);
            const Overlay& overlay = hud->Build({"seed", {{"number", std::to_string(seed)}}});
            Frame fromOSMesa;
            Frame fromEgl;
            ASSERT_TRUE(osMesa->Submit(list, camera, &overlay));
            ASSERT_TRUE(egl->Submit(list, camera, &overlay));
            ASSERT_TRUE(osMesa->Read(fromOSMesa));
            ASSERT_TRUE(egl->Read(fromEgl));
            EXPECT_TRUE(fromOSMesa == fromEgl) << width << "x" << height << ", seed " << seed;
            EXPECT_GT(std::count(fromEgl.rgba.begin(), fromEgl.rgba.end(), 255), width * height)
                << "something is drawn";
            EXPECT_FALSE(fromEgl == DrawWith(*egl, Everything(seed + 1), camera, &overlay))
                << "and not always the same";
        }
    }
}

TEST_F(BothBackEnds, AreNamedByTheirRenderers)
{
    EXPECT_THAT(RendererOf(Backend::OSMesa)->Description(),
                AllOf(testing::StartsWith("OSMesa, "), HasSubstr("Mesa ")));
    EXPECT_THAT(RendererOf(Backend::Egl)->Description(),
                AllOf(testing::StartsWith("EGL, "), HasSubstr("Mesa ")));
}

TEST_F(BothBackEnds, WorkInAnyOrderOfCreationAndEnd)
{
    const Camera camera = PixelCamera(320, 240);
    std::optional<Renderer> first(std::move(*RendererOf(Backend::Egl)));
    const Frame expected = DrawWith(*first, Everything(1), camera);
    for (const Backend backend : {Backend::OSMesa, Backend::Egl, Backend::OSMesa})
    {
        std::optional<Renderer> second(std::move(*RendererOf(backend)));
        EXPECT_TRUE(DrawWith(*second, Everything(1), camera) == expected);
        (void)DrawWith(*first, Everything(2), camera);
        first = std::move(second); // ends the one that drew last
        EXPECT_TRUE(DrawWith(*first, Everything(1), camera) == expected);
    }
}

TEST_F(BothBackEnds, DrawInSeveralThreadsAtOnce)
{
    const Camera camera = PixelCamera(320, 240);
    const Frame expected = Picture(Everything(1), 320, 240);
    Frame frames[4];
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
    {
        threads.emplace_back([&camera, &frame = frames[i], i] {
            Result<Renderer> renderer = RendererOf(i % 2 ? Backend::Egl : Backend::OSMesa);
            for (const unsigned seed : {2u, 1u})
            {
                frame = DrawWith(*renderer, Everything(seed), camera);
            }
        });
    }
    for (std::thread& thread : threads)
    {
        thread.join();
    }
    for (const Frame& frame : frames)
    {
        EXPECT_TRUE(frame == expected);
    }
}

TEST_F(BothBackEnds, AreChosenByTheVariableUnlessTheSettingsNameOne)
{
    for (const auto& [value, begins] : {std::pair{"egl", "EGL, "},
                                        {"osmesa", "OSMesa, "},
                                        {"auto", "OSMesa, "},
                                        {"", "OSMesa, "}})
    {
        const Variable variable(value);
        EXPECT_THAT(RendererOf(Backend::Auto)->Description(), testing::StartsWith(begins)) << value;
        EXPECT_THAT(RendererOf(Backend::Egl)->Description(), testing::StartsWith("EGL, "));
        EXPECT_THAT(RendererOf(Backend::OSMesa)->Description(), testing::StartsWith("OSMesa, "));
    }
    const Variable none(nullptr);
    EXPECT_THAT(RendererOf(Backend::Auto)->Description(), testing::StartsWith("OSMesa, "));
}

TEST_F(BothBackEnds, ReplaceEachOtherWhenOneIsMissing)
{
    const Variable none(nullptr);
    const auto context = CreateContext(Backend::Auto, {.osMesa = kNoLibraries.osMesa});
    ASSERT_TRUE(context) << context.GetError().Text();
    EXPECT_STREQ((*context)->BackEnd(), "EGL");
    const auto first = CreateContext(Backend::Auto, {.egl = kNoLibraries.egl});
    ASSERT_TRUE(first);
    EXPECT_STREQ((*first)->BackEnd(), "OSMesa");
}

TEST(Backend, IsReadFromItsName)
{
    EXPECT_EQ(*ParseBackend("--backend", "auto"), Backend::Auto);
    EXPECT_EQ(*ParseBackend("--backend", "osmesa"), Backend::OSMesa);
    EXPECT_EQ(*ParseBackend("--backend", "egl"), Backend::Egl);
    EXPECT_EQ(*ParseBackend("--backend", "egl-gpu"), Backend::EglGpu);
    for (const std::string bad : {"", "EGL", "gpu", "egl ", "vulkan"})
    {
        EXPECT_THAT(ParseBackend("--backend", bad), Refuses(AsTyped("--backend", bad)));
    }
}

TEST(Backend, IsRefusedForUnknownNameInVariable)
{
    const Variable variable("vulkan");
    EXPECT_THAT(CreateContext(Backend::Auto, {}), Refuses("BOXREEL_BACKEND vulkan"));
    EXPECT_THAT(Refusal(Backend::OSMesa, kNoLibraries), HasSubstr("libNoSuchMesa"))
        << "what the settings name is not looked up";
    EXPECT_THAT(RendererOf(Backend::Auto), Refuses("BOXREEL_BACKEND vulkan"));
}

TEST(Context, ListsLibraryAndPackageOfEachTriedBackEnd)
{
    const Variable none(nullptr);
    EXPECT_THAT(CreateContext(Backend::Auto, kNoLibraries),
                Fails(ErrorKind::Absent, "back end auto"));
    EXPECT_THAT(Refusal(Backend::Auto, kNoLibraries),
                AllOf(HasSubstr("osmesa: libNoSuchMesa.so.8"), HasSubstr("libosmesa6"),
                      HasSubstr("egl: libNoSuchEgl.so.1"), HasSubstr("libegl1"),
                      Not(HasSubstr("\n"))));
}

TEST(Context, TriesOnlyTheBackEndThatIsNamed)
{
    EXPECT_THAT(Refusal(Backend::OSMesa, kNoLibraries),
                AllOf(HasSubstr("libNoSuchMesa.so.8"), Not(HasSubstr("libNoSuchEgl"))));
    EXPECT_THAT(Refusal(Backend::Egl, kNoLibraries),
                AllOf(HasSubstr("libNoSuchEgl.so.1"), Not(HasSubstr("libNoSuchMesa"))));
    EXPECT_THAT(Refusal(Backend::EglGpu, kNoLibraries),
                AllOf(HasSubstr("libNoSuchEgl.so.1"), Not(HasSubstr("libNoSuchMesa"))));
    EXPECT_THAT(CreateContext(Backend::EglGpu, kNoLibraries),
                Fails(ErrorKind::Absent, "back end egl-gpu"));
    const Variable variable("egl");
    EXPECT_THAT(CreateContext(Backend::Auto, kNoLibraries),
                Fails(ErrorKind::Absent, "BOXREEL_BACKEND egl"));
    EXPECT_THAT(Refusal(Backend::Auto, kNoLibraries),
                AllOf(HasSubstr("libNoSuchEgl.so.1"), Not(HasSubstr("libNoSuchMesa"))));
}

TEST(Context, RefusesOtherLibraries)
{
    const ContextLibraries foreign{"libm.so.6", "libm.so.6"};
    EXPECT_THAT(Refusal(Backend::OSMesa, foreign), HasSubstr("(libm.so.6"));
    EXPECT_THAT(Refusal(Backend::Egl, foreign), HasSubstr("(libm.so.6"));
}

TEST_F(FakeEglLibrary, DrawsInSoftwareBesideAGpu)
{
    const FakeDevice& gpu = Add(kGpu);
    const FakeDevice& software = Add(kSoftware);
    fake->surfaceless = kGpu;
    EXPECT_EQ(Drawing(Backend::Egl), &software) << message;
    EXPECT_EQ(gpu.started + fake->surfaceless.started, 0) << "the GPU is left alone";
}

TEST_F(FakeEglLibrary, DrawsOnTheGpuWhenAsked)
{
    const FakeDevice& software = Add(kSoftware);
    const FakeDevice& gpu = Add(kGpu);
    EXPECT_EQ(Drawing(Backend::EglGpu), &gpu) << message;
    EXPECT_EQ(software.started, 0);
    const Variable variable("egl-gpu");
    EXPECT_EQ(Drawing(Backend::Auto), &gpu) << message;
}

TEST_F(FakeEglLibrary, UsesGpuOnlyOnRequest)
{
    const Variable none(nullptr);
    const FakeDevice& gpu = Add(kGpu);
    fake->surfaceless = kGpu;
    for (const Backend backend : {Backend::Egl, Backend::Auto})
    {
        EXPECT_EQ(Drawing(backend), nullptr);
        EXPECT_THAT(message,
                    AllOf(HasSubstr("AMD Radeon RX 6600"), HasSubstr("BOXREEL_BACKEND=egl-gpu"),
                          HasSubstr("apt install libegl-mesa0 libgl1-mesa-dri")));
    }
    EXPECT_EQ(gpu.started, 0);
}

TEST_F(FakeEglLibrary, NamesSoftwareWhenThereIsNoGpu)
{
    Add(kSoftware);
    fake->surfaceless = kSoftware;
    EXPECT_EQ(Drawing(Backend::EglGpu), nullptr);
    EXPECT_THAT(message, AllOf(HasSubstr("llvmpipe (LLVM 15.0.6, 256 bits)"), HasSubstr("GPU")));
}

TEST_F(FakeEglLibrary, GoesOnToTheNextDeviceWhenOneFails)
{
    FakeDevice broken = kGpu;
    broken.starts = false;
    Add(broken);
    FakeDevice old = kGpu;
    old.makesContexts = false;
    Add(old);
    const FakeDevice& last = Add(kGpu);
    EXPECT_EQ(Drawing(Backend::EglGpu), &last) << message;

    fake->devices[2].bindsWithoutSurface = false;
    fake->surfaceless = kSoftware;
    EXPECT_EQ(Drawing(Backend::EglGpu), nullptr);
    EXPECT_THAT(message, testing::ContainsRegex(
                             "device 0.*0x3009.*device 1.*0x3009.*device 2.*0x3009.*llvmpipe"));
}

TEST_F(FakeEglLibrary, ChecksRendererIfDevicesCannotBeListed)
{
    fake->extensions = "EGL_MESA_platform_surfaceless";
    Add(kGpu); // without a way to select it
    fake->surfaceless = kSoftware;
    EXPECT_EQ(Drawing(Backend::Egl), &fake->surfaceless) << message;
    EXPECT_EQ(Drawing(Backend::EglGpu), nullptr);
    fake->surfaceless = kGpu;
    EXPECT_EQ(Drawing(Backend::EglGpu), &fake->surfaceless) << message;
    EXPECT_EQ(Drawing(Backend::Egl), nullptr);
    EXPECT_EQ(fake->devices[0].started, 0);
}

TEST_F(FakeEglLibrary, IsRefusedWhenItCanOnlyDrawOnScreens)
{
    fake->extensions = nullptr;
    EXPECT_EQ(Drawing(Backend::Egl), nullptr);
    EXPECT_THAT(message, AllOf(HasSubstr("(" BOXREEL_FAKE_EGL ": "), HasSubstr("display")));
}

TEST_F(FakeEglLibrary, IsLeftWhenAnotherContextIsEntered)
{
    const FakeDevice& software = Add(kSoftware);
    auto egl = Create(Backend::Egl);
    ASSERT_TRUE(egl);
    ASSERT_TRUE((*egl)->MakeCurrent());
    EXPECT_EQ(fake->current, &software);
    auto osMesa = CreateContext(Backend::OSMesa);
    if (!osMesa)
    {
        GTEST_SKIP() << "one back end is not on this machine: " << osMesa.GetError().Text();
    }
    ASSERT_TRUE((*osMesa)->MakeCurrent());
    EXPECT_EQ(fake->current, nullptr);
    ASSERT_TRUE((*egl)->MakeCurrent());
    EXPECT_EQ(fake->current, &software);
}
