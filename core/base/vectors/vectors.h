// SPDX-License-Identifier: Apache-2.0
// Included after <hwy/foreach_target.h>: what core/base/vectors/vectors-inl.h chooses from. Without
// a guard, since Highway's header has something to do for every target.
#include <hwy/highway.h>

#include "core/base/vectors/plain_vectors.h"
