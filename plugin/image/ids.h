// SPDX-License-Identifier: Apache-2.0
// IDs in files of 32-bit integers.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

namespace ddt {

/// OpenImageIO's cache, which may stand behind `src`, makes floats of 32-bit integers. If it does,
/// make `ids` an image of what they were, else leave it uninitialised. Floats have room for whole
/// numbers up to 2^24; where there are larger ones the file is read again, by its name. If the
/// image came from memory (an IOProxy), another file may have that name: it counts only if its
/// numbers are those of the cache. False with one line in `error` when the file cannot be read.
bool read_ids(const OIIO::ImageBuf& src, OIIO::ImageBuf& ids, std::string& error);

} // namespace ddt
