// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/DrawList.h>

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

/// The few kinds of controls that the panels are made of. Each is known by its panel's name and its
/// own, "Solver/Sleep", so that a script can find it wherever it has been laid out.
namespace boxreel
{

/// The position of a control in the picture [px].
struct ControlPlace
{
    Vec2 low;
    Vec2 high;
};

class Widgets
{
public:
    explicit Widgets(double scale) : m_scale(float(scale)) {}

    /// Returns a length at the current scale [px]. `length` is at scale 1.
    float Px(double length) const { return float(length) * m_scale; }

    /// Call once per frame, before the functions below.
    void BeginFrame();

    /// A headline that expands and collapses the controls that follow; true while it is expanded.
    bool Section(const char* name, bool opensFirst);
    /// Assigns the following controls to a panel of this name.
    void SetPanel(const char* name) { m_panel = name; }

    bool Button(const char* name, float width = 0.0f);
    bool Check(const char* name, bool& value);
    /// Returns the width of a check box with its label [px].
    static float CheckWidth(const char* name);
    /// A slider between two limits, with a button for one less and one for one more.
    bool Number(const char* name, int& value, int lowest, int highest);
    /// An entry of a list, as a line that can be selected.
    bool Line(const char* name, bool isChosen);
    /// "name    value".
    void Fact(const char* name, const std::string& value);
    /// Draws a line through these points [px] in the colour of plots.
    void Curve(std::span<const Vec2> points);
    /// Draws a border around the current window or popup, whose corners have this radius [px].
    void Border(float rounding);
    /// A text beside the mouse.
    void Tip(const std::string& text);
    /// The last item of Dear ImGui's gets this name.
    void Note(const std::string& name);

    /// The middle of the control in the picture [px]; none when it is not seen.
    std::optional<Vec2> Find(const std::string& name) const;
    /// All of it, with its label; none when it is not seen.
    std::optional<ControlPlace> PlaceOf(const std::string& name) const;
    /// Opens its section and scrolls to it, in the frames that follow.
    void Reveal(const std::string& name) { m_revealed = name; }
    /// Returns the names of the controls of the last frame.
    std::vector<std::string> Names() const;

    const std::set<std::string>& OpenSections() const { return m_open; }
    /// Opens these sections and closes the others, in the next frame.
    void SetOpenSections(std::set<std::string> names) { m_toOpen = std::move(names); }

private:
    bool IsRevealed(const std::string& name) const { return m_revealed && *m_revealed == name; }

    float m_scale;
    std::string m_panel;
    std::map<std::string, std::optional<ControlPlace>> m_places; // none: out of sight
    std::optional<std::string> m_revealed;
    std::set<std::string> m_open; // sections
    std::optional<std::set<std::string>> m_toOpen;
    std::optional<std::set<std::string>> m_opening; // of this frame
};

} // namespace boxreel
