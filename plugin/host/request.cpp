// SPDX-License-Identifier: Apache-2.0
#include "plugin/host/request.h"

#include "ddt/option_table.h"

namespace ddt::host {

bool set_filter(std::string_view filter, std::string_view light, Enlargement& work,
                std::string& error) {
    FilterOptions options;
    // Also where the filter's light counts the other has to be one.
    if (!parse_filter(filter, options, error) || !find_meaning(light, work.meaning, error) ||
        (options.light != "auto" && !find_meaning(options.light, work.meaning, error)))
        return false;
    work.surface = options.surface;
    work.mesh = options.mesh;
    work.device = options.device;
    work.holes = options.holes;
    return true;
}

} // namespace ddt::host
