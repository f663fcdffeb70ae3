// SPDX-License-Identifier: Apache-2.0
// What a build's module (ddt_turn) does for the program `turns`, which may be another build's.
#pragma once

#include <cstdint>

namespace turns {

/// Nanoseconds.
struct Spent {
    int64_t triangulate, surface, sample;
    int64_t other; ///< reading and writing
};

struct Turn {
    const float* pixels; ///< RGB
    const float* guide;
    int width, height;
    float* to; ///< RGB, scale times as many rows and columns
    int scale;
    const char* filter;
    int threads;
};

/// Enlarge once. Null, or why not.
using Take = const char*(const Turn& turn, Spent& spent);
constexpr const char* name_of_take = "ddt_take_turn";

} // namespace turns
