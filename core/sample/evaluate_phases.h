// SPDX-License-Identifier: Apache-2.0
// Positions that lie alike in neighbouring cells: cell beside cell in the lanes, channels as they
// lie, in place of position beside position.
#pragma once

#include "core/sample/evaluate.h"

namespace ddt {

/// What evaluate_block() does of Columns::alike, as if all their cells were plain: the values in
/// crossed cells may be anything.
void evaluate_phases(const ControlNet& net, Surface surface, const Columns& columns,
                     const LocatedBlock& block, const GroupOutput& to);

} // namespace ddt
