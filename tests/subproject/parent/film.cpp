// SPDX-License-Identifier: MIT
// A program with no engine at all: a square moves to the right, and the frames become the film
// named on the command line.
#include <debugdraw/DrawList.h>
#include <recorder/VideoWriter.h>
#include <render/Renderer.h>

#include <cstdio>

namespace
{

int Fail(const boxreel::Error& error)
{
    std::fprintf(stderr, "%s\n", error.Text().c_str());
    return 1;
}

boxreel::DrawList SquareAt(float x)
{
    const boxreel::Vec2 corners[] = {{x, 0.0f}, {x + 1.0f, 0.0f}, {x + 1.0f, 1.0f}, {x, 1.0f}};
    boxreel::DrawList list;
    list.AddSolidPolygon(corners, 4, {230, 178, 178, 255});
    return list;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2)
    {
        return 2;
    }
    auto renderer = boxreel::Renderer::Create({.width = 64, .height = 48});
    if (!renderer)
    {
        return Fail(renderer.GetError());
    }
    auto writer =
        boxreel::VideoWriter::Open(argv[1], {.width = 64, .height = 48, .overwrite = true});
    if (!writer)
    {
        return Fail(writer.GetError());
    }
    const boxreel::Camera camera{
        .width = 64, .height = 48, .centerX = 2.0, .centerY = 0.5, .pixelsPerMeter = 12.0};
    boxreel::Frame frame;
    for (int i = 0; i < 10; ++i)
    {
        if (auto drawn = renderer->Draw(SquareAt(0.3f * float(i)), camera, frame); !drawn)
        {
            return Fail(drawn.GetError());
        }
        if (auto appended = writer->Append(frame); !appended)
        {
            return Fail(appended.GetError());
        }
    }
    auto closed = writer->Close();
    return closed ? 0 : Fail(closed.GetError());
}
