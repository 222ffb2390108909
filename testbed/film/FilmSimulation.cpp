// SPDX-License-Identifier: MIT
#include "FilmSimulation.h"
#include "StopSignals.h"

#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <options/OptionNames.h>
#include <recorder/StageTimes.h>
#include <session/SessionPanels.h>

#include <algorithm>
#include <utility>

namespace boxreel
{

Result<void> FilmSimulation::Open(SceneSource source)
{
    ASSIGN_OR_RETURN(SceneSession session, OpenSession(std::move(source), m_options.look));
    m_session.emplace(std::move(session));
    m_clock = {m_options.film.framesPerSecond, m_session->StepsPerSecond(), m_options.pace.speed};
    return {};
}

std::int64_t FilmSimulation::StepOf(std::int64_t number) const
{
    return StepAt(m_options.length.from.value_or(Duration{}), m_session->StepsPerSecond()) +
           m_clock.StepOfFrame(number);
}

void FilmSimulation::Begin(std::int64_t number)
{
    if (m_snapshots != nullptr)
    {
        m_snapshots->Begin(*m_session, m_session->LatestStateFor(StepOf(number)));
    }
    m_firstStep = m_session->Step();
}

void FilmSimulation::Step()
{
    m_session->AdvanceTo(m_session->Step() + 1);
    if (m_snapshots != nullptr)
    {
        m_snapshots->Offer(*m_session);
    }
}

bool FilmSimulation::AdvanceTo(std::int64_t number)
{
    const StageTimer timer(m_stages, Stage::Simulate);
    const std::int64_t first = m_session->Step();
    const std::int64_t step = StepOf(number);
    while (m_session->Step() < step && StopSignals::Caught() == 0)
    {
        Step();
        m_progress.Simulate({.step = m_session->Step(), .first = first, .last = step});
    }
    if (StopSignals::Caught() != 0)
    {
        return false;
    }
    Show(number);
    return true;
}

void FilmSimulation::FinishAt(std::int64_t number)
{
    for (const std::int64_t step = StepOf(number); m_session->Step() < step;)
    {
        Step();
    }
    Show(number);
}

/// The step is simulated; with --interpolate the next one may be needed too.
void FilmSimulation::Show(std::int64_t number)
{
    const double fraction = m_options.pace.interpolate ? m_clock.FractionOfFrame(number) : 0.0;
    const std::int64_t before = m_session->Step();
    m_session->AdvanceBetween(StepOf(number), fraction);
    m_isBetween = fraction != 0.0;
    if (m_snapshots != nullptr && m_session->Step() != before)
    {
        m_snapshots->Offer(*m_session);
    }
}

void FilmSimulation::Fill(FrameContent& content)
{
    const StageTimer timer(m_stages, Stage::Collect);
    m_session->Fill(content);
}

void FilmSimulation::TellMissingBodies() const
{
    for (const Condition& condition : m_options.length.until)
    {
        const auto missing = condition.MissingBody(m_session->World(), m_session->Names());
        if (missing)
        {
            WriteMessage("boxreel: " + missing->Text());
        }
    }
}

bool FilmSimulation::IsAtEnd() const
{
    const std::vector<Condition>& until = m_options.length.until;
    return std::any_of(until.begin(), until.end(), [this](const Condition& condition) {
        return condition.Holds(m_session->World(), m_session->Names(), m_session->Time());
    });
}

Result<int> FilmSimulation::Conclude(std::int64_t frames) const
{
    if (!m_options.length.until.empty() && !IsAtEnd())
    {
        WriteMessage("boxreel: no condition of --until or --until-sleep became true within " +
                     std::to_string(frames) + " frames");
    }
    // A missed camera target does not fail the film.
    const Result<void> played = m_session->CheckCompanion();
    if (const Result<void> met = m_session->CheckView(); played && !met)
    {
        WriteMessage("boxreel: " + TextInOptions(met.GetError()));
    }
    return played ? Result<int>(0) : played.GetError();
}

SimulationTotals FilmSimulation::Totals() const
{
    return {.firstStep = m_firstStep, .steps = m_session->Step() - m_firstStep};
}

} // namespace boxreel
