// SPDX-License-Identifier: Apache-2.0
#include "times.h"

#include <algorithm>

namespace speed {

double median(Times values) {
    std::sort(values.begin(), values.end());
    const size_t n = values.size();
    return n % 2 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

Times ratios(const Times& a, const Times& b) {
    Times result;
    for (size_t i = 0; i < a.size(); ++i)
        result.push_back(a[i] / b[i]);
    std::sort(result.begin(), result.end());
    return result;
}

double ratio(const Times& a, const Times& b) {
    return median(ratios(a, b));
}

double seconds_of(const Way& way, const Task& task, int calls) {
    double sum = 0;
    for (int call = 0; call < calls; ++call) {
        const double seconds = way.run(task);
        if (seconds < 0)
            return seconds;
        sum += seconds;
    }
    return sum;
}

bool measure(const std::vector<Way>& ways, const Task& task, int rounds, std::vector<Times>& times,
             int calls) {
    times.assign(ways.size(), {});
    for (int round = 0; round < rounds; ++round)
        for (size_t i = 0; i < ways.size(); ++i) {
            if (!ways[i].is_program && seconds_of(ways[i], task, 1) < 0)
                return false;
            times[i].push_back(seconds_of(ways[i], task, calls));
            if (times[i].back() < 0)
                return false;
        }
    return true;
}

} // namespace speed
