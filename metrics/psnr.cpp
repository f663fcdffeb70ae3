// SPDX-License-Identifier: Apache-2.0
#include "metrics/psnr.h"

#include <cmath>
#include <limits>

namespace metrics {

double psnr(const Image& a, const Image& b) {
    double sum = 0;
    size_t count = 0;
    for (int c = 0; c < 3; ++c) {
        const auto &u = a.channels[c].values, &v = b.channels[c].values;
        for (size_t i = 0; i < u.size(); ++i)
            sum += (u[i] - v[i]) * (u[i] - v[i]);
        count += u.size();
    }
    if (sum == 0)
        return std::numeric_limits<double>::infinity();
    return 10 * std::log10(255.0 * 255.0 * double(count) / sum);
}

} // namespace metrics
