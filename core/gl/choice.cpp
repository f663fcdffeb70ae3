#include "core/gl/choice.h"

#include <cstdlib>

#include "core/gl/offload.h"

namespace ddt {

namespace gl {

const char* name_of(Device device) {
    switch (device) {
    case Device::automatic:
        return "auto";
    case Device::cpu:
        return "cpu";
    case Device::egl:
        return "egl";
    case Device::osmesa:
        return "osmesa";
    }
    return "";
}

bool wish(const Job& job, Device& device, std::string& why) {
    device = job.device;
    const char* name = std::getenv("DDT_DEVICE");
    if (device != Device::automatic || !name || !*name)
        return true;
    for (const Device d : {Device::automatic, Device::cpu, Device::egl, Device::osmesa})
        if (std::string(name) == name_of(d)) {
            device = d;
            return true;
        }
    why = "ddt: DDT_DEVICE=" + std::string(name) + " is not one of auto, cpu, egl, osmesa";
    return false;
}

} // namespace gl

bool verbose() {
    const char* value = std::getenv("DDT_VERBOSE");
    return value && std::string(value) == "1";
}

} // namespace ddt
