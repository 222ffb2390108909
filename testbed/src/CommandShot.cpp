// SPDX-License-Identifier: MIT
#include "Commands.h"
#include "OutputPath.h"
#include "Terminal.h"

#include <render/Png.h>
#include <render/Renderer.h>

namespace boxreel
{
namespace
{

Result<Frame> TakePicture(const ShotOptions& options, SceneSource source)
{
    Result<Renderer> renderer = Renderer::Create(
        {.width = options.look.width, .height = options.look.height, .backend = options.backend});
    if (!renderer)
    {
        return renderer.GetError();
    }
    Result<SceneSession> session = SceneSession::Open(std::move(source), options.look);
    if (!session)
    {
        return session.GetError();
    }
    session->AdvanceTo(options.at ? StepAt(*options.at, session->StepsPerSecond())
                                  : options.step.value_or(0));
    FrameContent content;
    session->Fill(content);
    Frame frame;
    const Result<void> drawn =
        renderer->Draw(content.list, content.camera, frame, &content.overlay);
    if (!drawn)
    {
        return drawn.GetError();
    }
    return frame;
}

} // namespace

Result<int> RunShot(const ShotOptions& options)
{
    const Result<void> usable = CheckPicturePath(options.output, options.force);
    if (!usable)
    {
        return usable.GetError();
    }
    Result<SceneSource> source = OpenScene(options.scene);
    if (!source)
    {
        return source.GetError();
    }
    for (const std::string& line : source->leftOut)
    {
        WriteMessage(line);
    }
    const Result<Frame> frame = TakePicture(options, std::move(*source));
    if (!frame)
    {
        return frame.GetError();
    }
    const Result<void> written = WritePng(options.output, *frame, {.overwrite = options.force});
    if (!written)
    {
        return written.GetError();
    }
    return 0;
}

} // namespace boxreel
