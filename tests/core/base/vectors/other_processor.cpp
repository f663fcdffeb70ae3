// SPDX-License-Identifier: Apache-2.0
// Compiled as for a processor that has none of the modes that DenormalsAreZero knows: that this
// compiles, without a warning, is the test.
#undef __SSE2__
#undef __aarch64__
#include "core/base/float_mode.h"

/// To be called by nobody.
float half_of_other_processor(float x);
float half_of_other_processor(float x) {
    const ddt::DenormalsAreZero nothing_to_set;
    return 0.5f * x;
}
