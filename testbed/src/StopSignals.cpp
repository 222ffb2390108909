// SPDX-License-Identifier: MIT
#include "StopSignals.h"

#include <atomic>
#include <csignal>

namespace boxreel
{
namespace
{

constexpr int kStopSignals[] = {SIGINT, SIGTERM, SIGHUP};

// A handler may touch nothing but a lock-free atomic.
std::atomic<int> s_caught{0};
static_assert(std::atomic<int>::is_always_lock_free);

void Remember(int signal)
{
    s_caught.store(signal);
}

} // namespace

StopSignals::StopSignals()
{
    s_caught.store(0);
    std::signal(SIGXFSZ, SIG_IGN);
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
            action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
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
    std::signal(SIGXFSZ, SIG_DFL);
}

int StopSignals::Caught()
{
    return s_caught.load();
}

} // namespace boxreel
