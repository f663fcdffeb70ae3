// SPDX-License-Identifier: Apache-2.0
#include "core/base/memory/numa_node.h"

#ifdef __linux__
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace ddt {

int this_memory_node() {
#ifdef __linux__
    // By its number: not every C library has the function.
    unsigned core = 0, node = 0;
    if (syscall(SYS_getcpu, &core, &node, nullptr) == 0)
        return int(node);
#endif
    return 0;
}

} // namespace ddt
