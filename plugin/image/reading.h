// SPDX-License-Identifier: Apache-2.0
// How an image is read.
#pragma once

#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>

#include "ddt/guide.h"
#include "ddt/resize.h"
#include "plugin/colour/light.h"
#include "plugin/image/channels.h"

namespace ddt {

/// How an image is read: what is converted, what makes the guide, which channels are handed on.
struct Reading {
    Channels channels;
    Light light;               ///< Light() when nothing is to be converted
    GuideRecipe guide;         ///< positions are channels of the image
    std::vector<int> selected; ///< channels of the image that the core gets, in this order
    bool keep_nan = false;     ///< whatever converting light makes of a NaN, it is one again
};

/// False with one line in `error` unless each option has a value that is allowed, whether or not
/// the image makes use of it.
bool check_options_of(const OIIO::ImageBuf& src, const Options& options, std::string& error);

/// False with one line in `error` unless there is the light that the options name, or that the
/// image's colour, if any, is in. `native`: of the file that it was read from.
bool check_light(const OIIO::ImageSpec& spec, const OIIO::ImageSpec& native, const Options& options,
                 std::string& error);

/// Decide on it for the channels of `roi` under options.light; where holes are to be filled, all
/// channels are handed on: which pixels are missing does not depend on what is wanted. False with
/// one line in `error` for a colour space that does not exist.
bool plan_reading(const OIIO::ImageBuf& src, const Options& options, const OIIO::ROI& roi,
                  Reading& reading, std::string& error);

} // namespace ddt
