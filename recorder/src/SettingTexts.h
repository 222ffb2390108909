// SPDX-License-Identifier: MIT
#pragma once

#include <base/ErrorMacros.h>
#include <recorder/VideoWriter.h>

/// The members of VideoSettings that errors name, and values of them that errors ask for.
namespace boxreel
{

inline constexpr std::string_view kSize = BOXREEL_MEMBERS(VideoSettings, width, height);
inline constexpr std::string_view kCodec = BOXREEL_MEMBER(VideoSettings, codec);
inline constexpr std::string_view kCodecOptions = BOXREEL_MEMBER(VideoSettings, codecOptions);
inline constexpr std::string_view kChroma = BOXREEL_MEMBER(VideoSettings, chroma);
inline constexpr std::string_view kFormat = BOXREEL_MEMBER(VideoSettings, format);
inline constexpr std::string_view kPlays = BOXREEL_MEMBER(VideoSettings, plays);
inline constexpr std::string_view kTiming = BOXREEL_MEMBER(VideoSettings, timing);
inline constexpr std::string_view kResume = BOXREEL_MEMBER(VideoSettings, resume);

inline const ErrorSetting kLossless{BOXREEL_MEMBER(VideoSettings, quality), {"Quality::Lossless"}};
inline const ErrorSetting kFullChroma{kChroma, {"Chroma::Full"}};
inline const ErrorSetting kVariableRate{kTiming, {"FrameTiming::Variable"}};
inline const ErrorSetting kResumed{kResume, {"true"}};
inline const ErrorSetting kOverwritten{BOXREEL_MEMBER(VideoSettings, overwrite), {"true"}};

/// Returns what to do about the part file of a film that was interrupted.
inline ErrorText LeftoverRemedy()
{
    return ErrorText::AnyOf(
        {"continue it (" + kResumed + ")", "start again (" + kOverwritten + ")"});
}

} // namespace boxreel
