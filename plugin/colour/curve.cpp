#include "plugin/colour/curve.h"

namespace ddt {

std::vector<float> Curve::arguments() {
    std::vector<float> x;
    x.reserve(2 * half);
    for (const float sign : {1.0f, -1.0f}) {
        x.push_back(0.0f);
        for (uint32_t u = first; u <= last; u += 1u << shift)
            x.push_back(sign * mag(u));
    }
    return x;
}

void Curve::fill(const float* values) {
    m_values.assign(values, values + 2 * half);
}

} // namespace ddt
