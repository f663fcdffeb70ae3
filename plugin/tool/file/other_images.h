// SPDX-License-Identifier: Apache-2.0
// What a file has beside its first image: others, and smaller ones of it.
#pragma once

#include <string>
#include <vector>

namespace ddt::tool {

/// How many images a file has; 0 if it cannot be opened. OpenImageIO 3's ImageBuf does not know it
/// of every format.
int count_images(const std::string& path);

/// What is to be said, line by line: that of the images in a file only the first was looked at, if
/// there are more, and how to have all, if that can be said; and levels_beside(). To be asked for
/// before a result is put in place, which may be the file's own.
std::vector<std::string> images_beside(const std::string& path,
                                       const std::string& how_to_have_all = "");

/// That of the first image in a file only the largest MIP level was looked at, if it has more:
/// results have none.
std::vector<std::string> levels_beside(const std::string& path);

/// Say on stderr what images_beside() has to say.
void note_others(const std::string& path);

} // namespace ddt::tool
