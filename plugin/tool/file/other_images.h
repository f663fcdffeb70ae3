// SPDX-License-Identifier: Apache-2.0
// What a file has beside its first image: others, and smaller ones of it.
#pragma once

#include <string>

namespace ddt::tool {

/// How many images a file has; 0 if it cannot be opened. OpenImageIO 3's ImageBuf does not know it
/// of every format.
int count_images(const std::string& path);

/// Say on stderr that of the images in a file only the first was looked at, if there are more, and
/// how to have all, if that can be said; and what note_levels() says.
void note_others(const std::string& path, const std::string& how_to_have_all = "");

/// Say on stderr that of the first image in a file only the largest MIP level was looked at, if it
/// has more: results have none.
void note_levels(const std::string& path);

} // namespace ddt::tool
