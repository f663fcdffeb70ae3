// SPDX-License-Identifier: Apache-2.0
#include "rows.h"

#include <algorithm>

namespace bench {

std::vector<Row> all_rows(Light light, const std::vector<std::string>& more) {
    std::vector<Row> rows = oiio_rows();
    for (const auto& others :
         {light == Light::scene ? std::vector<Row>() : imagemagick_rows(), ddt_rows(light)})
        rows.insert(rows.end(), others.begin(), others.end());
    for (const std::string& specification : more)
        rows.push_back(ddt_row(specification, light));
    return rows;
}

std::vector<Row> rows_with(const std::string& part, Light light,
                           const std::vector<std::string>& more) {
    std::vector<Row> rows = all_rows(light, more);
    rows.erase(std::remove_if(rows.begin(), rows.end(),
                              [&](const Row& row) { return row.name.find(part) == row.name.npos; }),
               rows.end());
    return rows;
}

} // namespace bench
