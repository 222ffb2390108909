// SPDX-License-Identifier: MIT
#pragma once

#include "FilmPlan.h"

#include <recorder/Recording.h>
#include <render/Renderer.h>

/// The picture of one frame beside a film.
namespace boxreel
{

class FilmThumbnail
{
public:
    /// Both are borrowed.
    FilmThumbnail(const RecordOptions& options, const FilmPlan& plan)
        : m_options(options), m_plan(plan)
    {}

    bool IsWanted() const { return !m_options.thumbnail.file.empty(); }

    /// Its frame, counted from the first that is filmed.
    std::int64_t Index() const;

    /// A frame of the film was drawn.
    void See(std::int64_t index, const Frame& pixels);

    /// Draws it by itself, of a frame that another run has filmed.
    Result<void> Draw(Renderer& renderer, const FrameContent& content);

    /// Writes it, if it is wanted; `renderer`: that drew the film's last frame, which is shown when
    /// the film ended before its own.
    Result<void> Write(Renderer& renderer);

private:
    const RecordOptions& m_options;
    const FilmPlan& m_plan;
    Frame m_pixels;
};

} // namespace boxreel
