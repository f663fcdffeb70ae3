// SPDX-License-Identifier: Apache-2.0
// Writing the rows of an image while those that follow are still being made.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include <OpenImageIO/imagebuf.h>

#include "ddt/progress.h"
#include "plugin/tool/file/image_file.h"
#include "plugin/tool/ids/mixed_ids.h"

namespace ddt::tool {

/// Writes scanlines, or rows of tiles, on a thread of its own, in order. To be used by one other
/// thread.
class RowWriter {
public:
    /// Rows of `image`, whose pixels are in local memory and stay there, into `file`, which was
    /// opened with its spec. `ids`: put into it. All must outlive this.
    RowWriter(const OIIO::ImageBuf& image, ImageFile& file, MixedIds& ids);
    /// Writes no more rows.
    ~RowWriter();
    RowWriter(const RowWriter&) = delete;
    RowWriter& operator=(const RowWriter&) = delete;

    /// Rows before `end` are as they shall be.
    void ready(int end);
    /// Whether writing came to an end before all rows were written.
    bool has_failed();
    /// Wait until all rows are written; they are all ready. `progress`, which cannot cancel it, is
    /// told the share of rows that are. False, with a failure, if one could not be written.
    bool finish(const ProgressCallback& progress, Failure& failure);

private:
    void work();
    int writable() const;
    bool write(int begin, int end);

    // What is needed of the image, whose spec is the other thread's.
    const char* const m_pixels;
    const OIIO::TypeDesc m_format;
    const size_t m_row, m_width; ///< bytes, pixels
    ImageFile& m_file;
    MixedIds& m_ids; ///< of which pack() alone is this thread's
    const int m_begin, m_end;
    const int m_step; ///< rows are written in multiples of it, but for the last
    std::mutex m_mutex;
    std::condition_variable m_changed;
    int m_ready, m_done; ///< rows before
    bool m_stopped = false, m_failed = false;
    Failure m_failure;
    std::thread m_thread; ///< last: it uses all of the above
};

} // namespace ddt::tool
