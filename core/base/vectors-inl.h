// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace, after core/base/vectors.h: the vectors of that target.

// Where a machine has no instruction set that Highway knows (x86 without SSSE3, as some virtual
// machines have it), not its emulation, which is a loop for each operation: by the compiler's
// vectors work takes less than half the time, and so does compiling a file for all targets.
#if HWY_TARGET == HWY_EMU128
namespace hn = plain_vectors;
#else
namespace hn = hwy::HWY_NAMESPACE;
#endif
