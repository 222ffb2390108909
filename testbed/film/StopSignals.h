// SPDX-License-Identifier: MIT
#pragma once

/// While one exists, SIGINT, SIGTERM and SIGHUP ask for an orderly stop instead of ending the
/// program; a second one ends it at once. A signal that the parent process has switched
/// off (nohup, a job in the background) stays off. One at a time, in the main thread.
namespace boxreel
{

class StopSignals
{
public:
    StopSignals();
    ~StopSignals();
    StopSignals(const StopSignals&) = delete;
    StopSignals& operator=(const StopSignals&) = delete;

    /// Exit code of a stopped program: EX_TEMPFAIL of sysexits.h, "try again later".
    static constexpr int kExitCode = 75;

    /// The signal that came, or 0.
    static int Caught();
};

} // namespace boxreel
