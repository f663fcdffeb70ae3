// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"

#include <algorithm>
#include <new>
#include <vector>

#include <sys/mman.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "core/base/control_groups.h"
#include "core/base/thread_sanitizer.h"

namespace ddt {

namespace {

/// While one lives a body is at work: after the call began, after the one before in the same slot,
/// and before the call returns. That is what oneTBB sees to.
struct InSlot {
    char* slot;
    InSlot(char* begin, char* of_slot) : slot(of_slot) {
        happens_after(begin);
        happens_after(slot);
    }
    ~InSlot() { happens_before(slot); }
    InSlot(const InSlot&) = delete;
    InSlot& operator=(const InSlot&) = delete;
};

/// Throws where there is no memory for a thread. oneTBB 2022 and 2023, which find that out as they
/// begin, never come back: what would be thrown asks for a control whose lock is held until then
/// (threading_control::create_threading_control()). Nothing is written: it costs no pages.
void have_memory_for_a_thread() {
    constexpr size_t bytes = size_t(8) << 20; // of its stack; oneTBB's own are fewer
    void* const begin =
        mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (begin == MAP_FAILED)
        throw std::bad_alloc();
    munmap(begin, bytes);
}

} // namespace

int usual_threads() {
    return allowed_threads(
        std::min(tbb::this_task_arena::max_concurrency(), processors_of_groups()));
}

int allowed_threads(int wanted) {
    const size_t most =
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    return int(std::clamp<size_t>(size_t(std::max(wanted, 1)), 1, most));
}

void allow_threads(int number) {
    if (allowed_threads(number) >= number)
        return;
    // Of several limits the lowest counts. Not deleted at the program's end, when oneTBB may have
    // gone.
    static tbb::global_control* limit = nullptr;
    delete limit;
    limit = new tbb::global_control(tbb::global_control::max_allowed_parallelism, size_t(number));
}

void for_each_index(int threads, int count, const std::function<void(int, int)>& body) {
    if (threads <= 1 || count <= 1) {
        for (int i = 0; i < count; ++i)
            body(0, i);
        return;
    }
    have_memory_for_a_thread();
    tbb::task_arena arena(threads);
    std::vector<char> slots(static_cast<size_t>(threads)); // tokens
    char begin = 0;
    happens_before(&begin);
    arena.execute([&] {
        // Isolated: where the body waits for tasks of its own, as a source that uses oneTBB does,
        // its thread does not begin another index meanwhile, in the slot that is in use.
        tbb::parallel_for(0, count, [&](int i) {
            tbb::this_task_arena::isolate([&] {
                const int slot = tbb::this_task_arena::current_thread_index();
                const InSlot ordered(&begin, &slots[size_t(slot)]);
                body(slot, i);
            });
        });
    });
    for (char& slot : slots)
        happens_after(&slot);
}

} // namespace ddt
