// SPDX-License-Identifier: Apache-2.0
// Stands in for Highway's header of this name (highway.h beside this says for what).
#pragma once

namespace hwy {

static inline void FlushStream() {}

} // namespace hwy
