// SPDX-License-Identifier: Apache-2.0
// What parts of one result have in common.
#pragma once

#include <string>

#include <OpenImageIO/imageio.h>

#include "plugin/tool/command/exit_code.h"
#include "plugin/tool/resize/plan_result.h"

namespace ddt::tool {

/// A hash of what makes the result: the source, the result's windows, types of channels and
/// compression, the filter's options less the device, and the version. The source counts by its
/// header, its size in bytes and the bytes themselves, up to 64 MiB all of them. A larger one
/// counts by 1024 pieces of 64 KiB, evenly spread, since reading all of it would take longer than a
/// part: sources that differ only between the pieces look like one. The time of its last change
/// does not count: machines may have copies. Empty with a failure if the file cannot be read.
std::string fingerprint(const std::string& source, const OIIO::ImageSpec& source_spec,
                        const OIIO::ImageSpec& result, const ResizeSettings& settings,
                        Failure& failure);

} // namespace ddt::tool
