// SPDX-License-Identifier: Apache-2.0
// The ways of enlarging whose time is taken.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>

#include "ddt/core.h"

namespace speed {

/// Seconds to enlarge the image by a factor on so many threads; negative on failure, after a line
/// on stderr.
using Run = std::function<double(const OIIO::ImageBuf& image, double scale, int threads)>;

struct Way {
    std::string name;
    Run run;
};

/// A filter of this project, by its specification; `statistics`, when not null, is filled in by
/// each run.
Way ddt_way(const std::string& filter, ddt::Statistics* statistics = nullptr);

/// OpenImageIO's filters, those that people use to enlarge.
std::vector<Way> oiio_ways();

/// The programs of ImageMagick and libvips, as far as they are installed. Their time is that of
/// the program with the filter less that of the same program without it, so starting it and
/// reading the image do not count. Floats reach them as 16 bits.
std::vector<Way> program_ways();

} // namespace speed
