// SPDX-License-Identifier: MIT
#include <render/FigureSheet.h>

#include <debugdraw/Axes.h>
#include <debugdraw/Paper.h>
#include <debugdraw/ScaleBar.h>
#include <debugdraw/TextWidth.h>

#include <algorithm>

namespace boxreel
{
namespace
{

// All lengths in pixels.
constexpr int kBorder = 12;      // around the sheet
constexpr int kGap = 16;         // between pictures
constexpr int kTitleHeight = 24; // of a title above a picture
constexpr int kLine = 20;        // line spacing of the caption
constexpr int kCaptionGap = 14;  // above the caption
constexpr int kAxisEnd = 6;      // space for the last number of an axis
static_assert(kBorder >= kAxisOver);

/// Margins around each picture.
struct Margins
{
    int left = 0;
    int top = 0;
    int bottom = 0;
};

struct Grid
{
    int columns = 1;
    int rows = 1;
    int cellWidth = 0;
    int cellHeight = 0;
    int gap = 0;
    int border = 0;
    int Width() const { return 2 * border + columns * cellWidth + (columns - 1) * gap; }
    int Height() const { return 2 * border + rows * cellHeight + (rows - 1) * gap; }
};

int ColumnsFor(int count)
{
    int columns = std::min(count, 3);
    columns = count == 4 ? 2 : columns; // 2 x 2 instead of 3 + 1
    while (columns * columns < count)
    {
        ++columns;
    }
    return std::max(columns, 1);
}

bool IsPlain(const std::vector<SheetPicture>& pictures, const SheetSettings& settings)
{
    return pictures.size() == 1 && !settings.axes && !settings.scaleBar &&
           settings.caption.empty() && pictures.front().title.empty();
}

/// True if all pictures have the same scale, so that one scale bar suffices.
bool HaveOneScale(const std::vector<SheetPicture>& pictures)
{
    return std::all_of(pictures.begin(), pictures.end(), [&](const SheetPicture& picture) {
        return picture.camera.pixelsPerMeter == pictures.front().camera.pixelsPerMeter;
    });
}

void AddBar(DrawList& list, const Camera& sheet, const Camera& view, double left, double top)
{
    AddScaleBar(list, sheet, view.pixelsPerMeter,
                {float(left), float(top + 0.5 * kScaleBarHeight + 2.0)}, std::min(view.width, 240));
}

Margins MarginsOf(const std::vector<SheetPicture>& pictures, const SheetSettings& settings)
{
    Margins margins;
    for (const SheetPicture& picture : pictures)
    {
        margins.left = std::max(margins.left, settings.axes ? RoomForAxis(picture.camera) : 0);
        margins.top = std::max(margins.top, picture.title.empty() ? 0 : kTitleHeight);
    }
    margins.bottom = settings.axes ? kAxisBelow : 0;
    margins.bottom += settings.scaleBar && !HaveOneScale(pictures) ? kScaleBarHeight : 0;
    return margins;
}

Grid GridOf(const std::vector<SheetPicture>& pictures, const Margins& margins,
            const SheetSettings& settings)
{
    const int count = static_cast<int>(pictures.size());
    Grid grid;
    grid.columns = std::clamp(settings.columns > 0 ? settings.columns : ColumnsFor(count), 1,
                              std::max(count, 1));
    grid.rows = std::max(1, (count + grid.columns - 1) / grid.columns);
    for (const SheetPicture& picture : pictures)
    {
        grid.cellWidth = std::max(grid.cellWidth, margins.left + picture.camera.width);
        grid.cellHeight =
            std::max(grid.cellHeight, margins.top + picture.camera.height + margins.bottom);
    }
    grid.gap = settings.axes ? kGap + kAxisEnd : kGap;
    grid.border = kBorder;
    return grid;
}

/// Outlines a picture without axes, just outside of it, to show its edges.
void AddFrame(const Paper& paper, const Camera& view, PixelPoint corner)
{
    constexpr Paint kFrame = ColorRole::AsleepBody; // a grey in most themes
    const double left = corner.x - 1.0;
    const double top = corner.y - 1.0;
    const double right = corner.x + view.width + 1.0;
    const double bottom = corner.y + view.height + 1.0;
    paper.Line({left, top}, {right, top}, kFrame);
    paper.Line({right, top}, {right, bottom}, kFrame);
    paper.Line({right, bottom}, {left, bottom}, kFrame);
    paper.Line({left, bottom}, {left, top}, kFrame);
}

void AddSurroundings(DrawList& list, const Camera& sheet, const SheetPicture& picture,
                     PixelPoint corner, const SheetSettings& settings, bool hasBar)
{
    const Paper paper(list, sheet);
    const Camera& view = picture.camera;
    const Vec2 at{float(corner.x), float(corner.y)};
    double below = corner.y + view.height;
    if (settings.axes)
    {
        AddAxes(list, sheet, view, at);
        below += kAxisBelow;
    }
    else
    {
        AddFrame(paper, view, corner);
    }
    if (hasBar)
    {
        AddBar(list, sheet, view, corner.x, below);
    }
    paper.Text({corner.x, corner.y - 0.5 * kTitleHeight}, picture.title, {0.0, 0.5}, kInk);
}

} // namespace

Figure SheetOf(std::vector<SheetPicture> pictures, const SheetSettings& settings)
{
    Figure figure;
    figure.theme = settings.theme;
    figure.scale = settings.scale;
    figure.title = settings.title;
    if (IsPlain(pictures, settings))
    {
        figure.width = pictures.front().camera.width;
        figure.height = pictures.front().camera.height;
        figure.panels.push_back(
            {std::move(pictures.front().list), pictures.front().camera, 0.0, 0.0, {}});
        return figure;
    }
    const Margins margins = MarginsOf(pictures, settings);
    const Grid grid = GridOf(pictures, margins, settings);
    const bool sharesBar = settings.scaleBar && HaveOneScale(pictures);
    const int barHeight = sharesBar ? kScaleBarHeight : 0;
    figure.width = grid.Width();
    figure.height = grid.Height() + barHeight;
    std::vector<std::string> lines;
    if (!settings.caption.empty())
    {
        lines = WrapText(settings.caption, grid.Width() - 2.0 * kBorder);
        figure.height += kCaptionGap + kLine * static_cast<int>(lines.size());
    }
    const Camera sheet = PaperCamera(figure.width, figure.height);
    FigurePanel around{{}, sheet, 0.0, 0.0, {}};
    figure.panels.resize(1);
    for (std::size_t i = 0; i < pictures.size(); ++i)
    {
        const int column = static_cast<int>(i) % grid.columns;
        const int row = static_cast<int>(i) / grid.columns;
        const PixelPoint corner{
            double(grid.border + column * (grid.cellWidth + grid.gap) + margins.left),
            double(grid.border + row * (grid.cellHeight + grid.gap) + margins.top)};
        AddSurroundings(around.list, sheet, pictures[i], corner, settings,
                        settings.scaleBar && !sharesBar);
        figure.panels.push_back(
            {std::move(pictures[i].list), pictures[i].camera, corner.x, corner.y, {}});
        figure.panels.back().name =
            pictures.size() > 1 ? "picture-" + std::to_string(i + 1) : std::string();
    }
    if (sharesBar)
    {
        AddBar(around.list, sheet, figure.panels.back().camera, grid.border + margins.left,
               grid.Height() - grid.border);
    }
    const Paper paper(around.list, sheet);
    double y = grid.Height() - grid.border + barHeight + kCaptionGap;
    for (const std::string& line : lines)
    {
        paper.Text({double(kBorder), y}, line, {0.0, 0.0}, kInk);
        y += kLine;
    }
    figure.panels.front() = std::move(around);
    return figure;
}

} // namespace boxreel
