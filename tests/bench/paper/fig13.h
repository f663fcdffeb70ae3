// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace paper {

/// The paper's figure 13: seconds of work to triangulate (init and comp, one core, the whole image
/// in one mesh) against image size, doubling from 1/8 to `megapixels`. The image is a mosaic of the
/// folder's. The last row is the growth exponent: the slope of log time over log size. False on
/// failure.
bool fig13(const std::string& folder, double megapixels, const std::string& csv_folder);

} // namespace paper
