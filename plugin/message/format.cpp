// SPDX-License-Identifier: Apache-2.0
#include "plugin/message/format.h"

namespace ddt {

std::string vformat(const char* text, ::fmt::format_args values) {
    return ::fmt::vformat(text, values);
}

void set_error(OIIO::ImageBuf& image, const std::string& line) {
    image.errorfmt("{}", line);
}

} // namespace ddt
