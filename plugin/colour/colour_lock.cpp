// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/colour_lock.h"

#include <pthread.h>

namespace ddt {
namespace {

std::mutex lock;

// Before any thread can be in here: when the library is loaded. In the child the one thread that is
// left holds the lock, as in the parent.
[[maybe_unused]] const int registered =
    pthread_atfork([] { lock.lock(); }, [] { lock.unlock(); }, [] { lock.unlock(); });

} // namespace

std::mutex& colour_lock() {
    return lock;
}

} // namespace ddt
