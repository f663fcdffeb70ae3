// SPDX-License-Identifier: Apache-2.0
// build_mesh() of ddt/mesh.h: what it refuses.
#pragma once

#include <string>

namespace ddt {

/// Whether build_mesh() makes a mesh of so many pixels, for who takes memory before it does; false
/// with one line in `error`.
bool check_mesh_size(int width, int height, std::string& error);

} // namespace ddt
