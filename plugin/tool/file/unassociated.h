// SPDX-License-Identifier: Apache-2.0
// Files whose colour is not multiplied by alpha, and whose readers multiply it.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

namespace ddt::tool {

/// Whether an image has alpha and was read from a file of a format that OpenImageIO reads and
/// writes unassociated where it is asked to, and says so.
bool may_be_unassociated(const OIIO::ImageBuf& image);

/// An image as such a file has it. Readers round the products with alpha to the file's type; from
/// here on they are floats, and what nobody changes keeps its numbers.
class Unassociated {
public:
    /// Read the first image of a file. False with one line in `error`.
    bool read(const std::string& path, std::string& error);
    /// Whether its colour is unassociated.
    explicit operator bool() const;

    /// Make `floats` the image as floats, associated. False with one line in `error`.
    bool associate(OIIO::ImageBuf& floats, std::string& error) const;

    /// Take those pixels of `changed` that differ from what associate() made.
    void put(const OIIO::ImageBuf& associated, const OIIO::ImageBuf& changed);

    const OIIO::ImageBuf& image() const { return m_image; }

private:
    OIIO::ImageBuf m_image;
};

} // namespace ddt::tool
