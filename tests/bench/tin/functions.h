// SPDX-License-Identifier: Apache-2.0
// Functions over the unit square, for interpolation from scattered values.
#pragma once

#include <vector>

namespace ddt::bench {

struct TestFunction {
    const char* name;
    bool directional; ///< it changes in one direction much more than across it
    double (*value)(double x, double y);
};

/// The six of Franke 1979, "A critical comparison of some methods for interpolation of scattered
/// data" (NPS-53-79-003); then a step, a ridge and a curved cliff.
const std::vector<TestFunction>& test_functions();

} // namespace ddt::bench
