// SPDX-License-Identifier: Apache-2.0
// Parts of a file of IDs.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

#include "ddt/core.h"

namespace ddt::tool {

/// Read some pixels of a file of 32-bit integers as they are: the cache behind `image`, which is
/// the file's, would make floats of them. `ids` becomes an image like `image` of which there are
/// those pixels of `wanted` that there are, and the others of the file's tiles and rows they lie
/// in. False with one line in `error`.
bool read_ids_of(const std::string& path, const OIIO::ImageBuf& image, const Rect& wanted,
                 OIIO::ImageBuf& ids, std::string& error);

} // namespace ddt::tool
