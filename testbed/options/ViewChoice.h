// SPDX-License-Identifier: MIT
#pragma once

#include "BodyRef.h"

#include <base/Result.h>
#include <debugdraw/CameraPath.h>

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// The view of a picture of a scene, as `--camera` names it. Bodies are named by their number or
/// name.
namespace boxreel
{

/// The view that the scene prefers; if it has none, the view of the dynamic bodies.
struct SceneView
{
    friend bool operator==(const SceneView&, const SceneView&) = default;
};

/// The camera keeps in view what moves.
struct FitView
{
    bool wholeWorld = false; ///< begins with all that there is, the static surroundings too
    friend bool operator==(const FitView&, const FitView&) = default;
};

/// These bodies, as large as fits.
struct FitBodiesView
{
    std::vector<BodyRef> bodies;
    friend bool operator==(const FitBodiesView&, const FitBodiesView&) = default;
};

/// A camera that stays where it is.
struct FixedView
{
    double centerX = 0.0; ///< [m]
    double centerY = 0.0; ///< [m]
    double height = 50.0; ///< of the visible area [m], above 0
    friend bool operator==(const FixedView&, const FixedView&) = default;
};

/// These bodies in the middle.
struct FollowView
{
    std::vector<BodyRef> bodies;
    std::optional<double> height; ///< of the visible area [m]; none: what suits their size
    friend bool operator==(const FollowView&, const FollowView&) = default;
};

/// From key to key.
struct PathView
{
    std::vector<CameraKey> keys;
    friend bool operator==(const PathView&, const PathView&) = default;
};

using ViewChoice = std::variant<SceneView, FitView, FitBodiesView, FixedView, FollowView, PathView>;

/// The bodies that a view names.
std::vector<BodyRef*> BodiesOf(ViewChoice& view);

/// "scene", "fit", "fit:world", "fit:3,17", "0,20,50", "follow:17", "follow:3,17:12",
/// "path:0s=0,20,50;3s=10,5,12". A failure is Unusable, one sentence that names `option`.
Result<ViewChoice> ParseView(const std::string& option, const std::string& text);

/// The same text for the same view, and another one for every other: not always what ParseView
/// takes.
std::string TextOf(const ViewChoice& view);

} // namespace boxreel
