// SPDX-License-Identifier: MIT
#include "Machines.h"

/// Ten minutes of machines with forty joints.
namespace
{

using namespace stability;

class MachineLong : public EverySubStepCount
{};
INSTANTIATE_TEST_SUITE_P(SubSteps, MachineLong, testing::Values(1, 2, 4, 8, 16),
                         testing::PrintToStringParamName());

TEST_P(MachineLong, RunsForTenMinutesWithFortyTwoJoints)
{
    RunFortyTwo(GetParam(), 600.0);
}

TEST_P(MachineLong, SwingsForTenMinutesWithFortyRods)
{
    RunSwinging(GetParam(), 600.0);
}

} // namespace
