// SPDX-License-Identifier: Apache-2.0
// Positions that lie alike in crossed cells: those of several cells, each in its own triangle,
// beside each other in the lanes.
#pragma once

#include "core/sample/evaluate.h"

namespace ddt {

/// What evaluate_block() does of LocatedBlock::crossed; nothing else is overwritten.
void evaluate_crossed(const ControlNet& net, Surface surface, const Columns& columns,
                      const LocatedBlock& block, const GroupOutput& to);

} // namespace ddt
