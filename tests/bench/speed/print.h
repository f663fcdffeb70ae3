// SPDX-License-Identifier: Apache-2.0
// What the tables have in common on paper.
#pragma once

#include <OpenImageIO/imagebuf.h>

#include "pictures.h"
#include "tables.h"
#include "times.h"

namespace speed {

/// A line above a table: what its numbers are, and of which image.
void heading(const char* what, const OIIO::ImageBuf& image, Format format, int threads);

const char* name_of(Memory memory);

/// A cell of these ratios, as ratios() has them: the median, and the quartiles about it.
void print_ratio(const Times& ratios);

} // namespace speed
