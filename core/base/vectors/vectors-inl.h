// SPDX-License-Identifier: Apache-2.0
// Included inside a SIMD target's namespace: the vectors of that target, hn.
// Needs: vectors.h.

// Where a machine has no instruction set of use to Highway (x86 without SSSE3, as some virtual
// machines have it), not its emulation, which is a loop for each operation, nor, since
// Highway 1.0.4, its SSE2: by the compiler's vectors work takes less than half the time of the one
// and four fifths of the other's, and compiling a file for all targets half of what it does with
// the emulation.
#undef DDT_PLAIN_VECTORS
#if HWY_TARGET == HWY_EMU128 || HWY_TARGET == HWY_SSE2
#define DDT_PLAIN_VECTORS 1
namespace hn = plain_vectors;
#else
#define DDT_PLAIN_VECTORS 0
namespace hn = hwy::HWY_NAMESPACE;
#endif
