// SPDX-License-Identifier: MIT
#include <base/Quoting.h>
#include <recorder/FrameClock.h>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <optional>
#include <string>

namespace boxreel
{

namespace
{

// The product of three parts of a Rational and a frame number is at most 10^27 * 10^11 < 2^127.
__extension__ typedef __int128 Wide;

constexpr std::size_t kMaxDigits = 9;
constexpr std::int64_t kMaxPart = 1'000'000'000;

bool IsDigits(std::string_view text)
{
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

std::int64_t ToInteger(std::string_view digits)
{
    std::int64_t value = 0;
    for (const char digit : digits)
    {
        value = value * 10 + (digit - '0');
    }
    return value;
}

constexpr const char* kRemedy = "use a number above zero, such as 60, 29.97 or 30000/1001";

Error Refuse(std::string_view text, const char* why)
{
    constexpr std::size_t kShown = 40; // limit of the quoted text in a message
    std::string shown(text.substr(0, kShown));
    if (text.size() > kShown)
    {
        shown += "...";
    }
    return Error{ErrorKind::Unusable, Quoted(shown), why, kRemedy};
}

std::optional<Rational> Reduce(std::int64_t num, std::int64_t den)
{
    const std::int64_t divisor = std::gcd(num, den);
    num /= divisor;
    den /= divisor;
    if (num > kMaxPart || den > kMaxPart)
    {
        return std::nullopt;
    }
    return Rational{num, den};
}

/// Returns the quotient as a double with a single rounding.
double Divide(Wide num, Wide den)
{
    return double(num / den) + double(num % den) / double(den);
}

} // namespace

Result<Rational> Rational::Parse(std::string_view text)
{
    if (text.empty())
    {
        return Error{ErrorKind::Unusable, "number", "is empty", kRemedy};
    }
    if (text.front() == '-')
    {
        return Refuse(text, "is not above zero");
    }
    const std::size_t slash = text.find('/');
    const std::size_t mark = slash != std::string_view::npos ? slash : text.find('.');
    const std::string_view whole = text.substr(0, mark);
    const std::string_view part = mark == std::string_view::npos ? "" : text.substr(mark + 1);
    // ".5" is accepted; "5." and "1/" are typing errors.
    const bool wholeMissing = whole.empty() && slash == std::string_view::npos;
    if ((!wholeMissing && !IsDigits(whole)) || (mark != std::string_view::npos && !IsDigits(part)))
    {
        return Refuse(text, "is not a number");
    }
    if (whole.size() > kMaxDigits || part.size() > kMaxDigits)
    {
        return Refuse(text, "has more than nine digits on one side");
    }
    std::int64_t num = ToInteger(whole);
    std::int64_t den = 1;
    if (slash != std::string_view::npos)
    {
        den = ToInteger(part);
    }
    else
    {
        for (const char digit : part)
        {
            num = num * 10 + (digit - '0');
            den *= 10;
        }
    }
    if (num == 0 || den == 0)
    {
        return Refuse(text, den == 0 ? "divides by zero" : "is not above zero");
    }
    const std::optional<Rational> reduced = Reduce(num, den);
    return reduced ? Result<Rational>(*reduced)
                   : Refuse(text, "has too many digits to be kept exactly");
}

namespace
{

/// The number of steps at a frame, as a fraction.
struct Steps
{
    Wide num;
    Wide den;
};

Steps StepsAt(const FrameClock& clock, std::int64_t frame)
{
    assert(frame >= 0 && "frames are counted from 0");
    return {Wide(frame) * clock.speed.num * clock.stepsPerSecond.num * clock.framesPerSecond.den,
            Wide(clock.speed.den) * clock.stepsPerSecond.den * clock.framesPerSecond.num};
}

} // namespace

std::int64_t FrameClock::StepOfFrame(std::int64_t frame) const
{
    const Steps steps = StepsAt(*this, frame);
    return std::int64_t(steps.num / steps.den);
}

double FrameClock::FractionOfFrame(std::int64_t frame) const
{
    const Steps steps = StepsAt(*this, frame);
    // Rounding could reach 1 only for denominators beyond 2^53; the frame then stays below the next
    // step.
    constexpr double kBelowOne = 1.0 - 0x1p-53;
    return std::min(kBelowOne, double(steps.num % steps.den) / double(steps.den));
}

double FrameClock::SecondsOfFrame(std::int64_t frame) const
{
    return Divide(Wide(frame) * speed.num * framesPerSecond.den,
                  Wide(speed.den) * framesPerSecond.num);
}

double FrameClock::FilmSecondsOfFrame(std::int64_t frame) const
{
    return Divide(Wide(frame) * framesPerSecond.den, Wide(framesPerSecond.num));
}

} // namespace boxreel
