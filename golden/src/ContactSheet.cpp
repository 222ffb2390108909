// SPDX-License-Identifier: MIT
#include <golden/ContactSheet.h>

#include <base/ErrorMacros.h>
#include <recorder/VideoReader.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace boxreel
{

namespace
{

constexpr int kGap = 2; ///< between pictures [px]
constexpr std::uint8_t kGray = 128;

/// Box filter in integers: with the sides W and w, a pixel of the result covers W units of 1/w
/// pixel.
class Shrink
{
public:
    Shrink(int from, int to) : m_from(from), m_to(to) {}

    /// Calls visit(pixel, weight) for the pixels below one of the result; the sum of weights is the
    /// larger side.
    template <class Visit>
    void ForCovered(int place, Visit&& visit) const
    {
        const std::int64_t begin = std::int64_t(place) * m_from;
        const std::int64_t end = begin + m_from;
        for (std::int64_t pixel = begin / m_to; pixel * m_to < end; ++pixel)
        {
            const std::int64_t covered =
                std::min(end, (pixel + 1) * m_to) - std::max(begin, pixel * m_to);
            visit(int(pixel), covered);
        }
    }

private:
    std::int64_t m_from, m_to;
};

Frame Shrunk(const Frame& frame, int width, int height)
{
    const Shrink columns(frame.width, width);
    const Shrink rows(frame.height, height);
    const std::int64_t area = std::int64_t(frame.width) * frame.height;
    Frame small(width, height);
    for (int y = 0; y < height; ++y)
    {
        for (int x = 0; x < width; ++x)
        {
            std::int64_t sums[4] = {};
            rows.ForCovered(y, [&](int row, std::int64_t rowWeight) {
                columns.ForCovered(x, [&](int column, std::int64_t weight) {
                    const std::uint8_t* const pixel = frame.Pixel(column, row);
                    for (int channel = 0; channel < 4; ++channel)
                    {
                        sums[channel] += rowWeight * weight * pixel[channel];
                    }
                });
            });
            for (int channel = 0; channel < 4; ++channel)
            {
                small.Pixel(x, y)[channel] = std::uint8_t((sums[channel] + area / 2) / area);
            }
        }
    }
    return small;
}

void Put(const Frame& picture, const PixelBounds& place, Frame& sheet)
{
    for (int y = 0; y < picture.height; ++y)
    {
        const std::uint8_t* const row = picture.Pixel(0, y);
        std::copy_n(row, std::size_t(picture.width) * 4, sheet.Pixel(place.x0, place.y0 + y));
    }
}

std::string WhyNotUsable(const ContactSheetSettings& settings)
{
    if (!(settings.stepsPerSecond > 0.0) || !std::isfinite(settings.stepsPerSecond))
    {
        return "the steps per second must be above 0";
    }
    if (settings.every < 1)
    {
        return "the steps between two pictures must be at least 1";
    }
    return settings.columns < 1 || settings.width < 1 ? "columns and width must be at least 1" : "";
}

Error NoContactSheet(const std::filesystem::path& film, const std::string& why,
                     const std::string& remedy = "")
{
    return Error{ErrorKind::Unusable, film.string(), "cannot become a contact sheet: " + why,
                 remedy};
}

/// Returns the frames at these times. A frame is shown until the next one starts, up to rounding.
Result<std::vector<Frame>> Sample(const std::filesystem::path& film,
                                  const ContactSheetSettings& settings)
{
    ASSIGN_OR_RETURN(VideoReader reader, VideoReader::Open(film));
    constexpr double kRounding = 1e-3; // containers round times to a millisecond
    std::vector<Frame> pictures;
    Frame shown, next;
    double seconds = 0.0;
    const double interval = double(settings.every) / settings.stepsPerSecond; // [s]
    for (bool isFirst = true;; isFirst = false)
    {
        ASSIGN_OR_RETURN(const bool more, reader.Next(next, &seconds));
        while (!isFirst && more && double(pictures.size()) * interval + kRounding < seconds)
        {
            if (pictures.size() == kMaxSheetPictures)
            {
                return NoContactSheet(
                    film,
                    "it has more than " + std::to_string(kMaxSheetPictures) +
                        " pictures, one every " + std::to_string(settings.every) + " steps",
                    "use a larger interval, such as every " + std::to_string(2 * settings.every));
            }
            pictures.push_back(shown);
        }
        if (!more)
        {
            break;
        }
        std::swap(shown, next);
    }
    if (shown.rgba.empty())
    {
        return NoContactSheet(film, "it has no frame");
    }
    // The last frame lasts one period, in which another sample may fall.
    const double period = 1.0 / reader.Info().framesPerSecond.ToDouble();
    while (pictures.size() < kMaxSheetPictures &&
           double(pictures.size()) * interval + kRounding < seconds + period)
    {
        pictures.push_back(shown);
    }
    return pictures;
}

} // namespace

PixelBounds SheetLayout::Place(std::size_t picture) const
{
    const int x = int(picture) % columns * (width + kGap);
    const int y = int(picture) / columns * (height + kGap);
    return {x, y, x + width, y + height};
}

Frame CutOut(const Frame& sheet, const PixelBounds& place)
{
    Frame picture(place.x1 - place.x0, place.y1 - place.y0);
    for (int y = 0; y < picture.height; ++y)
    {
        std::copy_n(sheet.Pixel(place.x0, place.y0 + y), std::size_t(picture.width) * 4,
                    picture.Pixel(0, y));
    }
    return picture;
}

Result<ContactSheet> ContactSheetOf(const std::filesystem::path& film,
                                    const ContactSheetSettings& settings)
{
    if (const std::string why = WhyNotUsable(settings); !why.empty())
    {
        return NoContactSheet(film, why);
    }
    ASSIGN_OR_RETURN(const std::vector<Frame> pictures, Sample(film, settings));
    const Frame& first = pictures.front();
    ContactSheet sheet;
    SheetLayout& layout = sheet.layout;
    layout.columns = int(std::min(std::size_t(settings.columns), pictures.size()));
    layout.width = std::min(settings.width, first.width);
    layout.height = std::max(
        1, int((std::int64_t(first.height) * layout.width + first.width / 2) / first.width));
    layout.pictures = pictures.size();
    layout.every = settings.every;
    layout.stepsPerSecond = settings.stepsPerSecond;
    const PixelBounds last = layout.Place(pictures.size() - 1);
    sheet.frame = Frame(layout.Place(std::size_t(layout.columns) - 1).x1, last.y1);
    for (std::size_t i = 0; i < sheet.frame.rgba.size(); ++i)
    {
        sheet.frame.rgba[i] = i % 4 == 3 ? std::uint8_t(255) : kGray;
    }
    for (std::size_t i = 0; i < pictures.size(); ++i)
    {
        Put(Shrunk(pictures[i], layout.width, layout.height), layout.Place(i), sheet.frame);
    }
    return sheet;
}

} // namespace boxreel
