// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"

#include <algorithm>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace ddt {

int usual_threads() {
    return allowed_threads(tbb::this_task_arena::max_concurrency());
}

int allowed_threads(int wanted) {
    const size_t most =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    return int(std::clamp<size_t>(size_t(std::max(wanted, 1)), 1, most));
}

void for_each_index(int threads, int count, const std::function<void(int, int)>& body) {
    if (threads <= 1 || count <= 1) {
        for (int i = 0; i < count; ++i)
            body(0, i);
        return;
    }
    tbb::task_arena arena(threads);
    arena.execute([&] {
        // Isolated: where the body waits for tasks of its own, as a source that uses oneTBB does,
        // its thread does not begin another index meanwhile, in the slot that is in use.
        tbb::parallel_for(0, count, [&](int i) {
            tbb::this_task_arena::isolate(
                [&] { body(tbb::this_task_arena::current_thread_index(), i); });
        });
    });
}

} // namespace ddt
