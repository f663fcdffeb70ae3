// SPDX-License-Identifier: Apache-2.0
// What the paper's experiments are made on.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ddt/core.h"
#include "metrics/image.h"

namespace paper {

/// How images are reduced. The paper says "bilinear".
enum class Reduce {
    bilinear, ///< the value between the four pixels nearest the new pixel's centre
    triangle, ///< OpenImageIO's triangle filter, as wide as the reduction needs: a smoother picture
};

/// An image reduced by an even factor in encoded light and rounded to 8 bits.
metrics::Image reduce(const metrics::Image& image, int factor, Reduce how);

/// An image and its reduction.
struct Subject {
    std::string name;
    int factor = 1;
    metrics::Image original; ///< cropped to a multiple of the factor
    metrics::Image reduced;
    int width() const { return reduced.width(); }
    int height() const { return reduced.height(); }
};

/// Call f for every image of the folder that can be read; tell on stderr of the others. False if
/// there is none. With a factor of 1 the reduction is the original.
bool each_subject(const std::string& folder, int factor, Reduce how,
                  const std::function<void(const Subject&)>& f);

/// Luma as the core's guide: 0 to 1, multiples of 2^-12.
std::vector<float> guide_of(const metrics::Image& image);

/// The schemes that are compared, the paper's in its order, then those from elsewhere and ours; in
/// every one SCF as the cost and the same bare guard, so that costs can be compared.
std::vector<ddt::MeshOptions> all_schemes();

/// scheme_name() and, where it is not the paper's parallel diagonals, the start.
std::string label(const ddt::MeshOptions& options);

/// SCF of a guide of 0..1 in the paper's units, squared grey levels of 0..255.
constexpr double grey_levels = 255.0 * 255.0;

} // namespace paper
