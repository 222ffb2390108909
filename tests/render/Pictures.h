// SPDX-License-Identifier: MIT
#pragma once

#include <render/FigureFrame.h>
#include <render/Renderer.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

/// Helpers for the tests of drawing: a camera with a scale of pixels, and pictures from one call.
namespace boxreel
{

/// World (x, y) is y pixels above the lower edge, x from the left.
inline Camera PixelCamera(int width, int height)
{
    Camera camera;
    camera.width = width;
    camera.height = height;
    camera.centerX = 0.5 * width;
    camera.centerY = 0.5 * height;
    camera.pixelsPerMeter = 1.0;
    return camera;
}

inline Renderer MakeRenderer(int width, int height, const Theme& theme = Theme::Classic())
{
    RendererSettings settings;
    settings.width = width;
    settings.height = height;
    settings.theme = theme;
    Result<Renderer> renderer = Renderer::Create(settings);
    EXPECT_TRUE(renderer) << renderer.GetError().Text();
    return std::move(*renderer);
}

inline Frame DrawWith(Renderer& renderer, const DrawList& list, const Camera& camera,
                      const Overlay* overlay = nullptr)
{
    Frame frame;
    const Result<void> drawn = renderer.Draw(list, camera, frame, overlay);
    EXPECT_TRUE(drawn) << drawn.GetError().Text();
    return frame;
}

inline Frame Picture(const DrawList& list, int width, int height,
                     const Theme& theme = Theme::Classic())
{
    Renderer renderer = MakeRenderer(width, height, theme);
    return DrawWith(renderer, list, PixelCamera(width, height));
}

inline Frame FrameOf(const Figure& figure)
{
    const Result<Frame> frame = ToFrame(figure);
    EXPECT_TRUE(frame) << frame.GetError().Text();
    return frame ? *frame : Frame();
}

/// A part of a picture.
inline Frame Cut(const Frame& frame, int x, int y, int width, int height)
{
    Frame part(width, height);
    for (int row = 0; row < height; ++row)
    {
        std::copy_n(frame.Pixel(x, y + row), std::size_t(4 * width), part.Pixel(0, row));
    }
    return part;
}

using Pixel = std::array<int, 4>;

inline Pixel At(const Frame& frame, int x, int y)
{
    const std::uint8_t* const p = frame.Pixel(x, y);
    return {p[0], p[1], p[2], p[3]};
}

inline void AddRectangle(DrawList& list, float x0, float y0, float x1, float y1, const Paint& color)
{
    const Vec2 corners[4] = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    list.AddSolidPolygon(corners, 4, color);
}

inline void AddTurnedBox(DrawList& list, Vec2 center, float halfX, float halfY, float angle,
                         const Paint& color)
{
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    Vec2 corners[4] = {{-halfX, -halfY}, {halfX, -halfY}, {halfX, halfY}, {-halfX, halfY}};
    for (Vec2& p : corners)
    {
        p = {center.x + c * p.x - s * p.y, center.y + s * p.x + c * p.y};
    }
    list.AddSolidPolygon(corners, 4, color);
}

inline void AddRegular(DrawList& list, Vec2 center, float radiusX, float radiusY, int count,
                       float angle, const Paint& color)
{
    std::array<Vec2, 16> corners;
    for (int i = 0; i < count; ++i)
    {
        const float t = 6.2831853f * float(i) / float(count);
        const Vec2 p{radiusX * std::cos(t), radiusY * std::sin(t)};
        corners[std::size_t(i)] = {center.x + std::cos(angle) * p.x - std::sin(angle) * p.y,
                                   center.y + std::sin(angle) * p.x + std::cos(angle) * p.y};
    }
    list.AddSolidPolygon(corners.data(), std::size_t(count), color);
}

inline constexpr Paint kAwake = ColorRole::AwakeBody;
inline constexpr Paint kStatic = ColorRole::StaticBody;
inline constexpr Paint kKinematic = ColorRole::KinematicBody;
inline constexpr Color kWhite{255, 255, 255, 255};

/// Every kind of item, in layers over each other, in a picture of 320 x 240.
inline DrawList Everything(unsigned seed = 1)
{
    std::mt19937 random(seed);
    const auto between = [&](float a, float b) {
        return a + (b - a) * float(random() % 10000u) / 10000.0f;
    };
    DrawList list;
    for (int i = 0; i < 60; ++i)
    {
        const Vec2 at{between(0, 320), between(0, 240)};
        const float size = between(0.5f, 30);
        const float angle = between(0, 6);
        AddTurnedBox(list, at, size, between(0.5f, 30), angle, kAwake);
        list.AddSolidCircle({at.y, at.x}, size, {std::cos(angle), std::sin(angle)}, kStatic);
        AddRegular(list, {at.x + 20, at.y}, size, between(1, 30), 3 + i % 6, angle, kKinematic);
        list.AddSegment(at, {between(0, 320), between(0, 240)}, kWhite);
        list.AddCircle(at, size, kAwake);
        list.AddPoint(at, between(1, 9), kStatic);
        list.AddTransform(at, {std::cos(angle), std::sin(angle)}, size);
        list.AddText(at, "label", kWhite);
    }
    return list;
}

} // namespace boxreel
