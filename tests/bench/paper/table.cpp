// SPDX-License-Identifier: Apache-2.0
#include "paper/table.h"

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace paper {

std::string Table::text() const {
    std::vector<size_t> width;
    for (const auto& row : m_rows)
        for (size_t c = 0; c < row.size(); ++c) {
            width.resize(std::max(width.size(), c + 1));
            width[c] = std::max(width[c], row[c].size());
        }
    std::string out = m_name + "\n";
    for (const auto& row : m_rows) {
        for (size_t c = 0; c < row.size(); ++c) {
            const std::string pad(width[c] - row[c].size(), ' ');
            out += c == 0 ? row[c] + pad : "  " + pad + row[c];
        }
        out += "\n";
    }
    return out;
}

std::string Table::csv() const {
    std::string out;
    for (const auto& row : m_rows)
        for (size_t c = 0; c < row.size(); ++c)
            out += row[c] + (c + 1 < row.size() ? "," : "\n");
    return out;
}

bool Table::show(const std::string& csv_folder) const {
    std::printf("%s\n", text().c_str());
    std::fflush(stdout);
    return write(csv_folder);
}

bool Table::write(const std::string& csv_folder) const {
    if (csv_folder.empty())
        return true;
    const std::string path = csv_folder + "/" + m_name + ".csv";
    std::ofstream file(path);
    file << csv();
    if (file.flush())
        return true;
    std::fprintf(stderr, "paper_tables: cannot write \"%s\"\n", path.c_str());
    return false;
}

std::string number(double value, int decimals) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
    return buffer;
}

} // namespace paper
