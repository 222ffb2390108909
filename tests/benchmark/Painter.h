// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>
#include <render/Frame.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

/// The interface of a renderer in the benchmark of drawing. Each program has one source that
/// implements it (Painter*.cpp) and shares the rest, like the engines (Sim.h).
namespace bench
{

class Painter
{
public:
    virtual ~Painter() = default;

    /// Begins a picture in the classic theme.
    virtual boxreel::Result<void> Submit(const boxreel::DrawList& list,
                                         const boxreel::Camera& camera) = 0;
    /// Ends it: its pixels lie in memory, in whichever order of bytes suits the painter.
    virtual boxreel::Result<void> Read() = 0;

    /// The last picture that was read; not timed.
    virtual boxreel::Frame Picture() const = 0;

    /// Returns the name of the drawing library, for people.
    virtual std::string Description() const = 0;
};

using MakePainter = std::function<boxreel::Result<std::unique_ptr<Painter>>(int width, int height)>;

struct Method
{
    std::string name; ///< with its version
    MakePainter make;
    MakePainter makeFloor;             ///< only clears and reads; empty: not measured
    bool drawsOnlyWhatChanged = false; ///< else one time holds for all changes
    bool isUsual = true;               ///< with the settings that the program has by itself
};

/// Those of this program.
const std::vector<Method>& Methods();

} // namespace bench
