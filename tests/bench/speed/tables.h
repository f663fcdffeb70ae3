// SPDX-License-Identifier: Apache-2.0
// The tables the program prints. Times that are compared are taken alternately: a round runs every
// way, one after the other, so that a slow moment of the machine strikes all alike; what is printed
// are medians over the rounds, of ratios those of the ratio within one round. Stages are measured
// filter by filter; of cores the least of the rounds counts; growth has one round above 4
// megapixels.
#pragma once

#include <string>
#include <vector>

#include "pictures.h"
#include "ways.h"

namespace speed {

/// Whether the result's memory is there. What must be had from the system costs as much as an
/// enlargement, or several times as much, by the state the system's memory is in.
enum class Memory { warm, fresh };

struct Plan {
    std::vector<std::string> filters;
    std::vector<double> scales;
    std::vector<int> threads;
    std::vector<Format> formats;
    std::vector<Memory> memory;
    double megapixels = 1; ///< of the source
    double largest = 64;   ///< megapixels up to which growth is looked at
    int rounds = 3;
    bool programs = true; ///< ImageMagick and libvips too
};

/// How many times as fast as the others, and nanoseconds an output pixel.
bool print_ratios(const Pictures& pictures, const Plan& plan);

/// Nanoseconds an output pixel by stage on one thread; evaluations and flips a source pixel.
bool print_stages(const Pictures& pictures, const Plan& plan);

/// Time over image size, and its exponent: 1 where twice the pixels take twice the time.
bool print_growth(const Pictures& pictures, const Plan& plan);

/// One thread's time over that of several; and how many times as much as one such job as many jobs
/// get done that are run side by side, a thread each: what the machine has to give.
bool print_threads(const Pictures& pictures, const Plan& plan);

/// What more cores than there are would make of it: how often the time of one thread that of so
/// many is, when each tile takes what it took on one.
bool print_cores(const Pictures& pictures, const Plan& plan);

/// Calls a second on small images and for a small part of a large one, and the first call of the
/// process, if no other table came before.
bool print_small(const Pictures& pictures, const Plan& plan);

} // namespace speed
