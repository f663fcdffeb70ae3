// SPDX-License-Identifier: Apache-2.0
// Which programs a job uses: shaders, and the macros that choose among what they can be.
#pragma once

#include <string>
#include <vector>

#include "core/gl/transfer.h"
#include "core/triangulate/gain.h"
#include "ddt/core.h"

namespace ddt::gl {

std::string criterion_macros(const Criterion& by);
std::string surface_macros(const SurfaceOptions& options);
std::string gradient_macros(const SurfaceOptions& options);
std::string bend_macros(const SurfaceOptions& options);
std::string correct_macros(const SurfaceOptions& options);
/// mesh: of several that are averaged, from 0 on.
std::string sample_macros(const SurfaceOptions& options, int channels, int mesh);
std::string unpack_macros(const Numbers& numbers);
std::string pack_macros(Transfer::Download back);

struct JobProgram {
    std::string file, macros;
};

/// All that the job may use, and its check (SelfChecks), in the order in which they do.
std::vector<JobProgram> job_programs(const Job& job, const Transfer& transfer);

} // namespace ddt::gl
