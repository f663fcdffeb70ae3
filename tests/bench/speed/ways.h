// SPDX-License-Identifier: Apache-2.0
// The ways of enlarging whose time is taken.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>

#include "ddt/core.h"

namespace speed {

/// One enlargement of a float or 8-bit RGB image.
struct Task {
    const OIIO::ImageBuf& image;
    double scale;
    int threads;
    /// The result's memory, if it has been written to before; null: it must be had, and its pages
    /// count.
    OIIO::ImageBuf* into;
    /// Of the result, what is wanted (of OpenImageIO's filters and ours, with `into`); undefined:
    /// all.
    OIIO::ROI part = {};

    int width() const { return int(std::lround(image.spec().width * scale)); }
    int height() const { return int(std::lround(image.spec().height * scale)); }
};

/// An image for a task's result, every page of it written to.
OIIO::ImageBuf warm_image(const Task& task);

/// Seconds it takes; negative on failure, after a line on stderr.
using Run = std::function<double(const Task& task)>;

struct Way {
    std::string name;
    Run run;
    bool is_program = false; ///< a process of its own each time
};

/// A filter of this project, by its specification; `statistics`, when not null, is filled in by
/// each run (ddt/resize.h).
Way ddt_way(const std::string& filter, ddt::Statistics* statistics = nullptr);

/// OpenImageIO's filters, those that people use to enlarge.
std::vector<Way> oiio_ways();

/// OpenCV's resize and zimg's, where this was built with them: libraries that do the least there is
/// to do, on the numbers as they are. zimg's pixels are in planes, as it wants them, and taking
/// them apart is not counted; it has one thread.
std::vector<Way> neighbour_ways();

/// The programs of ImageMagick and libvips, as far as they are installed. Their time is that of
/// the program with the filter less that of the same program without it, so starting it and
/// reading the image do not count, but the memory of the result does, always. Floats reach them as
/// 16 bits.
std::vector<Way> program_ways();

} // namespace speed
