// SPDX-License-Identifier: Apache-2.0
// `ddt resize` of one file.
#pragma once

#include <functional>
#include <string>

#include <OpenImageIO/imagebuf.h>

#include "ddt/resize.h"
#include "plugin/tool/command/exit_code.h"

namespace ddt::tool {

struct ResizeSettings {
    std::string size; ///< see size.h
    Options options;
    std::string type;        ///< of the result's pixels; empty: the image's
    std::string compression; ///< of the result's file; empty: the image's, or the format's usual
    int threads = 1;         ///< at least 1
};

/// False with a failure, which names the file, unless it holds what can be worked on with
/// these options.
bool check_image(const OIIO::ImageBuf& image, const std::string& path, const Options& options,
                 Failure& failure);

/// What an image of spec `from`, which check_image() found right, becomes: the windows that
/// oiiotool makes. The size is the display window's; the data window is scaled along with it, its
/// origin rounded down, its size up. Where a size does not change, the origin does not either.
/// False with a failure if the size is not allowed, or the data window would leave the coordinates
/// that are allowed.
bool plan_result(const OIIO::ImageSpec& from, const ResizeSettings& settings,
                 OIIO::ImageSpec& result, Failure& failure);

/// Resize the file `in` into `out`, which appears when whole: what its format has room for (see
/// fit_format.h), each channel in the image's own type where it can hold that. `progress` is called
/// with the share done, one thread at a time.
bool resize_file(const std::string& in, const std::string& out, const ResizeSettings& settings,
                 const std::function<bool(float)>& progress, Failure& failure);

/// Bytes that resize_file() takes at its peak, about; 0 if that cannot be told.
int64_t memory_to_resize(const std::string& in, const std::string& out,
                         const ResizeSettings& settings);

} // namespace ddt::tool
