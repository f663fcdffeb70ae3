#include "plugin/image/pixels.h"

#include <OpenImageIO/imageio.h>

namespace ddt {

bool read_pixels(const OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend,
                 OIIO::TypeDesc type, void* out, std::string& error) {
    const int channels = chend - chbegin;
    if (image.localpixels()) {
        const auto pixel = OIIO::stride_t(type.size()) * channels;
        return OIIO::convert_image(channels, r.width(), r.height(), 1,
                                   image.pixeladdr(r.x0, r.y0, 0, chbegin), image.spec().format,
                                   image.pixel_stride(), image.scanline_stride(), OIIO::AutoStride,
                                   out, type, pixel, pixel * r.width(), OIIO::AutoStride);
    }
    // Pixels of a file, through OpenImageIO's cache.
    if (image.get_pixels({r.x0, r.x1, r.y0, r.y1, 0, 1, chbegin, chend}, type, out) &&
        !image.has_error())
        return true;
    error = image.has_error() ? image.geterror(false) : "the source image cannot be read";
    return false;
}

void write_pixels(OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend, OIIO::TypeDesc type,
                  const void* values, OIIO::stride_t pixel_size) {
    const int channels = chend - chbegin;
    if (pixel_size == 0)
        pixel_size = OIIO::stride_t(type.size()) * channels;
    OIIO::convert_image(channels, r.width(), r.height(), 1, values, type, pixel_size,
                        pixel_size * r.width(), OIIO::AutoStride,
                        image.pixeladdr(r.x0, r.y0, 0, chbegin), image.spec().format,
                        image.pixel_stride(), image.scanline_stride(), OIIO::AutoStride);
}

} // namespace ddt
