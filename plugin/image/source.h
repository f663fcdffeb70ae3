// SPDX-License-Identifier: Apache-2.0
// An ImageBuf as the core's source of pixels.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>

#include "ddt/core.h"
#include "plugin/image/arrival.h"
#include "plugin/image/reading.h"

namespace ddt {

class ImageSource final : public Source {
public:
    /// arrival: of the image's pixels; null: all are there.
    ImageSource(const OIIO::ImageBuf& image, const Reading& reading, Arrival* arrival = nullptr);
    bool read(const Rect& r, float* values, float* guide) override;
    /// Of images of 8 bits and of halfs, all channels of which are wanted and convert alike.
    std::vector<float> codes() override;
    bool read_codes(const Rect& r, void* codes, float* guide) override;
    /// Why the first read() that failed did so.
    std::string error() const;

private:
    bool read_row(int y, const Rect& r, float* pixels, float* guide);
    bool fail(const std::string& error);
    bool wait_for(int end);
    void convert(float* pixels, size_t count, int channels) const;

    const OIIO::ImageBuf& m_image;
    const Reading& m_reading;
    Arrival* const m_arrival;
    bool m_all; ///< every channel is selected, in order
    mutable std::mutex m_mutex;
    std::string m_error;
};

} // namespace ddt
