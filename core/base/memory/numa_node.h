// SPDX-License-Identifier: Apache-2.0
// Machines whose cores are nearer to some of the memory than to the rest (NUMA).
#pragma once

namespace ddt {

/// The number of the node of memory that is nearest to the core that runs this thread; 0 where
/// nobody tells. A thread may be moved, so this is how things stand, not how they stay.
int this_memory_node();

} // namespace ddt
