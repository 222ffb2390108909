// SPDX-License-Identifier: MIT
#pragma once

#include "WorldObject.h"

#include <base/Result.h>
#include <debugdraw/Camera.h>
#include <debugdraw/DrawLayer.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/Theme.h>
#include <debugdraw/WorldBodies.h>
#include <render/Frame.h>

#include <pybind11/numpy.h>

/// Declarations shared by the parts of the package boxreel.
namespace boxreel::python
{

/// Throws boxreel.Error.
[[noreturn]] void ThrowError(const Error& error);

/// Returns the value, or throws boxreel.Error.
template <class T>
T Need(Result<T> result)
{
    if (!result)
    {
        ThrowError(result.GetError());
    }
    if constexpr (!std::is_void_v<T>)
    {
        return std::move(*result);
    }
}

/// Throws b2Error: the argument has a word that is not one of these.
[[noreturn]] void ThrowNotOneOf(const char* argument, const std::string& word,
                                const std::vector<std::string>& words);

/// A word of an argument, and its meaning.
template <class T>
struct Word
{
    const char* word;
    T meaning;
};

/// Returns the meaning of a word in a table, or throws b2Error.
template <class T, std::size_t N>
T OneOf(const char* argument, const std::string& word, const Word<T> (&table)[N])
{
    std::vector<std::string> words;
    for (const Word<T>& row : table)
    {
        if (word == row.word)
        {
            return row.meaning;
        }
        words.emplace_back(row.word);
    }
    ThrowNotOneOf(argument, word, words);
}

/// Returns the theme of that name.
Theme ThemeFrom(const std::string& name);

/// The content of a picture of a world.
struct Look
{
    LayerSet layers;                       ///< by default the usual ones
    std::vector<std::vector<Vec2>> trails; ///< paths [m], oldest point first
};

/// Returns what the first frame of a film shows beside the dynamic bodies: where each meets a
/// static body if it falls. Empty without gravity or ground.
Rect GroundBelow(const b2World& world);
/// Reads layers (names) and trails (sequences of points).
Look LookFrom(py::handle layers, py::handle trails);

/// Throws b2Error in a forked process that would wait for ever: the threads that its parent's
/// drawing or encoding began do not exist there. Call before the first picture or a film.
void RequireThreadsOfPictures();
void RequireThreadsOfFilms();

/// Returns the text of an attribute `name`, which is any object.
std::string NameFrom(py::handle name);

/// Returns the names of bodies that have an attribute `name`, as those of boxreel.scene do.
BodyNames NamesOf(WorldObject& world);

/// Returns the draw list of a world in the view of a camera, which may be enlarged by up to `zoom`.
DrawList ListOf(WorldObject& world, const Camera& camera, const Look& look, double zoom = 1.0);

/// Returns the camera, or for None the view of a world that a film starts with.
Camera CameraFrom(py::handle camera, WorldObject& world, int width, int height);

/// Returns a picture as an array (height, width, 4) that owns it.
py::array ArrayOf(Frame&& frame);

/// Returns an array (height, width, 3 or 4) of uint8 as a picture.
Frame FrameFrom(py::handle array);

} // namespace boxreel::python
