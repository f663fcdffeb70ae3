// SPDX-License-Identifier: Apache-2.0
// What lies deep in a hole: between rims that are many pixels apart a mesh has nothing but long
// thin triangles, and every pixel of the rim leaves a streak across the hole.
#pragma once

#include <cstdint>
#include <vector>

#include "core/fill/fill.h"

namespace ddt {

/// Smooth what was filled: `filled` is not 0 where a pixel was missing and a mesh has filled it.
/// Those beside a pixel that was there stay as they are. The others become a membrane held by all
/// about them, channel by channel: the weighted mean of the four neighbours that are `known` (not
/// 0), where a neighbour counts the less the more `guide` changes on the way, so that edges which
/// the mesh has led across the hole stay. Never outside the range of what the mesh had made;
/// IDs, and what is not finite, stay. image.filled_guide, if there is one, is smoothed alike at the
/// end. The same bits for any number of image.threads. False: `progress` cancelled it, and pixels
/// may be anything between.
bool smooth_holes(const HoledImage& image, const std::vector<uint8_t>& filled,
                  const std::vector<uint8_t>& known, const std::vector<float>& guide,
                  const ProgressCallback& progress = {});

} // namespace ddt
