// SPDX-License-Identifier: Apache-2.0
// Reading files while others wait for it.
#pragma once

#include <thread>

#include <OpenImageIO/thread.h>

namespace ddt {

/// While one is there, what its thread asks of OpenImageIO is not shared with the pool. A thread
/// that waits for its share of the pool's takes up whatever else waits there, as a task that asks
/// the reader for another piece of the image that is being made: which may be for ever, if this
/// thread is one of those that make it.
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
