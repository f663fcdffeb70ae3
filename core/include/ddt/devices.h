// SPDX-License-Identifier: Apache-2.0
// Which device a job is worked on, for people.
#pragma once

#include <string>

#include "ddt/job.h"

namespace ddt {

/// Describe in one line where `job` would be worked on: "cpu", or "egl: llvmpipe (...), OpenGL 4.5
/// ...". Opens a GPU as the job itself would; of the job its device, mesh, threads and window
/// count. False if the device that it names, or DDT_DEVICE, cannot be had, or one of MeshOptions is
/// not allowed; the line then says why. Safe to call from several threads at once.
bool describe_device(const Job& job, std::string& line) noexcept;

/// Whether a job of this device may begin as far as names go: false if DDT_DEVICE counts for it and
/// is no device's name; the line then says so, and else stays as it is. Opens nothing.
bool check_device(Device device, std::string& line) noexcept;

} // namespace ddt
