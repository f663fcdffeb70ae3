// SPDX-License-Identifier: Apache-2.0
#include "core/gl/requested_device.h"

#include <cstdlib>

#include "core/base/one_line.h"
#include "core/options/values.h"
#include "ddt/names.h"

namespace ddt::gl {

bool requested_device(const Job& job, Device& device, std::string& why) {
    device = job.device;
    const char* name = std::getenv("DDT_DEVICE");
    if (device != Device::automatic || !name || !*name)
        return true;
    if (find_device(name, device))
        return true;
    why = "ddt: DDT_DEVICE=" + std::string(name) + " is not one of " + joined(device_names());
    return false;
}

std::string why_unavailable(Device device, const std::string& reason) {
    return with_prefix(std::string("device ") + device_name(device) + unavailable_text + reason);
}

} // namespace ddt::gl
