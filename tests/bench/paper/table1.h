// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "paper/subject.h"

namespace paper {

/// The paper's table 1 over a folder of images reduced by `factor`: what each scheme does to the
/// cost and how long it takes. Costs in squared grey levels a pixel of the reduced image; flips and
/// evaluations a pixel; iterations and rounds the mean of an image.
///
/// Times are nanoseconds a pixel on one core: init, making the starting mesh, and comp, flipping
/// it, of work, whatever else the machine does; final, the surface of the flipped mesh and the
/// enlarged image (planes, the factor's size), by the clock. Then, for each device there is, the
/// sum by the clock for the whole of ddt::enlarge(), all threads; "-" where the device does not
/// know the scheme.
///
/// Then the order of the paper's section 6 is checked, image by image. False on failure.
bool table1(const std::string& folder, int factor, Reduce how, const std::string& csv_folder);

} // namespace paper
