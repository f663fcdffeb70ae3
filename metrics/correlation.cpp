// SPDX-License-Identifier: Apache-2.0
#include "metrics/correlation.h"

#include <cmath>

namespace metrics {

namespace {

double mean(const Plane& p) {
    double sum = 0;
    for (const double v : p.values)
        sum += v;
    return p.empty() ? 0 : sum / double(p.values.size());
}

} // namespace

double correlation(const Plane& a, const Plane& b) {
    const double ma = mean(a), mb = mean(b);
    double aa = 0, bb = 0, ab = 0;
    const double n = double(a.values.size());
    for (size_t i = 0; i < a.values.size(); ++i) {
        const double u = a.values[i] - ma, v = b.values[i] - mb;
        aa += u * u;
        bb += v * v;
        ab += u * v;
    }
    // Of a flat image nothing is left but what was rounded off.
    const bool flat_a = aa <= 1e-18 * n * ma * ma, flat_b = bb <= 1e-18 * n * mb * mb;
    if (flat_a || flat_b)
        return flat_a && flat_b ? 1 : 0;
    return ab / std::sqrt(aa * bb);
}

double cross_correlation(const Plane& reference, const Plane& test) {
    double rr = 0, rt = 0;
    for (size_t i = 0; i < reference.values.size(); ++i) {
        rr += reference.values[i] * reference.values[i];
        rt += reference.values[i] * test.values[i];
    }
    return rr == 0 ? 1 : rt / rr;
}

} // namespace metrics
