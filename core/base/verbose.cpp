// SPDX-License-Identifier: Apache-2.0
#include "core/base/verbose.h"

#include <cstdlib>

namespace ddt {

bool verbose() {
    const char* value = std::getenv("DDT_VERBOSE");
    return value && *value && *value != '0';
}

} // namespace ddt
