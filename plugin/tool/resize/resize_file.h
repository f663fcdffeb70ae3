// SPDX-License-Identifier: Apache-2.0
// `ddt resize` of one file.
#pragma once

#include <string>

#include "ddt/progress.h"
#include "plugin/tool/resize/plan_result.h"

namespace ddt::tool {

/// Resize the first image of the file `in`, or all, into `out`, which appears when whole: what its
/// format has room for (see fit_format.h), each channel in the image's own type where it can hold
/// that. False also if `in` was changed meanwhile. `progress` is called with the share done, one
/// thread at a time.
bool resize_file(const std::string& in, const std::string& out, const ResizeSettings& settings,
                 const ProgressCallback& progress, Failure& failure);

/// Bytes that resize_file() takes at its peak, about; 0 if that cannot be told.
int64_t memory_to_resize(const std::string& in, const std::string& out,
                         const ResizeSettings& settings);

} // namespace ddt::tool
