// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/ids/id_file.h"

#include <algorithm>
#include <cstring>

#include "plugin/image/file_tiles.h"
#include "plugin/image/memory.h"
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/file/read_native.h"
#include "plugin/tool/file/rows_together.h"

namespace ddt::tool {

namespace {

/// Rows that are read at once of more channels than are wanted.
constexpr int rows_at_once = 64;

} // namespace

IdFile::IdFile(const std::string& path, int number, const OIIO::ImageBuf& image,
               std::vector<int> channels)
    : m_path(path), m_number(number), m_channels(std::move(channels)) {
    const OIIO::ImageSpec& all = image.spec();
    m_spec = all;
    m_spec.set_format(image.nativespec().channelformat(m_channels[0]));
    if (int(m_channels.size()) == all.nchannels)
        return;
    m_spec.nchannels = int(m_channels.size());
    m_spec.alpha_channel = m_spec.z_channel = -1;
    m_spec.channelnames.clear();
    for (const int c : m_channels)
        m_spec.channelnames.push_back(all.channel_name(c));
}

bool IdFile::open(std::string& error) {
    if (!m_input)
        m_input = open_input(m_path, m_number, error);
    return m_input != nullptr;
}

/// Rows of pixels, which read_native() reads.
bool IdFile::read_some(const Rect& r, char* to, std::string& error) {
    const OIIO::ImageSpec& file = m_input->spec();
    const int first = m_channels.front(), end = m_channels.back() + 1;
    const size_t id = m_spec.format.size(), pixel = file.pixel_bytes(first, end, true);
    const bool alone = pixel == m_spec.pixel_bytes();
    std::vector<char> others(alone ? 0 : r.area() * pixel);
    if (!read_native(*m_input, r, first, end, alone ? to : others.data())) {
        error = why_unreadable(m_input->geterror(), m_path);
        return false;
    }
    for (size_t k = 0; !alone && k < m_channels.size(); ++k) {
        const char* const from = others.data() + file.pixel_bytes(first, m_channels[k], true);
        for (size_t i = 0; i < r.area(); ++i)
            std::memcpy(to + i * m_spec.pixel_bytes() + k * id, from + i * pixel, id);
    }
    return true;
}

bool IdFile::read(const Rect& wanted, OIIO::ImageBuf& ids, std::string& error) {
    if (!open(error))
        return false;
    const OIIO::ImageSpec& file = m_input->spec();
    const Rect r = readable(file, wanted);
    OIIO::ImageSpec spec = m_spec;
    spec.x = r.x0;
    spec.y = r.y0;
    spec.width = r.width();
    spec.height = r.height();
    if (!take_memory(ids, spec, error))
        return false;
    const int rows = rounded_up(rows_at_once, rows_together(file));
    char* to = static_cast<char*>(ids.localpixels());
    go_to_row(*m_input, r.y0);
    for (int y = r.y0; y < r.y1; y += rows, to += spec.scanline_bytes() * size_t(rows))
        if (!read_some({r.x0, y, r.x1, std::min(y + rows, r.y1)}, to, error))
            return false;
    return true;
}

} // namespace ddt::tool
