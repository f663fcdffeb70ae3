// SPDX-License-Identifier: Apache-2.0
// Copying past the caches.
#pragma once

#include <cstddef>

namespace ddt {

/// Copy n floats to where nobody reads soon: past the caches, where the processor can. Plain stores
/// fetch what they overwrite, and put out of the caches what is still of use. finish_streams()
/// makes what a thread has copied visible to others.
void stream_copy(const float* from, size_t n, float* to);
void finish_streams();

} // namespace ddt
