// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/resize/row_reader.h"

#include <algorithm>
#include <limits>

#include "core/base/one_line.h"
#include "plugin/image/lazy_file.h"
#include "plugin/image/memory.h"
#include "plugin/image/oiio_defects.h"
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/file/read_native.h"
#include "plugin/tool/file/rows_together.h"

namespace ddt::tool {

namespace {

/// Rows that the reader is asked for at once, or more.
constexpr int least_rows = 64;

/// Whether there are rows of pixels that follow one another as they are in memory, of one type.
bool comes_by_rows(const OIIO::ImageSpec& spec) {
    return !spec.deep && spec.depth <= 1 && spec.channelformats.empty() && spec.width > 0 &&
           spec.height > 0 && spec.nchannels > 0 && !is_associated_when_read(spec);
}

} // namespace

bool RowReader::begin(const std::string& path, OIIO::ImageBuf& image, std::string& error,
                      int number) {
    m_path = path;
    if (!check_reader(path, number, error))
        return false;
    image.reset(path, number, 0);
    if (image.init_spec(path, number, 0) && comes_by_rows(image.nativespec())) {
        m_spec = image.nativespec();
        m_input = open_input(path, number, error);
        if (m_input && !is_unchanged(m_spec, m_input->spec(), path, error))
            return false;
    }
    if (!m_input) {
        m_ready = std::numeric_limits<int>::max();
        return open_image(path, image, error, number);
    }
    if (!take_memory(image, m_spec, error)) {
        error = "\"" + path + "\": " + error;
        return false;
    }
    m_pixels = static_cast<char*>(image.localpixels());
    m_ready = m_spec.y;
    m_thread = std::thread([this] { work(); });
    return true;
}

RowReader::~RowReader() {
    {
        const std::lock_guard lock(m_mutex);
        m_stopped = true;
    }
    if (m_thread.joinable())
        m_thread.join();
}

void RowReader::work() {
    const int end = m_spec.y + m_spec.height, rows = rows_to_read(m_spec, least_rows);
    for (int y = m_spec.y, next = y; y < end; y = next) {
        next = y + std::min(rows, end - y);
        bool done = false;
        std::string error = out_of_memory_text;
        try {
            done = read(y, next, error);
        } catch (const std::exception&) { // it is that
        }
        const std::lock_guard lock(m_mutex);
        if (done)
            m_ready = next;
        else
            m_error = error;
        m_failed = !done;
        m_changed.notify_all();
        if (m_failed || m_stopped)
            return;
    }
}

bool RowReader::read(int begin, int end, std::string& error) {
    char* const to = m_pixels + m_spec.scanline_bytes() * size_t(begin - m_spec.y);
    if (read_native(*m_input, {m_spec.x, begin, m_spec.x + m_spec.width, end}, to))
        return true;
    // Which only the thread that read is told.
    error = why_unreadable(m_input->geterror(), m_path);
    return false;
}

bool RowReader::wait_for(int end, std::string& error) {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [&] { return end <= m_ready || m_failed; });
    if (end <= m_ready)
        return true;
    error = m_error;
    return false;
}

} // namespace ddt::tool
