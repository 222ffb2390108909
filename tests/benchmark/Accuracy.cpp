// SPDX-License-Identifier: MIT
#include "Accuracy.h"

#include <algorithm>

namespace bench
{

const AccuracyCases& AllAccuracyCases()
{
    static const AccuracyCases all = [] {
        AccuracyCases cases;
        AppendMotionCases(cases);
        AppendJointCases(cases);
        AppendPileCases(cases);
        AppendImpactCases(cases);
        std::stable_sort(cases.begin(), cases.end(), [](const auto& a, const auto& b) {
            return a.name.front() < b.name.front(); // inside a group as they were appended
        });
        return cases;
    }();
    return all;
}

} // namespace bench
