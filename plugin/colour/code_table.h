// SPDX-License-Identifier: Apache-2.0
// The 8-bit codes of linear light.
#pragma once

#include "ddt/code_table.h"
#include "plugin/colour/curve.h"

namespace ddt {

/// Fill the table of the codes code_of<uint8_t>(curve(x)). False if the curve is none that rises
/// from 0 to 1; the table is then not to be used.
bool fill_codes(const Curve& curve, CodeTable& table);

} // namespace ddt
