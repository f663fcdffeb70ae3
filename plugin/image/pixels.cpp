// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/pixels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>

#include "core/base/codes.h"
#include "core/base/half.h"
#include "plugin/image/cached_reads.h"
#include "plugin/image/channels.h"
#include "plugin/image/file_tiles.h"
#include "plugin/image/own_tasks.h"
#include "plugin/message/format.h"

namespace ddt {
namespace {

/// ROI(x0, x1, y0, y1, z0, z1, ...) of pixels of a flat image, which may lie at any z.
OIIO::ROI roi_of(const OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend) {
    const int z = image.spec().z;
    return {r.x0, r.x1, r.y0, r.y1, z, z + 1, chbegin, chend};
}

void write_strided(OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend,
                   OIIO::TypeDesc type, const void* values, OIIO::stride_t pixel) {
    OIIO::convert_image(chend - chbegin, r.width(), r.height(), 1, values, type, pixel,
                        pixel * r.width(), OIIO::AutoStride, address(image, r.x0, r.y0, chbegin),
                        image.spec().format, image.pixel_stride(), image.scanline_stride(),
                        OIIO::AutoStride);
}

// OpenImageIO does the same several times slower, which enlarging, with its many output pixels,
// would feel.

/// Whether the image has `channels` numbers a pixel and no gaps between pixels.
bool is_dense(const OIIO::ImageBuf& image, int channels) {
    return channels == image.nchannels() &&
           image.pixel_stride() == OIIO::stride_t(image.spec().format.size()) * channels;
}

/// Call f(the first number in the image, the first float) for each row of r, of n floats.
template <class Number, class Image, class Float, class F>
void each_row(Image& image, const Rect& r, int chbegin, Float* floats, size_t n, F&& f) {
    for (int y = r.y0; y < r.y1; ++y, floats += n)
        f(static_cast<Number*>(address(image, r.x0, y, chbegin)), floats);
}

/// Call f with the kind of number whose rows convert at once; false if this type has none.
template <class F>
bool with_kind(OIIO::TypeDesc type, F&& f) {
    if (type == OIIO::TypeUInt8)
        f(Codes<uint8_t>());
    else if (type == OIIO::TypeUInt16)
        f(Codes<uint16_t>());
    else if (type == OIIO::TypeHalf)
        f(Halfs());
    else
        return false;
    return true;
}

/// All channels, of images of such types; false of others.
bool read_rows(const OIIO::ImageBuf& image, const Rect& r, float* out) {
    const size_t n = size_t(r.width()) * size_t(image.nchannels());
    return with_kind(image.spec().format, [&](auto kind) {
        using Stored = typename decltype(kind)::Stored;
        each_row<const Stored>(image, r, 0, out, n, [n](const Stored* from, float* to) {
            decltype(kind)::row_to(from, n, to);
        });
    });
}
bool write_rows(OIIO::ImageBuf& image, const Rect& r, const float* values) {
    const size_t n = size_t(r.width()) * size_t(image.nchannels());
    return with_kind(image.spec().format, [&](auto kind) {
        using Stored = typename decltype(kind)::Stored;
        each_row<Stored>(image, r, 0, values, n, [n](Stored* to, const float* from) {
            decltype(kind)::row_from(from, n, to);
        });
    });
}

/// Some channels of images of 8 or 16 bits.
template <class Code>
void write_codes(OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend, const float* values,
                 int stride) {
    const OIIO::stride_t pixel = image.pixel_stride();
    each_row<char>(image, r, chbegin, values, size_t(stride) * size_t(r.width()),
                   [&](char* row, const float* from) {
                       for (int x = 0; x < r.width(); ++x, row += pixel, from += stride)
                           for (int c = 0; c < chend - chbegin; ++c)
                               reinterpret_cast<Code*>(row)[c] = code_of<Code>(from[c]);
                   });
}

/// Width and height of the tiles in which OpenImageIO's cache keeps an image's file.
struct CachedTiles {
    int width, height;

    explicit CachedTiles(const OIIO::ImageBuf& image) {
        const OIIO::ImageSpec& file = image.nativespec();
        width = file.tile_width, height = file.tile_height;
        if (width < 1 || height < 1) {
            int side = 0, by_rows = 0;
            image.imagecache()->getattribute("autotile", side);
            image.imagecache()->getattribute("autoscanline", by_rows);
            width = side > 0 && by_rows == 0 ? side : file.width;
            height = side > 0 ? side : file.height;
        }
        width = tile_side(width, file.width), height = tile_side(height, file.height);
    }

    /// Call f(part) for each part of `roi` that one tile has, where the file begins at (x, y),
    /// until one returns false. Whether none did.
    template <class F>
    bool each(const OIIO::ROI& roi, int x, int y, F&& f) const {
        const auto end = [](int at, int first, int size) {
            return at + (size - (at - first) % size);
        };
        OIIO::ROI part = roi;
        for (part.ybegin = roi.ybegin; part.ybegin < roi.yend; part.ybegin = part.yend) {
            part.yend = std::min(end(part.ybegin, y, height), roi.yend);
            for (part.xbegin = roi.xbegin; part.xbegin < roi.xend; part.xbegin = part.xend) {
                part.xend = std::min(end(part.xbegin, x, width), roi.xend);
                if (!f(part))
                    return false;
            }
        }
        return true;
    }
};

/// Pixels of a file, through OpenImageIO's cache. Not by ImageBuf::get_pixels(), which does not
/// fail when the cache does and leaves that as the image's error, where another may be pending.
bool read_cached(const OIIO::ImageBuf& image, const OIIO::ROI& roi, OIIO::TypeDesc type, void* out,
                 std::string& error) {
    const OwnTasksOnly alone;
    const auto cache = image.imagecache();
    const auto name = OIIO::ustring(image.name());
    // The cache counts as the file does, wherever the image has been moved since.
    const OIIO::ImageSpec &spec = image.spec(), &file = image.nativespec();
    const int dx = spec.x - file.x, dy = spec.y - file.y;
    const auto pixel = OIIO::stride_t(type.size()) * roi.nchannels();
    const OIIO::stride_t row = pixel * roi.width();
    // Tile by tile: the cache asks as a call begins whether another thread has found the file
    // broken, and, where OpenImageIO is 2.5 or later and asserts, the program ends if it has by the
    // time that a tile is looked for.
    const auto read = [&](const OIIO::ROI& part) {
        char* const to = static_cast<char*>(out) + (part.ybegin - roi.ybegin) * row +
                         (part.xbegin - roi.xbegin) * pixel;
        return cache->get_pixels(name, image.subimage(), image.miplevel(), part.xbegin - dx,
                                 part.xend - dx, part.ybegin - dy, part.yend - dy, part.zbegin,
                                 part.zend, part.chbegin, part.chend, type, to, pixel, row,
                                 OIIO::AutoStride);
    };
    if (CachedTiles(image).each(roi, spec.x, spec.y, read))
        return true;
    error = cache->geterror();
    if (error.empty())
        error = "the source image cannot be read";
    CachedReads::fail(image, error);
    return false;
}

} // namespace

bool read_pixels(const OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend,
                 OIIO::TypeDesc type, void* out, std::string& error) {
    const int channels = chend - chbegin;
    const auto pixel = OIIO::stride_t(type.size()) * channels;
    const OIIO::TypeDesc from = image.spec().format;
    if (!image.localpixels())
        return read_cached(image, roi_of(image, r, chbegin, chend), type, out, error);
    if (type == OIIO::TypeFloat && from != type && is_dense(image, channels) &&
        read_rows(image, r, static_cast<float*>(out)))
        return true;
    return OIIO::convert_image(channels, r.width(), r.height(), 1,
                               address(image, r.x0, r.y0, chbegin), from, image.pixel_stride(),
                               image.scanline_stride(), OIIO::AutoStride, out, type, pixel,
                               pixel * r.width(), OIIO::AutoStride);
}

void write_pixels(OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend, OIIO::TypeDesc type,
                  const void* values) {
    // An ID is the same in the other type, where a number would be scaled.
    const bool ids = is_id_type(type) && is_id_type(image.spec().format);
    write_strided(image, r, chbegin, chend, ids ? image.spec().format : type, values,
                  OIIO::stride_t(type.size()) * (chend - chbegin));
}

void write_floats(OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend, float* values,
                  int stride) {
    const OIIO::TypeDesc type = image.spec().format;
    if (chend - chbegin == stride && is_dense(image, stride) && write_rows(image, r, values))
        return;
    if (type == OIIO::TypeUInt8) {
        write_codes<uint8_t>(image, r, chbegin, chend, values, stride);
    } else if (type == OIIO::TypeUInt16) {
        write_codes<uint16_t>(image, r, chbegin, chend, values, stride);
    } else {
        // Converting NaN to an integer is undefined.
        if (!type.is_floating_point())
            for (size_t i = 0; i < r.area() * size_t(stride); ++i)
                values[i] = std::isnan(values[i]) ? 0.0f : values[i];
        write_strided(image, r, chbegin, chend, OIIO::TypeFloat, values,
                      OIIO::stride_t(sizeof(float)) * stride);
    }
}

OIIO::TypeDesc copied_type(const OIIO::ImageBuf& src, const OIIO::ImageBuf& dst) {
    const OIIO::TypeDesc stored = src.spec().format;
    return stored.is_floating_point() && !dst.spec().format.is_floating_point() ? OIIO::TypeFloat
                                                                                : stored;
}

void write_copied(OIIO::ImageBuf& image, const Rect& r, int chbegin, int chend, OIIO::TypeDesc type,
                  void* values) {
    if (type == OIIO::TypeFloat && !image.spec().format.is_floating_point())
        write_floats(image, r, chbegin, chend, static_cast<float*>(values), chend - chbegin);
    else
        write_pixels(image, r, chbegin, chend, type, values);
}

} // namespace ddt
