// SPDX-License-Identifier: Apache-2.0
// How a result is compressed, in oiiotool's words.
#pragma once

#include <string>

namespace ddt::tool {

/// Whether files of a format ("openexr", "tiff", "jpeg") can be compressed so: "zip", or with the
/// format's level "dwaa:45". An empty format stands for any. OpenImageIO itself takes another
/// compression where it does not know one. False with one line in `error`.
bool check_compression(const std::string& given, const std::string& format, std::string& error);

} // namespace ddt::tool
