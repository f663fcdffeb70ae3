// SPDX-License-Identifier: Apache-2.0
// An ImageBuf as the core's sink.
#pragma once

#include <OpenImageIO/imagebuf.h>

#include "ddt/core.h"
#include "plugin/colour/light.h"
#include "plugin/image/channels.h"

namespace ddt {

/// How results are written.
struct Writing {
    Light light;                ///< Light() when nothing is to be converted back
    ColourLayout colour;        ///< positions within what the core hands over
    int channels = 0;           ///< floats a pixel that the core hands over
    int chbegin = 0, chend = 0; ///< channels of the image; the first ones handed over go there
    /// Known: the floats are the bits of numbers of this 32-bit type, one a channel written.
    OIIO::TypeDesc bits = OIIO::TypeUnknown;
};

class ImageSink final : public Sink {
public:
    /// `image` is in local memory.
    ImageSink(OIIO::ImageBuf& image, const Writing& writing) : m_image(image), m_writing(writing) {}
    bool write(const Rect& r, float* values) override;
    float* place(const Rect& r, size_t& row) override;
    /// Into images of halfs, of numbers that stay as they are.
    bool takes_halfs() const override;
    /// Into images of 8 bits, of colour alone, alike in all channels.
    const CodeTable* takes_codes() const override;
    bool write_packed(const Rect& r, const void* numbers) override;

private:
    bool as_they_are() const;
    bool write_codes(const Rect& r, const float* values);

    OIIO::ImageBuf& m_image;
    const Writing& m_writing;
};

} // namespace ddt
