// SPDX-License-Identifier: Apache-2.0
// The image that is enlarged, read in parts where that changes no number.
#pragma once

#include <memory>
#include <string>

#include "plugin/image/lazy_file.h"

namespace ddt {

class SourceImage {
public:
    /// `input` is open at the subimage; `hints` are those it was opened with. False with one line
    /// in `error`.
    bool open(const std::string& path, OIIO::ImageInput& input, int subimage,
              const OIIO::ImageSpec& hints, std::string& error);
    const OIIO::ImageBuf& image() const { return m_file ? m_file->image() : m_pixels; }

private:
    std::unique_ptr<LazyFile> m_file;
    OIIO::ImageBuf m_pixels; // where there is no such file
};

} // namespace ddt
