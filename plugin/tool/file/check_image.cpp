// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/check_image.h"

#include "plugin/image/memory.h"
#include "plugin/image/prepare.h"
#include "plugin/image/reading.h"

namespace ddt::tool {

bool check_image(const OIIO::ImageBuf& image, const std::string& name, const Options& options,
                 Failure& failure) {
    if (check_source(image, failure.why) && check_options_of(image, options, failure.why))
        return true;
    failure.why = name + ": " + failure.why;
    failure.code = code_of_message(failure.why);
    return false;
}

bool check_size_of(const OIIO::ImageSpec& spec, Failure& failure) {
    if (check_size(OIIO::get_roi(spec), spec.nchannels, spec.format, failure.why))
        return true;
    failure.code = code_of_message(failure.why);
    return false;
}

} // namespace ddt::tool
