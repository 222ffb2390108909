// SPDX-License-Identifier: MIT
// A running session as bytes, and the settings it must share with a session that continues from
// them.
#include "SceneSession.h"

#include <base/Bytes.h>
#include <scenes/SceneSnapshot.h>

#include <bit>
#include <limits>

namespace boxreel
{

std::string SceneSession::DescribeOrigin()
{
    const std::string start = HexText(ChecksumOf(SaveScene(*m_scene)));
    return "scene " + m_title + "\nstart " + start + "\nseed " +
           std::to_string(m_look.simulation.seed) + "\nsteps a second " +
           std::to_string(m_stepsPerSecond.num) + "/" + std::to_string(m_stepsPerSecond.den) +
           "\niterations " + std::to_string(m_stepSettings.velocityIterations) + " " +
           std::to_string(m_stepSettings.positionIterations) + "\ncamera " + TextOf(m_look.view) +
           "\nactions " +
           HexText(
               ChecksumOf(m_look.simulation.script ? m_look.simulation.script->actionText : "")) +
           "\nsize " + std::to_string(m_look.width) + "x" + std::to_string(m_look.height) + "\n";
}

std::int64_t SceneSession::LatestStateFor(std::int64_t step) const
{
    return m_look.layers[DrawLayer::Contacts] ? step - 1
                                              : step; // dots show which contacts are new in a step
}

std::vector<std::uint8_t> SceneSession::SaveState()
{
    std::vector<std::uint8_t> bytes;
    PutNumber(bytes, static_cast<std::uint64_t>(m_step));
    PutNumber(bytes, static_cast<std::uint64_t>(m_stepSettings.velocityIterations));
    PutNumber(bytes, static_cast<std::uint64_t>(m_stepSettings.positionIterations));
    const std::vector<double> camera = m_camera.State();
    PutNumber(bytes, camera.size());
    for (const double number : camera)
    {
        PutNumber(bytes, std::bit_cast<std::uint64_t>(number));
    }
    const std::vector<std::uint8_t> scene = SaveScene(*m_scene);
    bytes.insert(bytes.end(), scene.begin(), scene.end());
    return bytes;
}

bool SceneSession::RestoreState(std::span<const std::uint8_t> bytes)
{
    const std::uint64_t step = TakeNumber(bytes);
    const std::uint64_t velocityIterations = TakeNumber(bytes);
    const std::uint64_t positionIterations = TakeNumber(bytes);
    std::vector<double> numbers;
    for (std::uint64_t left = TakeNumber(bytes); left > 0 && !bytes.empty(); --left)
    {
        numbers.push_back(std::bit_cast<double>(TakeNumber(bytes)));
    }
    SceneCamera camera = m_camera;
    constexpr std::uint64_t kMaxIterations = 1'000'000;
    if (step > std::uint64_t(std::numeric_limits<std::int64_t>::max()) ||
        velocityIterations > kMaxIterations || positionIterations > kMaxIterations ||
        !camera.Restore(numbers) || !RestoreScene(*m_scene, bytes).empty())
    {
        return false;
    }
    m_camera = camera;
    m_step = m_sceneStep = static_cast<std::int64_t>(step);
    m_stepSettings.velocityIterations = static_cast<int32>(velocityIterations);
    m_stepSettings.positionIterations = static_cast<int32>(positionIterations);
    return true;
}

} // namespace boxreel
