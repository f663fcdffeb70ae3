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
    for (size_t i = 0; i < a.values.size(); ++i) {
        const double u = a.values[i] - ma, v = b.values[i] - mb;
        aa += u * u;
        bb += v * v;
        ab += u * v;
    }
    if (aa == 0 || bb == 0)
        return aa == bb ? 1 : 0;
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
