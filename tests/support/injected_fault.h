#pragma once
// Where a fault was put into a sound building, so that a test can ask whether it is found there and nowhere else.

#include <array>
#include <string>
#include <vector>

#include "base/finding.h"

namespace enfilade::testing {

struct InjectedFault {
    std::string code;                  ///< the constraint that is broken, and the only one that may be reported
    std::array<double, 3> point = {};  ///< world metres
    std::vector<ElementRef> elements;  ///< of the plan; the finding names one of them at least (none: any will do)
    double reach = 0;                  ///< metres: how far the reported point may be from `point`
};

}  // namespace enfilade::testing
