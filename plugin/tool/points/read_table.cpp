// SPDX-License-Identifier: Apache-2.0
// Points as text: comma-separated values, XYZ files with a header.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <optional>

#include <OpenImageIO/strutil.h>

#include "plugin/message/byte_order_mark.h"
#include "plugin/message/format.h"
#include "plugin/tool/points/point_file.h"

namespace ddt::tool {

namespace {

/// What is between a line's cells: a comma, else a semicolon, else (empty) blanks.
std::string separator_of(const std::string& line) {
    for (const char* separator : {",", ";"})
        if (line.find(separator) != std::string::npos)
            return separator;
    return "";
}

std::vector<std::string> split(const std::string& line, const std::string& separator) {
    if (separator.empty())
        return OIIO::Strutil::splits(line);
    std::vector<std::string> cells;
    for (const std::string& cell : OIIO::Strutil::splits(line, separator))
        cells.emplace_back(OIIO::Strutil::strip(cell, " \t\"'"));
    return cells;
}

/// Have r, g and b, where all three are there, called as usual, and with them a; A without them
/// too.
void spell_out_colours(std::vector<std::string>& names) {
    const auto place = [&](const char* name) {
        return std::find_if(names.begin(), names.end(),
                            [&](const std::string& n) { return OIIO::Strutil::iequals(n, name); });
    };
    const auto alpha = std::find(names.begin(), names.end(), "A");
    if (alpha != names.end() && place("alpha") == names.end())
        *alpha = "alpha";
    for (int k = 0; k < 3; ++k)
        if (place(colour_columns[k][1]) == names.end() ||
            place(colour_columns[k][0]) != names.end())
            return;
    for (const auto& [name, letter] : colour_columns)
        if (place(letter) != names.end() && place(name) == names.end())
            *place(letter) = name;
}

/// The names of the columns, if x and y are among them, each once; else none. Those that mean
/// something are as PointFile has them, the others as they are written.
std::vector<std::string> names_in(const std::string& line, const std::string& separator) {
    std::vector<std::string> names;
    for (const std::string& cell : split(line, separator)) {
        const std::string lower = OIIO::Strutil::lower(cell);
        const bool known = lower == "x" || lower == "y" || lower == "z" ||
                           std::any_of(std::begin(colour_columns), std::end(colour_columns),
                                       [&](const auto& column) { return lower == column[0]; });
        names.push_back(known ? lower : cell);
    }
    for (const char* axis : {"x", "y"})
        if (std::count(names.begin(), names.end(), axis) != 1)
            return {};
    spell_out_colours(names);
    return names;
}

/// Whether the columns hold 8-bit numbers: whole ones from 0 to 255 (and NaNs), some above 1.
bool are_bytes(const std::vector<Column*>& columns) {
    bool above_one = false;
    for (const Column* column : columns)
        for (const double v : column->values) {
            if (!std::isnan(v) && !(v >= 0 && v <= 255 && v == std::floor(v)))
                return false;
            above_one |= v > 1;
        }
    return above_one;
}

void take_as_bytes(const std::vector<Column*>& columns) {
    for (Column* column : columns) {
        column->type = "uchar";
        column->scale = 255;
        for (auto& v : column->values)
            v /= column->scale;
    }
}

/// Text has no types: colours that can only be meant as 8 bits are such. Alpha is by itself, as
/// it is often a share beside colours that are bytes.
void find_bytes(PointFile& points) {
    std::vector<Column*> colours, alphas;
    for (Column& column : points.columns) {
        if (column.is_colour())
            colours.push_back(&column);
        if (column.is_alpha())
            alphas.push_back(&column);
    }
    for (const auto& columns : {colours, alphas})
        if (are_bytes(columns))
            take_as_bytes(columns);
}

/// The line without the # or // that makes it a comment, or nothing if it is none.
std::optional<std::string> comment_in(const std::string& line) {
    for (const char* mark : {"#", "//"})
        if (OIIO::Strutil::starts_with(line, mark))
            return std::string(OIIO::Strutil::strip(line.substr(std::strlen(mark))));
    return {};
}

/// Remove the columns without a name and a number: separators at every line's end make such.
void drop_empty_columns(PointFile& points) {
    const auto is_empty = [](const Column& column) {
        return column.name.empty() && std::all_of(column.values.begin(), column.values.end(),
                                                  [](double v) { return std::isnan(v); });
    };
    auto& columns = points.columns;
    columns.erase(std::remove_if(columns.begin(), columns.end(), is_empty), columns.end());
}

/// Fills in the points of a text, line by line.
class TableReader {
public:
    explicit TableReader(PointFile& points) : m_points(points) {}

    bool has_names() const { return !m_place.empty(); }
    /// Take a line for that of the columns' names, if it is.
    bool read_names(const std::string& line);
    /// False with `error`, which does not name the line.
    bool read_row(const std::string& line, std::string& error);

private:
    enum : int { x = -1, y = -2 };

    PointFile& m_points;
    std::string m_separator;
    std::vector<int> m_place; ///< of each column: x, y or an index
};

bool TableReader::read_names(const std::string& line) {
    m_separator = separator_of(line);
    for (const std::string& name : names_in(line, m_separator)) {
        if (name == "x" || name == "y") {
            m_place.push_back(name == "x" ? x : y);
            continue;
        }
        m_place.push_back(int(m_points.columns.size()));
        m_points.columns.push_back({name, "float", 1, {}});
    }
    return has_names();
}

bool TableReader::read_row(const std::string& line, std::string& error) {
    const std::vector<std::string> cells =
        split(line, m_separator.empty() ? separator_of(line) : m_separator);
    if (cells.size() != m_place.size()) {
        error = format("there are {} columns, not {}", cells.size(), m_place.size());
        return false;
    }
    for (size_t k = 0; k < cells.size(); ++k) {
        const bool is_value = m_place[k] >= 0;
        const std::optional<double> number =
            cells[k].empty() && is_value ? std::nan("") : number_in(cells[k]);
        if (!number) {
            error = format("\"{}\" is no number", cells[k]);
            return false;
        }
        if (!is_value && !std::isfinite(*number)) {
            error = "a position that is not finite";
            return false;
        }
        std::vector<double>& column = m_place[k] == x ? m_points.mesh.x
                                      : m_place[k] == y
                                          ? m_points.mesh.y
                                          : m_points.columns[size_t(m_place[k])].values;
        column.push_back(*number);
    }
    return true;
}

} // namespace

bool read_table(const std::string& text, PointFile& points, std::string& error) {
    points = {};
    TableReader reader(points);
    // What some spreadsheets write.
    const char line_end = text.find('\n') == std::string::npos ? '\r' : '\n';
    size_t number = 1;
    for (size_t at = begin_of_text(text); at < text.size(); ++number) {
        const size_t end = std::min(text.find(line_end, at), text.size());
        std::string line(OIIO::Strutil::strip(text.substr(at, end - at)));
        at = end + 1;
        const std::optional<std::string> comment = comment_in(line);
        if (comment) // which may hold the names
            line = reader.has_names() ? "" : *comment;
        if (line.empty())
            continue;
        std::string fault;
        if (reader.has_names()) {
            if (!reader.read_row(line, fault)) {
                error = format("line {}: {}", number, fault);
                return false;
            }
        } else if (!reader.read_names(line) && !comment) {
            error =
                format("line {}: the first line must name the columns, x and y among them", number);
            return false;
        }
    }
    if (points.mesh.x.empty())
        error = "there are no points";
    drop_empty_columns(points);
    find_bytes(points);
    return !points.mesh.x.empty();
}

} // namespace ddt::tool
