// SPDX-License-Identifier: Apache-2.0
#include "plugin/host/request.h"

#include "ddt/option_table.h"

namespace ddt::host {

bool set_filter(std::string_view filter, std::string_view light, Enlargement& work,
                std::string& error) {
    FilterOptions options;
    return parse_filter(filter, options, error) && set_filter(options, light, work, error);
}

bool set_filter(const FilterOptions& filter, std::string_view light, Enlargement& work,
                std::string& error) {
    // Also where the filter's light counts the other has to be one.
    if (!find_meaning(light, work.meaning, error) ||
        (filter.light != "auto" && !find_meaning(filter.light, work.meaning, error, "auto")))
        return false;
    work.surface = filter.surface;
    work.mesh = filter.mesh;
    work.device = filter.device;
    work.holes = filter.holes;
    return true;
}

} // namespace ddt::host
