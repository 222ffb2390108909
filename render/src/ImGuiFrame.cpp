// SPDX-License-Identifier: MIT
#include "ImGuiFrame.h"

#include "FontAtlas.h"

#include <algorithm>
#include <mutex>
#include <string>

namespace boxreel
{
namespace
{

// Dear ImGui keeps its current context in one variable of the process.
std::mutex g_imgui;

} // namespace

ImGuiFrame::ImGuiFrame(int width, int height, double scale) : m_width(width), m_height(height)
{
    const std::lock_guard lock(g_imgui);
    // The atlas is shared; Dear ImGui only marks it as in use while a frame is built, under the
    // lock.
    m_context = ImGui::CreateContext(FontAtlas::Get(scale).ImGuiAtlas());
    ImGui::SetCurrentContext(m_context);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.DisplaySize = {float(width), float(height)};
    io.DeltaTime = 1.0f / 60.0f;
    // What is shown hangs on the input alone, not on how many frames there were.
    io.ConfigInputTextCursorBlink = false;
    ImGui::SetCurrentContext(nullptr);
}

ImGuiFrame::~ImGuiFrame()
{
    const std::lock_guard lock(g_imgui);
    ImGui::DestroyContext(m_context);
}

void ImGuiFrame::With(const std::function<void()>& act)
{
    const std::lock_guard lock(g_imgui);
    ImGui::SetCurrentContext(m_context);
    act();
    ImGui::SetCurrentContext(nullptr);
}

const Overlay& ImGuiFrame::Build(const std::function<void()>& draw)
{
    With([&] {
        ImGui::NewFrame();
        draw();
        ImGui::Render();
        Copy(*ImGui::GetDrawData());
    });
    return m_overlay;
}

void ImGuiFrame::Resize(int width, int height)
{
    m_width = width;
    m_height = height;
    With([&] { ImGui::GetIO().DisplaySize = {float(width), float(height)}; });
}

void ImGuiFrame::Copy(const ImDrawData& data)
{
    m_overlay.vertices.clear();
    m_overlay.indices.clear();
    m_overlay.commands.clear();
    for (int i = 0; i < data.CmdListsCount; ++i)
    {
        const ImDrawList& list = *data.CmdLists[i];
        const auto firstVertex = std::uint32_t(m_overlay.vertices.size());
        for (const ImDrawVert& vertex : list.VtxBuffer)
        {
            const auto channel = [&](int shift) {
                return std::uint8_t(vertex.col >> shift & 0xffu);
            };
            m_overlay.vertices.push_back({{vertex.pos.x, vertex.pos.y},
                                          {vertex.uv.x, vertex.uv.y},
                                          {channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT),
                                           channel(IM_COL32_B_SHIFT), channel(IM_COL32_A_SHIFT)}});
        }
        for (const ImDrawCmd& command : list.CmdBuffer)
        {
            if (command.ElemCount == 0)
            {
                continue;
            }
            const auto firstIndex = std::uint32_t(m_overlay.indices.size());
            for (unsigned int k = 0; k < command.ElemCount; ++k)
            {
                const ImDrawIdx index = list.IdxBuffer[int(command.IdxOffset + k)];
                m_overlay.indices.push_back(firstVertex + command.VtxOffset + index);
            }
            const auto limit = [](float value, int most) {
                return int(std::clamp(value, 0.0f, float(most)));
            };
            m_overlay.commands.push_back(
                {firstIndex, command.ElemCount, limit(command.ClipRect.x, m_width),
                 limit(command.ClipRect.y, m_height), limit(command.ClipRect.z, m_width),
                 limit(command.ClipRect.w, m_height)});
        }
    }
}

Result<void> CheckPanelSize(int width, int height, double scale)
{
    if (width < 1 || width > 8192 || height < 1 || height > 8192)
    {
        return Error{ErrorKind::Unusable, "a panel cannot be laid out in a picture of " +
                                              std::to_string(width) + "x" + std::to_string(height) +
                                              " pixels; width and height go from 1 to 8192"};
    }
    if (!(scale >= 0.1 && scale <= 16.0))
    {
        return Error{ErrorKind::Unusable, "a panel cannot be scaled by " + std::to_string(scale) +
                                              "; give a scale from 0.1 to 16"};
    }
    return {};
}

} // namespace boxreel
