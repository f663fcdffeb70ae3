// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/work_line.h"

#include "core/base/log.h"

namespace ddt {

void say_worked(const std::string& device, const std::string& amount, const Statistics& statistics,
                double milliseconds) {
    say("ddt: device %s; %s, %lld flips, %d iterations, %.1f ms", device.c_str(), amount.c_str(),
        static_cast<long long>(statistics.flips), statistics.iterations, milliseconds);
}

} // namespace ddt
