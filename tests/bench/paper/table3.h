// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "paper/subject.h"

namespace paper {

/// The paper's table 3 over a folder: each image reduced by `factor`, enlarged again by every way
/// and compared with what it was, as luma in encoded light without a border of one factor. Figures
/// are means over the images. The schemes' pictures are planes over the triangles, as in the paper;
/// the last rows are this project's filters. False on failure.
bool table3(const std::string& folder, int factor, Reduce how, const std::string& csv_folder);

} // namespace paper
