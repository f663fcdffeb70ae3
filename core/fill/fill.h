// SPDX-License-Identifier: Apache-2.0
// Missing pixels of an image: which they are, and filling them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "ddt/points.h"

namespace ddt {

/// Of the time of a job whose holes are filled before, about.
constexpr float share_of_filling = 0.5f;

/// A whole image in memory. `kinds` may be null: all channels are Channel::blend.
struct HoledImage {
    float* values;       ///< `channels` interleaved floats per pixel
    const float* guide;  ///< one float per pixel; what clean_guide() zeroes counts as 0
    float* filled_guide; ///< `guide` itself, to be filled like a channel; null: it is not
    int width, height, channels;
    const Channel* kinds;
    int threads = 0; ///< that share the work, which has the same bits for any number; 0: all
};

/// A byte a pixel that is not 0 where it is missing: where a channel that is not Channel::nearest
/// is NaN, and by Holes::fill_alpha where the one that is Channel::alpha is 0. False if none is.
bool find_missing(const HoledImage& image, Holes holes, std::vector<uint8_t>& missing);

/// fill_holes() of ddt/points.h. `report`, when not null, as optimise() fills it in, if a mesh is
/// made. May throw.
bool fill_holes(const HoledImage& image, const uint8_t* missing, const MeshOptions& options,
                Device device, const ProgressCallback& progress, MeshReport* report,
                std::string& error);

/// Find and fill what is missing; a pixel that lacks some channels keeps the others. Edges flip by
/// the cost's own min_gain, and by Scheme::look_ahead where the scheme is one_round, which is meant
/// for pictures. `progress` is not called if nothing is missing. False with one line in `error`;
/// then pixels that are missing may be anything. May throw.
bool fill_missing(const HoledImage& image, Holes holes, const MeshOptions& options, Device device,
                  const ProgressCallback& progress, MeshReport* report, std::string& error);

} // namespace ddt
