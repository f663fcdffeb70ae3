// SPDX-License-Identifier: Apache-2.0
// A table as text and as comma-separated values.
#pragma once

#include <string>
#include <vector>

namespace paper {

class Table {
public:
    /// `name` becomes the title and, with folder and ".csv", the file's name.
    Table(std::string name, std::vector<std::string> columns)
        : m_name(std::move(name)), m_rows{std::move(columns)} {}

    void add(std::vector<std::string> cells) { m_rows.push_back(std::move(cells)); }

    /// First column flush left, the others right, as wide as they need.
    std::string text() const;
    std::string csv() const;

    /// Print the text; with a folder, write the CSV there. False if that fails.
    bool show(const std::string& csv_folder) const;
    /// Write the CSV to the folder unless that is empty.
    bool write(const std::string& csv_folder) const;

private:
    std::string m_name;
    std::vector<std::vector<std::string>> m_rows;
};

/// A number with so many decimals.
std::string number(double value, int decimals);

} // namespace paper
