// SPDX-License-Identifier: Apache-2.0
// Flipping the edges of a mesh that is there already.
#pragma once

#include <string>

#include "ddt/points.h"
#include "ddt/progress.h"
#include "plugin/tool/command/exit_code.h"

namespace ddt::tool {

/// Whether a file is read as a mesh: by its name.
bool is_point_mesh(const std::string& path);

/// Read a PLY mesh, flip edges by its usual_columns(), write it with all its columns.
bool optimise_file(const std::string& in, const std::string& out, const MeshOptions& options,
                   Device device, MeshReport& report, const ProgressCallback& progress,
                   Failure& failure);

} // namespace ddt::tool
