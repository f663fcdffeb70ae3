// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/ids/mixed_ids.h"

#include <algorithm>
#include <cstring>

#include "plugin/image/channels.h"
#include "plugin/image/memory.h"
#include "plugin/image/pixels.h"
#include "plugin/image/windows.h"
#include "plugin/imagebuf/resize.h"
#include "plugin/message/format.h"

namespace ddt::tool {

namespace {

constexpr size_t id_size = sizeof(float);

std::vector<int> find_mixed_ids(const OIIO::ImageSpec& file, const OIIO::ImageSpec& written) {
    std::vector<int> channels;
    if (!file.channelformats.empty() && !written.channelformats.empty())
        for (int c = 0; c < std::min(file.nchannels, written.nchannels); ++c)
            if (is_id_type(file.channelformat(c)) &&
                written.channelformat(c) == file.channelformat(c))
                channels.push_back(c);
    return channels;
}

Rect row_of(const OIIO::ROI& roi, int y) {
    return {roi.xbegin, y, roi.xend, y + 1};
}

float* floats_of(OIIO::ImageBuf& image, const OIIO::ROI& roi, int y) {
    return static_cast<float*>(address(image, roi.xbegin, y, 0));
}

} // namespace

int count_mixed_ids(const OIIO::ImageSpec& file, const OIIO::ImageSpec& written) {
    return int(find_mixed_ids(file, written).size());
}

MixedIds::MixedIds(const std::string& path, int number, const OIIO::ImageBuf& image,
                   const OIIO::ImageSpec& written)
    : m_channels(find_mixed_ids(image.nativespec(), written)), m_all(size_t(image.nchannels())) {
    if (!m_channels.empty())
        m_file = IdFile(path, number, image, m_channels);
}

bool MixedIds::put_into(OIIO::ImageBuf& image, std::string& error) {
    const OIIO::ROI all = image.roi();
    if (!m_file.read(rect_of(all), m_ids, error))
        return false;
    for (int y = all.ybegin; y < all.yend; ++y)
        complete(row_of(all, y), floats_of(image, all, y));
    m_ids.clear();
    return true;
}

bool MixedIds::resize(OIIO::ImageBuf& result, const OIIO::ImageBuf& image, const Rect& source,
                      const Options& options, const OIIO::ROI& roi, int threads) {
    std::string error;
    if (m_file.read(source, m_ids, error)) {
        if (!resize_arriving(result, image, this, options, roi, threads))
            return false;
        if (enlarges(image.roi_full(), result.roi_full()) ||
            copy_nearest(result, roi, threads, error))
            return true;
    }
    set_error(result, error);
    return false;
}

void MixedIds::copy_ids(const OIIO::ImageBuf& ids, const Rect& r, float* pixels) const {
    const size_t count = m_channels.size();
    for (int y = r.y0; y < r.y1; ++y) {
        const auto* from = static_cast<const char*>(address(ids, r.x0, y, 0));
        for (int x = r.x0; x < r.x1; ++x, pixels += m_all, from += count * id_size)
            for (size_t k = 0; k < count; ++k)
                std::memcpy(pixels + m_channels[k], from + k * id_size, id_size);
    }
}

void MixedIds::complete(const Rect& r, float* pixels) const {
    copy_ids(m_ids, r, pixels);
}

bool MixedIds::copy_nearest(OIIO::ImageBuf& result, const OIIO::ROI& roi, int threads,
                            std::string& error) const {
    OIIO::ImageSpec spec = m_ids.spec();
    OIIO::set_roi(spec, roi);
    OIIO::set_roi_full(spec, result.roi_full());
    OIIO::ImageBuf ids;
    if (!take_memory(ids, spec, error))
        return false;
    if (!ddt::resize(ids, m_ids, {}, {}, threads)) {
        error = ids.geterror();
        return false;
    }
    for (int y = roi.ybegin; y < roi.yend; ++y)
        copy_ids(ids, row_of(roi, y), floats_of(result, roi, y));
    return true;
}

const char* MixedIds::pack(const float* pixels, size_t n, const OIIO::ImageSpec& written) {
    const auto from = OIIO::stride_t(sizeof(float) * m_all);
    const auto pixel = OIIO::stride_t(written.pixel_bytes(true));
    m_packed.resize(n * size_t(pixel));
    char* to = m_packed.data();
    for (int c = 0; c < written.nchannels; ++c) {
        const OIIO::TypeDesc type = written.channelformat(c);
        const bool id = std::binary_search(m_channels.begin(), m_channels.end(), c);
        OIIO::convert_image(1, int(n), 1, 1, pixels + c, id ? type : OIIO::TypeFloat, from,
                            OIIO::AutoStride, OIIO::AutoStride, to, type, pixel, OIIO::AutoStride,
                            OIIO::AutoStride);
        to += type.size();
    }
    return m_packed.data();
}

} // namespace ddt::tool
