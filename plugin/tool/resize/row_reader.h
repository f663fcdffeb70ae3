// SPDX-License-Identifier: Apache-2.0
// Reading the rows of an image while those above are already worked on.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imageio.h>

#include "plugin/image/arrival.h"

namespace ddt::tool {

/// Reads an image of a file on a thread of its own, from the top downwards.
class RowReader final : public Arrival {
public:
    RowReader() = default;
    /// Reads no more rows.
    ~RowReader() override;
    RowReader(const RowReader&) = delete;
    RowReader& operator=(const RowReader&) = delete;

    /// Begin to read into `image`, which must outlive this: its spec and its memory are there
    /// afterwards, as open_image() of file/open_image.h makes them. Begins also with what is no
    /// flat image with pixels: check_source() is to refuse that. False with one line in `error`.
    bool begin(const std::string& path, OIIO::ImageBuf& image, std::string& error, int number = 0);

    bool wait_for(int end, std::string& error) override;

private:
    void work();
    bool read(int begin, int end, std::string& error);

    std::string m_path;
    std::unique_ptr<OIIO::ImageInput> m_input;
    OIIO::ImageSpec m_spec; ///< the image's own is another thread's
    char* m_pixels = nullptr;
    std::mutex m_mutex; ///< of what follows
    std::condition_variable m_changed;
    int m_ready = 0; ///< rows above
    bool m_stopped = false, m_failed = false;
    std::string m_error;
    std::thread m_thread; ///< if any: it uses all of the above
};

} // namespace ddt::tool
