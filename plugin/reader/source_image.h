// SPDX-License-Identifier: Apache-2.0
// The image that is enlarged, read in parts where that changes no number.
#pragma once

#include <memory>
#include <string>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagecache.h>

namespace ddt {

class SourceImage {
public:
    SourceImage() = default;
    ~SourceImage();
    SourceImage(const SourceImage&) = delete;
    SourceImage& operator=(const SourceImage&) = delete;

    /// `input` is open at the subimage; `hints` are those it was opened with. False with one line
    /// in `error`.
    bool open(const std::string& path, OIIO::ImageInput& input, int subimage,
              const OIIO::ImageSpec& hints, std::string& error);
    const OIIO::ImageBuf& image() const { return *m_image; }

private:
    // Of this image alone: programs limit and empty the one they share. Older than the image, which
    // uses it until its end.
    std::shared_ptr<OIIO::ImageCache> m_cache;
    std::unique_ptr<OIIO::ImageBuf> m_image;
};

} // namespace ddt
