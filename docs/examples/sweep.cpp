// SPDX-License-Identifier: MIT
// The same throw with six coefficients of restitution, beside each other: sweep-light.svg,
// sweep-dark.svg and sweep.pdf, or the one file that is named.
#include <Box2D/Box2D.h>
#include <debugdraw/DrawCollector.h>
#include <debugdraw/Trail.h>
#include <render/FigureSheet.h>

#include <cstdio>
#include <string>

namespace
{

/// The ball and its path after four seconds.
boxreel::SheetPicture Throw(float restitution, const boxreel::Camera& camera)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    world.SetSubStepCount(4); // bounces keep the energy that they should
    b2BodyDef def;
    b2EdgeShape floor;
    floor.Set(b2Vec2(0.0f, 0.0f), b2Vec2(20.0f, 0.0f));
    world.CreateBody(&def)->CreateFixture(&floor, 0.0f);
    def.type = b2_dynamicBody;
    def.position.Set(1.0f, 5.0f);
    def.linearVelocity.Set(3.0f, 0.0f);
    b2Body* const ball = world.CreateBody(&def);
    b2CircleShape round;
    round.m_radius = 0.4f;
    b2FixtureDef fixture;
    fixture.shape = &round;
    fixture.density = 1.0f;
    fixture.friction = 0.0f;
    fixture.restitution = restitution;
    ball->CreateFixture(&fixture);

    std::vector<boxreel::Vec2> path;
    for (int step = 0; step < 240; ++step)
    {
        path.push_back({ball->GetPosition().x, ball->GetPosition().y});
        world.Step(1.0f / 60.0f, 8, 3);
    }
    boxreel::SheetPicture picture{.list = {}, .camera = camera};
    boxreel::AddTrail(picture.list, camera, path);
    boxreel::DrawCollector collector(picture.list);
    collector.SetFlags(b2Draw::e_shapeBit);
    world.SetDebugDraw(&collector);
    world.DrawDebugData();
    return picture;
}

bool Write(const std::string& path, const boxreel::Figure& figure)
{
    if (!path.ends_with(".svg") && !path.ends_with(".pdf"))
    {
        std::fprintf(stderr, "%s is no drawing; name a file that ends in .svg or .pdf.\n",
                     path.c_str());
        return false;
    }
    const auto written = path.ends_with(".pdf")
                             ? boxreel::WritePdf(path, figure, {.overwrite = true})
                             : boxreel::WriteSvg(path, figure, {.overwrite = true});
    if (!written)
    {
        std::fprintf(stderr, "%s\n", written.GetError().Text().c_str());
    }
    return bool(written);
}

} // namespace

int main(int argc, char** argv)
{
    const boxreel::Camera camera{320, 150, 7.9, 3.0, 20.0}; // pixels, centre, pixels a metre
    std::vector<boxreel::SheetPicture> pictures;
    for (const float restitution : {0.0f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f})
    {
        pictures.push_back(Throw(restitution, camera));
        pictures.back().title = "restitution " + std::to_string(restitution).substr(0, 3);
    }
    boxreel::Figure sheet = boxreel::SheetOf(
        std::move(pictures), {.columns = 2,
                              .axes = true,
                              .caption = "A ball thrown with 3 m/s, 5 m high, after 4 s.",
                              .theme = boxreel::Theme::Print()});
    sheet.title = "A throw with six coefficients of restitution";
    if (argc > 1)
    {
        return Write(argv[1], sheet) ? 0 : 1;
    }
    const bool light = Write("sweep-light.svg", sheet) && Write("sweep.pdf", sheet);
    sheet.theme = boxreel::Theme::Dark();
    return light && Write("sweep-dark.svg", sheet) ? 0 : 1;
}
