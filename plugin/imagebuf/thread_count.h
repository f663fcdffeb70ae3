// SPDX-License-Identifier: Apache-2.0
// Threads of a call on an ImageBuf.
#pragma once

namespace ddt {

/// Threads for `nthreads` as ddt/resize.h says; 0: the core takes all.
int thread_count(int nthreads);

} // namespace ddt
