// SPDX-License-Identifier: Apache-2.0
// The whole from its parts.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "plugin/tool/command/exit_code.h"

namespace ddt::tool {

/// Join the files of `parts`, in any order, into `out`. Refuses parts that are missing, there
/// twice, overlap or belong to another job. Memory: two rows of the parts' tiles over the whole
/// width, but 16 MiB and one where that is more; 256 MiB in all for whole images up to a million
/// pixels of half RGB wide. Of a format that is written at once (IFF) all pixels.
bool join(const std::vector<std::string>& parts, const std::string& out,
          const std::function<bool(float)>& progress, Failure& failure);

} // namespace ddt::tool
