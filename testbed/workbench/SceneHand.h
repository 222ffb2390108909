// SPDX-License-Identifier: MIT
#pragma once

#include "SceneWork.h"

#include <debugdraw/DrawList.h>
#include <render/Window.h>

#include <set>

/// Mouse and keyboard interaction with a scene. The mouse pulls bodies, moves the view and throws
/// bombs. Keys are passed to the scene.
namespace boxreel
{

class SceneHand
{
public:
    /// A button goes down; `isOnPanels`: it is theirs until it goes up.
    void Press(SceneWork& work, const WindowEvent& event, bool isOnPanels);
    void Release(SceneWork& work, const WindowEvent& event);
    void Move(SceneWork& work, const WindowEvent& event);

    /// Presses a key. Does nothing if the scene does not use it.
    void PressKey(SceneWork& work, Key key);
    void ReleaseKey(SceneWork& work, Key key);

    /// Releases all held keys and buttons. The mouse was last at `pointer` [px].
    void LetGo(SceneWork& work, Vec2 pointer);

    /// Forgets everything held in the previous scene, after a new one has been opened.
    void Forget();

    /// While a bomb is pulled back, the path of the pull.
    void AddSling(const SceneWork& work, Vec2 pointer, DrawList& list) const;

private:
    /// The action of the mouse button that is down.
    enum class Hold
    {
        Nothing,
        Panels,
        Scene,
        View,
        Bomb,
    };

    Hold m_hold = Hold::Nothing;
    int m_button = 0;      // that holds
    Vec2 m_at{0.0f, 0.0f}; // where it went down, or was last [px]
    b2Vec2 m_slingFrom{0.0f, 0.0f};
    std::set<Key> m_keys; // of the scene, that are down
};

} // namespace boxreel
