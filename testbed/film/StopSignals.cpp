// SPDX-License-Identifier: MIT
#include "StopSignals.h"

#include <atomic>
#include <csignal>

namespace boxreel
{
namespace
{

// SIGPIPE as well: the reader of the progress has ended, so the film is not needed.
constexpr int kStopSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE};

// A handler may only access lock-free atomics.
std::atomic<int> s_caught{0};
static_assert(std::atomic<int>::is_always_lock_free);

// The first signal is remembered, the second ends the program, unless it is one more write into the
// same broken pipe, which fails by itself. Only what POSIX allows in a handler.
void Remember(int signal)
{
    int none = 0;
    if (signal == SIGPIPE)
    {
        s_caught.compare_exchange_strong(none, signal);
        return;
    }
    if (s_caught.exchange(signal) == 0)
    {
        return;
    }
    std::signal(signal, SIG_DFL);
    ::raise(signal);
}

} // namespace

StopSignals::StopSignals()
{
    s_caught.store(0);
    for (const int number : kStopSignals)
    {
        struct sigaction before
        {};
        sigaction(number, nullptr, &before);
        if (before.sa_handler != SIG_IGN)
        {
            struct sigaction action
            {};
            action.sa_handler = Remember;
            action.sa_flags = SA_RESTART;
            sigaction(number, &action, nullptr);
        }
    }
}

StopSignals::~StopSignals()
{
    for (const int number : kStopSignals)
    {
        struct sigaction current
        {};
        sigaction(number, nullptr, &current);
        if (current.sa_handler == Remember)
        {
            std::signal(number, SIG_DFL);
        }
    }
}

int StopSignals::Caught()
{
    return s_caught.load();
}

} // namespace boxreel
