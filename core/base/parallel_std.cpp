// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#ifdef __linux__
#include <sched.h>
#endif

#include "core/base/control_groups.h"

namespace ddt {

namespace {

int processors() {
#ifdef __linux__
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) == 0)
        return CPU_COUNT(&set);
#endif
    return int(std::thread::hardware_concurrency());
}

} // namespace

int usual_threads() {
    return std::max(1, std::min(processors(), processors_of_groups()));
}

int allowed_threads(int wanted) {
    return std::max(wanted, 1);
}

void allow_threads(int) {}

void for_each_index(int threads, int count, const std::function<void(int, int)>& body) {
    std::atomic<int> next{0};
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&](int slot) {
        try {
            for (int i = next++; i < count; i = next++)
                body(slot, i);
        } catch (...) {
            next = count;
            const std::lock_guard<std::mutex> lock(mutex);
            if (!failure)
                failure = std::current_exception();
        }
    };
    std::vector<std::thread> others;
    others.reserve(size_t(std::max(0, std::min(threads, count) - 1)));
    // Where no further thread can be had, those that are there do the work.
    try {
        while (others.size() < others.capacity())
            others.emplace_back(work, int(others.size()) + 1);
    } catch (...) { // no thread, or no memory for one
    }
    work(0);
    for (std::thread& other : others)
        other.join();
    if (failure)
        std::rethrow_exception(failure);
}

} // namespace ddt
