// SPDX-License-Identifier: MIT
#include "FilmSimulation.h"
#include "StopSignals.h"

#include <base/ErrorMacros.h>
#include <recorder/StageTimes.h>
#include <session/SessionPanels.h>

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

SimulationTotals FilmSimulation::Totals() const
{
    return {.firstStep = m_firstStep, .steps = m_session->Step() - m_firstStep};
}

} // namespace boxreel
