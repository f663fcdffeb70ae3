// An ImageBuf as the core's source of pixels.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>

#include "core/guide/guide.h"
#include "ddt/core.h"
#include "plugin/colour/light.h"
#include "plugin/image/channels.h"

namespace ddt {

/// How an image is read: what is converted, what makes the guide, which channels are handed on.
struct Reading {
    Channels channels;
    Light light;               ///< Light() when nothing is to be converted
    GuideRecipe guide;         ///< positions are channels of the image
    std::vector<int> selected; ///< channels of the image that the core gets, in this order
};

class ImageSource final : public Source {
public:
    ImageSource(const OIIO::ImageBuf& image, const Reading& reading);
    bool read(const Rect& r, float* values, float* guide) override;
    /// Why the first read() that failed did so.
    std::string error() const;

private:
    bool read_row(int y, const Rect& r, float* pixels, float* guide);

    const OIIO::ImageBuf& m_image;
    const Reading& m_reading;
    bool m_all; ///< every channel is selected, in order
    mutable std::mutex m_mutex;
    std::string m_error;
};

} // namespace ddt
