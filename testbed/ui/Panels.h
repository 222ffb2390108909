// SPDX-License-Identifier: MIT
#pragma once

#include "History.h"
#include "PanelData.h"
#include "ScenePicker.h"
#include "Widgets.h"

#include <render/PanelCanvas.h>

/// The panels of the testbed: one column at the right of the picture, and the picker of scenes over
/// its middle. They are the same in a window and in pictures without one. Independent of worlds and
/// files.
namespace boxreel
{

class Panels
{
public:
    static constexpr int kColumnWidth = 320; ///< at scale 1 [px]

    /// For a picture of this size [px], with the scale in it.
    static Result<Panels> Create(int width, int height, double scale);

    /// Builds a frame: shows the facts, changes the choices, returns the requests.
    PanelAnswer Build(const PanelFacts& facts, PanelChoices& choices, const PanelInput& input);

    /// Returns the overlay of the last frame.
    const Overlay& Picture() const { return m_picture; }

    /// Adds a simulated step to the plots. Facts of another scene, or of an earlier step, restart
    /// them.
    void Observe(const PanelFacts& facts);

    void Resize(int width, int height);

    /// Returns the width that they cover at the right of the picture [px].
    double Width(const PanelChoices& choices) const;

    bool WantsPointer() const { return m_canvas.WantsPointer(); }
    bool WantsKeys(const PanelChoices& choices) const
    {
        return choices.showsPicker || m_canvas.WantsKeys();
    }

    /// "Solver/Sleep" and so on; scripts use them.
    Widgets& Controls() { return m_widgets; }
    const Widgets& Controls() const { return m_widgets; }

private:
    Panels(PanelCanvas canvas, int width, int height, double scale);
    void Recognise(const PanelFacts& facts);
    void Column(const PanelFacts& facts, PanelChoices& choices);
    void Buttons(const PanelFacts& facts, PanelChoices& choices);
    void FileButtons(const PanelFacts& facts, PanelChoices& choices);
    void ScenesSection(const PanelFacts& facts);
    void DrawSection(const PanelFacts& facts, PanelChoices& choices);
    void StatisticsSection(const PanelFacts& facts);
    void ProfileSection(const PanelFacts& facts);
    void Plot(const char* name, const History& history);
    void DrawCurve(const History& history, float top);
    void Ask(PanelWish wish) { m_answer.wishes.push_back(wish); }

    PanelCanvas m_canvas;
    Widgets m_widgets;
    ScenePicker m_picker;
    int m_width;
    int m_height;
    Overlay m_picture;
    PanelAnswer m_answer;
    std::string m_observed; // scene
    std::int64_t m_observedStep = 0;
    History m_contacts;
    std::array<History, kStageNames.size()> m_times;
};

} // namespace boxreel
