// SPDX-License-Identifier: Apache-2.0
// Devices by name.
#pragma once

#include <string>

#include "ddt/core.h"

namespace ddt::gl {

/// The device a job asks for: Job::device, or where that is automatic what DDT_DEVICE names. False
/// with `why` if that is no device's name.
bool requested_device(const Job& job, Device& device, std::string& why);

/// One line that says why a device that was named cannot be had.
std::string why_unavailable(Device device, const std::string& reason);

} // namespace ddt::gl
