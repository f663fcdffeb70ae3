// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part/strip_writer.h"

#include <cstring>

#include "plugin/image/memory.h"

namespace ddt::tool {

StripWriter::StripWriter(const OIIO::ImageSpec& whole, const Rect& part, int tile_height,
                         OIIO::ImageOutput& output, MixedIds& ids)
    : m_spec(whole), m_part(part), m_tile_height(tile_height), m_output(output), m_ids(ids),
      m_done(part.y0), m_made(part.y0) {
    m_spec.x = part.x0;
    m_spec.width = part.width();
    m_spec.channelformats.clear(); // strips in memory have one type
}

bool StripWriter::strip(int end, const OIIO::ImageBuf& source, const Rect& shown,
                        const Options& options, int threads, std::string& error) {
    OIIO::ImageSpec spec = m_spec;
    spec.y = m_done;
    spec.height = end - m_done;
    if (!check_size(OIIO::get_roi(spec), spec.nchannels, spec.format, error))
        return false;
    OIIO::ImageBuf strip;
    if (!take_memory(strip, spec, error))
        return false;
    const size_t row = spec.scanline_bytes();
    if (m_made > m_done)
        std::memcpy(strip.localpixels(), m_left.data(), row * size_t(m_made - m_done));
    if (!make(strip, source, shown, options, threads)) {
        error = strip.geterror();
        return false;
    }
    const int rows =
        end == m_part.y1 ? end - m_done : (end - m_done) / m_tile_height * m_tile_height;
    const auto* pixels = static_cast<const char*>(strip.localpixels());
    if (rows > 0 && !write(rows, spec.format, pixels))
        return false;
    m_left.assign(pixels + row * size_t(rows), pixels + row * size_t(end - m_done));
    m_done += rows;
    m_made = end;
    return true;
}

/// Enlarge the rows that are not made yet.
bool StripWriter::make(OIIO::ImageBuf& strip, const OIIO::ImageBuf& source, const Rect& shown,
                       const Options& options, int threads) const {
    OIIO::ROI roi = strip.roi();
    roi.ybegin = m_made;
    return m_ids && options.holes == Holes::keep
               ? m_ids.resize(strip, source, shown, options, roi, threads)
               : resize(strip, source, options, roi, threads);
}

bool StripWriter::write(int rows, OIIO::TypeDesc type, const char* pixels) {
    const size_t n = size_t(rows) * size_t(m_part.width());
    return m_output.write_tiles(
        m_part.x0, m_part.x1, m_done, m_done + rows, 0, 1,
        m_ids ? OIIO::TypeDesc(OIIO::TypeUnknown) : type,
        m_ids ? m_ids.pack(reinterpret_cast<const float*>(pixels), n, m_output.spec()) : pixels);
}

} // namespace ddt::tool
