// SPDX-License-Identifier: Apache-2.0
// The whole from its parts.
#pragma once

#include <string>
#include <vector>

#include "ddt/progress.h"
#include "plugin/tool/command/exit_code.h"

namespace ddt::tool {

/// Join the files of `parts`, in any order, into `out`. Refuses parts that are missing, there
/// twice, overlap, belong to another job or are changed meanwhile. Memory: a row of the parts'
/// tiles over the whole width, and another, or of the whole's own tiles up to 64 MiB, or 16 MiB of
/// rows; 256 MiB in all for whole images up to a million pixels of half RGB wide.
bool join(const std::vector<std::string>& parts, const std::string& out,
          const ProgressCallback& progress, Failure& failure);

} // namespace ddt::tool
