// SPDX-License-Identifier: Apache-2.0
// The 32-bit integers of a file, which name objects.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imageio.h>

#include "ddt/rect.h"

namespace ddt::tool {

/// Reads parts of channels of 32-bit integers as they are: the cache behind an ImageBuf, and an
/// ImageBuf of channels of several types, would make floats of them, which have no room for all.
class IdFile {
public:
    IdFile() = default;
    /// `image`: that of the number from 0 in the file `path`. channels: those to be read, in
    /// ascending order, of 32-bit integers all.
    IdFile(const std::string& path, int number, const OIIO::ImageBuf& image,
           std::vector<int> channels);

    /// `ids` becomes an image of those channels: of the pixels of `wanted` that the file has, and
    /// the others of the file's tiles and rows that they lie in. False with one line in `error`.
    bool read(const Rect& wanted, OIIO::ImageBuf& ids, std::string& error);

private:
    bool open(std::string& error);
    bool read_some(const Rect& r, char* to, std::string& error);

    std::string m_path;
    int m_number = 0;
    OIIO::ImageSpec m_spec; ///< of what is read, its data window apart
    std::vector<int> m_channels;
    std::unique_ptr<OIIO::ImageInput> m_input; ///< once something was read
};

} // namespace ddt::tool
