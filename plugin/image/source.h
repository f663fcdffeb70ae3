// SPDX-License-Identifier: Apache-2.0
// An ImageBuf as the core's source of pixels.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>

#include "ddt/core.h"
#include "plugin/image/reading.h"

namespace ddt {

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
