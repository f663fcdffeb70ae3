// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/resize/row_writer.h"

#include <algorithm>

#include "core/base/one_line.h"
#include "plugin/image/file_tiles.h"
#include "plugin/tool/file/rows_together.h"

namespace ddt::tool {

namespace {

/// Rows that are handed to the writer at once, times those that the format keeps together: what
/// writers compress in one go must not be cut. (TIFF has 32, or what the image's own file had.)
constexpr int handed_at_once = 64;

/// Rows of tiles, if the file has them, else scanlines.
int step_of(const OIIO::ImageSpec& image, ImageFile& file) {
    const OIIO::ImageSpec& written = file.output().spec();
    if (file.wants_all_rows())
        return written.height;
    if (written.tile_width == 0)
        return handed_at_once * rows_in_strip(image);
    return rounded_up(handed_at_once, rows_together(written));
}

} // namespace

RowWriter::RowWriter(const OIIO::ImageBuf& image, ImageFile& file, MixedIds& ids)
    : m_pixels(static_cast<const char*>(image.localpixels())), m_format(image.spec().format),
      m_row(image.spec().scanline_bytes()), m_width(size_t(image.spec().width)), m_file(file),
      m_ids(ids), m_begin(image.ybegin()), m_end(image.yend()), m_step(step_of(image.spec(), file)),
      m_ready(m_begin), m_done(m_begin), m_thread([this] { work(); }) {}

RowWriter::~RowWriter() {
    {
        const std::lock_guard lock(m_mutex);
        m_stopped = true;
    }
    m_changed.notify_all();
    m_thread.join();
}

void RowWriter::ready(int end) {
    {
        const std::lock_guard lock(m_mutex);
        m_ready = end;
    }
    m_changed.notify_all();
}

bool RowWriter::has_failed() {
    const std::lock_guard lock(m_mutex);
    return m_failed;
}

/// Where the next rows to write end; m_done if they are not ready.
int RowWriter::writable() const {
    const int end = std::min(m_done + m_step, m_end);
    return end <= m_ready ? end : m_done;
}

void RowWriter::work() {
    std::unique_lock lock(m_mutex);
    while (m_done < m_end) {
        m_changed.wait(lock, [&] { return m_stopped || writable() > m_done; });
        if (m_stopped)
            return;
        const int end = writable();
        lock.unlock();
        bool written = false;
        Failure failure{out_of_memory_text, exit_resources};
        try {
            written = write(m_done, end);
            if (!written)
                failure = m_file.failed(); // which only the thread that wrote is told
        } catch (const std::exception&) {  // it is that
        }
        lock.lock();
        m_done = end;
        if (!written) {
            m_failed = true;
            m_failure = failure;
        }
        m_changed.notify_all();
        if (m_failed)
            return;
    }
}

bool RowWriter::write(int begin, int end) {
    const char* const rows = m_pixels + m_row * size_t(begin - m_begin);
    return m_ids ? m_file.write_rows(begin, end, OIIO::TypeUnknown,
                                     m_ids.pack(reinterpret_cast<const float*>(rows),
                                                m_width * size_t(end - begin),
                                                m_file.output().spec()))
                 : m_file.write_rows(begin, end, m_format, rows);
}

bool RowWriter::finish(const ProgressCallback& progress, Failure& failure) {
    std::unique_lock lock(m_mutex);
    while (m_done < m_end && !m_failed) {
        const int done = m_done;
        lock.unlock();
        if (progress)
            progress(float(done - m_begin) / float(m_end - m_begin));
        lock.lock();
        m_changed.wait(lock, [&] { return m_done > done || m_failed; });
    }
    if (m_failed)
        failure = m_failure;
    return !m_failed;
}

} // namespace ddt::tool
