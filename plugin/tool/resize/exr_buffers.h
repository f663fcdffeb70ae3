// SPDX-License-Identifier: Apache-2.0
// What OpenEXR reads and writes with.
#pragma once

#include <cstdint>

#include <OpenImageIO/imageio.h>

namespace ddt::tool {

/// Bytes that OpenEXR takes, about, to read or write an EXR of this spec with so many threads: two
/// blocks of rows for each, or two tiles, as they are stored, compressed, and between.
int64_t exr_buffers(const OIIO::ImageSpec& spec, int threads);

} // namespace ddt::tool
