// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>
#include <golden/ReferenceStore.h>
#include <render/Frame.h>

#include <string>

/// Small pictures in the manner of a debug drawing, for tests of the comparison. The painter snaps
/// to whole pixels and knows upright boxes, lines and blocks for letters: enough to plant changes,
/// and the same on every machine.
namespace boxreel::test
{

inline constexpr Color kDark{26, 26, 26, 255};
inline constexpr Color kLight{242, 242, 242, 255};
inline constexpr Color kAwake{230, 179, 179, 255};
inline constexpr Color kStatic{128, 230, 128, 255};
inline constexpr Color kJoint{128, 204, 204, 255};

struct Style
{
    Color ground = kDark;
    double pixelsPerMeter = 14.0;
    int outline = 1;   ///< [px]
    int fillShift = 0; ///< added to every channel of every fill
};

Frame Filled(int width, int height, Color color);
void FillRect(Frame& frame, int x0, int y0, int x1, int y1, Color color);

/// A ground, three boxes, a joint line between two of them and a label.
DrawList SmallScene();

/// 320 x 180 pixels, world origin at the bottom in the middle.
Frame Painted(const DrawList& list, const Style& style = {});

/// The scene as the golden tests see it.
GoldenCandidate Candidate(const std::string& name, const DrawList& list = SmallScene(),
                          const Style& style = {});

/// With the item at `index` and the one after it the other way round.
DrawList WithSwappedOrder(const DrawList& list, std::size_t index);
DrawList WithoutItem(const DrawList& list, std::size_t index);

} // namespace boxreel::test
