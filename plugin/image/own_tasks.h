// SPDX-License-Identifier: Apache-2.0
// Reading files while others wait for it.
#pragma once

#include <thread>

#include <OpenImageIO/thread.h>

namespace ddt {

/// While one is there, OpenImageIO does not share with its pool what this thread asks of it. A
/// thread that waits for the pool takes up any task that waits there, such as one that asks the
/// reader for another piece of the image that is being made. That task may wait for ever, if this
/// thread is one of those that make the image.
class OwnTasksOnly {
public:
    OwnTasksOnly() : m_added(!pool().is_worker(std::this_thread::get_id())) {
        if (m_added)
            pool().register_worker(std::this_thread::get_id());
    }
    ~OwnTasksOnly() {
        if (m_added)
            pool().deregister_worker(std::this_thread::get_id());
    }
    OwnTasksOnly(const OwnTasksOnly&) = delete;
    OwnTasksOnly& operator=(const OwnTasksOnly&) = delete;

private:
    static OIIO::thread_pool& pool() { return *OIIO::default_thread_pool(); }

    const bool m_added;
};

} // namespace ddt
