// SPDX-License-Identifier: Apache-2.0
// What is enlarged.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

namespace speed {

enum class Format {
    linear_float, ///< floats in linear light: nothing to convert
    srgb_8bit,    ///< as PNG files hold it
};
const char* name_of(Format format);

/// Square RGB pictures of any size, in any format, of one subject.
class Pictures {
public:
    /// The subject is a file's image or, with an empty path, clouds and in front of them the
    /// outlines of other clouds: flat parts, texture, hard edges. Ends the program if the file
    /// cannot be read.
    explicit Pictures(const std::string& path);
    /// Cut to size or, if the subject is smaller, repeated. What the numbers mean makes no
    /// difference to the filters' time, but which conversions they call for does.
    OIIO::ImageBuf make(double megapixels, Format format) const;

private:
    OIIO::ImageBuf m_subject;
};

} // namespace speed
