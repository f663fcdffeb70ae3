// SPDX-License-Identifier: Apache-2.0
// Preloaded: after so many requests, $NO_MEMORY_AFTER, that a program has made since main() began
// there is no memory, for $NO_MEMORY_FOR requests. It tells at the end how many there were.
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

#include <dlfcn.h>

extern "C" {
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* memory, size_t size);
void* __libc_memalign(size_t alignment, size_t size);
}

namespace {

using Main = int (*)(int, char**, char**);
Main real_main;
std::atomic<long> requests{0};
std::atomic<bool> counts{false};
long after = -1, lacking = 0;

bool fails() {
    if (!counts)
        return false;
    const long number = ++requests;
    if (after < 0 || number <= after || number > after + lacking)
        return false;
    errno = ENOMEM;
    return true;
}

long number_in(const char* variable, long otherwise) {
    const char* const text = std::getenv(variable);
    return text ? std::atol(text) : otherwise;
}

int counted_main(int count, char** arguments, char** variables) {
    after = number_in("NO_MEMORY_AFTER", -1);
    lacking = number_in("NO_MEMORY_FOR", 1);
    counts = true;
    const int code = real_main(count, arguments, variables);
    counts = false;
    if (after < 0)
        std::fprintf(stderr, "%ld\n", requests.load());
    return code;
}

} // namespace

extern "C" {

void* malloc(size_t size) noexcept {
    return fails() ? nullptr : __libc_malloc(size);
}

void* calloc(size_t count, size_t size) noexcept {
    return fails() ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* memory, size_t size) noexcept {
    return size > 0 && fails() ? nullptr : __libc_realloc(memory, size);
}

void* memalign(size_t alignment, size_t size) noexcept {
    return fails() ? nullptr : __libc_memalign(alignment, size);
}

void* aligned_alloc(size_t alignment, size_t size) noexcept {
    return memalign(alignment, size);
}

int posix_memalign(void** memory, size_t alignment, size_t size) noexcept {
    *memory = memalign(alignment, size);
    return *memory ? 0 : ENOMEM;
}

int __libc_start_main(Main main, int count, char** arguments, void (*init)(), void (*fini)(),
                      void (*rtld_fini)(), void* stack_end);
int __libc_start_main(Main main, int count, char** arguments, void (*init)(), void (*fini)(),
                      void (*rtld_fini)(), void* stack_end) {
    using Start = decltype(&__libc_start_main);
    real_main = main;
    const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
    return start(counted_main, count, arguments, init, fini, rtld_fini, stack_end);
}
}
