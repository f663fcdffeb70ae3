// SPDX-License-Identifier: Apache-2.0
// Times of ways, taken alternately, and what is made of them.
#pragma once

#include <vector>

#include "ways.h"

namespace speed {

using Times = std::vector<double>; ///< seconds, a round each

double median(Times values);

/// a / b, round by round, in order.
Times ratios(const Times& a, const Times& b);

/// The median of the ratios.
double ratio(const Times& a, const Times& b);

/// Seconds of `calls` runs, one after the other; negative if one failed.
double seconds_of(const Way& way, const Task& task, int calls);

/// Times of every way, alternately, `calls` calls one after the other counting as one; false if one
/// failed. Each begins with a call that does not count, but for programs: the first after another
/// way's finds its code and memory gone from the caches, after a program's it takes up to twice as
/// long.
bool measure(const std::vector<Way>& ways, const Task& task, int rounds, std::vector<Times>& times,
             int calls = 1);

} // namespace speed
