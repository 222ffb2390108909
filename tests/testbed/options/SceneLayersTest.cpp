// SPDX-License-Identifier: MIT
#include "../../base/Errors.h"
#include "../../engine/MixedWorld.h"

#include <base/Quoting.h>
#include <base/Words.h>
#include <options/SceneLayers.h>
#include <render/Figure.h>
#include <render/Renderer.h>
#include <session/SceneSession.h>

#include <gmock/gmock.h>

#include <functional>

namespace boxreel
{
namespace
{

LayerSet Layers(const std::string& text)
{
    const Result<LayerSet> layers = ParseLayers("--draw", text);
    EXPECT_TRUE(layers) << layers.GetError().Text();
    return *layers;
}

/// "shapes,joints,…": all that `--draw` knows.
std::string Everything()
{
    return JoinedBy(",", kOptionalLayers, std::mem_fn(&LayerInfo::option));
}

DrawList Collected(b2World& world, const LayerCollector& collector, const View& view)
{
    const BodyNames names{{3, "a long name of a body"}, {5, "two\nlines"}};
    DrawList list;
    collector.Collect(world, view, names, {}, list);
    return list;
}

TEST(SceneLayers, AreOnlyThoseThatAreNamed)
{
    LayerSet expected;
    EXPECT_EQ(Layers("joints,shapes"), expected) << "what is drawn unless said";
    expected[DrawLayer::Joints] = false;
    expected[DrawLayer::Contacts] = true;
    EXPECT_EQ(Layers("shapes,contacts"), expected);
    for (const auto& [text, unknown] : {std::pair("", ""),
                                        {"everything", "everything"},
                                        {"shapes,,joints", ""},
                                        {"shapes,", ""},
                                        {"Shapes", "Shapes"}})
    {
        EXPECT_THAT(ParseLayers("--draw", text), Refuses(AsTyped("--draw", unknown)));
    }
}

TEST(SceneLayers, CollectNothingWhenOff)
{
    MixedWorld mixed(1);
    const View all = ViewOfEverything(Camera());
    const LayerCollector everything(Layers(Everything()), {}, 60.0, mixed.world);
    std::map<DrawLayer, int> items;
    for (const DrawItem& item : Collected(mixed.world, everything, all).items)
    {
        ++items[item.layer];
    }
    for (const LayerInfo& layer : kOptionalLayers)
    {
        const LayerCollector one(Layers(layer.option), {}, 60.0, mixed.world);
        const DrawList list = Collected(mixed.world, one, all);
        for (const DrawItem& item : list.items)
        {
            ASSERT_EQ(item.layer, layer.layer) << layer.option;
        }
        // Names have lines where other layers are in their way.
        if (layer.layer != DrawLayer::Labels)
        {
            EXPECT_EQ(int(list.items.size()), items[layer.layer]) << layer.option;
        }
        const bool isOfContacts =
            layer.layer >= DrawLayer::Contacts && layer.layer <= DrawLayer::ContactFriction;
        EXPECT_TRUE(isOfContacts || !list.items.empty()) << layer.option;
    }
}

/// A still says which contacts are new just as the film does that comes to the same step.
TEST(SceneLayers, MarkNewContactsEquallyInFilmAndShot)
{
    SceneLook look;
    look.layers = Layers("contacts");
    const auto open = [&look] { return *SceneSession::Open(*OpenScene("pyramid"), look); };
    SceneSession film = open();
    bool hasNew = false;
    bool hasOld = false;
    for (int step = 0; step <= 30; ++step)
    {
        FrameContent frame;
        film.AdvanceTo(step);
        film.Fill(frame);
        SceneSession shot = open();
        FrameContent still;
        shot.AdvanceTo(step);
        shot.Fill(still);
        ASSERT_EQ(frame.list, still.list) << step;
        for (const DrawItem& item : frame.list.items)
        {
            hasNew |= item.role == ColorRole::NewContact;
            hasOld |= item.role == ColorRole::OldContact;
        }
    }
    EXPECT_TRUE(hasNew && hasOld);
}

/// The weight of a box at rest is drawn a third of its size long, of a hanging one an eighth.
TEST(SceneLayers, DrawImpulsesLongerThanForcesByDefault)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef def;
    b2Body* const ground = world.CreateBody(&def);
    b2EdgeShape edge;
    edge.Set(b2Vec2(-9.0f, 0.0f), b2Vec2(9.0f, 0.0f));
    ground->CreateFixture(&edge, 0.0f);
    def.type = b2_dynamicBody;
    b2CircleShape ball;
    ball.m_radius = 1.0f;
    def.position.Set(-5.0f, 1.0f);
    world.CreateBody(&def)->CreateFixture(&ball, 1.0f);
    def.position.Set(5.0f, 5.0f);
    b2Body* const hanging = world.CreateBody(&def);
    hanging->CreateFixture(&ball, 1.0f);
    b2DistanceJointDef rod;
    rod.Initialize(ground, hanging, b2Vec2(5.0f, 8.0f), b2Vec2(5.0f, 5.0f));
    world.CreateJoint(&rod);
    for (int i = 0; i < 100; ++i)
    {
        world.Step(1.0f / 60.0f, 8, 3);
    }
    const auto longest = [&world](const char* layer, const ArrowScales& scales) {
        const LayerCollector collector(Layers(layer), scales, 60.0, world);
        float length = 0.0f;
        const Camera close{.pixelsPerMeter = 200.0}; // heads are shorter than arrows
        const DrawList list = Collected(world, collector, ViewOfEverything(close));
        for (std::size_t i = 1; i < list.points.size(); ++i)
        {
            length = std::max(length, list.points[i].y - list.points.front().y);
        }
        return length;
    };
    EXPECT_NEAR(longest("impulses", {}), 2.0f / 3.0f, 0.05f);
    EXPECT_NEAR(longest("forces", {}), 2.0f / 8.0f, 0.02f);
    const ArrowScales given{0.2, 0.01};
    EXPECT_NEAR(longest("impulses", given), 0.314f, 0.02f) << "pi kg";
    EXPECT_NEAR(longest("forces", given), 0.314f, 0.02f);
}

/// Contact points move with the bodies, which takes them far out of both boxes for long bodies.
TEST(SceneLayers, DrawContactPointsOutsideTheirBodies)
{
    b2World world(b2Vec2(0.0f, 0.0f));
    b2BodyDef def;
    b2PolygonShape rod;
    rod.SetAsBox(10.0f, 0.1f);
    world.CreateBody(&def)->CreateFixture(&rod, 0.0f);
    def.type = b2_dynamicBody;
    def.position.Set(0.0f, 0.2f);
    b2Body* const turned = world.CreateBody(&def);
    turned->CreateFixture(&rod, 1.0f);
    world.Step(1.0f / 60.0f, 8, 3);
    turned->SetTransform(b2Vec2(0.0f, 0.2f), 0.5f * b2_pi);
    const LayerCollector collector(Layers("contacts"), {}, 60.0, world);
    const DrawList whole = Collected(world, collector, ViewOfEverything(Camera()));
    ASSERT_EQ(whole.points.size(), 2u);
    for (const Vec2& point : whole.points)
    {
        EXPECT_GT(std::abs(point.y), 4.0f);
        const Camera close{
            .centerX = double(point.x), .centerY = double(point.y), .pixelsPerMeter = 500.0};
        EXPECT_THAT(Collected(world, collector, ViewOf(close, 0.0)).points,
                    testing::Contains(point));
    }
}

/// For any view, pixels, drawn items and figure equal those of the whole list.
TEST(SceneLayers, GiveEqualPicturesForViewAndWholeWorld)
{
    std::size_t seen = 0;
    std::size_t all = 0;
    for (unsigned seed = 0; seed < 24; ++seed)
    {
        MixedWorld mixed(seed);
        LayerCollector collector(Layers(Everything()), {}, 60.0, mixed.world);
        collector.BeforeStep(mixed.world);
        mixed.world.Step(1.0f / 60.0f, 8, 3);
        const double scale = seed % 3 == 0 ? 0.5 : seed % 3 == 1 ? 1.0 : 2.0;
        const Theme theme = seed % 2 == 0 ? Theme::Classic() : Theme::Print();
        Camera size{.width = 160, .height = 120};
        const Camera pixels = Scaled(size, scale);
        Result<Renderer> renderer =
            Renderer::Create({.width = pixels.width,
                              .height = pixels.height,
                              .theme = theme,
                              .scale = scale,
                              .redrawsWhole = true}); // counts all items that touch the picture
        ASSERT_TRUE(renderer) << renderer.GetError().Text();
        for (int i = 0; i < 6; ++i)
        {
            const b2Vec2 middle = mixed.Place();
            Camera camera = size;
            camera.centerX = double(middle.x);
            camera.centerY = double(middle.y);
            camera.pixelsPerMeter = 120.0 / double(mixed.Between(0.5f, 40.0f));
            const DrawList whole = Collected(mixed.world, collector, ViewOfEverything(camera));
            const DrawList part =
                Collected(mixed.world, collector, PictureView(camera, theme, scale));
            Frame expected;
            Frame actual;
            ASSERT_TRUE(renderer->Draw(whole, Scaled(camera, scale), expected));
            const std::size_t drawn = renderer->Statistics().itemsDrawn;
            ASSERT_TRUE(renderer->Draw(part, Scaled(camera, scale), actual));
            EXPECT_EQ(renderer->Statistics().itemsDrawn, drawn) << seed << ", " << i;
            EXPECT_TRUE(expected.rgba == actual.rgba) << seed << ", " << i;
            const Result<std::string> figure = ToSvg(FigureOf(part, camera, theme));
            EXPECT_TRUE(*ToSvg(FigureOf(whole, camera, theme)) == *figure) << seed << ", " << i;
            seen += part.items.size();
            all += whole.items.size();
        }
    }
    EXPECT_GT(seen, 5000u);
    EXPECT_LT(3 * seen, all);
}

} // namespace
} // namespace boxreel
