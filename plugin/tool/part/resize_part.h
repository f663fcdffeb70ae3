// SPDX-License-Identifier: Apache-2.0
// A part of a result, made and written by itself.
#pragma once

#include <string>

#include "ddt/progress.h"
#include "plugin/tool/part/part.h"
#include "plugin/tool/resize/plan_result.h"

namespace ddt::tool {

/// Resize the share of the file `in` that makes a part, and write that to `out`, tile row by tile
/// row of the source. Takes memory for one of these rows, for 192 MiB of source pixels (in memory
/// some 1.4 times that; more for a source in large tiles or long rows, LazyFile::make_room()), and
/// for enlarging what ddt/job.h says. If the source is in tiles, or in rows that can be had singly,
/// no more of it is read than the part needs. Both axes must grow or stay. `out` must not be the
/// file `in`, of which the other parts are made.
bool resize_part(const std::string& in, const std::string& out, const ResizeSettings& settings,
                 Part part, const ProgressCallback& progress, Failure& failure);

/// Whether `out` is what resize_part() would write: the same part of the same result, of a source
/// that has not changed (see fingerprint()); and not cut off.
bool is_part_there(const std::string& in, const std::string& out, const ResizeSettings& settings,
                   Part part);

} // namespace ddt::tool
