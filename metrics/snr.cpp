// SPDX-License-Identifier: Apache-2.0
#include "metrics/snr.h"

#include <cmath>
#include <limits>

namespace metrics {

double snr(const Plane& reference, const Plane& test) {
    double signal = 0, noise = 0;
    for (size_t i = 0; i < reference.values.size(); ++i) {
        const double r = reference.values[i], d = r - test.values[i];
        signal += r * r;
        noise += d * d;
    }
    return noise == 0 ? std::numeric_limits<double>::infinity() : 10 * std::log10(signal / noise);
}

} // namespace metrics
