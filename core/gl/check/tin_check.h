// SPDX-License-Identifier: Apache-2.0
// Whether a device keeps the promise of the same bits on meshes of points. Twin: job_check.h.
#pragma once

#include <string>

#include "ddt/options.h"

namespace ddt::gl {

struct Gpu;

/// Flip edges of a small mesh of points by options.cost on the device and on the CPU, by schemes
/// that take every branch of the programs; compare triangles, faces, gains and counts bit for bit.
/// Empty if they are the same, else what differs first. On the context's thread; throws Failure.
std::string tin_differs_from_cpu(Gpu& gpu, const MeshOptions& options);

/// Two options of one key use the same programs.
std::string tin_key_of(const MeshOptions& options);

} // namespace ddt::gl
