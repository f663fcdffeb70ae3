// SPDX-License-Identifier: Apache-2.0
// The ways of enlarging that are compared: one row of the table each.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>

#include "light.h"

namespace bench {

/// Enlarges a float RGB image by a whole factor, in the light its values are in. Returns a buffer
/// that has_error() on failure.
using Enlarge = std::function<OIIO::ImageBuf(const OIIO::ImageBuf&, int scale)>;

struct Row {
    std::string name;
    Enlarge enlarge;
};

/// OpenImageIO's own filters, by their names.
std::vector<Row> oiio_rows();

/// ImageMagick in a child process, if it is installed. Values reach it as 16-bit integers, so what
/// lies beyond 0..1 is clipped, and are resized as they are, whatever the light.
std::vector<Row> imagemagick_rows();

/// This project's filters, and once more the one that gives integers another surface than floats.
/// `light` is what the values are in.
std::vector<Row> ddt_rows(Light light);

/// A filter specification such as "ddt,cost=scf", or "ddt-sharp,clipped=1 to integers" for a result
/// of 16 bits.
Row ddt_row(const std::string& specification, Light light);

/// All of the above that can show the light (ImageMagick clips), then a row for each specification.
std::vector<Row> all_rows(Light light, const std::vector<std::string>& more = {});

/// Those of them whose names have `part` in them.
std::vector<Row> rows_with(const std::string& part, Light light,
                           const std::vector<std::string>& more = {});

} // namespace bench
