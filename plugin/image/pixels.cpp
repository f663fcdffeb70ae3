// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/pixels.h"

#include <cmath>
#include <cstdint>

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>

#include "core/base/half.h"
#include "plugin/colour/codes.h"
#include "plugin/image/channels.h"

namespace ddt {
namespace {

void write_strided(OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend,
                   OIIO::TypeDesc type, const void* values, OIIO::stride_t pixel) {
    OIIO::convert_image(chend - chbegin, r.width(), r.height(), 1, values, type, pixel,
                        pixel * r.width(), OIIO::AutoStride,
                        image.pixeladdr(r.x0, r.y0, 0, chbegin), image.spec().format,
                        image.pixel_stride(), image.scanline_stride(), OIIO::AutoStride);
}

// OpenImageIO does the same several times slower, which enlarging, with its many output pixels,
// would feel.

/// Whether the image has `channels` numbers a pixel and no gaps between pixels.
bool is_dense(const OIIO::ImageBuf& image, int channels) {
    return image.pixel_stride() == OIIO::stride_t(image.spec().format.size()) * channels;
}

/// The image's own, as they are.
void read_halfs(const OIIO::ImageBuf& image, const Rect& r, float* out) {
    const size_t row = size_t(r.width()) * size_t(image.nchannels());
    for (int y = r.y0; y < r.y1; ++y, out += row)
        floats_of_halfs(static_cast<const uint16_t*>(image.pixeladdr(r.x0, y)), row, out);
}
void write_halfs(OIIO::ImageBuf& image, const Rect& r, const float* values) {
    const size_t row = size_t(r.width()) * size_t(image.nchannels());
    for (int y = r.y0; y < r.y1; ++y, values += row)
        halfs_of_floats(values, row, static_cast<uint16_t*>(image.pixeladdr(r.x0, y)));
}

template <class Code>
void write_codes(OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend, const float* values,
                 int stride) {
    const int channels = chend - chbegin;
    for (int y = r.y0; y < r.y1; ++y, values += size_t(stride) * size_t(r.width())) {
        auto* row = static_cast<char*>(image.pixeladdr(r.x0, y, 0, chbegin));
        const OIIO::stride_t pixel = image.pixel_stride();
        if (stride == channels && is_dense(image, channels)) {
            auto* codes = reinterpret_cast<Code*>(row);
            for (int i = 0; i < r.width() * channels; ++i)
                codes[i] = code_of<Code>(values[i]);
            continue;
        }
        for (int x = 0; x < r.width(); ++x) {
            auto* codes = reinterpret_cast<Code*>(row + x * pixel);
            for (int c = 0; c < channels; ++c)
                codes[c] = code_of<Code>(values[size_t(x) * size_t(stride) + size_t(c)]);
        }
    }
}

/// Pixels of a file, through OpenImageIO's cache. Not by ImageBuf::get_pixels(), which does not
/// fail when the cache does and leaves that as the image's error, where another may be pending.
bool read_cached(const OIIO::ImageBuf& image, const OIIO::ROI& roi, OIIO::TypeDesc type, void* out,
                 std::string& error) {
    const auto cache = image.imagecache();
    const auto name = OIIO::ustring(image.name());
    if (cache->get_pixels(name, image.subimage(), image.miplevel(), roi.xbegin, roi.xend,
                          roi.ybegin, roi.yend, roi.zbegin, roi.zend, roi.chbegin, roi.chend, type,
                          out, OIIO::AutoStride, OIIO::AutoStride, OIIO::AutoStride))
        return true;
    error = cache->geterror();
    if (error.empty())
        error = "the source image cannot be read";
    return false;
}

} // namespace

bool read_pixels(const OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend,
                 OIIO::TypeDesc type, void* out, std::string& error) {
    const int channels = chend - chbegin;
    const auto pixel = OIIO::stride_t(type.size()) * channels;
    const bool all = channels == image.nchannels() && is_dense(image, channels);
    if (image.localpixels() && all && image.spec().format == OIIO::TypeHalf &&
        type == OIIO::TypeFloat) {
        read_halfs(image, r, static_cast<float*>(out));
        return true;
    }
    if (image.localpixels())
        return OIIO::convert_image(channels, r.width(), r.height(), 1,
                                   image.pixeladdr(r.x0, r.y0, 0, chbegin), image.spec().format,
                                   image.pixel_stride(), image.scanline_stride(), OIIO::AutoStride,
                                   out, type, pixel, pixel * r.width(), OIIO::AutoStride);
    return read_cached(image, {r.x0, r.x1, r.y0, r.y1, 0, 1, chbegin, chend}, type, out, error);
}

bool read_ids(const OIIO::ImageBuf& src, OIIO::ImageBuf& ids) {
    const OIIO::TypeDesc native = src.nativespec().format;
    if (src.storage() != OIIO::ImageBuf::IMAGECACHE || !is_id_type(native))
        return false;
    ids.reset(src.name(), src.subimage(), src.miplevel());
    if (!ids.read(src.subimage(), src.miplevel(), true, native))
        return false;
    // What the caller may have changed since.
    ids.specmod().extra_attribs = src.spec().extra_attribs;
    ids.set_origin(src.spec().x, src.spec().y);
    ids.set_roi_full(src.roi_full());
    return true;
}

void write_pixels(OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend, OIIO::TypeDesc type,
                  const void* values) {
    write_strided(image, r, chbegin, chend, type, values,
                  OIIO::stride_t(type.size()) * (chend - chbegin));
}

void write_floats(OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend, float* values,
                  int stride) {
    const OIIO::TypeDesc type = image.spec().format;
    if (type == OIIO::TypeUInt8) {
        write_codes<uint8_t>(image, r, chbegin, chend, values, stride);
    } else if (type == OIIO::TypeUInt16) {
        write_codes<uint16_t>(image, r, chbegin, chend, values, stride);
    } else if (type == OIIO::TypeHalf && chend - chbegin == stride && stride == image.nchannels() &&
               is_dense(image, stride)) {
        write_halfs(image, r, values);
    } else {
        // Converting NaN to an integer is undefined.
        if (!type.is_floating_point())
            for (size_t i = 0; i < r.area() * size_t(stride); ++i)
                values[i] = std::isnan(values[i]) ? 0.0f : values[i];
        write_strided(image, r, chbegin, chend, OIIO::TypeFloat, values,
                      OIIO::stride_t(sizeof(float)) * stride);
    }
}

} // namespace ddt
