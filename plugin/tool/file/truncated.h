// SPDX-License-Identifier: Apache-2.0
// Files that end before their pixels do, where readers make up what is missing.
#pragma once

#include <string>

namespace ddt::tool {

/// Whether a file, whose reader has this name of its format, ends before the pixels of the image of
/// this number from 0 do: before a TIFF's strips and tiles, as it lists them, or before a DPX's
/// pixels and what it says of its size. OpenImageIO's readers (2.4.7) say nothing of strips, and of
/// 10 or 12 bits, that are not there. False of other formats, and where the tables make no sense.
bool is_truncated(const std::string& path, const std::string& format, int number);

} // namespace ddt::tool
