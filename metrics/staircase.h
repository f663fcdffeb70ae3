// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "metrics/image.h"

namespace metrics {

/// How far a straight edge's outline is from straight once enlarged, in source pixels: root mean
/// square distance of the 50 % iso-line from the line that fits it best, over edges at every 3
/// degrees.
struct Staircase {
    double mean = 0, worst = 0;
};

/// `enlarge` maps a plane to one `scale` times as wide and high. The edges run from 64 to 192
/// through a plane of 48x48 pixels, each pixel the exact share of its area on either side.
Staircase staircase(const std::function<Plane(const Plane&)>& enlarge, int scale);

/// For one edge; `angle` in radians, of the edge's direction against the x axis.
double staircase_at(const std::function<Plane(const Plane&)>& enlarge, int scale, double angle);

} // namespace metrics
