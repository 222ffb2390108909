// SPDX-License-Identifier: MIT
#include "Machines.h"

/// Machines with forty joints: energy and gaps stay bounded. The first seconds of what
/// MachineLongTest does for ten minutes.
namespace
{

using namespace stability;

STABILITY_SUITE(Machine);

TEST_P(Machine, RunsForTwentySecondsWithFortyTwoJoints)
{
    RunFortyTwo(GetParam(), 20.0);
}

TEST_P(Machine, SwingsForTwentySecondsWithFortyRods)
{
    RunSwinging(GetParam(), 20.0);
}

} // namespace
