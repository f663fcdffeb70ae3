// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/ids.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include <OpenImageIO/imagecache.h>

#include "plugin/image/channels.h"
#include "plugin/image/memory.h"
#include "plugin/image/pixels.h"
#include "plugin/image/windows.h"
#include "plugin/message/format.h"

namespace ddt {
namespace {

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

/// As OpenImageIO's cache does it.
std::vector<float> floats_of(const void* numbers, OIIO::TypeDesc type, size_t count) {
    std::vector<float> floats(count);
    OIIO::convert_pixel_values(type, numbers, OIIO::TypeFloat, floats.data(), int(count));
    return floats;
}

/// The numbers of which these are the floats; false if others may have the same.
bool find_numbers(const std::vector<float>& floats, OIIO::TypeDesc type, uint32_t* numbers) {
    constexpr double room = 1 << std::numeric_limits<float>::digits;
    const double scale = type == OIIO::TypeDesc::UINT32 ? 0x1p32 : 0x1p31;
    for (size_t i = 0; i < floats.size(); ++i) {
        const double number = double(floats[i]) * scale;
        if (!(std::abs(number) < room))
            return false;
        numbers[i] = uint32_t(int32_t(number));
    }
    return same_bits(floats_of(numbers, type, floats.size()), floats);
}

/// Call f(y, the first number of that row, the row's floats in the cache) until it is false.
template <class F>
bool each_row(const OIIO::ImageBuf& src, OIIO::ImageBuf& ids, std::string& error, F&& f) {
    const Rect all = rect_of(src.roi());
    std::vector<float> floats(size_t(all.width()) * size_t(src.nchannels()));
    for (int y = all.y0; y < all.y1; ++y)
        if (!read_pixels(src, {all.x0, y, all.x1, y + 1}, 0, src.nchannels(), OIIO::TypeFloat,
                         floats.data(), error) ||
            !f(y, static_cast<uint32_t*>(address(ids, all.x0, y, 0)), floats))
            return false;
    return true;
}

/// The file that has the source's name.
bool read_again(const OIIO::ImageBuf& src, OIIO::ImageBuf& ids, std::string& error) {
    const OIIO::TypeDesc type = src.nativespec().format;
    OIIO::ImageBuf file(src.imagecache()->resolve_filename(src.name()), src.subimage(),
                        src.miplevel());
    const bool there = file.read(src.subimage(), src.miplevel(), true, type);
    file.set_origin(src.spec().x, src.spec().y);
    const bool alike = there && file.nchannels() == src.nchannels() &&
                       file.roi().width() == src.roi().width() &&
                       file.roi().height() == src.roi().height();
    const auto copy = [&](int y, uint32_t* numbers, const std::vector<float>& floats) {
        std::memcpy(numbers, address(file, src.xbegin(), y, 0), floats.size() * sizeof *numbers);
        return same_bits(floats_of(numbers, type, floats.size()), floats);
    };
    if (alike && each_row(src, ids, error, copy))
        return true;
    if (error.empty())
        error = format("the source image has integers beyond 2^24, which OpenImageIO's cache "
                       "rounds, and no file of its name (\"{}\") has them; read it into memory "
                       "before, by ImageBuf::read(0, 0, true, TypeDesc::{})",
                       src.name(), type == OIIO::TypeDesc::UINT32 ? "UINT32" : "INT32");
    return false;
}

} // namespace

bool read_ids(const OIIO::ImageBuf& src, OIIO::ImageBuf& ids, std::string& error) {
    const OIIO::TypeDesc type = src.nativespec().format;
    if (src.storage() != OIIO::ImageBuf::IMAGECACHE || !is_id_type(type))
        return true;
    OIIO::ImageSpec spec = src.spec();
    spec.set_format(type);
    spec.tile_width = src.nativespec().tile_width;
    spec.tile_height = src.nativespec().tile_height;
    if (!check_size(src.roi(), spec.nchannels, type, error) || !take_memory(ids, spec, error))
        return false;
    return each_row(src, ids, error,
                    [&](int, uint32_t* numbers, const std::vector<float>& floats) {
                        return find_numbers(floats, type, numbers);
                    }) ||
           (error.empty() && read_again(src, ids, error));
}

} // namespace ddt
