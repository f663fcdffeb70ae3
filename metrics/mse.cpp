// SPDX-License-Identifier: Apache-2.0
#include "metrics/mse.h"

namespace metrics {

double mse(const Plane& reference, const Plane& test) {
    double sum = 0;
    for (size_t i = 0; i < reference.values.size(); ++i) {
        const double d = reference.values[i] - test.values[i];
        sum += d * d;
    }
    return reference.empty() ? 0 : sum / double(reference.values.size());
}

} // namespace metrics
