// SPDX-License-Identifier: Apache-2.0
// How the cells of a row are divided.
#pragma once

#include "core/lattice/site.h"

namespace ddt {

/// Twin of division() for n cells of a row: to[k] becomes that of the one with its centre at
/// `centres` + 2 k. By the widest vectors this machine has. 2 n sites are read.
void find_divisions(const Site* centres, int n, Division* to);

} // namespace ddt
