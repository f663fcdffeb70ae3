// SPDX-License-Identifier: Apache-2.0
// Jobs drawn at random: pictures of every kind of value, options from the whole table, mappings.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ddt/core.h"

namespace ddt::test {

/// What a picture's floats are like.
enum class PictureValues {
    shapes,     ///< smooth shades, edges and a little noise, about 0 to 1
    noise,      ///< all bits of the guide in use
    levels,     ///< few values, so that gains tie
    lights,     ///< single pixels thousands of times as bright
    nonfinite,  ///< NaN, infinities, -0 and numbers near the largest among the others
    denormal,   ///< numbers below and round the smallest normal one
    full_range, ///< every exponent there is, finite
    count
};

/// A picture with its guide, and what is done to it.
struct RandomJob {
    int width = 0, height = 0;
    PictureValues kind = PictureValues::shapes;
    std::vector<float> values; ///< Job::channels a pixel
    std::vector<float> guide;
    Job job; ///< on the CPU with one thread; window, channels, kinds and options set
    std::string specification;
    std::unique_ptr<Mapping> mapping;
    Rect out;  ///< all output pixels the mapping may give
    Rect part; ///< some of them
};

/// The job of that number. Whoever draws it again gets the same.
RandomJob random_job(uint64_t seed, uint64_t number);

/// Set what follows from the sizes: the job's window and channels, `out`, and the mapping: a resize
/// of the picture to out_width x out_height, or with an angle (radians) a turn about its middle as
/// well. `part` becomes the middle of the output.
void set_shape(RandomJob& job, int channels, int out_width, int out_height, double angle);

/// `job.mapping` for the output pixels of `part` alone.
std::unique_ptr<Mapping> mapping_of_part(const RandomJob& job, const Rect& part);

/// In one line: size, channels, values, options.
std::string describe(const RandomJob& job);

} // namespace ddt::test
