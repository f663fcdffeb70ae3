// SPDX-License-Identifier: Apache-2.0
// Filters by name.
#include "core/options/values.h"
#include "ddt/names.h"

namespace ddt {

const std::vector<FilterRow>& filter_rows() {
    static const auto* rows = new std::vector<FilterRow>{
        {{"ddt",
          "One quadratic patch per triangle; every value lies between the three pixels of its "
          "triangle."},
         Surface::patch},
        {{"ddt-linear", "One plane per triangle; the same promise, less sharp, faster."},
         Surface::linear},
        {{"ddt-sharp", "As `ddt`, corrected so that the mean over each source pixel comes back; "
                       "closest to the original, may overshoot slightly."},
         Surface::patch},
    };
    return *rows;
}

const FilterRow* find_filter(std::string_view name) {
    for (const FilterRow& filter : filter_rows())
        if (name == filter.value.name)
            return &filter;
    return nullptr;
}

std::vector<std::string> filter_names() {
    std::vector<std::string> names;
    for (const FilterRow& filter : filter_rows())
        names.emplace_back(filter.value.name);
    return names;
}

bool is_filter_name(std::string_view spec) {
    return find_filter(spec.substr(0, spec.find(','))) != nullptr;
}

std::string filter_help(std::string_view name) {
    const FilterRow* filter = find_filter(name);
    return filter ? filter->value.help : "";
}

} // namespace ddt
