// SPDX-License-Identifier: Apache-2.0
// OpenImageIO's formatting of text, compiled once: a file that called it would take seconds more to
// compile, since all of it is templates.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/strutil.h>

namespace ddt {

/// What OIIO::Strutil::fmt::format makes of the same.
std::string vformat(const char* text, ::fmt::format_args values);

template <class... Values>
std::string format(const char* text, const Values&... values) {
    return vformat(text, ::fmt::make_format_args(values...));
}

/// Let `line` be an error of `image`, after those it has.
void set_error(OIIO::ImageBuf& image, const std::string& line);

} // namespace ddt
