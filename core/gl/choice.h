// Devices by name.
#pragma once

#include <string>

#include "ddt/core.h"

namespace ddt::gl {

/// "auto", "cpu", "egl" or "osmesa".
const char* name_of(Device device);

/// The device a job asks for: Job::device, or where that is automatic what DDT_DEVICE names. False
/// with `why` if that is no device's name.
bool wish(const Job& job, Device& device, std::string& why);

} // namespace ddt::gl
